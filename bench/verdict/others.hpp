// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What branch and bound is compared with: the reference engine, two SMT solvers on the
/// exported question, and a linear program in floating point for a weaker question.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stickslip/engine/question.hpp"

namespace stickslip::bench {

struct OtherAnswer {
  double ms = 0;
  std::string answer;  ///< "stable", "unstable", or "" when none came within the limit
};

/// One that answers; `is_same_question` is false for a weaker question.
struct Competitor {
  std::string name;
  std::string remark;
  bool is_same_question = true;
  OtherAnswer (*answer)(const Question& question, double seconds) = nullptr;
};

/// states, and Z3, cvc5 and GLPK as far as they are there.
std::vector<Competitor> competitors();

/// Those that are not there, with what to install.
std::vector<std::string> missing_competitors();

}  // namespace stickslip::bench
