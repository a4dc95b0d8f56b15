// SPDX-License-Identifier: GPL-3.0-or-later
#include "friction_disc.hpp"

#include <algorithm>
#include <cmath>

#include "stickslip/core/error.hpp"
#include "stickslip/core/integer_vector.hpp"
#include "stickslip/core/snap.hpp"
#include "stickslip/core/spatial_forces.hpp"

namespace stickslip::earlier_detail {
namespace {

constexpr unsigned kBits = 40;
const Rational kNarrowest = Rational(1, 1 << 20);

Vector3 times(const Rational& factor, const Vector3& v) {
  return plus(Vector3{}, factor, v);
}

/// Returns a vector across n; a unit vector if |n| is rational. The reflection that takes z to
/// n takes x there.
Vector3 across(const Vector3& n, const std::optional<Rational>& length) {
  if (!length) return n[0].is_zero() ? Vector3{1, 0, 0} : Vector3{n[1], -n[0], 0};
  const Vector3 h = plus(n, -*length, {0, 0, 1});
  const Rational square = dot(h, h);
  if (square.is_zero()) return {1, 0, 0};
  return plus(Vector3{1, 0, 0}, -2 * h[0] / square, h);
}

}  // namespace

Rational rational_length(const UncertainContact& contact, std::size_t index) {
  const Rational square = dot(contact.normal, contact.normal);
  const std::optional<Rational> length = exact_sqrt(square);
  if (length) return *length;
  throw InputError("", "contacts[" + std::to_string(index) + "].normal",
                   "this method needs its length, which is the irrational sqrt(" +
                       to_readable_string(square) + ")",
                   kSnapRemedy);
}

Rational preload_over_length(const UncertainContact& contact, std::size_t index) {
  const Rational& preload = contact.preload.low;
  return preload.is_zero() ? preload : Rational(preload / rational_length(contact, index));
}

FrictionDisc::FrictionDisc(const UncertainContact& contact) : normal_(vector3(contact.normal)) {
  for (std::size_t j = 0; j < 3; ++j) point_[j] = contact.position[j].low;
  row_ = wrench(normal_);
  const Rational squared_length = dot(normal_, normal_);
  square_ = contact.friction.low * contact.friction.low * squared_length;
  const std::optional<Rational> exact = exact_sqrt(squared_length);
  length_ = exact ? *exact : rational_in_bits(std::sqrt(to_double(squared_length)), 16);
  e_ = across(normal_, exact);
  for (std::set<Rational>& quarter : tangents_) {
    for (int k = 0; k < 4; ++k) quarter.insert(Rational(k, 4));
  }
}

Vector6 FrictionDisc::wrench(const Vector3& force) const {
  const Vector3 torque = cross(point_, force);
  return {force[0], force[1], force[2], torque[0], torque[1], torque[2]};
}

Vector3 FrictionDisc::slip(const Vector6& motion) const {
  const Vector3 u = displacement(point_, {motion.begin(), motion.end()});
  return plus(u, -dot(normal_, u) / dot(normal_, normal_), normal_);
}

bool FrictionDisc::presses_like(const FrictionDisc& other) const {
  return primitive_multiple(row_) == primitive_multiple(other.row_);
}

bool FrictionDisc::slips_like(const FrictionDisc& other) const {
  return point_ == other.point_ && presses_like(other);
}

Vector3 FrictionDisc::direction(std::size_t quarter, const Rational& t) const {
  Vector3 d = plus(times(1 - t * t, e_), 2 * t / length_, cross(normal_, e_));
  for (std::size_t k = 0; k < quarter % 4; ++k) d = times(1 / length_, cross(normal_, d));
  return d;
}

Sector FrictionDisc::near(const Vector3& tangent) const {
  constexpr double kRight = 1.5707963267948966;
  const double angle = std::atan2(to_double(dot(tangent, cross(normal_, e_)) / length_),
                                  to_double(dot(tangent, e_)));
  const double turns = std::floor(angle / kRight);
  const double half = std::min(1.0, std::max(0.0, std::tan((angle - turns * kRight) / 2)));
  const Rational t = rational_in_bits(half, 30);
  return {static_cast<std::size_t>(turns + 4) % 4, t, t};
}

/// Returns a point along d on the circle, or a little inside of it.
Vector3 FrictionDisc::on_circle(const Vector3& d) const {
  return times(short_sqrt(square_ / dot(d, d), kBits).lower, d);
}

/// Returns the point where lines meet that touch the circle at these directions, or pass it
/// outside.
Vector3 FrictionDisc::corner(const Vector3& before, const Vector3& after) const {
  const Rational a = dot(before, before);
  const Rational b = dot(before, after);
  const Rational c = dot(after, after);
  const Rational first = short_sqrt(square_ * a, kBits).upper;
  const Rational second = short_sqrt(square_ * c, kBits).upper;
  const Rational determinant = a * c - b * b;
  return plus(times((c * first - b * second) / determinant, before),
              (a * second - b * first) / determinant, after);
}

std::vector<Vector3> FrictionDisc::outer() const {
  if (!has_friction()) return {{}};
  std::vector<Vector3> directions;
  for (std::size_t q = 0; q < 4; ++q) {
    for (const Rational& t : tangents_[q]) directions.push_back(direction(q, t));
  }
  std::vector<Vector3> result;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    result.push_back(corner(directions[k], directions[(k + 1) % directions.size()]));
  }
  return result;
}

std::vector<Vector3> FrictionDisc::inner() const {
  if (!has_friction()) return {{}};
  std::vector<Vector3> result;
  for (std::size_t q = 0; q < 4; ++q) {
    for (const Rational& t : tangents_[q]) result.push_back(on_circle(direction(q, t)));
  }
  for (const Vector3& more : more_corners_) result.push_back(on_circle(more));
  return result;
}

std::vector<Vector3> FrictionDisc::directions(const Sector& sector) const {
  std::vector<Vector3> result{direction(sector.quarter, sector.low)};
  for (const Rational& t : tangents_[sector.quarter]) {
    if (sector.low < t && t < sector.high) result.push_back(direction(sector.quarter, t));
  }
  result.push_back(direction(sector.quarter, sector.high));
  return result;
}

std::vector<Vector3> FrictionDisc::outer_against(const std::vector<Vector3>& directions) const {
  if (!has_friction()) return {{}};
  std::vector<Vector3> result;
  for (std::size_t k = 0; k + 1 < directions.size(); ++k) {
    result.push_back(corner(directions[k], directions[k + 1]));
  }
  for (const Vector3& end : {directions.front(), directions.back()}) {
    result.push_back(on_circle(end));
    const Rational square = dot(end, end);
    const Vector3 beyond = times(short_sqrt(square_ * square, kBits).upper / square, end);
    if (beyond != result.back()) result.push_back(beyond);
  }
  for (Vector3& f : result) f = times(-1, f);
  return result;
}

std::optional<Vector3> FrictionDisc::against(const Vector3& d) const {
  const std::optional<Rational> factor = exact_sqrt(square_ / dot(d, d));
  if (!factor) return std::nullopt;
  return times(-*factor, d);
}

bool FrictionDisc::refine(const Vector3& friction) {
  const Sector there = near(friction);
  std::set<Rational>& quarter = tangents_[there.quarter];
  const auto after = quarter.upper_bound(there.low);
  const Rational high = after == quarter.end() ? Rational(1) : *after;
  const Rational low = *std::prev(after);
  if (high - low <= kNarrowest) return false;
  quarter.insert((low + high) / 2);
  return true;
}

void FrictionDisc::add_corner(const Vector3& friction) {
  const IntegerVector3 d = primitive_multiple(friction);
  if (!is_zero(d)) more_corners_.push_back({Rational(d[0]), Rational(d[1]), Rational(d[2])});
}

}  // namespace stickslip::earlier_detail
