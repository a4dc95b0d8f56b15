// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Parameters of a box of grasps, and parts into which a proof cuts it (certificate/FORMAT.md,
/// section 6).
#pragma once

#include <algorithm>
#include <cstddef>
#include <variant>
#include <vector>

#include "stickslip/core/number.hpp"

namespace stickslip {

/// Bits of the enclosure of irrational lengths in a certificate that does not say.
inline constexpr unsigned kDefaultBits = 128;

/// What may be uncertain of a contact.
enum class Parameter {
  kX,          ///< p_x
  kY,          ///< p_y
  kTurn,       ///< e, of the normal n + e t; in the plane (turns_of)
  kFriction,   ///< mu
  kPreload,    ///< P' = P / |n|, of the turned normal
  kStiffness,  ///< k' = k / |n|^2
  kWrench,     ///< of no contact: a component of w
  kZ,          ///< p_z, in space
  kTurnU,      ///< e_u, of the normal n + e_u u + e_v v; in space
  kTurnV       ///< e_v
};

/// "x", "y", "turn", "friction", "preload", "stiffness", "wrench", "z", "turn_u", "turn_v".
const char* to_string(Parameter parameter);

/// A parameter of one contact, or a component of the wrench.
struct ParameterId {
  Parameter parameter;  ///< of which contact: index
  std::size_t index;    ///< of the contact, or of the component
};

/// A parameter of this contact, or this component of the wrench, is cut at this value: two
/// children, low and high, with the parameter <= value and >= value.
struct PartSplit {
  Parameter parameter;  ///< of which contact: index
  std::size_t index;    ///< of the contact, or of the component
  Rational value;       ///< inside the parameter's interval
};

/// Cuts of a box, and a proof of each of its parts, in preorder.
template <class... Proof>
using PartsIn = std::vector<std::variant<PartSplit, Proof...>>;

/// How many parts have a proof of their own.
template <class... Proof>
std::size_t part_count(const std::vector<std::variant<PartSplit, Proof...>>& parts) {
  return static_cast<std::size_t>(
      std::count_if(parts.begin(), parts.end(),
                    [](const auto& part) { return !std::holds_alternative<PartSplit>(part); }));
}

}  // namespace stickslip
