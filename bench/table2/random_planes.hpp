// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Grasps with randomly generated contacts, as in Table II of the paper: the same on every
/// platform.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "stickslip/arrangement/great_circles.hpp"

namespace stickslip::bench {

/// 4m(m-1) + 2: the cells of m >= 2 planes in general position, and of no others.
std::size_t cells_of_simple(std::size_t m);

/// The stick planes of m >= 2 random contacts: positions in multiples of 1/1000 in the square
/// [-1, 1]^2, normals in random directions that point to the side of the origin. Grasps that
/// are not simple (two planes coincide or three are concurrent) are drawn again.
std::vector<Vector3> random_simple_planes(std::size_t m, std::uint64_t seed);

}  // namespace stickslip::bench
