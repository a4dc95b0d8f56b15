// SPDX-License-Identifier: GPL-3.0-or-later
#include "nearest_in_cone.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace stickslip::search_detail {
namespace {

using Few = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;

/// Returns the multiples of the generators whose sum, perhaps not in the cone, is nearest to
/// the target.
Few multiples_of(const std::vector<std::size_t>& generators, const std::vector<Double3>& units,
                 const Double3& target) {
  const auto count = static_cast<Eigen::Index>(generators.size());
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> gram(count, count);
  Few right(count);
  for (Eigen::Index a = 0; a < count; ++a) {
    const Double3& one = units[generators[static_cast<std::size_t>(a)]];
    right[a] = dot(one, target);
    for (Eigen::Index b = 0; b < count; ++b) {
      gram(a, b) = dot(one, units[generators[static_cast<std::size_t>(b)]]);
    }
  }
  return gram.partialPivLu().solve(right);
}

}  // namespace

ConePoint nearest_in_cone(const std::vector<Double3>& units, const Double3& target) {
  constexpr double kNear = 1e-10;  // relative to the target
  constexpr int kMostSteps = 30;
  ConePoint found;
  std::vector<std::size_t>& in_use = found.generators;
  std::vector<double> multiples;
  const double least = kNear * std::sqrt(dot(target, target));
  for (int step = 0; step < kMostSteps && in_use.size() < 3; ++step) {
    const Double3 rest{target[0] - found.point[0], target[1] - found.point[1],
                       target[2] - found.point[2]};
    std::size_t best = units.size();
    double most = least;
    for (std::size_t k = 0; k < units.size(); ++k) {
      if (const double along = dot(units[k], rest); along > most) {
        most = along;
        best = k;
      }
    }
    const bool is_new = std::find(in_use.begin(), in_use.end(), best) == in_use.end();
    if (best == units.size() || !is_new) break;
    in_use.push_back(best);
    multiples.push_back(0);
    // The multiples move towards the nearest point of the plane, as far as all of them stay
    // above 0.
    while (!in_use.empty()) {
      const Few wanted = multiples_of(in_use, units, target);
      if (!wanted.allFinite()) return found;
      double part = 1;
      for (std::size_t k = 0; k < in_use.size(); ++k) {
        const double towards = wanted[static_cast<Eigen::Index>(k)];
        if (towards <= 0) part = std::min(part, multiples[k] / (multiples[k] - towards));
      }
      for (std::size_t k = 0; k < in_use.size(); ++k) {
        multiples[k] += part * (wanted[static_cast<Eigen::Index>(k)] - multiples[k]);
      }
      if (!(part < 1)) break;
      constexpr double kNothing = 1e-14;
      for (std::size_t k = in_use.size(); k-- > 0;) {
        if (multiples[k] > kNothing * least / kNear) continue;
        in_use.erase(in_use.begin() + static_cast<std::ptrdiff_t>(k));
        multiples.erase(multiples.begin() + static_cast<std::ptrdiff_t>(k));
      }
    }
    found.point = {};
    for (std::size_t k = 0; k < in_use.size(); ++k) {
      for (std::size_t j = 0; j < 3; ++j) found.point[j] += multiples[k] * units[in_use[k]][j];
    }
  }
  return found;
}

}  // namespace stickslip::search_detail
