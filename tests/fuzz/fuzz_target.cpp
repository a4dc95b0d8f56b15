// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz_target.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>

namespace stickslip::fuzz {

std::vector<Seed> files_below(const std::filesystem::path& folder) {
  std::vector<Seed> result;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream in(entry.path(), std::ios::binary);
    result.push_back({entry.path().lexically_relative(folder).string(),
                      {std::istreambuf_iterator<char>(in), {}}});
  }
  std::sort(result.begin(), result.end(),
            [](const Seed& a, const Seed& b) { return a.name < b.name; });
  return result;
}

void broken(const std::string& message) {
  std::cerr << "property broken: " << message << std::endl;
  std::abort();
}

}  // namespace stickslip::fuzz
