// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The results of a batch that is to go on after an interruption.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>

namespace stickslip {

/// What became of a line of a batch.
enum class LineOutcome { kDecided, kUndecided, kUnreadable };

struct FinishedResult {
  std::string key;  ///< of the question
  LineOutcome outcome;
};

/// The results that stand in whole lines, one at a time; what an interruption left unfinished
/// behind them does not count.
class FinishedResults {
 public:
  /// Reads from `in`, which must outlive this; `file` is its name in errors.
  FinishedResults(std::istream& in, std::string file) : in_(in), file_(std::move(file)) {}

  /// Nothing at the end. Throws InputError naming the line that is not a result of a batch.
  std::optional<FinishedResult> next();

  std::size_t lines() const { return lines_; }     ///< read so far
  std::uintmax_t bytes() const { return bytes_; }  ///< of these lines

 private:
  std::istream& in_;
  std::string file_;
  std::string line_;
  std::size_t lines_ = 0;
  std::uintmax_t bytes_ = 0;
};

}  // namespace stickslip
