// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// One call for slip states, by any enumerator.
#pragma once

#include <cstddef>
#include <vector>

#include "stickslip/arrangement/slip_states.hpp"

namespace stickslip {

/// kAuto is kCgal, the reference, up to kMostContactsForCgal planes, kSweep beyond.
enum class Enumerator { kAuto, kCgal, kSweep, kPaper };

/// Up to here CGAL takes some ten milliseconds (bench/README.md).
inline constexpr std::size_t kMostContactsForCgal = 40;

/// What an enumerator found, and which one it was.
struct Enumeration {
  const char* engine;  ///< the one that ran: "cgal", "sweep" or "paper"
  SlipStates found;    ///< counts; the sweep gives the states only if they are to be listed
};

/// The paper's three steps are reported as what they find: lines as vertices, facets as edges,
/// regions as faces, and all-stick only if a step gives it (paper_enumerator.hpp). `threads`
/// serve the sweep's counts; 0 is one a core. Throws ContractError if a normal is zero.
Enumeration enumerate_slip_states(const std::vector<Vector3>& plane_normals,
                                  Enumerator enumerator, bool list, unsigned threads = 0);

}  // namespace stickslip
