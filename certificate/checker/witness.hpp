// SPDX-License-Identifier: MIT
/// \file
/// The stable verdict (FORMAT.md §3): an equilibrium, checked by substitution.
#pragma once

#include <vector>

#include "question.hpp"

namespace stickslip_check {

/// Throws Rejected unless (d, a, b) is an equilibrium. `forces` holds (a_i, b_i); `stated` is
/// the number of pairs in the certificate, of which `forces` may hold only the first.
void check_witness(const std::vector<Row>& rows, const Vector3& wrench, bool bilateral,
                   const Vector3& d, const std::vector<Vector2>& forces, std::size_t stated);

}  // namespace stickslip_check
