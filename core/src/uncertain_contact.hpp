// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What the numbers of a box must satisfy.
#pragma once

#include <functional>
#include <string>

#include "stickslip/core/box.hpp"

namespace stickslip::core_detail {

/// Throws InputError naming `place` if the ends are exchanged.
void check_ends(const Interval& interval, const std::string& place);

/// The requirements stated at UncertainContact. Throws InputError naming "<path>.<member>".
void check_contact(const UncertainContact& contact, const std::string& path);

/// The requirements stated at Spring. Throws InputError naming "<its place>.<member>".
void check_spring(const Spring& spring);

/// Runs a check of what was widened by these tolerances. If a law breaks that an absolute
/// tolerance of 1 or more has widened, its InputError asks whether percents were meant.
void check_widened(const Tolerances& tolerances, const std::function<void()>& check);

}  // namespace stickslip::core_detail
