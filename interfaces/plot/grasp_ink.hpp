// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The content of a picture of a verdict in scene coordinates (picture_frame.hpp), before it is
/// laid out on a page.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "grasp_scene.hpp"
#include "marks.hpp"
#include "stickslip/engine/box_verdict.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip::plot_detail {

struct Arrow {
  InkPoint tail;
  InkPoint tip;
  std::string css_class;  ///< "load", "force", "motion" or "virtual"
  Svg::Attributes attributes;
};

/// A body as rings, as it is seen from one side.
struct BodyInk {
  std::string name{};                            ///< its name, of several
  std::vector<std::vector<InkPoint>> outline{};  ///< none: its shape is not known
  std::vector<std::vector<InkPoint>> ghost{};   ///< the outline after the motion or the virtual
                                                ///< twist
  RingsAround within = RingsAround::kOddTimes;  ///< the meaning of outline and ghost
  std::optional<std::array<InkPoint, 2>> held{};  ///< a piece of the joint's line of a link
};

/// The grasp as it is seen from one side, in the plane or in space.
struct SceneInk {
  std::string heading;                    ///< empty in the plane
  std::array<std::size_t, 2> axes{0, 1};  ///< the axes of the object frame that point right and
                                          ///< up
  std::vector<ContactInk> contacts;
  std::vector<std::vector<InkPoint>> cones;  ///< by contact: a polygon
  std::vector<BodyInk> bodies;
  std::optional<InkPoint> pivot;  ///< the centre of rotation of the virtual twist, if near
  std::vector<Arrow> arrows;      ///< some may have no length
  Rational torque{0};  ///< the load's torque about the centre; counterclockwise as seen

  bool has_outline() const;
  bool has_ghost() const;
};

struct GraspInk {
  std::string title;               ///< the names of the grasp and its case
  std::optional<Units> units;      ///< nothing if nobody gave them
  bool of_several = false;         ///< whether there are several bodies
  bool outline_is_given = false;   ///< whether all outlines are given; else some are hulls of
                                   ///< their contacts
  std::vector<Rational> preloads;  ///< by contact
  std::vector<ContactMark> marks;  ///< by contact
  std::vector<SceneInk> scenes;    ///< one in the plane, three in space
  double cone_length = 0;          ///< the length of cones and normals
  Rational force_unit{0};          ///< the largest force, 0 if there is none; drawn this long:
  static constexpr double kLongestForce = 0.6;
  Rational load_factor{1};     ///< the enlargement of the load beyond the other forces
  std::string torque;          ///< the load's torque about the centre; empty if there is none
  Rational motion_factor{0};   ///< the enlargement of motions; 0 without such arrows
  Rational virtual_factor{0};  ///< the enlargement of virtual twists; 0 without such arrows
  std::vector<std::string> caption;  ///< paragraphs

  /// Returns the length of a force of this size, or the force as an arrow.
  double force_length(const Rational& size) const;
  InkPoint force(const Vector2& exact) const;

  void set_title(const std::string& name, const std::string& of_case);
  /// Chooses the size of cones, and the least force unit, by the preloads.
  void choose_sizes();
  /// Enlarges a load whose largest component is `largest`, if it would be too short to see.
  void choose_load_factor(const Rational& largest);
  /// \{ Add to the caption a load, or one with its coordinates, drawn at the centre, with this
  /// torque there.
  void describe_load(const std::string& load, NormalLaw law);
  void describe_load(const std::vector<Rational>& wrench, const std::vector<Rational>& centre,
                     const std::string& torque_there, NormalLaw law);
  /// \}
  /// Adds to the caption a motion, and a remark on the forces.
  void describe_motion(const std::string& motion, const std::string& of_forces);
};

/// Returns "1/2,-3": a force or a motion as an attribute has it.
std::string pair_text(const Vector2& v);

/// Returns a cone in the plane: a sector, so that wide cones look wide.
std::vector<InkPoint> planar_cone(const ContactInk& contact, const Rational& friction,
                                  double length);

/// Returns a round factor for motions whose largest component is `largest`, in a scene of this
/// radius; 0 if nothing moves.
Rational enlargement(const Rational& largest, const Rational& radius);

/// \{ Return the ink of one planar body whose numbers are rational; that of all others. Throw as
/// plot_grasp does.
GraspInk grasp_ink(const Question& question, const Verdict& verdict);
GraspInk bodies_ink(const Question& question, const Verdict& verdict);
/// \}

}  // namespace stickslip::plot_detail
