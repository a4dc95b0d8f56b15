// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Rounded vectors whose number of coordinates is known at run time, without memory of their
/// own. They only propose.
#pragma once

#include <Eigen/Core>

#include "stickslip/core/row.hpp"

namespace stickslip {

/// The most coordinates that points may have.
constexpr int kMostCoordinates = 32;

/// A vector in double precision.
using Reals = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostCoordinates, 1>;

/// Returns the sum of a_j b_j.
inline double dot(const Reals& a, const Reals& b) {
  return a.dot(b);
}

/// Returns a over a power of two, in doubles, like in_doubles() of integer_vector.hpp.
inline Reals in_doubles(const Row& a) {
  Reals result(static_cast<Eigen::Index>(a.size()));
  core_detail::round_to_one(a.data(), result.data(), a.size());
  return result;
}

/// Returns the primitive integer vector nearest to a multiple of a with entries of this many
/// bits, like in_bits() of integer_vector.hpp.
Row in_bits(const Reals& a, int bits);

/// \{ Divides x by its norm; 0 stays 0. It suffices that entries are finite: their squares may
/// overflow or vanish.
inline void normalize(Reals& x) {
  const double largest = x.size() > 0 ? x.lpNorm<Eigen::Infinity>() : 0;
  if (!(largest > 0)) return;
  x /= largest;
  x /= x.norm();
}
template <std::size_t n>
void normalize(std::array<double, n>& x) {
  double largest = 0;
  for (const double entry : x) largest = std::max(largest, std::fabs(entry));
  if (!(largest > 0)) return;
  for (double& entry : x) entry /= largest;
  const double size = std::sqrt(dot(x, x));
  for (double& entry : x) entry /= size;
}
/// \}

}  // namespace stickslip
