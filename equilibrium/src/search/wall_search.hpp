// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Branch and bound over one region of a family, such as the wall of a proof by degree: the
/// search of branch_and_bound.hpp without its exact program, and not for equilibria.
#pragma once

#include "double_model.hpp"
#include "stickslip/equilibrium/search/branch_and_bound.hpp"
#include "stickslip/equilibrium/search/degree.hpp"
#include "stickslip/equilibrium/search/region.hpp"

namespace stickslip::equilibrium_detail {

/// Appends to `trees` one that refutes the region, with `leaf-direction` if there is a
/// direction; false if it finds none of at most `node_limit` nodes, and then what was appended
/// is no tree. `model` is that of the family. Adds to `work`.
bool append_wall(const Problem& family, const DoubleModel& model, Region wall,
                 const Direction* direction, std::size_t node_limit, Refutation& trees,
                 ConeWork& work);

}  // namespace stickslip::equilibrium_detail
