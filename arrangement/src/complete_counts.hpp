// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "stickslip/arrangement/slip_states.hpp"

namespace stickslip {

/// Fills in what follows from the circles and from the numbers of vertices, edges and faces,
/// by the table of slip_states.hpp.
inline void complete_counts(ArrangementCounts& counts, const GreatCircles& circles) {
  counts.planes = circles.circle.size();
  counts.circles = circles.normals.size();
  counts.rank = circles.rank;
  counts.distinct_states = counts.rank == 3   ? counts.cells() + 1
                           : counts.rank == 2 ? counts.cells() - 1
                                              : counts.cells();
}

}  // namespace stickslip
