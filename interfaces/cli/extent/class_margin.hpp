// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What `margin --class` answers.
#pragma once

#include <string>

#include "question_options.hpp"

namespace stickslip {

struct ClassMarginOptions {
  std::string inertia;    ///< as --inertia gives it
  bool friction = false;  ///< of factors of friction, not of multiples of the direction
  Rational accuracy;      ///< of factors
};

/// Prints which multiples of the direction, or factors of friction, are of which class. Returns
/// the exit code.
int answer_class_margin(const Question& question, const ClassMarginOptions& options,
                        const NumberOptions& output);

}  // namespace stickslip
