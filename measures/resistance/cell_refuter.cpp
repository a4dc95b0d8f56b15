// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_refuter.hpp"

#include <limits>
#include <utility>

#include "engine/search/exact_region.hpp"
#include "engine/search/law_forces.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip::resistance_detail {
namespace {

LoadHull hull_of(const LoadCell& cell, const WrenchPlane& plane) {
  LoadHull hull;
  for (const HomogeneousPoint& g : cell.closure().generators) {
    const bool at_infinity = is_at_infinity(g);
    const Rational scale = at_infinity ? Rational(1) : Rational(1) / Rational(g[2]);
    const Wrench w = scale * (Rational(g[0]) * plane.u() + Rational(g[1]) * plane.v()) +
                     (at_infinity ? Wrench{} : plane.origin());
    LoadGenerator load{{w.x, w.y, w.torque}, {}};
    for (const LoadFunction& f : cell.strict()) {
      load.strict.push_back(scale * Rational(dot(f, g)));
    }
    (at_infinity ? hull.directions : hull.corners).push_back(std::move(load));
  }
  return hull;
}

}  // namespace

CellRefuter::CellRefuter(const Problem& problem, const WrenchPlane& plane,
                         const RegionProofOptions& options, RegionProofWork& work)
    : plane_(plane),
      options_(options),
      work_(work),
      law_(planar_law(problem.with_wrench({}))),
      root_(MotionRegion::root(law_)) {}

/// Decides a region by the exact linear program.
TreeNode CellRefuter::decide(const MotionRegion& region) {
  ++work_.programs;
  auto found = decide_exactly(law_, region);
  auto* node = std::get_if<TreeNode>(&found);
  require(node != nullptr, "a load outside of all pieces is resisted");
  return std::move(*node);
}

bool CellRefuter::refute(const LoadCell& cell, std::vector<RegionNode>& tree) {
  law_.hull = hull_of(cell, plane_);
  law_.complete_loads();
  SearchWork work;
  const std::size_t limit = options_.node_limit != 0 ? options_.node_limit - work_.nodes
                                                     : std::numeric_limits<std::size_t>::max();
  LawSearch search(law_, nullptr, limit, work);
  search.on_doubt([&](const MotionRegion& region) { return decide(region); });
  Trees found;
  const bool refuted = search.refute(root_, found);
  work_.nodes += work.nodes;
  if (options_.progress) options_.progress(work_);
  if (refuted) tree.insert(tree.end(), found.begin(), found.end());
  return refuted;
}

}  // namespace stickslip::resistance_detail
