// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Verdicts about every grasp in a box, with proofs that certificate/FORMAT.md, sections 6 and
/// 7, explain.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/degree/stability_proof.hpp"
#include "stickslip/equilibrium/verdict.hpp"
#include "stickslip/search/search_work.hpp"

namespace stickslip {

/// An equilibrium exists, for every grasp in the box.
struct StableThroughout {
  std::variant<StabilityProof, SpatialWitness> proof;  ///< a witness proves one grasp only
  /// Near an equilibrium of the grasp in the middle, of which the proof is about the first part
  /// or the only one; for people.
  RationalRow motion{};
};
/// No equilibrium exists, for any grasp in the box.
struct UnstableThroughout {
  Trees tree;  ///< the proof
};
/// Two grasps in the box have opposite verdicts.
struct Fragile {
  GraspBox stable;    ///< one grasp of the box
  GraspBox unstable;  ///< another one
};

/// The answer about a box of grasps, which owns its evidence. The grasps of Fragile have
/// certificates of their own.
using BoxVerdict = std::variant<StableThroughout, UnstableThroughout, Fragile, Undecided>;

/// The answer, and what it took.
struct BoxDecision {
  BoxVerdict verdict;            ///< with its evidence
  SearchWork work{};             ///< to find it
  unsigned bits = kDefaultBits;  ///< of the proof
};

/// "stable", "unstable", "fragile", "undecided".
inline const char* name_of(const BoxVerdict& verdict) {
  constexpr const char* kNames[] = {"stable", "unstable", "fragile", "undecided"};
  return kNames[verdict.index()];
}

/// Whether all grasps of the box are stable, or none; nothing if neither is proved.
std::optional<bool> throughout(const BoxDecision& decision);

/// StableThroughout::motion, in space.
Vector6 motion_of(const StableThroughout& stable);

/// Whether every grasp in the box is stable, none is, or some are. Deterministic. Undecided
/// when no proof and no pair of grasps was found within the limits: the verdicts of a box with
/// a threshold on its border, for instance, have neither.
BoxDecision decide_box(const GraspBox& box, NormalLaw law, const SearchOptions& options = {});

/// That one grasp in exact numbers is stable, as prove_by_degree() finds: StableThroughout with
/// one part. Nothing if no proof was found, which says nothing about the verdict.
std::optional<BoxDecision> prove_stable_by_degree(const Problem& problem);

}  // namespace stickslip
