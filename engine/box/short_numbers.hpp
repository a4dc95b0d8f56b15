// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Numbers of few bits near given ones, for searches that halve intervals.
#pragma once

#include "stickslip/core/number.hpp"

namespace stickslip::box_detail {

/// Returns the least power of two that is not below a number > 0; for 0 it is 1.
Rational power_of_two_above(const Rational& size);

/// Returns a number of few bits near (a + b) / 2, between them.
Rational short_middle(const Rational& a, const Rational& b);

}  // namespace stickslip::box_detail
