// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/earlier/grasp_map.hpp"

#include <algorithm>

#include "earlier/robustness/robustness_search.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/lp/exact_system.hpp"

namespace stickslip {

using namespace robustness_detail;

namespace {

using Matrix = std::vector<RationalRow>;

/// Returns the determinant of a positive semidefinite matrix, which eliminates without a choice
/// of pivots.
Rational determinant_of(Matrix a) {
  Rational result = 1;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k][k].is_zero()) return 0;
    result *= a[k][k];
    for (std::size_t i = k + 1; i < a.size(); ++i) {
      const Rational factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < a.size(); ++j) a[i][j] -= factor * a[k][j];
    }
  }
  return result;
}

/// Encloses the largest eigenvalue of a positive semidefinite matrix.
Interval largest_eigenvalue(const Matrix& a) {
  const std::size_t n = a.size();
  std::vector<Doubles> opposite(6);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t k = 0; k < n; ++k) opposite[j][k] = -to_double(a[j][k]);
  }
  const Doubles vector = least_eigenvalue(std::move(opposite), n).direction;
  RationalRow z;
  for (std::size_t j = 0; j < n; ++j) z.push_back(rational_in_bits(vector[j], 40));
  if (dot(z, z).is_zero()) z[0] = 1;
  RationalRow image;
  for (const RationalRow& row : a) image.push_back(dot(row, z));
  const Rational low = dot(z, image) / dot(z, z);
  Rational high = 0;  // the trace, unless less is known
  Matrix unit(n, RationalRow(n));
  for (std::size_t j = 0; j < n; ++j) {
    unit[j][j] = 1;
    high += a[j][j];
  }
  if (low.is_zero()) return {low, high};
  // The inverse of the eigenvalue is the largest c for which 1 - c A is semidefinite.
  const Rational c = semidefinite_multiple(unit, a, 1 / low);
  if (!c.is_zero()) high = std::min(high, Rational(1 / c));
  return {low, high};
}

}  // namespace

GraspMapMeasures grasp_map_measures(const GraspBox& grasp, const Rational& length) {
  RobustnessOptions options;
  options.length = length;
  ForceModel model(grasp, options);
  model.is_uniform = true;  // stiffnesses play no part
  const std::vector<SpringState> states = first_combination(model);
  Matrix square(model.coordinates, RationalRow(model.coordinates));
  for (const RationalRow& x : model.columns(states)) {
    for (std::size_t j = 0; j < x.size(); ++j) add_multiple(square[j], x[j], x);
  }
  const InverseSquare least = inverse_square(model, states);
  return {{least.low, least.high}, largest_eigenvalue(square), determinant_of(square)};
}

Rational squared_distance_of_centroid(const GraspBox& grasp, const RationalRow& point) {
  require(!grasp.contacts.empty(), "no contacts have no centroid");
  RationalRow away = point;
  const Rational count(static_cast<long>(grasp.contacts.size()));
  for (const UncertainContact& contact : grasp.contacts) {
    add_multiple(away, -1 / count, contact.point());
  }
  return dot(away, away);
}

}  // namespace stickslip
