// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Checks of the numbers of a box.
#pragma once

#include <functional>
#include <string>

#include "stickslip/core/box.hpp"

namespace stickslip::core_detail {

/// Throws InputError naming `place` if the ends are exchanged.
void check_ends(const Interval& interval, const std::string& place);

/// Checks the requirements stated at UncertainContact. Throws InputError naming
/// "<path>.<member>".
void check_contact(const UncertainContact& contact, const std::string& path);

/// Checks the requirements stated at Spring. Throws InputError naming "<its place>.<member>".
void check_spring(const Spring& spring);

/// Runs a check of a box that these tolerances widened. If it fails at a number that an
/// absolute tolerance of 1 or more has widened, the InputError asks whether percents were
/// meant.
void check_widened(const Tolerances& tolerances, const std::function<void()>& check);

}  // namespace stickslip::core_detail
