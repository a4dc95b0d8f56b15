// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// One contact under a claimed motion and force, in the plane and in space alike.
#pragma once

#include "stickslip/core/box.hpp"
#include "stickslip/core/root_sum.hpp"
#include "stickslip/core/row.hpp"

namespace stickslip::crosscheck_detail {

/// Returns a + factor b, of as many coordinates.
RationalRow sum(RationalRow a, const Rational& factor, const RationalRow& b);

/// Returns the largest |entry|; 0 of none.
Rational largest(const RationalRow& row);

/// Returns the largest |coordinate| of a contact, 1 if all are 0: a torque divided by it is
/// like a force.
Rational largest_coordinate(const GraspBox& grasp);

/// Returns the components of one wrench.
RationalRow components(const WrenchBox& wrench);

/// Returns the largest of the components of its force, and of those of its torque over a
/// length.
Rational size_of(const RationalRow& wrench, const Rational& length);

/// A contact of one grasp: normal n of any length L, unit normal n/L.
class ContactGeometry {
 public:
  /// The contact must outlive this.
  explicit ContactGeometry(const UncertainContact& contact);

  /// Returns L^2.
  const Rational& square() const { return square_; }
  /// Returns a force on the object at this contact with its torque about the origin.
  RationalRow wrench_of(const RationalRow& force) const;
  /// Returns how the motion d moves the point of contact.
  RationalRow displacement(const RationalRow& d) const;
  /// Returns the a of v = a n + (a part across n).
  Rational along(const RationalRow& v) const;
  /// Returns the part of v across n.
  RationalRow across(const RationalRow& v) const;
  /// Returns P - k u.(n/L), with u the displacement of the point: the normal force while it is
  /// not negative.
  RootSum separation(const RationalRow& moved) const;
  /// Returns in the plane the sign of v along t, n turned by +90 degrees: of a slip, its sign.
  /// In space returns whether v has a part across n.
  int slip_sign(const RationalRow& v) const;

 private:
  const UncertainContact& contact_;
  RationalRow point_;
  Rational square_;
};

}  // namespace stickslip::crosscheck_detail
