// SPDX-License-Identifier: GPL-3.0-or-later
#include "still_cell.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "friction_polygon.hpp"
#include "stickslip/core/cancellation.hpp"

namespace stickslip::resistance_detail {
namespace {

void add_to(IntegerVector4& sum, const IntegerVector4& what, int times) {
  for (std::size_t j = 0; j < 4; ++j) sum[j] += times * what[j];
}

}  // namespace

std::optional<PlaneCell> still_cell(const MotionRays& rays, const ModeImages& images) {
  struct Generator {
    IntegerVector3 tangent;
    IntegerVector4 image;  // half of the range over which friction moves the wrench, times 2
  };
  const MotionRay& rest = rays[rays.rest()];
  const auto preload = [&](std::size_t i) {
    return dot(rays.plane(rays.separation(i)), rest.x);
  };
  // All images are times 2, so that the middle between two edges has no fraction.
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
  std::vector<HomogeneousPoint> points;
  if (generators.empty()) add_section({middle}, points);
  for (const Generator& along : generators) {
    throw_if_cancelled();
    std::vector<const Generator*> others;
    std::vector<IntegerVector3> tangents;
    for (const Generator& other : generators) {
      if (&other == &along) continue;
      others.push_back(&other);
      tangents.push_back(other.tangent);
    }
    const std::vector<PolygonStep> steps = half_way_round(tangents, along.tangent);
    IntegerVector4 at = middle;
    for (const auto& [k, end] : steps) add_to(at, others[k]->image, -end);
    for (std::size_t step = 0;; ++step) {
      IntegerVector4 opposite = middle;
      add_to(opposite, middle, 1);
      add_to(opposite, at, -1);
      for (const IntegerVector4& vertex : {at, opposite}) {
        IntegerVector4 low = vertex;
        IntegerVector4 high = vertex;
        add_to(low, along.image, -1);
        add_to(high, along.image, 1);
        add_section({low, high}, points);
      }
      if (step == steps.size()) break;
      add_to(at, others[steps[step].segment]->image, 2 * steps[step].end);
    }
  }
  if (points.empty()) return std::nullopt;
  return PlaneCell::hull(std::move(points));
}

}  // namespace stickslip::resistance_detail
