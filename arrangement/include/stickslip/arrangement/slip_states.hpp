// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Slip states: the sign vectors of the cells that great circles cut from the sphere of
/// motions (Haas-Heger et al., RSS 2018, Section IV), their counts, and one call for them by
/// any enumerator.
///
/// Cells are not states. Two antipodal cells share a sign vector when the rank is below 3,
/// and the all-stick state (d = 0) lies on no cell of a rank 3 arrangement; it is always a
/// state. With k distinct circles:
///
///     rank  cells               distinct states
///     0     1 (one face)        1
///     1     3 (k = 1)           3
///     2     4k + 2 (a pencil)   4k + 1 = cells - 1: the two vertices are both all-stick
///     3     V + E + F           cells + 1: all-stick is on no cell
///
/// For simple arrangements of rank 3 the cells are 4k(k-1) + 2 (Table II).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "stickslip/arrangement/great_circles.hpp"

namespace stickslip {

/// A slip state: the sign of n_i.d for each plane i, which is +, - or 0 (stick).
using SlipState = std::vector<Sign>;

/// Returns "+0-" or the like, one character a plane.
std::string to_string(const SlipState& state);

/// The counts of the arrangement of the distinct circles on the sphere. A single circle is one
/// closed curve without a vertex: vertices 0, edges 1, faces 2, so that cells = 3. No circle
/// leaves one face. Otherwise vertices - edges + faces = 2.
struct ArrangementCounts {
  std::size_t planes = 0;           ///< m, as they were given
  std::size_t circles = 0;          ///< k, the distinct ones
  int rank = 0;                     ///< the rank of the planes' normals, 0..3
  std::size_t vertices = 0;         ///< V; the paper's lines
  std::size_t edges = 0;            ///< E; the paper's facets
  std::size_t faces = 0;            ///< F; the paper's regions
  std::size_t distinct_states = 0;  ///< sign vectors, all-stick included

  /// Returns the paper's #(S) of Table II.
  std::size_t cells() const { return vertices + edges + faces; }
};

/// The result of an enumeration.
struct SlipStates {
  ArrangementCounts counts;  ///< the counts of the cells and the states
  /// Every slip state once, all-stick included, sorted as their to_string() sorts
  /// ('+' < '-' < '0').
  std::vector<SlipState> states;
};

/// The reference enumerator: CGAL's Arrangement_on_surface_2 on the sphere, in exact
/// arithmetic. Works for any planes, degenerate ones included, none included. O(m^2 log m)
/// exact predicates, O(m^2) states, O(m^3) memory for their signs. Deterministic. Throws
/// ContractError if a normal is zero, or if the arrangement fails one of the checks that are
/// made on it in every build type.
SlipStates enumerate_slip_states_cgal(const std::vector<Vector3>& plane_normals);

/// The enumerators: kAuto is kCgal, the reference, up to kMostContactsForCgal planes, and
/// kSweep beyond.
enum class Enumerator { kAuto, kCgal, kSweep, kPaper };

/// The most planes for which CGAL is taken: up to here it takes some ten milliseconds
/// (bench/README.md).
inline constexpr std::size_t kMostContactsForCgal = 40;

/// The result of an enumerator, and which one it was.
struct Enumeration {
  const char* engine;  ///< the name of the enumerator: "cgal", "sweep" or "paper"
  SlipStates found;    ///< counts; the sweep gives the states only if they are to be listed
};

/// Enumerates the slip states with any enumerator. The three steps of kPaper are reported by
/// the cells that they find: lines as vertices, facets as edges, regions as faces, and
/// all-stick only if a step gives it (paper_enumerator.hpp). `threads` serve the sweep's
/// counts; 0 is one a core. Throws ContractError if a normal is zero.
Enumeration enumerate_slip_states(const std::vector<Vector3>& plane_normals,
                                  Enumerator enumerator, bool list, unsigned threads = 0);

}  // namespace stickslip
