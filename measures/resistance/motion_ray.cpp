// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion_ray.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace stickslip::resistance_detail {
namespace {

HomogeneousMotion without_multiple(const IntegerVector5& x) {
  return {x[0], x[1], x[2], x[3]};
}

Integer largest_entry_of(const HomogeneousMotion& x) {
  Integer largest = 0;
  for (const Integer& entry : x) largest = std::max<Integer>(largest, abs(entry));
  return largest;
}

/// Returns x over its largest entry, in doubles.
std::array<double, 4> scaled_to_one(const HomogeneousMotion& x) {
  std::array<double, 4> result = in_doubles(x);
  double largest = 0;
  for (const double entry : result) largest = std::max(largest, std::fabs(entry));
  if (largest > 0) {
    for (double& entry : result) entry /= largest;
  }
  return result;
}

/// Returns four directions that are not aligned with anything that people choose. Planes
/// through the directions could else coincide with those of contacts, which is no error but
/// takes longer.
const std::array<IntegerVector3, 4>& corners() {
  static const std::array<IntegerVector3, 4> all{
      IntegerVector3{83, 19, 7}, IntegerVector3{-31, 71, 13}, IntegerVector3{-23, -43, 67},
      IntegerVector3{-29, -47, -87}};
  return all;
}

}  // namespace

MotionRays::MotionRays(const Problem& problem)
    : contacts_(problem.size()),
      bilateral_(problem.law() == NormalLaw::kBilateral),
      class_of_(problem.size(), kNoClass),
      sense_(problem.size(), 1) {
  for (std::size_t i = 0; i < contacts_; ++i) {
    add_plane(without_multiple(problem.separation_plane(ContactId(i))));
  }
  std::map<IntegerVector3, std::size_t> known;
  for (std::size_t i = 0; i < contacts_; ++i) {
    if (problem.row(ContactId(i)).friction.is_zero()) continue;
    const HomogeneousMotion plane = without_multiple(problem.slip_plane(ContactId(i)));
    IntegerVector3 tangent{plane[0], plane[1], plane[2]};
    if (negated(tangent) < tangent) {
      tangent = negated(tangent);
      sense_[i] = -1;
    }
    const auto [found, is_new] = known.emplace(tangent, classes_.size());
    if (is_new) classes_.push_back({tangent, {}});
    class_of_[i] = found->second;
    classes_[found->second].contacts.push_back(i);
  }
  for (const SlipClass& c : classes_) {
    add_plane({c.tangent[0], c.tangent[1], c.tangent[2], Integer(0)});
  }
  add_plane({Integer(0), Integer(0), Integer(0), Integer(1)});
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      wall_[a][b] = wall_[b][a] = static_cast<PlaneIndex>(planes_.size());
      const IntegerVector3 normal = primitive(cross(corners()[a], corners()[b]));
      add_plane({normal[0], normal[1], normal[2], Integer(0)});
    }
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const IntegerVector3& d = corners()[k];
    corner_[k] = index_of(primitive<4>({d[0], d[1], d[2], Integer(0)}));
  }
  rest_ = index_of({Integer(0), Integer(0), Integer(0), Integer(1)});
}

void MotionRays::add_plane(HomogeneousMotion plane) {
  rows_.push_back(scaled_to_one(plane));
  largest_.push_back(largest_entry_of(plane));
  planes_.push_back(std::move(plane));
}

double MotionRays::value(PlaneIndex p, const HomogeneousMotion& x,
                         const std::array<double, 4>& scaled, const Integer& largest) const {
  const double sum = dot(rows_[p], scaled);
  if (std::fabs(sum) > kValueError) return sum;
  const Integer exact = dot(planes_[p], x);
  if (exact.is_zero()) return 0;
  const double near = std::fabs(to_double(Rational(exact, largest * largest_[p])));
  return exact.sign() * std::clamp(near, DBL_MIN, 2 * kValueError);
}

RayIndex MotionRays::index_of(HomogeneousMotion x) {
  const auto [found, is_new] = index_.emplace(x, static_cast<RayIndex>(rays_.size()));
  if (!is_new) return found->second;
  MotionRay ray;
  const std::array<double, 4> scaled = scaled_to_one(x);
  const Integer largest = largest_entry_of(x);
  ray.h = value(infinity(), x, scaled, largest);
  ray.values.reserve(planes_.size());
  for (PlaneIndex p = 0; p < planes_.size(); ++p) {
    ray.values.push_back(value(p, x, scaled, largest));
  }
  ray.is_free = std::all_of(ray.values.begin(),
                            ray.values.begin() + static_cast<std::ptrdiff_t>(contacts_),
                            [&](double v) { return bilateral_ ? v == 0 : v <= 0; });
  for (std::size_t c = 0; c < classes_.size(); ++c) {
    const std::vector<std::size_t>& contacts = classes_[c].contacts;
    if (ray.values[slip(c)] == 0 &&
        std::any_of(contacts.begin(), contacts.end(),
                    [&](std::size_t i) { return ray.values[separation(i)] > 0; })) {
      ray.sticking.push_back(static_cast<std::uint32_t>(c));
    }
  }
  ray.x = std::move(x);
  rays_.push_back(std::move(ray));
  return found->second;
}

RayIndex MotionRays::between(RayIndex a, RayIndex b, PlaneIndex p) {
  const Integer at_a = dot(planes_[p], rays_[a].x);
  const Integer at_b = dot(planes_[p], rays_[b].x);
  const bool a_above = at_a.sign() > 0;
  HomogeneousMotion x;
  for (std::size_t j = 0; j < 4; ++j) {
    x[j] = a_above ? at_a * rays_[b].x[j] - at_b * rays_[a].x[j]
                   : at_b * rays_[a].x[j] - at_a * rays_[b].x[j];
  }
  return index_of(primitive(std::move(x)));
}

}  // namespace stickslip::resistance_detail
