// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Verdicts on grasps in space, with proofs that certificate/FORMAT.md, section 7, explains;
/// and how they are found.
///
/// **Method.** An equilibrium is sought by Newton's method in doubles, and made exact if it has
/// a rational witness; else a parallelepiped around it is proved to hold one by degree. If
/// there is none, a branch and bound over regions of motions refutes them one by one: each by
/// the point of least norm of its wrenches (Wolfe's method), or it is cut where the relaxed
/// equilibrium breaks a law with the most energy. Doubles propose; a leaf is confirmed exactly.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "stickslip/equilibrium/part.hpp"
#include "stickslip/equilibrium/search/degree.hpp"
#include "stickslip/equilibrium/verdict.hpp"
#include "stickslip/space/spatial_question.hpp"

namespace stickslip {

/// An equilibrium: all other forces follow from it.
struct SpatialWitness {
  Vector6 twist;  ///< the motion d
  /// sigma, with the friction mu a sigma, of contacts that stick; increasing. 0 is left out.
  std::vector<std::pair<ContactId, Vector3>> shares;
};

/// Of a slip split two children: s_i = 0, and s_i strict.
using SpatialNode =
    std::variant<SlipSplit, SeparationSplit, PlaneSplitIn<6>, LeafIn<6>, PartSplit>;
/// Trees in preorder, one after another.
using SpatialTrees = std::vector<SpatialNode>;

/// Of every grasp of the box.
using SpatialDegreeProof = DegreeProofIn<6, SpatialNode>;

/// Nothing moves: friction at rest f0 + sum of G_l z_l, with whatever |z_l| <= reach_l balances
/// a grasp of the box (certificate/FORMAT.md, section 6, "Stable: at rest").
struct RestProof {
  /// G of a contact: the friction with which it answers a unit of each component of a wrench.
  struct Answer {
    ContactId contact;              ///< whose friction it is
    std::array<Vector3, 6> forces;  ///< across its normal
  };
  std::vector<std::pair<ContactId, Vector3>> friction;  ///< f0 by contact, increasing
  std::vector<Answer> answers;                          ///< by contact, increasing
  Vector6 reach{};                                      ///< >= 0
};

/// Of every grasp of the box, part by part.
using SpatialParts = PartsIn<SpatialDegreeProof, RestProof>;

/// Whether all parts are proved at rest.
bool are_at_rest(const SpatialParts& parts);

/// An equilibrium exists, for every grasp in the box.
struct SpatiallyStable {
  std::variant<SpatialWitness, SpatialParts> proof;  ///< a witness proves one grasp only
  Vector6 motion;  ///< near an equilibrium of the grasp in the middle; for people
};
/// No equilibrium exists, for any grasp in the box.
struct SpatiallyUnstable {
  SpatialTrees tree;  ///< the proof
};
/// Two grasps in the box have opposite verdicts.
struct SpatiallyFragile {
  SpatialGrasp stable;    ///< a grasp in the box
  SpatialGrasp unstable;  ///< another one
};
/// The answer, which owns its evidence. The grasps of a fragile box have certificates of their
/// own, by decide().
using SpatialVerdict =
    std::variant<SpatiallyStable, SpatiallyUnstable, SpatiallyFragile, Undecided>;

/// "stable", "unstable", "fragile", "undecided".
const char* name_of(const SpatialVerdict& verdict);

/// How many nodes are leaves.
std::size_t leaf_count(const SpatialTrees& trees);

/// How much to try.
struct SpatialSearchOptions {
  /// Of each tree; 0: one with which an answer takes about a minute at most for 12 contacts.
  std::size_t node_limit = 0;
  /// Of the enclosure of irrational lengths.
  unsigned bits = 128;
};

/// What it took; reproducible.
struct SpatialWork {
  std::size_t nodes = 0;         ///< of all trees, whether they were completed or given up
  std::size_t leaves = 0;        ///< that were confirmed
  std::size_t rays = 0;          ///< generators of all regions, lines counted twice
  std::size_t most_rays = 0;     ///< of one region
  std::size_t pairs = 0;         ///< of rays, tested for being neighbours when a plane cut
  std::size_t ray_bits = 0;      ///< of the largest entry of any ray
  std::size_t twist_bits = 0;    ///< of the largest entry of a leaf's twist
  std::size_t filter_hits = 0;   ///< twists that doubles turned down
  std::size_t exact_checks = 0;  ///< of twists, those that doubles could not turn down
  std::size_t proofs = 0;        ///< parallelepipeds tried
  std::size_t examples = 0;      ///< grasps of the box decided one by one
  std::size_t parts = 0;         ///< pieces of the box that were tried

  /// Sums, and the larger of what is the largest.
  SpatialWork& operator+=(const SpatialWork& part);
};

/// The work, by name; the order is that of the members.
std::vector<std::pair<std::string, std::size_t>> counters(const SpatialWork& work);

/// The answer, and what it took.
struct SpatialDecision {
  SpatialVerdict verdict;  ///< with its evidence
  SpatialWork work;        ///< to find it
  unsigned bits = 128;     ///< of the proof
};

/// Whether every grasp in the box is stable, none is, or some are. Deterministic. Undecided
/// when no proof and no two grasps that differ were found within the limits; on a threshold
/// there need be neither.
SpatialDecision decide(const SpatialQuestion& question,
                       const SpatialSearchOptions& options = {});

}  // namespace stickslip
