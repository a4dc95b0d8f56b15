// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// One contact under a claimed motion and force, in the plane and in space alike.
#pragma once

#include "stickslip/core/box.hpp"
#include "stickslip/core/root_sum.hpp"
#include "stickslip/core/row.hpp"

namespace stickslip::crosscheck_detail {

/// a + factor b, of as many coordinates.
RationalRow sum(RationalRow a, const Rational& factor, const RationalRow& b);

/// The largest |entry|; 0 of none.
Rational largest(const RationalRow& row);

/// The largest |coordinate| of a contact, 1 if all are 0: a torque divided by it is like a
/// force.
Rational largest_coordinate(const GraspBox& grasp);

/// The components of one wrench.
RationalRow components(const WrenchBox& wrench);

/// The largest of the components of its force, and of those of its torque over a length.
Rational size_of(const RationalRow& wrench, const Rational& length);

/// A contact of one grasp: normal n of any length L, unit normal n/L.
class ContactGeometry {
 public:
  /// The contact must outlive this.
  explicit ContactGeometry(const UncertainContact& contact);

  /// L^2.
  const Rational& square() const { return square_; }
  /// A force on the object at this contact with its torque about the origin.
  RationalRow wrench_of(const RationalRow& force) const;
  /// How the motion d moves the point of contact.
  RationalRow displacement(const RationalRow& d) const;
  /// The a of v = a n + (what is across n).
  Rational along(const RationalRow& v) const;
  /// What of it is across n.
  RationalRow across(const RationalRow& v) const;
  /// P - k u.(n/L), with u how the point is moved: the normal force while it is not negative.
  RootSum separation(const RationalRow& moved) const;
  /// In the plane of t, n turned by +90 degrees, in v: of a slip, its sign. In space whether v
  /// has anything across n.
  int slip_sign(const RationalRow& v) const;

 private:
  const UncertainContact& contact_;
  RationalRow point_;
  Rational square_;
};

}  // namespace stickslip::crosscheck_detail
