// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The fast engine: branch and bound over regions of motions instead of an enumeration of
/// states.
///
/// A node is a region (region.hpp). A virtual twist that satisfies leaf-bound closes it; it is
/// sought in double precision as the point of least norm of the wrenches that the region can
/// produce (Wolfe, "Finding the nearest point in a polytope", 1976; Gilbert, Johnson, Keerthi,
/// 1988), rounded to small integers, and confirmed by doubles with error bounds, or exactly
/// where these do not decide. If there is none, the combination of wrenches that vanishes is a
/// relaxed equilibrium; the contact that breaks the laws the most is split by its slip or
/// separation plane. Candidates for an equilibrium are completed exactly and verified by
/// substitution. When nothing is left to split, or double precision fails, the exact linear
/// program of region_program.hpp decides. Where the tree grows beyond a few dozen nodes and
/// Newton's method from rest had come to a balance, the motions near that are searched first.
///
/// Contacts are taken in groups that are alike, and in groups of these: where all of a group
/// are open, closed, or slip in one direction on a region, that is found and added up at once,
/// by boxes around the coefficients of their functions with bounds of what is rounded. The
/// search takes the best edges in the middle of a group for those of all of it; where that
/// leads nowhere it is done again precisely, and it only proposes.
///
/// *Guarantee.* Only planes that cut a region's relative interior are split (or touch it where
/// no strict function bars touching), each at most once on a path, so the leaves other than
/// void ones are no more than the cells of the arrangement of the 2m planes tau_i = 0, v_i = 0
/// in Q^4, which is O(m^3), whatever the heuristics propose; and at a region that no plane cuts
/// the exact program has no relaxation left. No tolerance decides a verdict.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "stickslip/engine/search_options.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// The work of the engine, by counters; reproducible.
struct BranchWork {
  /// The regions looked at, without those in the search near a balance of Newton's method.
  std::size_t nodes = 0;
  std::size_t leaves = 0;             ///< virtual-work leaves
  std::size_t voids = 0;              ///< void leaves
  std::size_t slip_splits = 0;        ///< nodes split by slip, into three children
  std::size_t separation_splits = 0;  ///< nodes split by separation, into two
  std::size_t depth = 0;              ///< the depth of the deepest node
  std::size_t searches = 0;           ///< searches for a virtual twist in double precision
  std::size_t support_points = 0;  ///< evaluations of the bounds on all rays in these searches
  /// The groups of contacts, and single contacts, that were looked at, summed over the nodes:
  /// what the nodes cost. It would be nodes * m if contacts were not taken in groups.
  std::size_t visits = 0;
  std::size_t filter_hits = 0;         ///< leaves confirmed by doubles with error bounds
  std::size_t filter_misses = 0;       ///< leaves confirmed exactly
  std::size_t exact_programs = 0;      ///< exact linear programs
  std::size_t witness_attempts = 0;    ///< candidates for an equilibrium completed exactly
  std::size_t largest_twist_bits = 0;  ///< the bits of the largest integer in a leaf

  /// Adds the counters of another search; depth and bits become the larger ones.
  BranchWork& operator+=(const BranchWork& part);
};

/// Returns the counters with their names, in a fixed order.
std::vector<std::pair<std::string, std::size_t>> counters(const BranchWork& work);

/// Returns the verdict with its evidence, and puts the work into `work`. Undecided only when
/// the node limit is reached. Deterministic. Requires that the problem is no family.
Verdict branch_and_bound(const Problem& problem, const SearchOptions& options = {},
                         BranchWork* work = nullptr);

/// Returns some equilibria with different motions, which Newton's method finds from `starts`
/// motions. There is none if the grasp is unstable; there may be none, too, if it is stable.
/// Deterministic.
std::vector<Witness> find_equilibria(const Problem& problem, std::size_t starts);

/// An equilibrium of one member of a family.
struct MarginPoint {
  Rational multiple;  ///< l
  Witness witness;    ///< for that multiple
};

/// Returns a multiple in the family's range for which the grasp is stable, or a proof that
/// there is none. It is the same search with the multiple as one more unknown. Undecided only
/// when the node limit is reached.
std::variant<MarginPoint, Unstable, Undecided> search_family(const Problem& family,
                                                             const SearchOptions& options = {},
                                                             BranchWork* work = nullptr);

}  // namespace stickslip
