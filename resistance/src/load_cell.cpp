// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_cell.hpp"

#include <algorithm>
#include <utility>

namespace stickslip::resistance_detail {
namespace {

/// d.(x - a), positive in the direction d from the point a.
LoadFunction beyond(const HomogeneousPoint& a, const PlaneDirection& d) {
  return primitive<3>({d[0] * a[2], d[1] * a[2], -(d[0] * a[0] + d[1] * a[1])});
}

/// The closed half-planes of which a cell is the intersection.
std::vector<LoadFunction> sides_of(const PlaneCell& cell) {
  std::vector<LoadFunction> sides;
  const auto add = [&](LoadFunction f) {
    f = primitive(std::move(f));
    if (std::find(sides.begin(), sides.end(), f) == sides.end()) sides.push_back(std::move(f));
  };
  if (cell.dimension() == 2) {
    for (const PlaneEdge& edge : cell.edges()) add(cross(edge.from, edge.to));
    return sides;
  }
  const HomogeneousPoint a = homogeneous(cell.vertices().front());
  PlaneDirection d{1, 0};
  if (!cell.rays().empty()) {
    d = cell.rays().front();
  } else if (cell.dimension() == 1) {
    const HomogeneousPoint b = homogeneous(cell.vertices()[1]);
    d = {b[0] * a[2] - a[0] * b[2], b[1] * a[2] - a[1] * b[2]};
  }
  const LoadFunction across = beyond(a, {-d[1], d[0]});
  add(across);
  add(negated(across));
  if (cell.rays().size() == 2) return sides;  // a line
  add(beyond(a, d));
  if (cell.rays().empty()) {
    add(beyond(homogeneous(cell.vertices().back()), PlaneDirection{-d[0], -d[1]}));
  }
  return sides;
}
}  // namespace

ConvexLoads::ConvexLoads(PlaneCell set)
    : cell(std::move(set)), generators(cell.generators()), sides(sides_of(cell)) {}

LoadSigns ConvexLoads::signs(const LoadFunction& f) const {
  LoadSigns signs;
  for (const HomogeneousPoint& g : generators) {
    const int sign = dot(f, g).sign();
    (sign > 0 ? signs.positive : sign < 0 ? signs.negative : signs.zero) = true;
  }
  return signs;
}

bool ConvexLoads::is_within(const ConvexLoads& other) const {
  return std::none_of(other.sides.begin(), other.sides.end(),
                      [&](const LoadFunction& f) { return signs(f).negative; });
}

LoadCell::LoadCell()
    : closure_(PlaneCell::hull({{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}})) {}

std::optional<LoadCell> LoadCell::part(const LoadFunction& f, bool strictly) const {
  std::optional<PlaneCell> closure = clip(closure_.cell, f);
  if (!closure) return std::nullopt;
  LoadCell part(ConvexLoads(std::move(*closure)), {});
  std::vector<LoadFunction> candidates = strict_;
  if (strictly) candidates.push_back(f);
  for (LoadFunction& g : candidates) {
    const LoadSigns signs = part.closure_.signs(g);
    if (!signs.positive) return std::nullopt;
    if (signs.zero) part.strict_.push_back(std::move(g));
  }
  return part;
}

/// What they have in common is convex: if no strict function is 0 on all of it, none is at the
/// mean of points where one of them is not.
bool LoadCell::meets(const ConvexLoads& other) const {
  std::vector<const LoadFunction*> cuts;
  for (const LoadFunction& f : closure_.sides) {
    const LoadSigns signs = other.signs(f);
    if (!signs.positive && !signs.zero) return false;
    if (signs.negative) cuts.push_back(&f);
  }
  for (const LoadFunction& f : other.sides) {
    const LoadSigns signs = closure_.signs(f);
    if (!signs.positive && !signs.zero) return false;
  }
  std::optional<PlaneCell> common = other.cell;
  for (const LoadFunction* f : cuts) {
    common = clip(*common, *f);
    if (!common) return false;
  }
  const std::vector<HomogeneousPoint> generators = common->generators();
  return std::none_of(strict_.begin(), strict_.end(), [&](const LoadFunction& f) {
    return std::all_of(generators.begin(), generators.end(),
                       [&](const HomogeneousPoint& g) { return dot(f, g).is_zero(); });
  });
}

}  // namespace stickslip::resistance_detail
