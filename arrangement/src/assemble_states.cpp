// SPDX-License-Identifier: GPL-3.0-or-later
#include "assemble_states.hpp"

#include <algorithm>

#include "stickslip/core/error.hpp"

namespace stickslip::arrangement_detail {

void complete_counts(ArrangementCounts& counts, const GreatCircles& circles) {
  counts.planes = circles.circle.size();
  counts.circles = circles.normals.size();
  counts.rank = circles.rank;
  counts.distinct_states = counts.rank == 3   ? counts.cells() + 1
                           : counts.rank == 2 ? counts.cells() - 1
                                              : counts.cells();
}

StateList::StateList(std::size_t planes)
    : planes_(planes), width_(PackedSigns::words_for(planes)) {}

template <class SignOf>
void StateList::pack(SignOf sign_of_plane) {
  for (std::size_t first = 0, w = 0; w < width_; ++w, first += PackedSigns::kSignsPerWord) {
    const std::size_t end = std::min(planes_, first + PackedSigns::kSignsPerWord);
    PackedSigns::Word word = 0;
    for (std::size_t p = first; p < end; ++p) {
      word |= PackedSigns::digit(sign_of_plane(p)) << PackedSigns::shift_of(p);
    }
    words_.push_back(word);
  }
}

void StateList::add(const SlipState& state) {
  pack([&](std::size_t p) { return state[p]; });
}

void StateList::add_over_planes(const GreatCircles& circles, const SlipState& of_circles) {
  pack([&](std::size_t p) {
    return circles.orientation[p] * of_circles[circles.circle[p].index()];
  });
}

std::vector<SlipState> StateList::sorted() const {
  std::vector<const PackedSigns::Word*> rows;
  rows.reserve(size());
  for (std::size_t i = 0; i < size(); ++i) rows.push_back((*this)[i].words());
  const auto less = [this](const PackedSigns::Word* a, const PackedSigns::Word* b) {
    return std::lexicographical_compare(a, a + width_, b, b + width_);
  };
  const auto equal = [this](const PackedSigns::Word* a, const PackedSigns::Word* b) {
    return std::equal(a, a + width_, b);
  };
  std::sort(rows.begin(), rows.end(), less);
  rows.erase(std::unique(rows.begin(), rows.end(), equal), rows.end());
  std::vector<SlipState> states;
  states.reserve(rows.size());
  for (const PackedSigns::Word* row : rows) {
    states.push_back(PackedSigns(row, planes_).unpack());
  }
  return states;
}

SlipStates assemble_states(StateList cells, const ArrangementCounts& counts) {
  cells.add(SlipState(counts.planes, Sign::kZero));
  SlipStates result{counts, cells.sorted()};
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
  require(result.states.size() == counts.distinct_states,
          "arrangement: the number of sign vectors contradicts the number of cells");
  return result;
}

}  // namespace stickslip::arrangement_detail
