// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Random grasps whose stick planes are in general position, for Table II.
#pragma once

#include <cstddef>

#include "stickslip/core/grasp.hpp"

namespace stickslip {

/// `contacts` contacts drawn by std::mt19937 from its default seed: coordinates of positions
/// are k/100 and of normals k, for integers k in [-100, 100]. A contact is drawn again when its
/// normal is 0, or its stick plane is parallel to, or shares a line with two of, those
/// before it. The same on every machine, and smaller grasps begin larger ones. Frictionless,
/// since slip states do not ask.
Grasp random_simple_grasp(std::size_t contacts);

}  // namespace stickslip
