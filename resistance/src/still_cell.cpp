// SPDX-License-Identifier: GPL-3.0-or-later
#include "still_cell.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "stickslip/core/cancellation.hpp"

namespace stickslip::resistance_detail {
namespace {

void add_to(IntegerVector4& sum, const IntegerVector4& what, int times) {
  for (std::size_t j = 0; j < 4; ++j) sum[j] += times * what[j];
}

/// Where edges of the zonotope meet the plane.
class PlaneCrossings {
 public:
  void add_edge(const IntegerVector4& a, const IntegerVector4& b) {
    if (a[2].is_zero()) points_.push_back({a[0], a[1], a[3]});
    if (b[2].is_zero()) points_.push_back({b[0], b[1], b[3]});
    if (a[2].sign() * b[2].sign() >= 0) return;
    const bool a_above = a[2].sign() > 0;
    const IntegerVector4& high = a_above ? a : b;
    const IntegerVector4& low = a_above ? b : a;
    HomogeneousPoint point;
    for (const std::size_t j : {0, 1, 2}) {
      const std::size_t from = j == 2 ? 3 : j;
      point[j] = high[2] * low[from] - low[2] * high[from];
    }
    points_.push_back(std::move(point));
  }

  std::optional<PlaneCell> hull() && {
    if (points_.empty()) return std::nullopt;
    return PlaneCell::hull(std::move(points_));
  }

 private:
  std::vector<HomogeneousPoint> points_;
};

}  // namespace

std::optional<PlaneCell> still_cell(const MotionRays& rays, const ModeImages& images) {
  struct Generator {
    IntegerVector3 tangent;
    IntegerVector4 image;  // half of what friction moves the wrench by, times 2
  };
  const MotionRay& rest = rays[rays.rest()];
  const auto preload = [&](std::size_t i) {
    return dot(rays.plane(rays.separation(i)), rest.x);
  };
  // All is times 2, as is the middle between two edges.
  IntegerVector4 middle = images.exact_at_rest();
  add_to(middle, images.exact_at_rest(), 1);
  std::size_t contacts = rays.slip(0);
  for (std::size_t i = 0; i < contacts; ++i) {
    const Integer v = preload(i);
    for (std::size_t j = 0; j < 3; ++j) {
      middle[j] += v * (images.exact_slipping(i, 0)[j] + images.exact_slipping(i, 1)[j]);
    }
  }
  std::vector<Generator> generators;
  for (const std::uint32_t c : rest.sticking) {
    Generator g{rays.classes()[c].tangent, {}};
    for (const std::size_t i : rays.classes()[c].contacts) {
      const Integer v = rays.sense(i) * preload(i);
      for (std::size_t j = 0; j < 3; ++j) {
        g.image[j] += v * (images.exact_slipping(i, 0)[j] - images.exact_slipping(i, 1)[j]);
      }
    }
    generators.push_back(std::move(g));
  }
  PlaneCrossings crossings;
  if (generators.empty()) crossings.add_edge(middle, middle);
  for (const Generator& along : generators) {
    throw_if_cancelled();
    // Others, as seen along it, turned into one half of the plane and sorted by angle.
    struct Seen {
      const Generator* generator;
      int sign;
      IntegerVector3 side;  // along x tangent, turned
    };
    std::vector<Seen> seen;
    for (const Generator& other : generators) {
      if (&other == &along) continue;
      IntegerVector3 side = cross(along.tangent, other.tangent);
      int sign = 1;
      if (!seen.empty()) {
        sign = dot(seen.front().side, other.tangent).sign();
        if (sign == 0) sign = dot(seen.front().side, side).sign();
        if (sign < 0) side = negated(std::move(side));
      }
      seen.push_back({&other, sign, std::move(side)});
    }
    const auto turn = [](const Seen& a, const Seen& b) {
      return b.sign * dot(a.side, b.generator->tangent).sign();
    };
    std::sort(seen.begin(), seen.end(),
              [&](const Seen& a, const Seen& b) { return turn(a, b) > 0; });
    IntegerVector4 at = middle;
    for (const Seen& other : seen) add_to(at, other.generator->image, -other.sign);
    for (std::size_t k = 0;; ++k) {
      if (k == 0 || k == seen.size() || turn(seen[k - 1], seen[k]) != 0) {
        IntegerVector4 opposite = middle;
        add_to(opposite, middle, 1);
        add_to(opposite, at, -1);
        for (const IntegerVector4& vertex : {at, opposite}) {
          IntegerVector4 low = vertex;
          IntegerVector4 high = vertex;
          add_to(low, along.image, -1);
          add_to(high, along.image, 1);
          crossings.add_edge(low, high);
        }
      }
      if (k == seen.size()) break;
      add_to(at, seen[k].generator->image, 2 * seen[k].sign);
    }
  }
  return std::move(crossings).hull();
}

}  // namespace stickslip::resistance_detail
