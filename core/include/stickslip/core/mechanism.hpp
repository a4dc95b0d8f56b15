// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A mechanism of several bodies (certificate/FORMAT.md, section 14): bodies that move freely;
/// *links*, which are bodies held by a hinge or a slide on another body or the ground;
/// *joints*, the coordinates by which links turn or slide there; and springs.
///
/// Points and vectors of all bodies are given in one frame. A *state* z is a motion of the
/// whole mechanism: first the twist, about the origin of the frame, of each body that is no
/// link, in the order of bodies, and then one coordinate for each joint. Rotations are in
/// radians. A link has the twist of the body that holds it, plus the twists by which its joints
/// move it.
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

/// A hinge or a slide that holds a body on another one, or on the ground.
struct Link {
  bool slides = false;  ///< whether the body slides along `axis`; else it turns about a hinge
  RationalRow at{};     ///< a point on the axis of a hinge
  /// The axis of a slide, or of a hinge in space; not 0. A unit of a joint moves the link by
  /// this vector, or turns it by the vector's length in radians, right-handed. It is empty for
  /// a hinge in the plane, about which a unit turns by a radian, counter-clockwise.
  RationalRow axis{};
  BodyIndex on{};  ///< the body that holds the link; it stands before the link in `bodies`
};

/// One of several bodies.
struct Body {
  std::string name;                    ///< unique, not empty, and not "ground"
  std::optional<Link> link{};          ///< its hinge or slide; nothing: it moves freely
  std::vector<Polygon> outline{};      ///< the outline of a body in the plane; may be empty
  std::shared_ptr<const Mesh> mesh{};  ///< the surface of a body in space; may be null
  std::vector<RationalRow> weights{};  ///< the points at which the file's weights act on it
};

/// The rates of links: pairs of a link's index in Mechanism::bodies and a number that is not 0.
/// For a joint the number is how far the link turns or slides, in units of Link::axis, per unit
/// of the joint; for a spring it is the lever arm of the spring's force on the link.
using LinkRates = std::vector<std::pair<std::size_t, Rational>>;

/// A joint: one coordinate by which one link, or several together, turn or slide.
struct Joint {
  std::string name;  ///< the name; may be empty
  LinkRates turns;   ///< the links that it moves, with their rates
};

/// Bodies and joints. Functions of one body follow its links down to a free body or the ground,
/// and take O(D) for each of these.
struct Mechanism {
  bool in_space = false;        ///< whether points have three coordinates
  std::vector<Body> bodies{};   ///< the bodies, links after those that they are on
  std::vector<Joint> joints{};  ///< the joints; each moves a link, and each link is moved

  /// Returns D, the number of coordinates of states.
  std::size_t coordinates() const;
  /// Returns the index in a state at which the twist of a body begins. Requires that the body
  /// is no link.
  std::size_t first_coordinate(std::size_t body) const;
  /// Returns the index in a state of a joint's coordinate.
  std::size_t joint_coordinate(std::size_t joint) const;
  /// Returns the Jacobian J of a body: its twist is J z, with 3 rows in the plane and 6 in
  /// space. That of the ground is 0.
  std::vector<RationalRow> motion_of(BodyIndex body) const;
  /// Returns J^T times a wrench on a body: the generalised force, a number for each coordinate
  /// of states. Coordinates that are not listed have 0.
  SparseRow load_on(BodyIndex body, const RationalRow& wrench) const;
  /// Returns J_of - J_by, so that its product with z is the twist of `of` relative to `by`.
  std::vector<RationalRow> motion_between(BodyIndex of, BodyIndex by) const;
  /// Returns, as a function of states, the sum over links b of the number in `over` times how
  /// far b turns or slides on the body that holds it.
  RationalRow row_of(const LinkRates& over) const;
  /// Returns the name of a coordinate of states: "box.x", "box.turn" or the like for a body
  /// "box"; for a joint its name, or "joint 0" if it has none.
  std::string coordinate_name(std::size_t coordinate) const;
  /// Returns whether a coordinate of states is an angle and not a length. That of a joint is an
  /// angle if it turns any link, even where it also slides others.
  bool is_rotation(std::size_t coordinate) const;
  /// Returns the body's name, or "ground".
  std::string name_of(BodyIndex body) const;
  /// Returns the body of this name. Throws InputError at `path` if there is none.
  std::size_t body_named(const std::string& name, const std::string& path) const;
};

/// Returns the names of all coordinates.
std::vector<std::string> coordinate_names(const Mechanism& mechanism);

/// Returns a row of one body, as a linear function of its twists, as one of states, if `motion`
/// gives its twist as a function of states. An empty `motion` leaves the row as it is.
RationalRow moved_by(const RationalRow& row, const std::vector<RationalRow>& motion);

/// A spring or a ratchet: a force F without friction that acts on the length or angle row.z, so
/// that its generalised force is F row. F is P - k row.z, of either sign; that of a ratchet
/// only pushes, and is max(0, P - k row.z).
struct Spring {
  /// The list of the file in which it stands: "ratchets", "joints" or "tendons".
  enum class Kind { kRatchet, kJoint, kTendon };

  Kind kind = Kind::kTendon;  ///< the list in which it stands
  std::string place{};        ///< its path in the file, such as "joints[1]"
  std::string name{};         ///< the name; may be empty
  std::size_t joint = 0;      ///< the index of the joint that it acts on, if it is in "joints"
  LinkRates over{};           ///< the links that it acts on, if it is in another list
  RationalRow row{};          ///< the row, which follows from `joint` or `over`; not 0
  Interval stiffness{};       ///< k >= 0, above 0 for a ratchet
  Interval force{};           ///< P: a torque or tension, or the preload >= 0 of a ratchet
  /// The most that the torque of a joint's motor may be in size, >= 0. To statics, which alone
  /// knows it, the motor then exerts any such torque, whatever its stiffness.
  std::optional<Rational> max_torque{};

  /// Returns whether it only pushes.
  bool is_ratchet() const { return kind == Kind::kRatchet; }
};

/// Returns the name of the member of a file that has a spring's force: "preload" for a ratchet,
/// "torque" for a joint, "tension" for a tendon.
const char* force_name(const Spring& spring);

}  // namespace stickslip
