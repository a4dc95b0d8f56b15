// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Reads the values of options as a command line spells them, and puts errors in its words.
#pragma once

#include <string>

#include "stickslip/core/error.hpp"
#include "stickslip/core/number_list.hpp"
#include "stickslip/engine/question.hpp"

namespace stickslip {

/// Returns the wrench "WX,WY,T" in an option's value. Throws InputError naming the option.
Wrench wrench_option(const std::string& option, const std::string& value);

/// Returns a number above 0. Throws InputError naming the option.
Rational positive_option(const std::string& option, const std::string& value);

/// Returns a part of a radius, "1%" or "0.01". Throws InputError naming --accuracy.
Rational accuracy_option(const std::string& value);

/// Returns an error of ask() or compare_methods() in the words of the command line, about the
/// grasp `name`.
InputError in_options(const InputError& error, const std::string& name);

/// Returns the question of ask(), with errors in the words of the command line; those of a
/// contact name the grasp `name`. Unless `takes_boxes` is set, it refuses what
/// require_one_grasp() does, except a margin.
Question ask_with_options(GraspFile file, const QuestionOptions& options,
                          const std::string& name, bool takes_boxes = false);

}  // namespace stickslip
