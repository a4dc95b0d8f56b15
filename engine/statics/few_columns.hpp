// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Exact systems of which doubles say which few columns are to be used.
#pragma once

#include <optional>
#include <vector>

#include "stickslip/core/row.hpp"

namespace stickslip::statics_detail {

/// The dimension up to which systems are solved as dense ones.
inline constexpr std::size_t kMostDense = 60;

/// Returns -row.
RationalRow opposite(RationalRow row);
/// Returns x without its bits below 2^-`bits`; 0 for NaN and infinities.
Rational on_grid(double x, int bits);

/// Returns coefficients with which columns add up to a vector: few of them are not 0, and these
/// of columns that are long if multiplied by their weights and divided, row by row, by units.
/// Returns nothing if it finds none. Takes O(n r^2) operations for n columns of r rows.
std::optional<RationalRow> few_columns(const std::vector<RationalRow>& columns,
                                       const std::vector<double>& weights,
                                       const RationalRow& sum,
                                       const std::vector<double>& units);

}  // namespace stickslip::statics_detail
