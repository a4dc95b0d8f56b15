// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/arrangement/paper_enumerator.hpp"

#include <boost/graph/connected_components.hpp>
#include <optional>
#include <utility>
#include <variant>

#include "assemble_states.hpp"
#include "paper_cycle_basis.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip {

using arrangement_detail::CycleBasis;
using arrangement_detail::DualPolyhedron;

namespace {

// Step 1: Algorithm 1 of the paper.

/// Returns the row of side n.d - t, over the variables (d, t).
std::vector<Rational> margin_row(const Vector3& normal, Sign side) {
  std::vector<Rational> row(normal.begin(), normal.end());
  if (side == Sign::kNegative) {
    for (Rational& entry : row) entry = -entry;
  }
  row.emplace_back(-1);
  return row;
}

/// Returns whether some d has s_j n_j.d > 0 for the signs of `region`, and side n_i.d > 0 for
/// the plane i that comes next. The largest margin t is bounded by the row t <= 1.
bool has_component(const std::vector<Vector3>& normals, const SlipState& region, Sign side,
                   PaperWork& work) {
  LinearProgram program;
  program.add_variables(4, VariableKind::kFree);
  for (std::size_t j = 0; j < region.size(); ++j) {
    program.add_row(margin_row(normals[j], region[j]), Relation::kGreaterEqual, 0);
  }
  program.add_row(margin_row(normals[region.size()], side), Relation::kGreaterEqual, 0);
  program.add_row({0, 0, 0, 1}, Relation::kLessEqual, 1);
  program.minimize({0, 0, 0, -1});

  LpWork lp_work;
  const LpResult result = solve(program, &lp_work);
  ++work.linear_programs;
  work.pivots += static_cast<std::size_t>(lp_work.double_pivots + lp_work.exact_pivots);
  const Optimal* optimal = std::get_if<Optimal>(&result);
  require(optimal != nullptr, "paper_regions: the margin of a region must have an optimum");
  return optimal->value < 0;
}

// Step 2: all pairs of regions at Hamming distance 1.

/// Returns the place where two states differ, if there is exactly one.
std::optional<std::size_t> only_difference(const SlipState& a, const SlipState& b) {
  std::optional<std::size_t> place;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i]) continue;
    if (place) return std::nullopt;
    place = i;
  }
  return place;
}

// Step 3: lines from a minimum cycle basis of the dual.

DualPolyhedron make_dual(std::size_t regions, const std::vector<PaperFacet>& facets) {
  DualPolyhedron dual(regions);
  for (std::size_t f = 0; f < facets.size(); ++f) {
    boost::add_edge(facets[f].first, facets[f].second, f, dual);
  }
  return dual;
}

/// Returns the line of these edges. Requires at least one edge.
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

/// Returns whether an element of the cycle space is one simple cycle: two edges at each vertex
/// that it meets, and in one piece.
bool is_one_cycle(const std::vector<std::size_t>& edges, std::size_t regions,
                  const std::vector<PaperFacet>& facets) {
  DualPolyhedron graph(regions);
  for (const std::size_t e : edges) {
    boost::add_edge(facets[e].first, facets[e].second, e, graph);
  }
  for (std::size_t v = 0; v < regions; ++v) {
    if (boost::out_degree(v, graph) > 2) return false;
  }
  std::vector<std::size_t> component(regions);
  const std::size_t components = boost::connected_components(graph, component.data());
  // The other vertices are components by themselves.
  return !edges.empty() && components == 1 + regions - edges.size();
}

std::vector<SlipState> distinct_states(const PaperEnumeration& found, std::size_t planes) {
  arrangement_detail::StateList states(planes);
  for (const SlipState& region : found.regions) states.add(region);
  for (const PaperFacet& facet : found.facets) states.add(facet.state);
  for (const PaperLine& line : found.lines.basis) states.add(line.state);
  if (found.lines.last) states.add(found.lines.last->state);
  return states.sorted();
}

}  // namespace

std::vector<SlipState> paper_regions(const std::vector<Vector3>& plane_normals,
                                     PaperWork* work) {
  for (const Vector3& n : plane_normals) {
    require(n[0] != 0 || n[1] != 0 || n[2] != 0,
            "paper_regions: the normal of a plane is zero");
  }
  PaperWork ignored;
  PaperWork& counters = work != nullptr ? *work : ignored;
  std::vector<SlipState> regions(1);
  for (std::size_t i = 0; i < plane_normals.size(); ++i) {
    std::vector<SlipState> split;
    for (const SlipState& region : regions) {
      for (const Sign side : {Sign::kPositive, Sign::kNegative}) {
        if (!has_component(plane_normals, region, side, counters)) continue;
        split.push_back(region);
        split.back().push_back(side);
      }
    }
    regions = std::move(split);
  }
  return regions;
}

std::vector<PaperFacet> paper_facets(const std::vector<SlipState>& regions, PaperWork* work) {
  std::vector<PaperFacet> facets;
  for (std::size_t k = 0; k < regions.size(); ++k) {
    for (std::size_t l = k + 1; l < regions.size(); ++l) {
      if (work != nullptr) ++work->pairs_compared;
      const std::optional<std::size_t> plane = only_difference(regions[k], regions[l]);
      if (!plane) continue;
      facets.push_back({k, l, *plane, regions[k]});
      facets.back().state[*plane] = Sign::kZero;
    }
  }
  return facets;
}

PaperLines paper_lines(const std::vector<SlipState>& regions,
                       const std::vector<PaperFacet>& facets, PaperWork* work) {
  const CycleBasis basis =
      arrangement_detail::minimum_cycle_basis(make_dual(regions.size(), facets));
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
  lines.last_is_one_cycle = is_one_cycle(sum, regions.size(), facets);
  if (!sum.empty()) lines.last = make_line(std::move(sum), regions, facets);
  return lines;
}

PaperEnumeration enumerate_slip_states_paper(const std::vector<Vector3>& plane_normals) {
  PaperEnumeration result;
  result.regions = paper_regions(plane_normals, &result.work);
  result.facets = paper_facets(result.regions, &result.work);
  result.lines = paper_lines(result.regions, result.facets, &result.work);
  result.states = distinct_states(result, plane_normals.size());
  return result;
}

}  // namespace stickslip
