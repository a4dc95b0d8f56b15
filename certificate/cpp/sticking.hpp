// SPDX-License-Identifier: MIT
/// \file
/// Proofs that every grasp in a box is stable near a motion at which contacts stick (FORMAT.md
/// §6, "Stable: sticking").
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "answer.hpp"
#include "box.hpp"
#include "question.hpp"
#include "rest.hpp"

namespace stickslip_check {

/// Forces that answer whatever load is left, as the certificate states them; only their shape
/// has been checked.
struct StickingProof {
  Vector twist;                                     ///< d0
  ContactForces friction;                           ///< f0: one force each
  std::vector<std::pair<Integer, Vector>> presses;  ///< H: D numbers each
  ContactForces answers;                            ///< G: D forces each
  Vector reach;                                     ///< Z
  Rational energy;                                  ///< c
};

/// The rules `sticking-...` of what is at `place`, for all multiples from range.low to
/// *range.high. Throws Rejected.
void check_sticking(const StickingProof& proof, const Box& box, const Range& range,
                    const Options& asked, const std::string& place);

}  // namespace stickslip_check
