// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/results.hpp"

#include <cstdlib>
#include <string_view>

#include "hash.hpp"
#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/json.hpp"

namespace stickslip {
namespace {

/// Returns the last member of a result, and the end of the line.
std::string check_of(std::string_view members) {
  batch_detail::Hash hash;
  hash.add(members);
  return ",\"check\":\"" + hash.digits() + "\"}";
}

bool is_as_written(std::string_view line) {
  static const std::size_t kLength = check_of("").size();
  if (line.size() < kLength) return false;
  const std::string_view members = line.substr(0, line.size() - kLength);
  return line.substr(members.size()) == check_of(members);
}

}  // namespace

std::string with_check(std::string result) {
  constexpr std::size_t kEnd = 2;  // } and a line feed
  result.resize(result.size() - kEnd);
  return result + check_of(result) + "\n";
}

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
         std::to_string(first_unreadable) + "; their results say why" +
         (results > 1 && unreadable == results
              ? "; a batch has one grasp a line, while a file of one grasp is decided by itself"
              : "");
}

std::optional<FinishedResult> FinishedResults::next() {
  if (changed_ || !std::getline(in_, line_) || in_.eof()) return std::nullopt;
  JsonNode result;
  try {
    result = parse_json(line_);
  } catch (const InputError&) {  // no more a result than null is
  }
  const JsonNode* const key = result.find("key");
  if (key == nullptr || key->kind != JsonNode::Kind::kString) {
    throw InputError(file_, "line " + std::to_string(lines_ + 1),
                     "this is not a result of a batch", "name another file");
  }
  FinishedResult finished;
  finished.is_as_written = is_as_written(line_);
  if (finished.is_as_written) {
    ++lines_;
    bytes_ += line_.size() + 1;
  } else {
    changed_ = lines_ + 1;
  }
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

std::string changed_note(const FinishedResults& results, const std::string& file) {
  if (!results.changed()) return "";
  return file + ": line " + std::to_string(*results.changed()) +
         ": this result is not as a batch has written it; it is decided again, and those "
         "behind it";
}

BatchTally skip_finished(FinishedResults& results, const std::string& output, BatchLines& lines,
                         const std::string& grasps, const LineDecider& decider) {
  BatchTally tally;
  while (const std::optional<FinishedResult> result = results.next()) {
    throw_if_cancelled();
    std::optional<BatchLine> line = lines.next();
    if (!line || result->key != decider.key(line->text)) {
      throw InputError(output, "result of line " + std::to_string(lines.number()),
                       "it is not that of this line of " + grasps + " under these options",
                       "resume with the same grasps and options, or name another file");
    }
    if (result->is_as_written) {
      tally.count(line->number, result->outcome);
    } else {
      lines.put_back(std::move(*line));
    }
  }
  return tally;
}

}  // namespace stickslip
