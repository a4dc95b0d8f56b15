// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Points x = (d, h, l) in double precision and comparable units: rotations are times a typical
/// length of the grasp. For proposals only.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "stickslip/core/integer_vector.hpp"

namespace stickslip::equilibrium_detail {

/// Coordinates from here on are rotations of motions, and torques of wrenches.
template <std::size_t D>
constexpr std::size_t kFirstRotation = D == 3 ? 2 : 3;

/// (d, h, l).
template <std::size_t D>
using ScaledPoint = std::array<double, D + 2>;

/// d.
template <std::size_t D>
std::array<double, D> motion_of(const ScaledPoint<D>& x) {
  std::array<double, D> d;
  std::copy_n(x.begin(), D, d.begin());
  return d;
}

/// Over its norm; 0 stays 0. Finite entries suffice: their squares may overflow or vanish.
template <std::size_t n>
void normalize(std::array<double, n>& x) {
  double largest = 0;
  for (const double entry : x) largest = std::max(largest, std::fabs(entry));
  if (!(largest > 0)) return;
  for (double& entry : x) entry /= largest;
  const double size = std::sqrt(dot(x, x));
  for (double& entry : x) entry /= size;
}

/// Of norm 1.
template <std::size_t D>
ScaledPoint<D> scaled_point(const IntegerVector<D + 2>& exact, double length) {
  ScaledPoint<D> x = in_doubles(exact);
  for (std::size_t j = kFirstRotation<D>; j < D; ++j) x[j] *= length;
  normalize(x);
  return x;
}

/// A plane through x and across the way from b to a, in few bits; 0 where these are too near.
template <std::size_t D>
IntegerVector<D + 2> plane_between(const ScaledPoint<D>& a, const ScaledPoint<D>& b,
                                   const ScaledPoint<D>& x, double length) {
  ScaledPoint<D> across{};
  for (std::size_t j = 0; j < D + 2; ++j) across[j] = a[j] - b[j];
  constexpr double kClose = 1e-8;  // squared
  const double size = dot(x, x);
  if (!(size > 0) || dot(across, across) < kClose) return {};
  const double along = dot(across, x) / size;
  for (std::size_t j = 0; j < D + 2; ++j) across[j] -= along * x[j];
  for (std::size_t j = kFirstRotation<D>; j < D; ++j) across[j] *= length;
  constexpr int kBits = 12;
  return in_bits(across, kBits);
}

/// plane.x over the norm of the plane.
template <std::size_t D>
double value_at(const IntegerVector<D + 2>& plane, const ScaledPoint<D>& x, double length) {
  ScaledPoint<D> p = in_doubles(plane);
  for (std::size_t j = kFirstRotation<D>; j < D; ++j) p[j] /= length;
  normalize(p);
  return dot(p, x);
}

}  // namespace stickslip::equilibrium_detail
