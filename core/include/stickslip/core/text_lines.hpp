// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Long files a line at a time, for JSON Lines.
#pragma once

#include <cstddef>
#include <istream>
#include <string>

namespace stickslip {

/// Lines one at a time; memory holds one, of at most kMaxGraspFileBytes.
class TextLines {
 public:
  /// Reads from `in`, which must outlive this.
  explicit TextLines(std::istream& in) : in_(in) {}

  /// The next line that is not blank, false at the end. Throws InputError for a line that is
  /// too long, which has been skipped, so that next() may be called again; number() is its
  /// number.
  bool next(std::string& line);

  /// Of the last line read, from 1, blank ones counted.
  std::size_t number() const { return number_; }

 private:
  std::istream& in_;
  std::size_t number_ = 0;
};

}  // namespace stickslip
