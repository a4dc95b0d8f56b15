// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/arrangement/slip_states.hpp"

#include <utility>

#include "stickslip/arrangement/paper_enumerator.hpp"
#include "stickslip/arrangement/sweep.hpp"

namespace stickslip {
namespace {

SlipStates by_the_paper(const std::vector<Vector3>& planes) {
  const GreatCircles circles = merge_planes(planes);
  PaperEnumeration paper = enumerate_slip_states_paper(planes);
  SlipStates result;
  result.counts = {planes.size(),      circles.normals.size(), circles.rank,
                   paper.lines.size(), paper.facets.size(),    paper.regions.size(),
                   paper.states.size()};
  result.states = std::move(paper.states);
  return result;
}

}  // namespace

std::string to_string(const SlipState& state) {
  std::string text;
  text.reserve(state.size());
  for (const Sign sign : state) text.push_back(to_char(sign));
  return text;
}

Enumeration enumerate_slip_states(const std::vector<Vector3>& plane_normals,
                                  Enumerator enumerator, bool list, unsigned threads) {
  if (enumerator == Enumerator::kAuto) {
    enumerator =
        plane_normals.size() <= kMostContactsForCgal ? Enumerator::kCgal : Enumerator::kSweep;
  }
  if (enumerator == Enumerator::kCgal) {
    return {"cgal", enumerate_slip_states_cgal(plane_normals)};
  }
  if (enumerator == Enumerator::kPaper) return {"paper", by_the_paper(plane_normals)};
  if (list) return {"sweep", enumerate_slip_states_sweep(plane_normals)};
  return {"sweep", {count_cells(plane_normals, threads), {}}};
}

}  // namespace stickslip
