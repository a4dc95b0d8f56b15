// SPDX-License-Identifier: GPL-3.0-or-later
#include "law_cases.hpp"

#include <utility>

namespace stickslip::test {

Direction random_direction(RandomSource& random, bool in_space) {
  if (!in_space) return random.pick<Direction>({{{3, 4}, 5}, {{0, -1}, 1}, {{-12, 5}, 13}});
  return random.pick<Direction>({{{1, -2, 2}, 3}, {{0, 0, 2}, 2}, {{4, 4, -7}, 9}});
}

namespace {

Interval around(RandomSource& random, const Rational& middle, bool is_wide) {
  const Rational half = is_wide ? Rational(random.between(1, 3), 7) : Rational(0);
  return {middle - half, middle + half};
}

UncertainContact contact(RandomSource& random, bool in_space) {
  UncertainContact c;
  for (int j = in_space ? 3 : 2; j > 0; --j) {
    c.position.push_back(around(random, Rational(random.between(-4, 4), 2), random.one_in(2)));
  }
  c.normal = random_direction(random, in_space).normal;
  if (random.one_in(2)) c.slope = Rational(1, 5);
  c.friction = around(random, Rational(1, 2), random.one_in(2));
  c.stiffness = around(random, random.between(1, 3), random.one_in(2));
  c.preload = around(random, random.between(1, 3), random.one_in(2));
  return c;
}

}  // namespace

GraspBox random_law_box(RandomSource& random, bool in_space) {
  GraspBox box;
  for (int i = random.between(1, 3); i > 0; --i)
    box.contacts.push_back(contact(random, in_space));
  for (int j = in_space ? 6 : 3; j > 0; --j) {
    box.wrench.push_back(around(random, random.between(-2, 2), random.one_in(2)));
  }
  box.check();
  return box;
}

MotionRegion random_region(RandomSource& random, const Law& law) {
  MotionRegion region = MotionRegion::root(law);
  for (int cuts = random.between(0, 3); cuts > 0; --cuts) {
    const auto contact = static_cast<std::size_t>(random.between(0, 99)) % law.contacts.size();
    const bool is_certain = law.contacts[contact].geometry_is_certain();
    if (is_certain && random.one_in(3) && !region.is_barred()) {
      std::vector<MotionRegion> children = region.slip_children(contact);
      region = std::move(
          children[static_cast<std::size_t>(random.between(0, 99)) % children.size()]);
    } else {
      Row plane(law.motions + 2);
      for (std::size_t j = 0; j <= law.motions; ++j) plane[j] = random.between(-2, 2);
      if (random.one_in(2)) plane = law.contacts[contact].separations.front();
      if (!is_zero(plane)) region = std::move(region.halves(plane)[random.one_in(4) ? 1 : 0]);
    }
  }
  return region;
}

RationalRow random_row(RandomSource& random, std::size_t size) {
  RationalRow row;
  while (row.size() < size) row.emplace_back(random.between(-9, 9), random.between(1, 4));
  return row;
}

RationalRow moved(const RationalRow& p, const RationalRow& d) {
  if (p.size() == 2) return {d[0] - d[2] * p[1], d[1] + d[2] * p[0]};
  return {d[0] + d[4] * p[2] - d[5] * p[1], d[1] + d[5] * p[0] - d[3] * p[2],
          d[2] + d[3] * p[1] - d[4] * p[0]};
}

RationalRow naive_slip(const NaivePlace& place, const RationalRow& n0, const RationalRow& d) {
  const RationalRow step = moved(place.position, d);
  const RationalRow& n = place.normal;
  if (n.size() == 2) return {n[0] * step[1] - n[1] * step[0]};
  const Rational along = dot(n0, step) / dot(n0, n);
  RationalRow slip = step;
  for (std::size_t j = 0; j < 3; ++j) slip[j] -= along * n[j];
  return slip;
}

}  // namespace stickslip::test
