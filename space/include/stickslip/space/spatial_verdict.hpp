// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Verdicts on grasps in space, with proofs that certificate/FORMAT.md, section 7, explains.
#pragma once

#include "stickslip/box/box_verdict.hpp"
#include "stickslip/space/spatial_question.hpp"

namespace stickslip {

/// Whether every grasp in the box is stable, none is, or some are: decide_box().
BoxDecision decide(const SpatialQuestion& question, const BoxOptions& options = {});

}  // namespace stickslip
