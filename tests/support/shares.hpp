// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How much a certificate has to say of a witness's friction.
#pragma once

#include "stickslip/engine/verdict.hpp"

namespace stickslip::test {

/// Of the contacts that stick under load and have friction.
struct ShareCount {
  std::size_t nonzero = 0;
  std::size_t fractional = 0;  ///< neither 0 nor all of the friction there can be
  Rational sum = 0;            ///< of absolute values
};

inline ShareCount shares_of(const Problem& problem, const Witness& witness) {
  ShareCount count;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    const ContactForce& force = witness.forces[i];
    if (force.tangential.is_zero() || !power(row.tangent, witness.twist).is_zero()) continue;
    const Rational share = abs(force.tangential) / (row.friction * force.normal);
    ++count.nonzero;
    count.fractional += share == 1 ? 0 : 1;
    count.sum += share;
  }
  return count;
}

}  // namespace stickslip::test
