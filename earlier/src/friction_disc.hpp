// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A contact in space, and the disc of its friction between polygons.
#pragma once

#include <array>
#include <optional>
#include <set>
#include <vector>

#include "stickslip/core/box.hpp"

namespace stickslip::earlier_detail {

/// Returns a + factor b.
template <std::size_t n>
std::array<Rational, n> plus(std::array<Rational, n> a, const Rational& factor,
                             const std::array<Rational, n>& b) {
  for (std::size_t j = 0; j < n; ++j) a[j] += factor * b[j];
  return a;
}

/// The force of one contact in space: a N + (f, p x f).
struct SpatialContactForce {
  Rational normal{0};  ///< a >= 0, the force over |n|
  Vector3 friction{};  ///< f, orthogonal to n
};
/// The forces by ContactId.
using SpatialForces = std::vector<SpatialContactForce>;

/// A range of directions of slip of a contact: e turned by `quarter` right angles, and on by 2
/// atan t for 0 <= low <= t <= high <= 1.
struct Sector {
  std::size_t quarter = 0;
  Rational low = 0;
  Rational high = 1;
};

/// Returns |n| of a contact whose numbers are certain. Throws InputError ("contacts[i].normal")
/// if that is irrational.
Rational rational_length(const UncertainContact& contact, std::size_t index);
/// Returns P / |n|, which is 0 whatever the length if P is. Else throws as rational_length()
/// does.
Rational preload_over_length(const UncertainContact& contact, std::size_t index);

class FrictionDisc {
 public:
  explicit FrictionDisc(const UncertainContact& contact);

  const Vector6& normal_row() const { return row_; }  ///< N
  Vector6 wrench(const Vector3& force) const;         ///< (f, p x f)
  Vector3 slip(const Vector6& motion) const;          ///< S d
  const Vector3& normal() const { return normal_; }   ///< n
  /// Returns true if the normals have one line of action, and one direction.
  bool presses_like(const FrictionDisc& other) const;
  /// Returns true if the slips are the same, too.
  bool slips_like(const FrictionDisc& other) const;
  bool has_friction() const { return !square_.is_zero(); }  ///< mu > 0
  const Rational& square() const { return square_; }        ///< (mu |n|)^2

  /// Returns e turned that far, about n; its length is rational if |n| is.
  Vector3 direction(std::size_t quarter, const Rational& t) const;
  /// Returns roughly the place of a vector in the tangent plane: its quarter, and t as both
  /// ends.
  Sector near(const Vector3& tangent) const;

  /// Returns the corners of a polygon around the disc of friction (for a = 1), or in it.
  std::vector<Vector3> outer() const;
  std::vector<Vector3> inner() const;
  /// Returns the sides of a sector, and the directions between them at which polygons touch, in
  /// their order.
  std::vector<Vector3> directions(const Sector& sector) const;
  /// Returns the corners of a polygon around all friction against slips between the first and
  /// the last of these.
  std::vector<Vector3> outer_against(const std::vector<Vector3>& directions) const;
  /// Returns the friction against a slip along d, if that is rational.
  std::optional<Vector3> against(const Vector3& d) const;

  /// Adds a corner near the direction of this force. Returns false if there are enough.
  bool refine(const Vector3& friction);
  /// Adds a corner of the inner polygon in the direction of this force.
  void add_corner(const Vector3& friction);

 private:
  Vector3 on_circle(const Vector3& d) const;
  Vector3 corner(const Vector3& before, const Vector3& after) const;

  Vector3 point_;
  Vector3 normal_;
  Vector6 row_;
  Rational square_;
  Rational length_;  ///< |n|, or near it
  Vector3 e_;
  std::array<std::set<Rational>, 4> tangents_;  ///< by quarter: t of the points of contact
  std::vector<Vector3> more_corners_;
};

}  // namespace stickslip::earlier_detail
