// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The last step of every enumerator: it sorts the states, completes the counts, and checks
/// them.
#pragma once

#include <cstddef>
#include <vector>

#include "stickslip/arrangement/slip_states.hpp"
#include "stickslip/arrangement/sweep.hpp"

namespace stickslip::arrangement_detail {

/// Fills in what follows from the circles and from the numbers of vertices, edges and faces,
/// by the table of slip_states.hpp.
void complete_counts(ArrangementCounts& counts, const GreatCircles& circles);

/// A list of states over the same planes, packed: a quarter of the memory of so many
/// SlipStates.
class StateList {
 public:
  explicit StateList(std::size_t planes);

  void add(const PackedSigns& signs) {
    words_.insert(words_.end(), signs.words(), signs.words() + width_);
  }
  void add(const SlipState& state);
  /// Adds the signs of the planes, given those of circles.normals[c].d.
  void add_over_planes(const GreatCircles& circles, const SlipState& of_circles);

  std::size_t size() const { return words_.size() / width_; }
  /// Returns a state, which is valid until the next one is added.
  PackedSigns operator[](std::size_t i) const { return {&words_[i * width_], planes_}; }

  /// Returns the states as their texts sort ('+' < '-' < '0'), each once.
  std::vector<SlipState> sorted() const;

 private:
  template <class SignOf>
  void pack(SignOf sign_of_plane);

  std::size_t planes_;
  std::size_t width_;  ///< words a state
  std::vector<PackedSigns::Word> words_;
};

/// Returns the slip states: those of the cells, and all-stick. Throws ContractError when the
/// complete `counts` contradict one another or the number of states: Euler, antipodal pairs,
/// and the relation of cells to states that slip_states.hpp states.
SlipStates assemble_states(StateList cells, const ArrangementCounts& counts);

}  // namespace stickslip::arrangement_detail
