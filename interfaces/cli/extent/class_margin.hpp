// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The answer of `margin --class`.
#pragma once

#include <string>

#include "question_options.hpp"
#include "stickslip/core/time_limit.hpp"

namespace stickslip {

struct ClassMarginOptions {
  std::string inertia;    ///< the text of --inertia
  bool friction = false;  ///< whether to vary factors of friction, not multiples of the
                          ///< direction
  Rational accuracy;      ///< the accuracy of factors
  TimeLimit time{};
};

/// Prints which multiples of the direction, or factors of friction, are of which class. Returns
/// the exit code.
int answer_class_margin(const Question& question, const ClassMarginOptions& options,
                        const NumberOptions& output);

}  // namespace stickslip
