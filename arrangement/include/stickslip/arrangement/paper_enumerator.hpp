// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The slip states as the paper enumerates them (Haas-Heger et al., RSS 2018, Section IV.B),
/// step by step, in exact arithmetic. The baseline of Table II; to get slip states use
/// enumerate_slip_states_sweep (sweep.hpp), which is faster and has no exceptions.
///
/// - Step 1 (Algorithm 1): the *regions*, sign vectors in {-1,+1}^m. Planes are added one by
///   one. The open region {s_j n_j.d > 0, j < i} has a component above plane i iff
///       max t  subject to  s_j n_j.d >= t (j < i),  n_i.d >= t,  t <= 1
///   is positive, below with -n_i. An exact LP decides (lp/); d = 0, t = 0 is feasible.
/// - Step 2: the *facets*. Every two regions at Hamming distance 1 are joined by an edge of
///   the dual polyhedron, whose state has a 0 where they differ.
/// - Step 3: the *lines*. The cycles of a minimum cycle basis of that graph, and the symmetric
///   sum of them all as last face. A cycle's state is that of a region on it, with 0 for every
///   plane that one of its edges crosses.
///
/// With no two planes coincident and normals of rank 3 these are the faces, edges and vertices
/// of the arrangement, each once, and all-stick (d = 0) is missing. In a pencil (rank 2) the
/// two vertices, both all-stick, are found as the one basis cycle and the last face. With
/// coincident planes the steps miss cells, and the last face may have a state that no motion
/// has. docs/paper_enumerator.md proves this and gives the cost: O(m^3) LPs, O(m^4)
/// comparisons, and O(m^6) operations of Step 3 for m planes. No step is shortened by a
/// heuristic.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "stickslip/arrangement/slip_states.hpp"

namespace stickslip {

/// The work of the steps. Reproducible: the same planes give the same counts.
struct PaperWork {
  std::size_t linear_programs = 0;  ///< linear programs of Step 1
  std::size_t pivots = 0;           ///< pivots of these, in double precision and exact
  std::size_t pairs_compared = 0;   ///< pairs of regions compared in Step 2
  std::size_t path_searches = 0;    ///< searches of Step 3, one for each basis cycle and region
  std::size_t edges_scanned = 0;    ///< edges scanned in these searches
};

/// A facet: two regions that differ in one plane.
struct PaperFacet {
  std::size_t first = 0;   ///< the index of a region; first < second
  std::size_t second = 0;  ///< the index of the other
  std::size_t plane = 0;   ///< the plane in which they differ
  SlipState state;         ///< the state of both, with 0 for `plane`
};

/// A line: a cycle of the dual, or a sum of cycles.
struct PaperLine {
  std::vector<std::size_t> facets;  ///< the indices of its facets, increasing
  SlipState state;                  ///< its state, from the region of the lowest index on it
};

/// The result of Step 3.
struct PaperLines {
  std::vector<PaperLine> basis;  ///< the cycles of the basis, E - V + components of them
  /// The symmetric sum of the basis; nothing when that is empty.
  std::optional<PaperLine> last;
  bool last_is_one_cycle = false;  ///< otherwise its state depends on the region taken
  std::size_t components = 0;      ///< the components of the dual graph; 1 for a polyhedron

  /// Returns how many lines there are, `last` included.
  std::size_t size() const { return basis.size() + (last ? 1 : 0); }
};

/// The result of the three steps.
struct PaperEnumeration {
  std::vector<SlipState> regions;  ///< the regions, in the order of Algorithm 1
  std::vector<PaperFacet> facets;  ///< the facets, in the order of pairs of regions
  PaperLines lines;                ///< the lines of Step 3
  /// Every state of a region, facet or line once, sorted as SlipStates::states is. All-stick
  /// stands there only if the steps give it.
  std::vector<SlipState> states;
  PaperWork work;  ///< the work of all steps

  /// Returns the paper's #(S): regions, facets and lines, equal states counted apart.
  std::size_t cells() const { return regions.size() + facets.size() + lines.size(); }
};

/// Runs Steps 1 to 3 on the planes as they are given: nothing is merged. Throws ContractError
/// if a normal is zero, or if a check that is made in every build type fails (an LP that is not
/// solved to its optimum, a basis cycle that is not a simple cycle). Deterministic.
PaperEnumeration enumerate_slip_states_paper(const std::vector<Vector3>& plane_normals);

// The steps one by one.

/// Runs Step 1. Counters are added to `work` if it is given, as in the other steps.
std::vector<SlipState> paper_regions(const std::vector<Vector3>& plane_normals,
                                     PaperWork* work = nullptr);
/// Runs Step 2. Requires states of equal length without 0, all different.
std::vector<PaperFacet> paper_facets(const std::vector<SlipState>& regions,
                                     PaperWork* work = nullptr);
/// Runs Step 3. Requires regions and facets as the steps before it made them.
PaperLines paper_lines(const std::vector<SlipState>& regions,
                       const std::vector<PaperFacet>& facets, PaperWork* work = nullptr);

}  // namespace stickslip
