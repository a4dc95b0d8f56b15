// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/arrangement/slip_states.hpp"

#include "assemble_states.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

void check_counts(const ArrangementCounts& counts) {
  if (counts.circles == 0) {
    require(counts.vertices == 0 && counts.edges == 0 && counts.faces == 1,
            "arrangement: no circle must leave one face");
  } else if (counts.circles == 1) {
    require(counts.vertices == 0 && counts.edges == 1 && counts.faces == 2,
            "arrangement: one circle must have one edge and two faces");
  } else {
    require(counts.vertices + counts.faces == counts.edges + 2,
            "arrangement: V - E + F must be 2");
    // -d lies on a cell of the same dimension as d, and never on the same one.
    require(counts.vertices % 2 == 0 && counts.edges % 2 == 0 && counts.faces % 2 == 0,
            "arrangement: cells must come in antipodal pairs");
  }
  const std::size_t expected = counts.rank == 3   ? counts.cells() + 1
                               : counts.rank == 2 ? counts.cells() - 1
                                                  : counts.cells();
  require(counts.distinct_states == expected,
          "arrangement: the number of sign vectors contradicts the number of cells");
}

}  // namespace

std::string to_string(const SlipState& state) {
  std::string text;
  text.reserve(state.size());
  for (const Sign sign : state) text.push_back(to_char(sign));
  return text;
}

SlipStates assemble_states(const GreatCircles& circles, SignRows cell_signs,
                           ArrangementCounts counts) {
  const std::size_t circle_count = circles.normals.size();
  const std::size_t plane_count = circles.circle.size();

  const std::size_t all_stick = cell_signs.add();
  for (std::size_t c = 0; c < circle_count; ++c) cell_signs.set(all_stick, c, Sign::kZero);

  // Sort circles' rows instead of planes' states, which are longer. Both orders agree once
  // each circle carries the sign of its first plane: circles are numbered by first
  // appearance, and the other planes of a circle never break a tie.
  std::vector<Sign> leading(circle_count, Sign::kZero);
  for (std::size_t p = 0; p < plane_count; ++p) {
    Sign& sign = leading[circles.circle[p].index()];
    if (sign == Sign::kZero) sign = circles.orientation[p];
  }
  std::vector<bool> reversed(circle_count);
  for (std::size_t c = 0; c < circle_count; ++c) reversed[c] = leading[c] == Sign::kNegative;
  cell_signs.flip_all(reversed);
  cell_signs.sort_and_unique();

  counts.planes = plane_count;
  counts.circles = circle_count;
  counts.rank = circles.rank;
  counts.distinct_states = cell_signs.size();
  check_counts(counts);

  std::vector<Sign> relative;  // of each plane to the first plane of its circle
  relative.reserve(plane_count);
  for (std::size_t p = 0; p < plane_count; ++p) {
    relative.push_back(circles.orientation[p] * leading[circles.circle[p].index()]);
  }

  SlipStates result;
  result.counts = counts;
  result.states.reserve(cell_signs.size());
  std::vector<Sign> of_circles;
  for (std::size_t row = 0; row < cell_signs.size(); ++row) {
    cell_signs.unpack(row, of_circles);
    if (plane_count == circle_count) {
      // Each plane is the first of its circle, and has its number.
      result.states.push_back(of_circles);
      continue;
    }
    SlipState& state = result.states.emplace_back(plane_count, Sign::kZero);
    for (std::size_t p = 0; p < plane_count; ++p) {
      state[p] = relative[p] * of_circles[circles.circle[p].index()];
    }
  }
  return result;
}

}  // namespace stickslip
