// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Exact arithmetic by words of the machine where numbers are short, as most are that people
/// write. It is several times faster than with numbers of any length.
#pragma once

#include <cstdint>

#include "stickslip/core/grasp.hpp"

static_assert(sizeof(unsigned long) == sizeof(std::uint64_t) && GMP_NUMB_BITS == 64,
              "a word of GMP, a long and 64 bits are one");

namespace stickslip::core_detail {

/// Returns numerator / denominator. Requires that the denominator is not 0.
Rational short_fraction(std::uint64_t numerator, std::uint64_t denominator);

/// Returns a.x b.y - a.y b.x, for numbers of any length.
Rational determinant(const Vector2& a, const Vector2& b);

}  // namespace stickslip::core_detail
