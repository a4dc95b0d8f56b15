// SPDX-License-Identifier: MIT
/// \file
/// Verdicts of more than 30 coordinates: an equilibrium, or one twist (FORMAT.md §14, "Many
/// coordinates"). Memory is linear in the number of elements.
#pragma once

#include <vector>

#include "question.hpp"
#include "tree.hpp"
#include "witness.hpp"

namespace stickslip_check {

/// The rules `witness-...`, as check_witness() judges them. Throws Rejected.
void check_large_witness(const Question& question, const Witness& witness);

/// `large-proof`, and `static-motion` of the one leaf; none if there is another proof. Throws
/// Rejected.
void check_large_leaf(const Question& question, const Node* leaf);

}  // namespace stickslip_check
