// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The weaker question: do any forces in the friction cones balance the load? No springs, no
/// motion, no maximum dissipation; what stickslip calls stable is weakly stable, not the other
/// way round. GLPK's simplex in doubles, default tolerances.
#pragma once

#include "stickslip/engine/question.hpp"

namespace stickslip::bench {

/// 3 rows, two columns per contact: the edges of its friction cone.
bool is_weakly_stable(const Question& question);

}  // namespace stickslip::bench
