// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What a grasp file of version 3 says of several bodies.
#pragma once

#include <vector>

#include "intervals.hpp"
#include "stickslip/core/json.hpp"
#include "stickslip/core/mechanism.hpp"

namespace stickslip::core_detail {

/// "bodies" and "joints", checked. Throws InputError.
Mechanism read_mechanism(const JsonNode& root, bool in_space);

/// "ratchets", those of "joints" that have one, and "tendons", in this order.
std::vector<Spring> read_springs(const JsonNode& root, const Mechanism& mechanism,
                                 IntervalReader& read);

}  // namespace stickslip::core_detail
