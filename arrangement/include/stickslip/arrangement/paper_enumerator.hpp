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
/// **Does this give the arrangement?** Let k be the number of distinct circles on the sphere.
/// 1. *No two planes coincide, rank 3 (so m >= 3): always*, concurrent planes included, and
///    whichever minimum cycle basis is found. By the theorem below it consists of faces of the
///    polyhedron. There are F - 1, all but one, and the faces of a polyhedron have one relation
///    over GF(2), their sum: the last face is the one that was missing. Regions, facets and
///    lines are the faces, edges and vertices of the arrangement, each once. All-stick (d = 0)
///    is none of them and is missing, though it is a slip state.
/// 2. *A pencil (rank 2), m >= 2 distinct planes, so every m = 2:* the dual is one cycle of 2m
///    edges. It is the whole basis, and also the last face: the two antipodal vertices of the
///    arrangement, with the same state, all-stick. Counted with multiplicity there are 4m + 2
///    cells, the 10 of Table II for m = 2; distinct states are 4m + 1, there 9.
/// 3. *m = 1:* two regions, one facet, no cycle, so no face to sum up. (E - V + 2 promises one;
///    it is the rest of the sphere around the edge, and no vertex of the arrangement.)
///    *m = 0:* one region. Both agree with the arrangement.
/// 4. *Coincident or opposite planes: never.* Regions on two sides of a plane that m' > 1
///    contacts share are at Hamming distance m', so no edge joins them. The dual falls apart
///    into one component for each region of the shared planes alone. Facets on a shared plane
///    and lines on one are not found; the basis gives exactly the lines on none; the Euler
///    relation that promises one more face does not hold. The sum of all cycles is then either
///    empty or the outlines of several components at once, hence no cycle: read as a face it
///    gives, according to the region one starts from, a state that was found before or one
///    that no motion has. Example: the grasp of the paper's Fig. 4 has four contacts on two
///    lines and gives four isolated regions, so 4 states of 9. Merging coincident planes first
///    (merge_planes) leads back to the cases above.
///
/// **Theorem.** In case 1 every cycle of a minimum cycle basis of the dual is a face.
/// *Notation.* Draw the dual on the sphere: a face f_v around each vertex v of the arrangement,
/// with 2 t_v edges when t_v circles pass through v; t_v < k because the rank is 3. Let Z be a
/// cycle, a Jordan curve, with 2r edges (each circle is crossed an even number of times).
/// *Lemma 1. If Z separates v from -v, then r >= t_v, with equality only for Z = f_v or f_-v.*
///   v and -v cut each circle through them into two arcs, and each arc crosses Z. If that is
///   all, the 2 t_v regions on Z have the same signs on all other planes, so they lie in one
///   convex cone; and they have 2 t_v different signs on the pencil of planes through v, that
///   is all. A convex set that meets all sectors of a pencil meets its axis: a linear form that
///   were positive on the set, and 0 on the axis, would be negative on a whole sector. So v or
///   -v lies in the cone, and Z runs around it.
/// *Lemma 2. If Z separates v from w but neither of them from its antipode, then r >= k.*
///   A circle that Z does not cross lies on one side of Z, say that of v and -v (w is the same
///   in the other case). The other side is connected, avoids the circle, and contains w and -w;
///   but the circle separates those, or passes through them. So Z crosses every circle, at
///   least twice.
/// *Proof.* Let Z be no face. Among the vertices with t_v >= r, none is separated from its
/// antipode (Lemma 1) and no two from one another (Lemma 2, as r <= t_v < k). So all are on one
/// side of Z, and Z is the sum of the faces on the other side, each of fewer than 2r edges. But
/// a cycle that is a sum of shorter ones is in no minimum cycle basis: one of them could take
/// its place. In case 4, Z and the vertices inside it lie in one region of the shared planes,
/// -v outside for each of these v, and Lemma 1 alone leads to the same end.
///
/// For simple arrangements this says that the dual has no 4-cycles but its faces (m >= 3). The
/// paper's own reason, that there are E - V + 1 = F - 1 cycles, is not enough: a minimum cycle
/// basis of a convex polyhedron can leave out two faces for one shorter cycle between them
/// (an example is in the tests). It takes the antipodal symmetry of the dual.
///
/// **Cost** for m planes, V, E = O(m^2) regions and facets. Step 1: two LPs for each region and
/// plane, O(m^3) LPs of 4 variables and at most m + 1 rows: the paper's bound for its two
/// loops. Step 2: V (V - 1) / 2 comparisons, O(m^4) of them; they stop at the second
/// difference. Step 3: de Pina's algorithm as Mehlhorn and Michail state it (the paper's
/// reference [11]), with breadth-first search where unit weights make Dijkstra's superfluous:
/// O(E^3 / 64 + V E^2) in place of the paper's O(E^3 + V E^2 log V), O(m^6) either way. No
/// step is shortened by a heuristic, so that times may be compared.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "stickslip/arrangement/slip_states.hpp"

namespace stickslip {

/// What the steps did. Reproducible: the same planes give the same counts.
struct PaperWork {
  std::size_t linear_programs = 0;  ///< Step 1
  std::size_t pivots = 0;           ///< of these, in double precision and exact
  std::size_t pairs_compared = 0;   ///< Step 2
  std::size_t path_searches = 0;    ///< Step 3: one for each basis cycle and region
  std::size_t edges_scanned = 0;    ///< Step 3: in these searches
};

/// Two regions that differ in one plane.
struct PaperFacet {
  std::size_t first = 0;   ///< index of a region; first < second
  std::size_t second = 0;  ///< index of the other
  std::size_t plane = 0;   ///< the one in which they differ
  SlipState state;         ///< that of both, with 0 for `plane`
};

/// A cycle of the dual, or a sum of cycles.
struct PaperLine {
  std::vector<std::size_t> facets;  ///< indices, increasing
  SlipState state;                  ///< from the region of the lowest index on it
};

/// What Step 3 gives.
struct PaperLines {
  std::vector<PaperLine> basis;  ///< E - V + components of them
  /// The symmetric sum of the basis; nothing when that is empty.
  std::optional<PaperLine> last;
  bool last_is_one_cycle = false;  ///< otherwise its state depends on the region taken
  std::size_t components = 0;      ///< of the dual graph; 1 for a polyhedron

  /// How many lines there are, `last` included.
  std::size_t size() const { return basis.size() + (last ? 1 : 0); }
};

/// What the three steps give.
struct PaperEnumeration {
  std::vector<SlipState> regions;  ///< in the order of Algorithm 1
  std::vector<PaperFacet> facets;  ///< by pairs of regions
  PaperLines lines;                ///< of Step 3
  /// Every state of a region, facet or line once, sorted as SlipStates::states is. All-stick
  /// stands there only if the steps give it.
  std::vector<SlipState> states;
  PaperWork work;  ///< of all steps

  /// The paper's #(S): regions, facets and lines, equal states counted apart.
  std::size_t cells() const { return regions.size() + facets.size() + lines.size(); }
};

/// Steps 1 to 3, on the planes as they are given: nothing is merged. Throws ContractError if a
/// normal is zero, or if a check that is made in every build type fails (an LP that is not
/// solved to its optimum, a basis cycle that is not a simple cycle). Deterministic.
PaperEnumeration enumerate_slip_states_paper(const std::vector<Vector3>& plane_normals);

// The steps one by one.

/// Step 1. Counters are added to `work` if it is given, as in the other steps.
std::vector<SlipState> paper_regions(const std::vector<Vector3>& plane_normals,
                                     PaperWork* work = nullptr);
/// Step 2. Requires states of equal length without 0, all different.
std::vector<PaperFacet> paper_facets(const std::vector<SlipState>& regions,
                                     PaperWork* work = nullptr);
/// Step 3. Requires what the steps before it made.
PaperLines paper_lines(const std::vector<SlipState>& regions,
                       const std::vector<PaperFacet>& facets, PaperWork* work = nullptr);

}  // namespace stickslip
