// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A mechanism of several bodies: bodies that move freely, links on hinges and slides, the
/// joints that turn them, and springs (certificate/FORMAT.md, section 14).
///
/// All are in one frame. A *state* z has the motion of each body that is no link, a twist about
/// the origin, in the order of bodies, and then one coordinate for each joint. A link moves as
/// the body that it is on, and besides as its joints turn it.
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

  /// Returns whether the interval is one number.
  bool is_point() const { return low == high; }
  /// Returns (low + high) / 2.
  Rational middle() const { return (low + high) / 2; }
  /// Returns whether low <= x <= high.
  bool contains(const Rational& x) const { return low <= x && x <= high; }
  /// Compares the two ends.
  friend bool operator==(const Interval& a, const Interval& b) {
    return a.low == b.low && a.high == b.high;
  }
};

/// Returns the interval of one number.
inline Interval point_interval(const Rational& x) {
  return {x, x};
}

/// The index of a body in Mechanism::bodies. Without a value it means the ground.
using BodyIndex = std::optional<std::size_t>;

/// A hinge or slide by which the body that it is on holds another one.
struct Link {
  bool slides = false;  ///< whether the body slides along `axis`; else it turns
  RationalRow at{};     ///< a point of the axis of a hinge
  /// The axis of a slide, or of a hinge in space; not 0. A unit of a joint moves the link by
  /// this vector, or turns it by the vector's length in radians, right-handed. It is empty for
  /// a hinge in the plane, about which a unit turns by a radian, counter-clockwise.
  RationalRow axis{};
  BodyIndex on{};  ///< the body that holds it, which stands before it
};

/// One of several bodies.
struct Body {
  std::string name;                    ///< unique, not empty, and not "ground"
  std::optional<Link> link{};          ///< nothing: it moves freely
  std::vector<Polygon> outline{};      ///< the outline of a body in the plane; may be empty
  std::shared_ptr<const Mesh> mesh{};  ///< the surface of a body in space; may be null
  std::vector<RationalRow> weights{};  ///< the points where the file's weights pull at it
};

/// The rates of links: pairs of a link's index in Mechanism::bodies and how fast it turns or
/// slides, a number that is not 0.
using LinkRates = std::vector<std::pair<std::size_t, Rational>>;

/// A joint: one coordinate by which links turn.
struct Joint {
  std::string name;  ///< may be empty
  LinkRates turns;   ///< how fast it turns links, per unit
};

/// Bodies and joints. Functions take O(D) for each link that they follow.
struct Mechanism {
  bool in_space = false;        ///< whether points have three coordinates
  std::vector<Body> bodies{};   ///< the bodies, links after those that they are on
  std::vector<Joint> joints{};  ///< the joints; each turns a link, and each link is turned

  /// Returns D, the number of coordinates of states.
  std::size_t coordinates() const;
  /// Returns the first coordinate of a body that is no link.
  std::size_t first_coordinate(std::size_t body) const;
  /// Returns the coordinate of a joint.
  std::size_t joint_coordinate(std::size_t joint) const;
  /// Returns J of a body, its twist as functions of states: 3 rows in the plane, 6 in space.
  std::vector<RationalRow> motion_of(BodyIndex body) const;
  /// Returns J^T of a body times a wrench on it: the generalised force, 0 where it is not
  /// listed.
  SparseRow load_on(BodyIndex body, const RationalRow& wrench) const;
  /// Returns J_of - J_by, the motion of one body relative to another.
  std::vector<RationalRow> motion_between(BodyIndex of, BodyIndex by) const;
  /// Returns the sum of r_b times how each link b turns, as a function of states.
  RationalRow row_of(const LinkRates& over) const;
  /// Returns "box.x", "box.turn" or the like, or for a joint its name or "joint 0".
  std::string coordinate_name(std::size_t coordinate) const;
  /// Returns whether the coordinate is an angle and not a length.
  bool is_rotation(std::size_t coordinate) const;
  /// Returns the body's name, or "ground".
  std::string name_of(BodyIndex body) const;
  /// Returns the body of this name. Throws InputError at `path` if there is none.
  std::size_t body_named(const std::string& name, const std::string& path) const;
};

/// Returns the names of all coordinates.
std::vector<std::string> coordinate_names(const Mechanism& mechanism);

/// A force that does work along a linear function of states, `row`, without friction. That of a
/// ratchet is max(0, P - k row.z), and that of a spring is P - k row.z, of either sign.
struct Spring {
  /// The list of the file that it stands in.
  enum class Kind { kRatchet, kJoint, kTendon };

  Kind kind = Kind::kTendon;  ///< its list
  std::string place{};        ///< its path in the file, "joints[1]"
  std::string name{};         ///< may be empty
  std::size_t joint = 0;      ///< the index of the joint, if it stands in "joints"
  LinkRates over{};           ///< the links that it acts on, if it stands elsewhere
  RationalRow row{};          ///< the function, which follows from `joint` or `over`; not 0
  Interval stiffness{};       ///< k >= 0, above 0 for a ratchet
  Interval force{};           ///< P: a torque or tension, or the preload >= 0 of a ratchet

  /// Returns whether it only pushes.
  bool is_ratchet() const { return kind == Kind::kRatchet; }
};

/// Returns "preload", "torque" or "tension", the member of a file that has its force.
const char* force_name(const Spring& spring);

}  // namespace stickslip
