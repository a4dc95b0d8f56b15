// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch_results.hpp"

#include "stickslip/core/error.hpp"
#include "stickslip/core/json.hpp"

namespace stickslip {

std::optional<FinishedResult> FinishedResults::next() {
  if (!std::getline(in_, line_) || in_.eof()) return std::nullopt;
  JsonNode result;
  try {
    result = parse_json(line_);
  } catch (const InputError&) {  // as little a result as null
  }
  const JsonNode* const key = result.find("key");
  if (key == nullptr || key->kind != JsonNode::Kind::kString) {
    throw InputError(file_, "line " + std::to_string(lines_ + 1),
                     "this is not a result of a batch", "name another file");
  }
  ++lines_;
  bytes_ += line_.size() + 1;
  const LineOutcome outcome = result.find("error") != nullptr   ? LineOutcome::kUnreadable
                              : result.find("limit") != nullptr ? LineOutcome::kUndecided
                                                                : LineOutcome::kDecided;
  return FinishedResult{key->text, outcome};
}

}  // namespace stickslip
