// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Equilibria of one grasp of many coordinates by Newton's method, in doubles.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/statics/statics_model.hpp"

namespace stickslip::large_detail {

/// The normal law of a contact, ratchet or spring: a = max(0, preload - stiffness N.d), of a
/// spring without the maximum.
struct SpringLaw {
  Rational preload;    ///< P'
  Rational stiffness;  ///< k'
};

/// A grasp of many coordinates: its contacts and ratchets as cones of a model whose joints are
/// free, and springs with stiffness.
struct LargeGrasp {
  statics_detail::StaticsModel model;   ///< statics, without these springs
  std::vector<SpringLaw> cone_law{};    ///< by cone of the model
  RationalRow frictions{};              ///< mu, by cone
  std::vector<SparseRow> springs{};     ///< rows of the springs
  std::vector<SpringLaw> spring_law{};  ///< by spring
  bool may_open = true;                 ///< whether contacts may open
};

/// The state of a contact near an equilibrium.
enum class LargeMode : std::int8_t {
  kOpen,
  kSticks,
  kFollows,  ///< sticks nearly, as another one with nearly the same slip does
  kSlips
};

/// An equilibrium in doubles.
struct LargeProposal {
  std::vector<LargeMode> modes{};  ///< by cone; what has no friction sticks if it is closed
  /// The friction of each cone, as multiples of its directions.
  std::vector<std::vector<double>> friction{};
  std::vector<double> most{};   ///< how much there may be, as a force
  std::vector<double> spare{};  ///< how much more
  bool drifts = false;          ///< whether bodies drift away, as if nothing held them
};

/// How contacts are made smooth; all of it vanishes with the size of slips over which friction
/// is. A pile has no forces at rest, so that friction needs some from elsewhere.
enum class Smoothing : std::int8_t {
  /// Open contacts pull a little, so that no body drifts away, and friction is as if contacts
  /// were pressed together.
  kPulling,
  /// Contacts are pressed together.
  kPressed
};

/// Returns an equilibrium found by following a curve, on which friction is smooth over slips of
/// a size that becomes smaller and smaller, and contacts open within about as much. It begins
/// where all that is nearly linear. A step factors a few sparse matrices of D rows. Either way
/// of smoothing finds some that the other does not. Returns nothing if the curve is lost.
std::optional<LargeProposal> propose(const LargeGrasp& grasp, Smoothing smoothing);

}  // namespace stickslip::large_detail
