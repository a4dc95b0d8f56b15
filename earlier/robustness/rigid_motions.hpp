// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The combinations of states that rigid motions in the plane allow.
#pragma once

#include <set>
#include <vector>

#include "earlier/robustness/force_model.hpp"

namespace stickslip::robustness_detail {

/// Returns the combinations of all motions: one for each face of the arrangement of the planes
/// N.y = 0 and T.y = 0, which meet in 0 alone. Requires that G has full rank. For m contacts
/// O(m^2) pairs of planes are tried, and O(m) signs found for each.
std::set<std::vector<SpringState>> states_of_motions(const ForceModel& model);

}  // namespace stickslip::robustness_detail
