// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Claims files (docs/crosscheck.md): JSON Lines, one question and one claim a line. All
/// numbers are exact, as in grasp files.
#pragma once

#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include "stickslip/crosscheck/claim.hpp"

namespace stickslip {

struct ClaimLine {
  Question question;
  Claim claim;
};

/// One line. `folder` is where the names of grasp files start; empty is the current one. Throws
/// InputError with a line:column (the line being 1) or a JSON path such as "claim.twist[1]", or
/// naming the grasp file that the line refers to.
ClaimLine parse_claim_line(std::string_view line, const std::string& folder);

/// Lines one at a time; memory holds one, of at most kMaxGraspFileBytes.
class ClaimLines {
 public:
  explicit ClaimLines(std::istream& in) : in_(in) {}

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
