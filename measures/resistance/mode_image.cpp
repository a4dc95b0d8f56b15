// SPDX-License-Identifier: GPL-3.0-or-later
#include "mode_image.hpp"

#include <algorithm>

#include "stickslip/core/error.hpp"

namespace stickslip::resistance_detail {
namespace {

/// (d, h) of a row of Problem.
Rational largest_of(const Vector5& row) {
  Rational largest = 0;
  for (const Rational& entry : row) largest = std::max<Rational>(largest, abs(entry));
  return largest;
}

}  // namespace

HomogeneousPoint crossing(const IntegerVector4& above, const IntegerVector4& below) {
  HomogeneousPoint point;
  for (const std::size_t j : {0, 1, 2}) {
    const std::size_t from = j == 2 ? 3 : j;
    point[j] = above[2] * below[from] - below[2] * above[from];
  }
  return point;
}

void add_section(const std::vector<IntegerVector4>& images,
                 std::vector<HomogeneousPoint>& points) {
  for (const IntegerVector4& a : images) {
    if (a[2].is_zero() && !is_zero(a)) points.push_back({a[0], a[1], a[3]});
    for (const IntegerVector4& b : images) {
      if (a[2].sign() > 0 && b[2].sign() < 0) points.push_back(crossing(a, b));
    }
  }
}

ModeImages::ModeImages(const Problem& problem, const WrenchPlane& plane, MotionRays& rays)
    : rays_(rays), contacts_(problem.size()) {
  const Vector4 nothing = plane.coordinates({0, 0, 0}, 1);
  no_wrench_ = primitive_multiple(nothing);
  std::vector<Vector4> exact;
  Integer factor = 1;
  const auto include_in_factor = [&](const Vector4& v) {
    for (const Rational& entry : v) factor = lcm(factor, denominator(entry));
  };
  include_in_factor(nothing);
  for (std::size_t i = 0; i < contacts_; ++i) {
    const ContactId contact(i);
    const Vector5& row = problem.separation(contact);
    const Rational largest = largest_of(row);
    Integer in_plane = 0;
    for (const Integer& entry : rays.plane(rays.separation(i))) {
      in_plane = std::max<Integer>(in_plane, abs(entry));
    }
    for (const int sigma : {-1, 1}) {
      const Vector3 edge = coordinates(Rational(-1) * problem.edge_wrench(contact, sigma));
      const Vector4 per_unit = plane.coordinates(edge, 0);
      std::array<NearNumber, 3> near;
      Vector4 scaled;
      for (std::size_t j = 0; j < 3; ++j) near[j] = near_number(largest * per_unit[j]);
      for (std::size_t j = 0; j < 4; ++j)
        scaled[j] = largest / Rational(in_plane) * per_unit[j];
      slipping_.push_back(near);
      include_in_factor(scaled);
      exact.push_back(std::move(scaled));
    }
  }
  const auto in_integers = [&](const Vector4& v) {
    IntegerVector4 result;
    for (std::size_t j = 0; j < 4; ++j) {
      result[j] = numerator(v[j]) * (factor / denominator(v[j]));
    }
    return result;
  };
  for (std::size_t j = 0; j < 3; ++j) at_rest_[j] = near_number(nothing[j]);
  exact_at_rest_ = in_integers(nothing);
  for (const Vector4& v : exact) exact_slipping_.push_back(in_integers(v));
}

template <class Add>
void ModeImages::for_each_force(const Generator& g, Add add) const {
  const MotionRay& ray = rays_[g.ray];
  for (std::size_t i = 0; i < contacts_; ++i) {
    if (!(ray.values[rays_.separation(i)] > 0)) continue;
    int slip = 1;
    if (const std::size_t c = rays_.class_of(i); c != MotionRays::kNoClass) {
      const double value = ray.values[rays_.slip(c)];
      if (value != 0) {
        slip = value > 0 ? 1 : -1;
      } else {
        const auto found = std::lower_bound(ray.sticking.begin(), ray.sticking.end(), c);
        slip = g.signs[static_cast<std::size_t>(found - ray.sticking.begin())];
      }
      slip *= rays_.sense(i);
    }
    add(i, slip > 0 ? 0 : 1);
  }
}

GeneratorIndex ModeImages::index_of(RayIndex ray, const FrictionSigns& signs) {
  const auto [found, is_new] = index_.emplace(std::make_pair(ray, signs),
                                              static_cast<GeneratorIndex>(generators_.size()));
  if (!is_new) return found->second;
  require(signs.size() == rays_[ray].sticking.size(), "a sign for each contact that sticks");
  Generator g{ray, signs, {}, std::nullopt};
  const MotionRay& motion = rays_[ray];
  const NearNumber h{motion.h, motion.h == 0 ? 0 : kValueError};
  for (std::size_t j = 0; j < 3; ++j) g.estimate[j] = at_rest_[j] * h;
  g.estimate[3] = h;
  for_each_force(g, [&](std::size_t i, int k) {
    const NearNumber v{motion.values[rays_.separation(i)], kValueError};
    for (std::size_t j = 0; j < 3; ++j) {
      g.estimate[j] = g.estimate[j] + slipping(i, k)[j] * v;
    }
  });
  generators_.push_back(std::move(g));
  return found->second;
}

const IntegerVector4& ModeImages::exact(GeneratorIndex index) {
  Generator& g = generators_[index];
  if (g.exact) return *g.exact;
  ++exact_images_;
  const HomogeneousMotion& x = rays_[g.ray].x;
  IntegerVector4 sum;
  for (std::size_t j = 0; j < 4; ++j) sum[j] = x[3] * exact_at_rest_[j];
  for_each_force(g, [&](std::size_t i, int k) {
    const Integer v = dot(rays_.plane(rays_.separation(i)), x);
    for (std::size_t j = 0; j < 3; ++j) sum[j] += v * exact_slipping(i, k)[j];
  });
  g.exact = primitive(std::move(sum));
  return *g.exact;
}

int ModeImages::side(GeneratorIndex g) {
  if (const std::optional<int> sign = estimate(g)[2].sign()) return *sign;
  return exact(g)[2].sign();
}

}  // namespace stickslip::resistance_detail
