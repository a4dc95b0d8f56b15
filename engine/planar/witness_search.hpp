// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Exact equilibria from approximate ones in double precision. Every witness that is returned
/// has passed find_violation; all else is a proposal.
#pragma once

#include <optional>
#include <vector>

#include "double_model.hpp"
#include "stickslip/engine/newton_equilibria.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// The mode of one contact, as an approximate equilibrium suggests it.
struct ModeGuess {
  bool closed = false;  ///< it bears a force
  bool sticks = false;  ///< it bears one and does not slip
  /// The share sigma of friction in the force N + sigma mu T: in [-1, 1], on an end if it
  /// slips.
  Rational share = 0;
  bool keeps_share = false;  ///< sticking with the share 1 or -1, it stays there
  bool touches = false;      ///< not closed, but v = 0
};

/// Returns a rational share of friction near an approximate one; between -1 and 1.
Rational rounded_share(double share);

/// Returns the equilibrium with these modes: balance, and no slip at the sticking contacts, are
/// solved exactly; O(m) rational operations. Returns nothing if the system is singular or its
/// solution is not an equilibrium. Few of the sticking contacts have friction (few_shares.hpp),
/// and how much is guessed does not matter. With `near` it does, and a singular system will do:
/// what it leaves open stays as it is there.
std::optional<Witness> complete_exactly(const Problem& problem,
                                        const std::vector<ModeGuess>& guesses,
                                        const Witness* near = nullptr);

/// Motions d within `reach` of a middle, by coordinates.
struct MotionBox {
  Double3 middle;  ///< the middle of the box
  Double3 reach;   ///< half its widths
};

/// Returns an equilibrium that is found from rest. Newton's method in the three unknowns of d
/// solves balance with friction made smooth, -mu c_n clamp(T.d / epsilon), while epsilon falls
/// from the size of all motion to nothing; then complete_exactly solves exactly. If the method
/// ends at a balance that cannot be completed, `otherwise` gets a box in which an equilibrium
/// may be. O(m) for each of at most a few hundred steps.
std::optional<Witness> find_witness_from_rest(const Problem& problem, const DoubleModel& model,
                                              std::optional<MotionBox>& otherwise);

/// Returns the same from d = `start` with a small epsilon. Gives up early unless `start` is
/// near, or if it comes to the modes of `failed`, if given; `failed` then gets those that fail
/// here.
std::optional<Witness> find_witness_near(const Problem& problem, const DoubleModel& model,
                                         Double3 start,
                                         std::vector<ModeGuess>* failed = nullptr);

/// Returns different equilibria, by the same method from this many motions at random (always
/// the same); not all that there are, and maybe none.
std::vector<Witness> find_witnesses_around(const Problem& problem, const DoubleModel& model,
                                           std::size_t starts);

/// Returns those of one grasp whose model is there (newton_equilibria.hpp).
std::vector<NearEquilibrium> newton_equilibria(const DoubleModel& model, std::size_t starts,
                                               double length);

}  // namespace stickslip
