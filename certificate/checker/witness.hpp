// SPDX-License-Identifier: MIT
/// \file
/// Equilibria, checked by substitution (FORMAT.md §3), and the segments between two (§10).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "question.hpp"

namespace stickslip_check {

/// A motion and its forces. With h = 1 an equilibrium, with h = 0 a ray of equilibria, for
/// which the rules hold with every preload times h.
struct Witness {
  Vector3 d;
  std::vector<Vector2> forces;  ///< (a_i, b_i)
  std::uint64_t stated = 0;     ///< pairs in the certificate; `forces` may hold only the first
  int h = 1;
};

/// The rules `witness-...` under a load. Throws Rejected.
void check_witness(const std::vector<Row>& rows, const Vector3& load, bool bilateral,
                   const Witness& witness);

/// `segment-mode`: why two accepted witnesses share no mode, or nothing.
std::optional<std::string> mode_refusal(const std::vector<Row>& rows, const Witness& first,
                                        const Witness& second);

}  // namespace stickslip_check
