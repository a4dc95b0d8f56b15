// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What the method in doubles is asked, by how hard it is for doubles.
#pragma once

#include <cstddef>

#include "stickslip/engine/question.hpp"

namespace stickslip::bench {

enum class FloatFamily {
  kRandom,          ///< nothing in common, loads of all kinds
  kGrid,            ///< positions on a grid, axis normals: parallel, coincident, concurrent
  kNearDegenerate,  ///< the same moved by 1e-5 to 1e-12
  kEdgeOfCones,     ///< on a grid, loads 0 or 1e-6 to 1e-13 beside one with all friction used
  kJaws,  ///< jaws and discs, within 1e-6 to 1e-13 of a threshold known exactly, or on it
};

inline constexpr std::size_t kFloatFamilies = 5;

const char* name_of(FloatFamily family);

/// Two to four contacts, both normal laws; the same on every platform.
Question float_question(FloatFamily family, std::size_t index);

}  // namespace stickslip::bench
