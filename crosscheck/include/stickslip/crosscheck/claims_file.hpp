// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Claims files (docs/crosscheck.md): JSON Lines, one question and one claim a line. All
/// numbers are exact, as in grasp files.
#pragma once

#include <string>
#include <string_view>

#include "stickslip/crosscheck/claim.hpp"

namespace stickslip {

/// What one line says.
struct ClaimLine {
  Question question;  ///< about the grasp of the line, or of the file that it names
  Claim claim;        ///< the answer to it
};

/// One line. `folder` is where the names of grasp files start; empty is the current one. Throws
/// InputError with a line:column (the line being 1) or a JSON path such as "claim.twist[1]", or
/// naming the grasp file that the line refers to.
ClaimLine parse_claim_line(std::string_view line, const std::string& folder);

}  // namespace stickslip
