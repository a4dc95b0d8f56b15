// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Families of grasps for benchmarks: exact, the same on every platform, of any size.
///
/// Numbers are those of measurements: positions are multiples of 1/1000, friction of 1/10,
/// preloads of 1/4, stiffness 1 to 5. Normals are unit vectors i^a ((3+4i)/5)^b ((5+12i)/13)^c
/// with |b|, |c| <= 2: one hundred directions, less than 8 degrees apart, whose denominators
/// divide 4225, so that sums over thousands of contacts keep short denominators; all but those
/// of kVaried, whose sums have the product of nearly all denominators.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "stickslip/core/grasp.hpp"

namespace stickslip::bench {

enum class Layout {
  kRound,   ///< all round a body of radius 2 that is not quite a disc
  kArc,     ///< on 40 % of it, below; normals point up and inwards
  kEdges,   ///< along three straight edges, open at the top: contacts of an edge share a circle
  kGrid,    ///< pegs on a regular grid, none of which pushes down: concurrent circles
  kJaws,    ///< mirrored pairs on two parallel edges, friction 1/2: threshold known exactly
  kDisc,    ///< antipodal pairs, radial normals, friction 1/2: threshold known exactly
  kVaried,  ///< as kRound, but each contact has denominators of its own, of three to seven
            ///< digits
};

const char* name_of(Layout layout);

/// `contacts` contacts (for kJaws and kDisc made even). Preloads are 1/4 to 2, or all 0.
Grasp make_grasp(Layout layout, std::size_t contacts, bool preloaded, std::uint64_t seed);

/// The hundred unit vectors, by angle from 0 (1, 0) counter-clockwise.
const std::vector<Vector2>& unit_directions();

/// The product of complex numbers: v turned by the unit vector `by`.
Vector2 rotated(const Vector2& v, const Vector2& by);

/// The largest multiple of 1/steps that is not above `value`.
Rational floor_to_grid(const Rational& value, int steps);

}  // namespace stickslip::bench
