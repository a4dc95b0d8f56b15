// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// From integers about the scaled rows to the evidence about the rows as given.
#pragma once

#include <vector>

#include "integer_tier.hpp"
#include "scaled_system.hpp"

namespace stickslip::lp_detail {

/// numerator / denominator in lowest terms. Requires denominator != 0.
Rational ratio(std::int64_t numerator, std::int64_t denominator);
Rational ratio(Int128 numerator, Int128 denominator);
Rational ratio(const Integer& numerator, const Integer& denominator);

/// The positive multiple of `values` that is a vector of coprime integers.
void make_coprime(std::vector<Rational>& values);

/// `multipliers` (one per row, or none for 0): the scaled objective is
/// sum multipliers_i (g_i.x + h_i) + terms in variables >= 0 + constant.
Optimal make_optimal(const LinearProgram& program, const ScaledSystem& system,
                     std::vector<Rational> point, std::vector<Rational> multipliers);

/// sum multipliers_i (g_i.x + h_i) = (terms that are <= 0) + a negative constant.
Infeasible make_infeasible(const ScaledSystem& system, std::vector<Rational> multipliers);

Unbounded make_unbounded(std::vector<Rational> point, std::vector<Rational> ray);

}  // namespace stickslip::lp_detail
