// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The step from exact numbers to ink. Everything is divided by the size of the picture
/// exactly, so that no double is ever out of range.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "stickslip/core/grasp.hpp"
#include "stickslip/interfaces/svg.hpp"

namespace stickslip::plot_detail {

/// The place and size of a grasp. The scene has its origin in `centre`, the unit `radius`, and
/// the axes of the object frame (y up): contacts and outline lie in [-1, 1]^2.
struct PictureFrame {
  Vector2 centre;
  Rational radius{1};

  InkPoint place(const Vector2& point) const;
  /// Returns the grasp in scene coordinates, exactly.
  Grasp in_scene(const Grasp& grasp) const;
};

/// The place and size of points that have one number for each axis, as a PictureFrame has them.
struct Surroundings {
  std::vector<Rational> centre;  ///< by axis
  Rational radius{1};
};
/// Returns surroundings centred in the origin or, if that is far away compared with the size of
/// the points, in the middle of them.
Surroundings surroundings(const std::vector<std::vector<Rational>>& points, std::size_t axes);

/// Returns the surroundings of contacts and outline.
PictureFrame picture_frame(const Grasp& grasp);

/// Returns (x, y) / size, for |x|, |y| up to about size > 0.
InkPoint ratio(const Vector2& vector, const Rational& size);
/// Returns the direction of length 1. Requires a nonzero vector.
InkPoint direction(const Vector2& vector);
/// Returns max(|x|, |y|).
Rational largest_entry(const Vector2& vector);

/// Returns the largest of 1, 2, 5 times a power of ten that is not above `value` > 0.
Rational round_down(const Rational& value);

/// Returns to_readable_string with minus signs as U+2212: "3/5", "~0.333333".
std::string short_text(const Rational& value);

/// Returns points as labels of one picture. All are in short fractions, "(-8/3, 2)"; or, if
/// some coordinate has no short fraction, all are in decimals of at most four digits, with one
/// mark before a rounded point: "~(-2.667, 2)".
std::vector<std::string> point_labels(const std::vector<std::array<Rational, 2>>& points);
/// Returns "(0, 1, \u22121/2)".
std::string short_tuple(const std::vector<Rational>& values);
/// Returns the name of a unit as it stands behind a number, with a blank before; nothing if
/// nobody gave units.
std::string force_unit(const std::optional<Units>& units);
std::string length_unit(const std::optional<Units>& units);
std::string torque_unit(const std::optional<Units>& units);
/// Returns the text with '-' as U+2212.
std::string typeset(std::string text);

/// The place of the scene on the page.
struct View {
  InkPoint origin;   ///< the origin of the scene
  double scale = 1;  ///< pixels per scene unit

  InkPoint operator()(InkPoint scene) const {
    return {origin.x + scale * scene.x, origin.y - scale * scene.y};
  }
};

}  // namespace stickslip::plot_detail
