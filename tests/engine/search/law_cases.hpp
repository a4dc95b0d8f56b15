// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Boxes of grasps at random, and what mechanics alone says of a contact.
#pragma once

#include "random_grasps.hpp"
#include "stickslip/core/box.hpp"
#include "stickslip/engine/motion_region.hpp"

namespace stickslip::test {

/// A normal of rational length.
struct Direction {
  RationalRow normal;
  Rational length;
};
Direction random_direction(RandomSource& random, bool in_space);

/// 1 to 3 contacts, of which each number is an interval or not, with normals of rational
/// length.
GraspBox random_law_box(RandomSource& random, bool in_space);

/// A region of the law: its root, split at random.
MotionRegion random_region(RandomSource& random, const Law& law);

RationalRow random_row(RandomSource& random, std::size_t size);

/// How far the point p of a body moves: u + omega x p, which in the plane is one about z.
RationalRow moved(const RationalRow& p, const RationalRow& d);

/// A contact with its point and normal.
struct NaivePlace {
  RationalRow position;
  RationalRow normal;
};

/// The slip in the plane along the normal turned left, times its length; in space seen along
/// the normal, in the plane across n0.
RationalRow naive_slip(const NaivePlace& place, const RationalRow& n0, const RationalRow& d);

}  // namespace stickslip::test
