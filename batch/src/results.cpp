// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/batch/results.hpp"

#include <cstdlib>

#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/json.hpp"

namespace stickslip {

void BatchTally::count(std::size_t line, LineOutcome outcome) {
  ++results;
  if (outcome == LineOutcome::kUnreadable && unreadable++ == 0) first_unreadable = line;
  undecided += outcome == LineOutcome::kUndecided ? 1 : 0;
}

void BatchTally::add(const BatchTally& later) {
  results += later.results;
  undecided += later.undecided;
  if (unreadable == 0) first_unreadable = later.first_unreadable;
  unreadable += later.unreadable;
}

std::string BatchTally::complaint(const std::string& name) const {
  if (results == 0) return name + ": the file is empty, there is no grasp in it";
  if (unreadable == 0) return "";
  return name + ": " + std::to_string(unreadable) + " of " + std::to_string(results) +
         (results == 1 ? " line" : " lines") + " could not be read, the first is line " +
         std::to_string(first_unreadable) + "; their results say why";
}

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
  FinishedResult finished;
  const JsonNode* const line = result.find("line");
  if (line != nullptr && line->kind == JsonNode::Kind::kNumber) {
    finished.line = std::strtoull(line->text.c_str(), nullptr, 10);
  }
  finished.key = key->text;
  finished.outcome = result.find("error") != nullptr   ? LineOutcome::kUnreadable
                     : result.find("limit") != nullptr ? LineOutcome::kUndecided
                                                       : LineOutcome::kDecided;
  return finished;
}

BatchTally skip_finished(FinishedResults& results, const std::string& output, BatchLines& lines,
                         const std::string& grasps, const LineDecider& decider) {
  BatchTally tally;
  while (const std::optional<FinishedResult> result = results.next()) {
    throw_if_cancelled();
    const std::optional<BatchLine> line = lines.next();
    if (!line || result->key != decider.key(line->text)) {
      throw InputError(output, "result of line " + std::to_string(lines.number()),
                       "it is not that of this line of " + grasps + " under these options",
                       "resume with the same grasps and options, or name another file");
    }
    tally.count(line->number, result->outcome);
  }
  return tally;
}

}  // namespace stickslip
