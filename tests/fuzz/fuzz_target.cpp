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

std::vector<Seed> hostile_texts() {
  const auto repeat = [](const char* text, int times) {
    std::string result;
    for (; times > 0; --times) result += text;
    return result;
  };
  return {{"deep arrays", repeat("[", 20000)},
          {"deep objects", repeat("{\"key\":", 20000)},
          {"deep member", "{\"key\":" + repeat("[", 20000) + repeat("]", 20000) + "}"},
          {"exponent", "{\"key\": 1e999999999, \"wrench\": [0, 0, 1e-999999999]}"},
          {"digits", "{\"key\": " + repeat("9", 20000) + "}"},
          {"decimals", "[0." + repeat("1", 20000) + "]"},
          {"many keys", "{" + repeat("\"key\": 0, ", 5000) + "}"}};
}

void broken(const std::string& message) {
  std::cerr << "property broken: " << message << std::endl;
  std::abort();
}

void expect_useful(const InputError& error, std::string_view text) {
  if (error.problem().empty() || error.remedy().empty()) {
    broken(std::string("an error without a problem or a remedy: ") + error.what());
  }
  const std::string& place = error.place();
  const std::size_t colon = place.find(':');
  if (colon == std::string::npos || place.find_first_not_of("0123456789:") < place.size()) {
    return;
  }
  const std::size_t line = std::stoul(place);
  const std::size_t column = std::stoul(place.substr(colon + 1));
  for (std::size_t i = 1; i < line; ++i) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) broken("no line " + place);
    text.remove_prefix(end + 1);
  }
  if (line == 0 || column == 0 || column > std::min(text.find('\n'), text.size()) + 1) {
    broken("no column " + place);
  }
}

}  // namespace stickslip::fuzz
