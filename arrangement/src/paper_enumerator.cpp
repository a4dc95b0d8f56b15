// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/arrangement/paper_enumerator.hpp"

#include <algorithm>

namespace stickslip {
namespace {

bool text_less(const SlipState& a, const SlipState& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                      [](Sign x, Sign y) { return to_char(x) < to_char(y); });
}

std::vector<SlipState> distinct_states(const PaperEnumeration& found) {
  std::vector<SlipState> states = found.regions;
  for (const PaperFacet& facet : found.facets) states.push_back(facet.state);
  for (const PaperLine& line : found.lines.basis) states.push_back(line.state);
  if (found.lines.last) states.push_back(found.lines.last->state);
  std::sort(states.begin(), states.end(), text_less);
  states.erase(std::unique(states.begin(), states.end()), states.end());
  return states;
}

}  // namespace

PaperEnumeration enumerate_slip_states_paper(const std::vector<Vector3>& plane_normals) {
  PaperEnumeration result;
  result.regions = paper_regions(plane_normals, &result.work);
  result.facets = paper_facets(result.regions, &result.work);
  result.lines = paper_lines(result.regions, result.facets, &result.work);
  result.states = distinct_states(result);
  return result;
}

}  // namespace stickslip
