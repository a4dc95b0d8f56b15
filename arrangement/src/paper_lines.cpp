// SPDX-License-Identifier: GPL-3.0-or-later
// Step 3 of the paper: lines from a minimum cycle basis of the dual.
#include <algorithm>
#include <utility>

#include "paper_cycle_basis.hpp"
#include "stickslip/arrangement/paper_enumerator.hpp"

namespace stickslip {
namespace {

DualPolyhedron make_dual(std::size_t regions, const std::vector<PaperFacet>& facets) {
  DualPolyhedron dual(regions);
  for (std::size_t f = 0; f < facets.size(); ++f) {
    boost::add_edge(facets[f].first, facets[f].second, f, dual);
  }
  return dual;
}

/// Requires at least one edge.
PaperLine make_line(std::vector<std::size_t> edges, const std::vector<SlipState>& regions,
                    const std::vector<PaperFacet>& facets) {
  // Facets are ordered by their first region, the lower of the two.
  PaperLine line{std::move(edges), {}};
  line.state = regions[facets[line.facets.front()].first];
  for (const std::size_t f : line.facets) line.state[facets[f].plane] = Sign::kZero;
  return line;
}

std::vector<std::size_t> symmetric_sum(const std::vector<std::vector<std::size_t>>& cycles,
                                       std::size_t edge_count) {
  std::vector<bool> is_in_sum(edge_count, false);
  for (const std::vector<std::size_t>& cycle : cycles) {
    for (const std::size_t e : cycle) is_in_sum[e] = !is_in_sum[e];
  }
  std::vector<std::size_t> sum;
  for (std::size_t e = 0; e < edge_count; ++e) {
    if (is_in_sum[e]) sum.push_back(e);
  }
  return sum;
}

/// Whether an element of the cycle space is one simple cycle: walks once around from an edge.
bool is_one_cycle(const std::vector<std::size_t>& edges,
                  const std::vector<PaperFacet>& facets) {
  if (edges.empty()) return false;
  std::vector<bool> is_used(edges.size(), false);
  std::size_t steps = 0;
  const std::size_t start = facets[edges.front()].first;
  std::size_t here = start;
  do {
    std::size_t incident = 0;
    std::size_t way_out = edges.size();
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const PaperFacet& facet = facets[edges[i]];
      if (facet.first != here && facet.second != here) continue;
      ++incident;
      if (!is_used[i]) way_out = i;
    }
    if (incident != 2 || way_out == edges.size()) return false;
    is_used[way_out] = true;
    ++steps;
    const PaperFacet& facet = facets[edges[way_out]];
    here = facet.first == here ? facet.second : facet.first;
  } while (here != start);
  return steps == edges.size();
}

}  // namespace

PaperLines paper_lines(const std::vector<SlipState>& regions,
                       const std::vector<PaperFacet>& facets, PaperWork* work) {
  const CycleBasis basis = minimum_cycle_basis(make_dual(regions.size(), facets));
  if (work != nullptr) {
    work->path_searches += basis.path_searches;
    work->edges_scanned += basis.edges_scanned;
  }
  PaperLines lines;
  lines.components = basis.components;
  for (const std::vector<std::size_t>& cycle : basis.cycles) {
    lines.basis.push_back(make_line(cycle, regions, facets));
  }
  std::vector<std::size_t> sum = symmetric_sum(basis.cycles, facets.size());
  lines.last_is_one_cycle = is_one_cycle(sum, facets);
  if (!sum.empty()) lines.last = make_line(std::move(sum), regions, facets);
  return lines;
}

}  // namespace stickslip
