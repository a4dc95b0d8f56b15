// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Single grasps drawn from a box at random.
#pragma once

#include <cstdint>
#include <memory>

#include "stickslip/core/box.hpp"
#include "stickslip/core/grasp.hpp"

namespace stickslip {

/// Draws grasps from a box, one after another. Each uncertain number is uniform in its interval
/// and independent of all others, on a grid of 2^17 steps; the slope of a normal in space is
/// uniform in its disc, and a load of a ball in the ball. The sequence depends on the box and
/// the seed alone, on every machine.
class BoxSampler {
 public:
  /// `box` must outlive this.
  BoxSampler(const GraspBox& box, NormalLaw law, std::uint64_t seed);
  ~BoxSampler();
  BoxSampler(const BoxSampler&) = delete;
  BoxSampler& operator=(const BoxSampler&) = delete;

  /// Returns the next grasp. O(uncertain numbers).
  GraspBox next();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace stickslip
