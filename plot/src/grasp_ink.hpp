// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What a picture of a verdict says, in scene coordinates (picture_frame.hpp), before it is
/// laid out on a page.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grasp_scene.hpp"
#include "marks.hpp"
#include "stickslip/equilibrium/question.hpp"
#include "stickslip/equilibrium/verdict.hpp"

namespace stickslip::plot_detail {

struct Arrow {
  InkPoint tail;
  InkPoint tip;
  std::string css_class;  ///< "load", "force", "motion" or "virtual"
  Svg::Attributes attributes;
};

struct GraspInk {
  PictureFrame frame;
  std::vector<ContactInk> contacts;
  std::vector<ContactMark> marks;              ///< by contact
  std::vector<std::vector<InkPoint>> cones;    ///< by contact: a sector, apex first
  std::vector<std::vector<InkPoint>> outline;  ///< rings of the body
  std::vector<std::vector<InkPoint>> ghost;    ///< after the motion or the virtual twist
  std::optional<InkPoint> pivot;  ///< the centre of rotation of the virtual twist, if near
  std::vector<Arrow> arrows;      ///< some may have no length
  Rational force_unit{0};         ///< the largest force, 0 if there is none; drawn this long:
  static constexpr double kLongestForce = 0.6;
  Rational load_factor{1};           ///< of enlargement of the load beyond the other forces
  Rational torque;                   ///< of the load, about the centre of the frame
  Rational motion_factor{0};         ///< of enlargement; 0 without such arrows
  Rational virtual_factor{0};        ///< likewise
  std::vector<std::string> caption;  ///< paragraphs

  /// A force of this size along a direction, or this force.
  double force_length(const Rational& size) const;
  InkPoint force(const Vector2& exact) const;
};

/// Throws as plot_grasp does.
GraspInk grasp_ink(const Question& question, const Verdict& verdict);

}  // namespace stickslip::plot_detail
