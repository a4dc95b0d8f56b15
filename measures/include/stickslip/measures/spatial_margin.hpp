// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Margins as lists of claims: multiples l >= 0 for which a grasp is stable under the wrench
/// w + l u and the preloads P + l P^u (certificate/FORMAT.md, section 5, "Claims"). Ends of
/// what is resisted may be irrational there, so that some multiples near them are left
/// undecided.
///
/// **Method.** An equilibrium is followed as the multiple grows and falls, in steps that become
/// smaller where it is lost. Where nothing slips the equilibria at the ends of a step prove it,
/// as all between them are their combinations; else it is proved by degree, with the multiple
/// as one more uncertain number. What is left is refuted by branch and bound with the multiple
/// as one more unknown, or has another equilibrium to be followed, or is cut in two.
#pragma once

#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include "stickslip/engine/proof.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/engine/search_work.hpp"
#include "stickslip/measures/margin.hpp"

namespace stickslip {

/// Equilibria of one mode, in which nothing that has friction slips: between them every
/// multiple is resisted, by a combination of the two.
struct SpatialSegment {
  ShareWitness start;               ///< at the low end
  std::optional<ShareWitness> end;  ///< at the high end, if that is another multiple
};
/// Every multiple from low to high is resisted, both included; all, if there is no high.
struct ResistedMultiples {
  Rational low;                  ///< >= 0
  std::optional<Rational> high;  ///< >= low; nothing only where w and P are 0: proof is of 1
  /// Nodes see l as well.
  std::variant<SpatialSegment, DegreeProof, RestProof, StickingProof> proof;
};
/// No multiple between low and high is resisted; nor is 0, if it is low, and w or P is not 0.
struct RefutedMultiples {
  Rational low;                  ///< >= 0
  std::optional<Rational> high;  ///< > low; nothing: without end
  Trees tree;                    ///< nodes see the multiple as well
};

/// What is claimed of some multiples.
using MultiplesClaim = std::variant<ResistedMultiples, RefutedMultiples>;

/// What is known of all multiples.
struct SpatialMargin {
  /// Increasing; where one ends the next may begin.
  std::vector<MultiplesClaim> claims;
  SearchWork work;      ///< to find them
  unsigned bits = 128;  ///< of the proofs
  /// Far motions, which only the rounding of the data decides, ended a search: within a bound
  /// on motions more may be known.
  bool ended_far = false;

  /// Increasing; claims that touch are one interval.
  std::vector<MarginInterval> resisted() const;
  /// Increasing; without their ends, but for 0.
  std::vector<MarginInterval> refuted() const;
};

/// How finely to look.
struct SpatialMarginOptions {
  /// What is left undecided at an end is about this part of the multiple there.
  Rational accuracy{1, 1000};
  SearchOptions search{};  ///< of each proof
};

/// Requires a question whose margin is a list of claims. Where motions are bounded only
/// equilibria within the bound count. Deterministic. `progress` is called now and then.
SpatialMargin find_margin(const Question& question, const SpatialMarginOptions& options = {},
                          const std::function<void(const SpatialMargin&)>& progress = {});

}  // namespace stickslip
