// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_cell.hpp"

#include <algorithm>
#include <utility>

namespace stickslip::resistance_detail {
ConvexLoads::ConvexLoads(PlaneCell set)
    : cell(std::move(set)), generators(cell.generators()), sides(cell.sides()) {}

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

/// The common part of both closures is convex. So if no strict function is 0 on all of it, none
/// is 0 at the mean of points, one for each function, at which it is not 0.
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
