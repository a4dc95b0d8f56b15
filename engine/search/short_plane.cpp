// SPDX-License-Identifier: GPL-3.0-or-later
#include "short_plane.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stickslip::search_detail {

bool are_long(const std::vector<Row>& planes) {
  constexpr std::size_t kLongBits = 64;
  for (const Row& plane : planes) {
    for (const Integer& entry : plane) {
      if (!entry.is_zero() && msb(abs(entry)) >= kLongBits) return true;
    }
  }
  return false;
}

Row short_plane(const Law& law, const MotionRegion& region, const std::vector<Row>& planes,
                const Reals& motion, int side) {
  Row none(law.coordinates());
  if (law.is_family) return none;
  const auto d = static_cast<Eigen::Index>(law.motions);
  // The units of length and of motion are powers of two.
  const int arm = std::ilogb(law.length);
  const auto rotate = [&](Reals& x, int by) {
    for (Eigen::Index j = 0; j < d; ++j) {
      if (law.rotates[static_cast<std::size_t>(j)] != 0) x[j] = std::ldexp(x[j], by);
    }
  };
  double reach = 0;
  std::vector<Reals> points;  // d and h
  for (const Row& point : region.points()) {
    Reals& x = points.emplace_back(in_doubles(point).head(d + 1));
    rotate(x, arm);
    if (x[d] > 0) reach = std::max(reach, x.head(d).norm() / x[d]);
  }
  constexpr int kMostUnits = 200;
  const int travel = reach > 0 && std::isfinite(reach) ? std::ilogb(reach) : 0;
  if (std::abs(travel) > kMostUnits || std::abs(arm) > kMostUnits) return none;
  // This function is above 0 on the region, if that is narrow.
  Reals inwards = Reals::Zero(d + 1);
  for (Reals& x : points) {
    x.head(d) *= std::ldexp(1.0, -travel);
    x.normalize();
    inwards += x;
  }
  inwards.normalize();
  double least = 1;
  for (const Reals& x : points) least = std::min(least, inwards.dot(x));
  constexpr double kNarrow = 0.05;
  if (!(least > kNarrow)) return none;
  std::vector<Reals> functions;
  for (const Row& plane : planes) {
    Reals& p = functions.emplace_back(in_doubles(plane).head(d + 1));
    rotate(p, -arm);
    p.head(d) *= std::ldexp(1.0, travel);
    p.normalize();
  }
  Reals at = motion.head(d + 1);
  for (Eigen::Index j = 0; j < d; ++j) {
    if (law.rotates[static_cast<std::size_t>(j)] == 0) continue;
    at[j] = at[j] / law.length * std::ldexp(1.0, arm);
  }
  at[d] = std::ldexp(at[d], travel);
  Reals nearest = *std::min_element(
      functions.begin(), functions.end(),
      [&](const Reals& a, const Reals& b) { return side * a.dot(at) < side * b.dot(at); });
  constexpr int kBits = 20;
  double error = std::ldexp(4.0, -kBits);
  for (const Reals& x : points) {
    for (const Reals& f : functions) {
      error = std::max(error, std::ldexp(4.0, -kBits) + std::fabs((f - nearest).dot(x)));
    }
  }
  nearest -= side * error / least * inwards;
  // The result is in the units of the file again.
  const int lowest = std::min({0, arm, travel});
  Row result(law.coordinates());
  for (Eigen::Index j = 0; j <= d; ++j) {
    const auto k = static_cast<std::size_t>(j);
    const double entry = std::ldexp(nearest[j], kBits);
    if (!std::isfinite(entry)) return none;
    const int unit = j == d ? travel : law.rotates[k] != 0 ? arm : 0;
    result[k] = Integer(std::llround(entry)) << static_cast<unsigned>(unit - lowest);
  }
  result = primitive(std::move(result));
  return region.signs(result).cuts() ? result : none;
}

}  // namespace stickslip::search_detail
