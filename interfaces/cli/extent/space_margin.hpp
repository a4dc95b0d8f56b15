// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The answer of `margin` to a question whose answer is a list of claims.
#pragma once

#include <cstddef>
#include <string>

#include "question_options.hpp"
#include "stickslip/core/time_limit.hpp"
#include "stickslip/measures/spatial_margin.hpp"

namespace stickslip {

struct SpaceMarginArguments {
  std::string certificate;
  SpatialMarginOptions search;
  NumberOptions output;
  bool least;
  bool warnings;  ///< look for traps of the model
  TimeLimit time;
};

/// Answers the question. Returns the exit code.
int answer_margin_in_space(const Question& question, const SpaceMarginArguments& arguments);

}  // namespace stickslip
