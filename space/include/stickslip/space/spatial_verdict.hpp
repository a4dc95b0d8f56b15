// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Verdicts on grasps in space, with proofs that certificate/FORMAT.md, section 7, explains.
#pragma once

#include "stickslip/box/box_verdict.hpp"
#include "stickslip/space/spatial_question.hpp"

namespace stickslip {

/// \{ In space.
using SpatialVerdict = VerdictOnBox<SpatialGrasp>;
using SpatialDecision = DecisionOnBox<SpatialGrasp>;
/// \}

/// How much to try.
struct SpatialSearchOptions {
  /// Of each tree; 0: one with which an answer takes about a minute at most for 12 contacts.
  std::size_t node_limit = 0;
  /// Of the enclosure of irrational lengths.
  unsigned bits = kDefaultBits;
};

/// Whether every grasp in the box is stable, none is, or some are. Deterministic. Undecided
/// when no proof and no two grasps that differ were found within the limits; on a threshold
/// there need be neither.
SpatialDecision decide(const SpatialQuestion& question,
                       const SpatialSearchOptions& options = {});

/// StableThroughout::motion, in space.
Vector6 motion_of(const StableThroughout& stable);

}  // namespace stickslip
