// SPDX-License-Identifier: MIT
/// \file
/// The bound of a leaf: the most work on a virtual twist that the forces of a region can do
/// (FORMAT.md §4 and, in space, §7).
#pragma once

#include <optional>
#include <string>

#include "region.hpp"

namespace stickslip_check {

/// `leaf-bound`, of the virtual twist y: why it does not hold, or nothing.
std::optional<std::string> leaf_refusal(const Box& box, const Generators& region,
                                        const Vector& y);

}  // namespace stickslip_check
