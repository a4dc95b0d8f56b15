// SPDX-License-Identifier: GPL-3.0-or-later
#include "answering_forces.hpp"

#include <algorithm>
#include <optional>

namespace stickslip::degree_detail {

Interval preload_at(const LawContact& c, const Rational& multiple) {
  return {c.preload.low + multiple * c.rate.low, c.preload.high + multiple * c.rate.high};
}

void add_wrenches(WrenchRange& sum, const LawContact& c, const RationalRow& friction,
                  const std::vector<Rational>& normal) {
  std::optional<WrenchRange> ends;
  for (const CornerRow& corner : c.corners) {
    const RationalRow across = corner.wrench_of(friction);
    for (const Rational& a : normal) {
      RationalRow wrench = across;
      for (std::size_t k = 0; k < wrench.size(); ++k) wrench[k] += a * corner.normal[k];
      if (!ends) {
        ends.emplace();
        for (const Rational& entry : wrench) ends->push_back(point_interval(entry));
      }
      for (std::size_t k = 0; k < wrench.size(); ++k) {
        (*ends)[k].low = std::min((*ends)[k].low, wrench[k]);
        (*ends)[k].high = std::max((*ends)[k].high, wrench[k]);
      }
    }
  }
  for (std::size_t k = 0; k < sum.size(); ++k) {
    sum[k].low += (*ends)[k].low;
    sum[k].high += (*ends)[k].high;
  }
}

WrenchRange loads_at(const GraspLaw& box, const Rational& multiple) {
  WrenchRange loads;
  for (std::size_t k = 0; k < box.motions; ++k) {
    Row along(box.motions);
    along[k] = 1;
    const Rational most = box.most_load_work(along);
    const Rational least = -box.most_load_work(negated(along));
    const Rational grown = multiple * box.growth[k];
    loads.push_back({least + grown, most + grown});
  }
  return loads;
}

Rational largest(const Interval& interval) {
  return std::max<Rational>(-interval.low, interval.high);
}

Rational length_above(const LawContact& contact, const RationalRow& f) {
  constexpr unsigned kBits = 64;
  return short_sqrt(contact.squared_force(f), kBits).upper;
}

}  // namespace stickslip::degree_detail
