// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch_results.hpp"

#include <nlohmann/json.hpp>

#include "stickslip/core/error.hpp"

namespace stickslip {

std::optional<FinishedResult> FinishedResults::next() {
  if (!std::getline(in_, line_) || in_.eof()) return std::nullopt;
  const auto json = nlohmann::json::parse(line_, nullptr, false);
  if (!json.is_object() || !json.contains("key") || !json["key"].is_string()) {
    throw InputError(file_, "line " + std::to_string(lines_ + 1),
                     "this is not a result of a batch", "name another file");
  }
  ++lines_;
  bytes_ += line_.size() + 1;
  const LineOutcome outcome = json.contains("error")   ? LineOutcome::kUnreadable
                              : json.contains("limit") ? LineOutcome::kUndecided
                                                       : LineOutcome::kDecided;
  return FinishedResult{json["key"].get<std::string>(), outcome};
}

}  // namespace stickslip
