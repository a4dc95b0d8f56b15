// SPDX-License-Identifier: GPL-3.0-or-later
#include "few_columns.hpp"

#include <algorithm>
#include <cmath>

#include "stickslip/lp/exact_system.hpp"

namespace stickslip::statics_detail {

RationalRow opposite(RationalRow row) {
  for (Rational& entry : row) entry = -entry;
  return row;
}

Rational on_grid(double x, int bits) {
  return std::isfinite(x)
             ? rational_from_double(std::ldexp(std::nearbyint(std::ldexp(x, bits)), -bits))
             : Rational(0);
}

std::optional<RationalRow> few_columns(const std::vector<RationalRow>& columns,
                                       const std::vector<double>& weights,
                                       const RationalRow& sum,
                                       const std::vector<double>& units) {
  std::vector<std::vector<double>> left;  // of each column, across those that are chosen
  for (std::size_t j = 0; j < columns.size(); ++j) {
    auto& column = left.emplace_back();
    for (std::size_t r = 0; r < sum.size(); ++r) {
      column.push_back(weights[j] * to_double(columns[j][r]) / units[r]);
    }
  }
  const auto square = [](const std::vector<double>& v) {
    double result = 0;
    for (const double entry : v) result += entry * entry;
    return result;
  };
  std::vector<std::size_t> chosen;
  double first = 0;
  while (chosen.size() < sum.size()) {
    std::size_t best = 0;
    double most = 0;
    for (std::size_t j = 0; j < left.size(); ++j) {
      if (const double size = square(left[j]); size > most) {
        most = size;
        best = j;
      }
    }
    if (chosen.empty()) first = most;
    constexpr double kNone = 1e-18;
    if (!(most > kNone * first)) break;
    chosen.push_back(best);
    const std::vector<double> along = left[best];
    for (std::vector<double>& v : left) {
      double product = 0;
      for (std::size_t r = 0; r < v.size(); ++r) product += v[r] * along[r];
      for (std::size_t r = 0; r < v.size(); ++r) v[r] -= product / most * along[r];
    }
    std::fill(left[best].begin(), left[best].end(), 0);
  }
  std::vector<RationalRow> basis;
  for (const std::size_t j : chosen) basis.push_back(columns[j]);
  RationalRow result(columns.size());
  if (basis.empty()) {
    for (const Rational& entry : sum) {
      if (!entry.is_zero()) return std::nullopt;
    }
    return result;
  }
  const auto solution = solve_exactly(matrix_of_columns(basis, sum.size()), sum);
  if (!solution) return std::nullopt;
  for (std::size_t k = 0; k < chosen.size(); ++k) result[chosen[k]] = (*solution)[k];
  return result;
}

}  // namespace stickslip::statics_detail
