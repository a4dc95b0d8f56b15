// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Several bodies: those that move freely, links on hinges and slides, the joints that turn
/// them, and springs (certificate/FORMAT.md, section 14).
///
/// All are in one frame. A *state* z has the motion of each body that is no link, a twist about
/// the origin, in the order of bodies, and then one coordinate for each joint. A link moves as
/// the body that it is on and as its joints turn it.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stickslip/core/grasp.hpp"
#include "stickslip/core/row.hpp"

namespace stickslip {

/// The numbers from low to high, both included; low <= high.
struct Interval {
  Rational low{0};   ///< the least
  Rational high{0};  ///< the greatest

  /// One number.
  bool is_point() const { return low == high; }
  /// (low + high) / 2.
  Rational middle() const { return (low + high) / 2; }
  /// low <= x <= high.
  bool contains(const Rational& x) const { return low <= x && x <= high; }
  /// The same two ends.
  friend bool operator==(const Interval& a, const Interval& b) {
    return a.low == b.low && a.high == b.high;
  }
};

/// The interval of one number.
inline Interval point_interval(const Rational& x) {
  return {x, x};
}

/// A body by its index in Mechanism::bodies; nothing: the ground.
using BodyIndex = std::optional<std::size_t>;

/// How a body is held by the one that it is on.
struct Link {
  bool slides = false;  ///< along `axis`; else it turns
  RationalRow at{};     ///< of a hinge a point of its axis
  RationalRow axis{};   ///< of a slide, and of a hinge in space; not 0. A unit of a joint
                        ///< turns or moves by its length. Empty of a hinge in the plane
  BodyIndex on{};       ///< stands before it
};

/// One of several bodies.
struct Body {
  std::string name;                    ///< not empty, not "ground", unlike all others
  std::optional<Link> link{};          ///< nothing: it moves freely
  std::vector<Polygon> outline{};      ///< in the plane; may be empty
  std::shared_ptr<const Mesh> mesh{};  ///< in space; may be null
  std::vector<RationalRow> weights{};  ///< where weights of its file pull at it: points of it
};

/// Numbers != 0 for links: how fast each turns.
using LinkRates = std::vector<std::pair<std::size_t, Rational>>;

/// One coordinate, by which links turn.
struct Joint {
  std::string name;  ///< may be empty
  LinkRates turns;   ///< per unit
};

/// Bodies and joints. O(D) for each link to follow.
struct Mechanism {
  bool in_space = false;        ///< of three coordinates
  std::vector<Body> bodies{};   ///< links after those that they are on
  std::vector<Joint> joints{};  ///< each turns a link, and each link is turned

  /// D, the number of coordinates of states.
  std::size_t coordinates() const;
  /// The first coordinate of a body that is no link.
  std::size_t first_coordinate(std::size_t body) const;
  /// That of a joint.
  std::size_t joint_coordinate(std::size_t joint) const;
  /// J of a body, of 3 rows in the plane and 6 in space: its twist as functions of states.
  std::vector<RationalRow> motion_of(BodyIndex body) const;
  /// J_of - J_by.
  std::vector<RationalRow> motion_between(BodyIndex of, BodyIndex by) const;
  /// The sum of r_b times how each link turns, as a function of states.
  RationalRow row_of(const LinkRates& over) const;
  /// "box.x", "box.turn" or the like; of a joint its name, or "joint 0".
  std::string coordinate_name(std::size_t coordinate) const;
  /// Whether it is an angle and not a length.
  bool is_rotation(std::size_t coordinate) const;
  /// "ground", or the body's name.
  std::string name_of(BodyIndex body) const;
  /// The one of this name. Throws InputError at `path` if there is none.
  std::size_t body_named(const std::string& name, const std::string& path) const;
};

/// Those of all coordinates.
std::vector<std::string> coordinate_names(const Mechanism& mechanism);

/// A force along a row of states, without friction: of a ratchet max(0, P - k row.z), of a
/// spring P - k row.z of either sign.
struct Spring {
  /// What it is in the file.
  enum class Kind { kRatchet, kJoint, kTendon };

  Kind kind = Kind::kTendon;  ///< of its list
  std::string place{};        ///< in its file, "joints[1]"
  std::string name{};         ///< may be empty
  std::size_t joint = 0;      ///< of a joint its own index
  LinkRates over{};           ///< of all others
  RationalRow row{};          ///< not 0
  Interval stiffness{};       ///< k >= 0, above 0 of a ratchet
  Interval force{};           ///< P: torque or tension, of a ratchet the preload, >= 0

  /// Whether it pushes only.
  bool is_ratchet() const { return kind == Kind::kRatchet; }
};

/// "preload", "torque" or "tension": the member of a file that has its force.
const char* force_name(const Spring& spring);

}  // namespace stickslip
