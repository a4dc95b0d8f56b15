// SPDX-License-Identifier: MIT
/// \file
/// The question (FORMAT.md §1): what the grasp file says, what whoever asks replaces, and the
/// rows that follow from it. The certificate plays no part here.
///
/// A *point* x = (d, h, l) is a motion d with two more coordinates, h = 1 and l = lambda. All
/// conditions are homogeneous in it; a point of a verdict has l = 0.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grasp.hpp"
#include "number.hpp"

namespace stickslip_check {

/// The number of coordinates of twists and wrenches: translation x, y and rotation.
inline constexpr std::size_t kDimension = 3;

/// How the preloads grow: by these numbers, one for each contact, or in proportion to
/// themselves.
struct PreloadDirection {
  bool scale = false;
  Vector values;  ///< unless scale

  bool operator==(const PreloadDirection& other) const {
    return scale == other.scale && values == other.values;
  }
};

/// What whoever asks may choose. Unset members leave the grasp file's own values.
struct Options {
  std::optional<Vector> wrench;
  std::optional<Rational> preload;  ///< for all contacts, >= 0
  bool bilateral = false;           ///< the normal law
  std::optional<Vector> direction;  ///< of wrenches
  std::optional<PreloadDirection> preload_direction;
  std::optional<std::string> case_name;  ///< whose wrench is asked about, if none is given

  /// Whether the margin along a direction is asked for, and not one verdict.
  bool margin() const { return direction || preload_direction; }
};

/// What is known of one contact.
struct Row {
  Vector normal;   ///< N
  Vector tangent;  ///< T
  Rational friction;
  Vector v;  ///< of a point: v_i(x) = v.x

  // The same in integers, up to positive factors; `weight` is the product of those of v_form
  // and of both edges, so that v_i(x) (N -+ mu T) = weight (v_form.x) edge.
  Form v_form;
  Form slip_form;  ///< of a point: tau_i
  Form edges[2];   ///< N - mu T, N + mu T
  Rational weight;
};

struct Question {
  Options asked;
  Vector wrench;  ///< w
  Vector growth;  ///< u; 0 for one verdict
  std::vector<Row> rows;
};

/// Throws Malformed, with "the question" or with `file`, if it cannot be asked of this grasp.
Question pose(const Grasp& grasp, const Options& options, const std::string& file);

}  // namespace stickslip_check
