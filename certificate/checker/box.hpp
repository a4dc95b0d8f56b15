// SPDX-License-Identifier: MIT
/// \file
/// The box of parameters that trees are about (FORMAT.md §6), and what they need of each
/// contact: its functions at the corners of the box, of which a contact without uncertainty has
/// one (§1, Rows).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "number.hpp"

namespace stickslip_check {

/// The number of coordinates of twists and wrenches: translation x, y and rotation.
inline constexpr std::size_t kDimension = 3;

/// FORMAT.md §6, the table; kWrench is of no contact.
enum class Parameter : std::int8_t { kX, kY, kTurn, kFriction, kPreload, kStiffness, kWrench };
inline constexpr std::array<const char*, 7> kParameterNames{
    "x", "y", "turn", "friction", "preload", "stiffness", "wrench"};
inline constexpr std::size_t kContactParameters = 6;

/// The parameters of a contact.
struct ContactBox {
  Vector normal;                                  ///< n0
  std::array<Bounds, kContactParameters> bounds;  ///< by Parameter
  Rational growth;                                ///< of a margin: P^u'

  const Bounds& operator[](Parameter name) const {
    return bounds[static_cast<std::size_t>(name)];
  }
};

/// What follows for one contact. A *corner* is one of the box of p_x, p_y and e, of which those
/// that are certain do not count. All forms are of points.
struct Row {
  /// v_i and tau_i at all corners, those of P' and k' included, and up to positive factors: one
  /// form each if they are certain.
  std::vector<Form> v;
  std::vector<Form> slip;

  bool certain = true;  ///< all parameters are
  Rational weight;      ///< of the products of what follows

  // If certain: v_i(x) (N -+ mu T) = weight (v.x) edge.
  Form edges[2];      ///< N - mu T, N + mu T
  bool frictionless;  ///< mu = 0

  // If not: (N + s T) v_i(x) = weight (edge) (pull.d + preload h), at each corner.
  std::vector<Form> corner_edges[4];  ///< s = -mu_max, -mu_min, mu_min, mu_max
  std::vector<Form> pulls[2];  ///< for k'_min, k'_max; the last is empty if k' is certain
  Integer preloads[2];         ///< for P'_min, P'_max
};

std::shared_ptr<const Row> make_row(const ContactBox& contact);

/// Rows are shared with the boxes that this one was cut from.
struct Box {
  std::vector<ContactBox> contacts;
  std::vector<Bounds> wrench;  ///< w
  Vector growth;               ///< u; 0 unless of a margin
  std::vector<std::shared_ptr<const Row>> rows;

  /// The interval of a parameter, or nothing if there is no such contact or component.
  const Bounds* find(Parameter name, const Integer& index) const;
  /// The part with another interval of a parameter that there is.
  Box with(Parameter name, std::size_t index, Bounds bounds) const;
  /// The one point q0 in the middle of all intervals.
  Box middle() const;
};

}  // namespace stickslip_check
