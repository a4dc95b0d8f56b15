// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Verdicts about every grasp in a box, with proofs that certificate/FORMAT.md, section 6,
/// explains; and how they are found.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "stickslip/box/parameter_box.hpp"
#include "stickslip/equilibrium/decide.hpp"
#include "stickslip/search/search_work.hpp"
#include "stickslip/search/tree.hpp"

namespace stickslip {

/// Of every grasp of a part of the box.
using DegreeProof = DegreeProofOf<3>;

/// Cuts and proofs in preorder.
using StabilityProof = PartsIn<DegreeProof>;

/// Stable for every grasp in the box.
struct StableThroughout {
  StabilityProof parts;  ///< the proof
};
/// Unstable for every grasp in the box.
struct UnstableThroughout {
  Trees tree;  ///< the proof
};
/// Two grasps in the box have opposite verdicts.
struct Fragile {
  LoadedGrasp stable;    ///< a grasp in the box
  LoadedGrasp unstable;  ///< another one
};
/// The answer about a box, which owns its evidence. The grasps of Fragile have certificates of
/// their own, by decide() or, with normals of irrational length, decide_box().
using BoxVerdict = std::variant<StableThroughout, UnstableThroughout, Fragile, Undecided>;

/// "stable", "unstable", "fragile", "undecided".
const char* name_of(const BoxVerdict& verdict);

/// How much to try.
struct BoxOptions {
  std::size_t node_limit = 0;  ///< of each tree search; 0: one that suits most questions
  /// Of the enclosure of irrational lengths: doubled from this until there is an answer, to the
  /// limit.
  unsigned bits = ParameterBox::kDefaultBits;
  unsigned most_bits = 1024;  ///< the limit
};

/// The answer, and what it took.
struct BoxDecision {
  BoxVerdict verdict;                          ///< with its evidence
  SearchWork work;                             ///< to find it
  unsigned bits = ParameterBox::kDefaultBits;  ///< of the proof
};

/// Whether every grasp in the box is stable, none is, or some are. Deterministic. Undecided
/// when no proof and no pair of grasps was found within the limits: the verdicts of a box with
/// a threshold on its border, for instance, have neither.
BoxDecision decide_box(const GraspBox& box, NormalLaw law, const BoxOptions& options = {});

/// That one grasp in exact numbers is stable, as prove_by_degree() finds: StableThroughout with
/// one part. Nothing if no proof was found, which says nothing about the verdict.
std::optional<BoxDecision> prove_stable_by_degree(const Problem& problem);

}  // namespace stickslip
