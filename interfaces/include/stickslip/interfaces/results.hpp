// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The results of a batch: counted, and read again to go on after an interruption.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>

#include "stickslip/interfaces/line.hpp"

namespace stickslip {

/// The numbers of results of each kind.
struct BatchTally {
  std::size_t results = 0;           ///< all results
  std::size_t undecided = 0;         ///< results undecided within the node limit
  std::size_t unreadable = 0;        ///< errors in place of a verdict
  std::size_t first_unreadable = 0;  ///< the number of the first such line

  void count(std::size_t line, LineOutcome outcome);  ///< counts one more result
  void add(const BatchTally& later);                  ///< adds the results of later lines

  /// Returns "g.jsonl: 2 of 5 lines could not be read, ...", or that there are none, about the
  /// file `name`; nothing if all is well.
  std::string complaint(const std::string& name) const;
};

/// Returns the result, a JSON object and a line feed, with its last member "check": a hash of
/// all before it. The hash tells a result that was changed after it was written from one that
/// was not; it proves nothing.
std::string with_check(std::string result);

/// A result, as it is read again.
struct FinishedResult {
  std::size_t line = 0;                         ///< its number; 0 if the result does not say
  std::string key{};                            ///< the key of the question
  LineOutcome outcome = LineOutcome::kDecided;  ///< the outcome that the result states
  bool is_as_written = true;                    ///< false if it was changed since (with_check)
};

/// The results that stand in whole lines, one at a time. A line that an interruption left
/// unfinished does not count; nor does the first result that was changed, with all behind it.
class FinishedResults {
 public:
  /// Reads from `in`, which must outlive this; `file` is its name in errors. `lines_before`
  /// lines and `bytes_before` bytes stood before.
  FinishedResults(std::istream& in, std::string file, std::size_t lines_before = 0,
                  std::uintmax_t bytes_before = 0)
      : in_(in), file_(std::move(file)), lines_(lines_before), bytes_(bytes_before) {}

  /// Returns nothing at the end, or behind a result that was changed. Throws InputError naming
  /// the line that is not a result of a batch.
  std::optional<FinishedResult> next();
  /// Returns the line of the file that was changed, if one was.
  std::optional<std::size_t> changed() const { return changed_; }

  std::size_t lines() const { return lines_; }     ///< the lines of the file so far that count
  std::uintmax_t bytes() const { return bytes_; }  ///< the bytes of these lines

 private:
  std::istream& in_;
  std::string file_;
  std::string line_;
  std::size_t lines_;
  std::uintmax_t bytes_;
  std::optional<std::size_t> changed_;
};

/// Returns a note that a result in `file` was changed and is decided again, with those behind
/// it; empty if none was.
std::string changed_note(const FinishedResults& results, const std::string& file);

/// Reads all results up to one that was changed, and as many lines, whose results they must be
/// under the options of `decider`. The next of `lines` is then the first without a result.
/// Throws InputError naming the result that is another line's; `grasps` is the name of the file
/// of lines.
BatchTally skip_finished(FinishedResults& results, const std::string& output, BatchLines& lines,
                         const std::string& grasps, const LineDecider& decider);

}  // namespace stickslip
