// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The options of all searches.
#pragma once

#include <cstddef>

#include "stickslip/engine/part.hpp"

namespace stickslip {

/// The engines for one grasp in the plane whose numbers are certain; any other question has one
/// engine.
enum class Engine {
  kAuto,           ///< kBranchAndBound, without forces where these would be long
  kStates,         ///< the method of the paper, which is the reference (decide_by_states)
  kBranchAndBound  ///< branch_and_bound(), which measures faster (bench/README.md)
};

/// The options of a search, and of an answer that takes several.
struct SearchOptions {
  /// The most nodes of each tree search. With 0 a single grasp in the plane has no limit, and
  /// all else one that suits most questions; in space that takes at most about a minute for 12
  /// contacts.
  std::size_t node_limit = 0;
  Engine engine = Engine::kAuto;  ///< the engine for one grasp in the plane
  /// Whether to look for a second answer, Answer::within.
  bool second = true;
  /// The bits to which irrational lengths are enclosed. In the plane they are doubled from this
  /// until there is an answer, up to `most_bits`.
  unsigned bits = kDefaultBits;
  unsigned most_bits = 1024;  ///< the most bits to try
};

/// Returns the default options with this engine.
inline SearchOptions by(Engine engine) {
  SearchOptions options;
  options.engine = engine;
  return options;
}

}  // namespace stickslip
