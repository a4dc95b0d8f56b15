// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// From an approximate equilibrium in double precision to an exact one, or none. Proposals
/// only: what is returned has passed find_violation.
#pragma once

#include <optional>
#include <vector>

#include "double_model.hpp"
#include "stickslip/equilibrium/verdict.hpp"

namespace stickslip {

/// What an approximate equilibrium says of one contact.
struct ContactMode {
  bool closed;
  /// Friction over its limit, in [-1, 1]; on an end, with `sticks` false, for a slipping
  /// contact.
  double friction_ratio;
  bool sticks;
  /// Takes the place of friction_ratio; a sticking contact with 1 or -1 keeps it.
  std::optional<Rational> exact_ratio = {};
  bool touches = false;  ///< not closed, but v = 0
};

/// Solves balance and no slip at the sticking contacts exactly, with the modes given; O(m)
/// rational operations. Nothing if the system is singular or its solution is not an
/// equilibrium. With `near` a singular system will do: what it leaves open stays as it is
/// there.
std::optional<Witness> complete_exactly(const Problem& problem,
                                        const std::vector<ContactMode>& modes,
                                        const Witness* near = nullptr);

/// Newton's method in the three unknowns of d for balance with friction made smooth,
/// -mu c_n clamp(T.d / epsilon); then complete_exactly. From rest: epsilon falls from the size
/// of all motion to nothing. O(m) for each of at most a few hundred steps.
std::optional<Witness> find_witness_from_rest(const Problem& problem, const DoubleModel& model);

/// The same from d = `start` with a small epsilon; gives up early unless `start` is near.
std::optional<Witness> find_witness_near(const Problem& problem, const DoubleModel& model,
                                         Double3 start);

}  // namespace stickslip
