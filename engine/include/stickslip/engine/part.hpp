// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The parameters of a box of grasps, and the parts into which a proof cuts it
/// (certificate/FORMAT.md, section 6).
#pragma once

#include <algorithm>
#include <cstddef>
#include <variant>
#include <vector>

#include "stickslip/core/number.hpp"

namespace stickslip {

/// The bits to which irrational lengths are enclosed if a certificate does not say.
inline constexpr unsigned kDefaultBits = 128;

/// A number of a contact that may be uncertain, or a component of the load.
enum class Parameter {
  kX,          ///< p_x
  kY,          ///< p_y
  kTurn,       ///< e, for the normal n + e t in the plane (turns_of)
  kFriction,   ///< mu
  kPreload,    ///< P' = P / |n|, for the turned normal n
  kStiffness,  ///< k' = k / |n|^2
  kWrench,     ///< a component of w, or of z of a ball; belongs to no contact
  kZ,          ///< p_z, in space
  kTurnU,      ///< e_u, for the normal n + e_u u + e_v v in space
  kTurnV       ///< e_v
};

/// Returns "x", "y", "turn", "friction", "preload", "stiffness", "wrench", "z", "turn_u" or
/// "turn_v".
const char* to_string(Parameter parameter);

/// A parameter of one contact, or a component of the wrench.
struct ParameterId {
  Parameter parameter;  ///< the kind of number
  std::size_t index;    ///< the index of the contact, or of the component
};

/// A cut of a box at a value of one parameter, which gives two children: the low one with the
/// parameter <= value, and the high one with it >= value.
struct PartSplit {
  Parameter parameter;  ///< the kind of number
  std::size_t index;    ///< the index of the contact, or of the component
  Rational value;       ///< inside the parameter's interval
};

/// The cuts of a box and a proof of each of its parts, in preorder.
template <class... Proof>
using PartsIn = std::vector<std::variant<PartSplit, Proof...>>;

/// Returns how many parts have a proof of their own.
template <class... Proof>
std::size_t part_count(const std::vector<std::variant<PartSplit, Proof...>>& parts) {
  return static_cast<std::size_t>(
      std::count_if(parts.begin(), parts.end(),
                    [](const auto& part) { return !std::holds_alternative<PartSplit>(part); }));
}

}  // namespace stickslip
