// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch_results.hpp"

#include <nlohmann/json.hpp>

#include "stickslip/core/error.hpp"

namespace stickslip {

FinishedResults read_results(std::istream& in, const std::string& file) {
  FinishedResults results;
  for (std::string line; std::getline(in, line) && !in.eof();) {
    const auto result = nlohmann::json::parse(line, nullptr, false);
    if (!result.is_object() || !result.contains("key") || !result["key"].is_string()) {
      throw InputError(file, "line " + std::to_string(results.keys.size() + 1),
                       "this is not a result of a batch", "name another file");
    }
    results.bytes += line.size() + 1;
    results.keys.push_back(result["key"].get<std::string>());
  }
  return results;
}

}  // namespace stickslip
