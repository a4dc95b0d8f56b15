// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Margins as lists of claims: multiples l >= 0 for which a grasp is stable under the wrench w
/// + l u and the preloads P + l P^u (certificate/FORMAT.md, section 5, "Claims"). The ends of
/// resisted intervals may be irrational there, so that some multiples near them are left
/// undecided.
///
/// **Method.** An equilibrium is followed as the multiple grows and falls, in steps that become
/// smaller where it is lost. If nothing slips, the equilibria at the ends of a step prove it,
/// as all between them are their combinations; else it is proved by degree, with the multiple
/// as one more uncertain number. The rest is refuted by branch and bound with the multiple as
/// one more unknown, or has another equilibrium to be followed, or is cut in two.
#pragma once

#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include "stickslip/engine/proof.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/engine/search_options.hpp"
#include "stickslip/engine/search_work.hpp"
#include "stickslip/measures/margin.hpp"

namespace stickslip {

/// Two equilibria of one mode in which no contact with friction slips: every multiple between
/// them is resisted, by a combination of the two.
struct SpatialSegment {
  ShareWitness start;               ///< at the low end
  std::optional<ShareWitness> end;  ///< at the high end, if that is another multiple
};
/// Every multiple from low to high, both included, is resisted; without `high`, every one from
/// low on.
struct ResistedMultiples {
  Rational low;                  ///< >= 0
  std::optional<Rational> high;  ///< >= low; nothing only if w and P are 0: the proof is then
                                 ///< about 1
  /// The proof; its nodes see l as well.
  std::variant<SpatialSegment, DegreeProof, RestProof, StickingProof> proof;
};
/// No multiple between low and high is resisted. If low is 0 and w or P is not 0, neither is
/// the multiple 0.
struct RefutedMultiples {
  Rational low;                  ///< >= 0
  std::optional<Rational> high;  ///< > low; nothing: without end
  Trees tree;                    ///< nodes see the multiple as well
};

/// A claim about some multiples.
using MultiplesClaim = std::variant<ResistedMultiples, RefutedMultiples>;

/// All that is known about the multiples.
struct SpatialMargin {
  /// In increasing order; the next may begin where one ends.
  std::vector<MultiplesClaim> claims;
  SearchWork work;      ///< the work to find the claims
  unsigned bits = 128;  ///< the precision of the proofs
  /// True if far motions, which only the rounding of the data decides, ended a search. With a
  /// bound on motions more may be known.
  bool ended_far = false;

  /// The resisted intervals, increasing; claims that touch are one interval.
  std::vector<MarginInterval> resisted() const;
  /// The refuted intervals, increasing; their ends are not refuted, but for 0.
  std::vector<MarginInterval> refuted() const;
};

/// The accuracy of the search.
struct SpatialMarginOptions {
  /// The part of the multiple at an end that may be left undecided there.
  Rational accuracy{1, 1000};
  SearchOptions search{};  ///< the options of each proof
};

/// Returns the margin of a question whose margin is a list of claims. If motions are bounded,
/// only equilibria within the bound count. Deterministic. Calls `progress` with
/// each new claim, when they are in no order, and a last time with all in order if the work is
/// cancelled and there are any.
SpatialMargin find_spatial_margin(
    const Question& question, const SpatialMarginOptions& options = {},
    const std::function<void(const SpatialMargin&)>& progress = {});

}  // namespace stickslip
