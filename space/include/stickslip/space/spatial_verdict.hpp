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
#include "stickslip/equilibrium/verdict.hpp"
#include "stickslip/search/search_work.hpp"
#include "stickslip/search/tree.hpp"
#include "stickslip/space/spatial_question.hpp"

namespace stickslip {

/// An equilibrium: all other forces follow from it.
struct SpatialWitness {
  Vector6 twist;  ///< the motion d
  /// sigma, with the friction mu a sigma, of contacts that stick; increasing. 0 is left out.
  std::vector<std::pair<ContactId, Vector3>> shares;
};

/// Of every grasp of the box.
using SpatialDegreeProof = DegreeProofOf<6>;

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
  Trees tree;  ///< the proof
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

/// How much to try.
struct SpatialSearchOptions {
  /// Of each tree; 0: one with which an answer takes about a minute at most for 12 contacts.
  std::size_t node_limit = 0;
  /// Of the enclosure of irrational lengths.
  unsigned bits = 128;
};

/// The answer, and what it took.
struct SpatialDecision {
  SpatialVerdict verdict;  ///< with its evidence
  SearchWork work;         ///< to find it
  unsigned bits = 128;     ///< of the proof
};

/// Whether every grasp in the box is stable, none is, or some are. Deterministic. Undecided
/// when no proof and no two grasps that differ were found within the limits; on a threshold
/// there need be neither.
SpatialDecision decide(const SpatialQuestion& question,
                       const SpatialSearchOptions& options = {});

}  // namespace stickslip
