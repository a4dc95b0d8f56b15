// SPDX-License-Identifier: MIT
/// \file
/// Proofs that every grasp in a box is stable with all contacts at rest (FORMAT.md §6, "Stable:
/// at rest").
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "answer.hpp"
#include "box.hpp"

namespace stickslip_check {

/// Friction forces that answer whatever load is left, as the certificate states them; only
/// their shape has been checked.
struct RestProof {
  /// Contacts, each with so many friction forces: of one number, in space of three or four.
  using Forces = std::vector<std::pair<Integer, std::vector<Vector>>>;

  Forces rest;     ///< f0: one force each
  Forces answers;  ///< G: D forces each
  Vector reach;    ///< Z
};

/// The rules `rest-...` of what is at `place`, for all multiples from range.low to *range.high.
/// Throws Rejected.
void check_rest(const RestProof& proof, const Box& box, const Range& range,
                const std::string& place);

}  // namespace stickslip_check
