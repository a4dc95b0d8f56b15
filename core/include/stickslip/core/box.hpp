// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Grasps in the plane or in space of which some numbers are known as intervals: all grasps in
/// a box at once. What is known exactly is an interval of one number.
///
/// Frame in space: the object frame, right-handed. A twist d = (u, omega) moves the point p to
/// p + u + omega x p; a wrench is a force and its torque about the origin. Friction is
/// Coulomb's cone (certificate/FORMAT.md, section 1), without a choice of tangents. The plane
/// has the conventions of grasp.hpp.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "stickslip/core/grasp.hpp"
#include "stickslip/core/mechanism.hpp"
#include "stickslip/core/row.hpp"

namespace stickslip {

/// A contact of which every number may be an interval; vectors have two coordinates in the
/// plane and three in space. The normal has any direction whose angle to n has a tangent of at
/// most the slope.
struct UncertainContact {
  std::vector<Interval> position;  ///< of the point of contact, in the object frame
  RationalRow normal;              ///< n, nonzero, points into the object; of any length
  Interval friction;               ///< coefficient mu >= 0
  Interval stiffness{1, 1};        ///< of the normal spring, k > 0, force per length
  Interval preload{};              ///< P >= 0, force
  Rational slope{0};               ///< of the normal, 0 <= slope < 1

  /// In space: e >= 0, a length: the friction of a soft pad has a moment about the normal, at
  /// most e times as large as a force across it (certificate/FORMAT.md, section 15). With one
  /// the normal is certain.
  Rational torsion{0};

  /// \{ Of several bodies: the one that is pressed, into which the normal points, and the
  /// other.
  BodyIndex of{};
  BodyIndex by{};
  /// \}
};

/// A way in which a normal may turn: n + e direction for some |e| <= most.
struct Turn {
  RationalRow direction;  ///< across n
  Rational most;          ///< >= 0
};

/// Those of a contact, all at once. In the plane there is one, by (-n_y, n_x) and the slope. In
/// space two, u and v of certificate/FORMAT.md, section 6; every normal of the contact is among
/// n + e_u u + e_v v, and some others are: of those the tangent is up to 1.42 times the slope.
std::vector<Turn> turns_of(const UncertainContact& contact);
/// n + the sum of e_j direction_j.
RationalRow turned(RationalRow normal, const std::vector<Turn>& turns, const RationalRow& e);

/// The components of a wrench: (x, y, torque), in space force x, y, z and torque x, y, z; of
/// several bodies one for each coordinate of a state.
using WrenchBox = std::vector<Interval>;

/// How far numbers of a kind may be off: by t, or by t times their size.
struct Tolerance {
  Rational amount{0};     ///< t >= 0
  bool relative = false;  ///< t is a factor: 1/10 for 10 %

  /// The interval widened at both ends: [A - t, B + t] or [A - t|A|, B + t|B|].
  Interval widen(const Interval& interval) const;
  /// As it is spelled: of 10 %, 10.
  Rational spelled() const { return relative ? Rational(100 * amount) : amount; }
  /// The same meaning.
  friend bool operator==(const Tolerance& a, const Tolerance& b) {
    return a.amount == b.amount && a.relative == b.relative;
  }
};

/// Loads around one that is certain (certificate/FORMAT.md, section 6): with it that of every
/// force f and torque tau at a point of the body with |f|^2 + |tau|^2 / length^2 <= radius^2.
struct LoadBall {
  Rational radius;      ///< > 0, a force
  Rational length{1};   ///< > 0
  RationalRow about{};  ///< the point; empty: the origin
  std::string body{};   ///< of several bodies that which is loaded; else empty

  /// Sets the point; one of two or three coordinates that are 0 is the origin.
  void set_about(RationalRow point);
  /// |f|^2 + |tau|^2 / length^2 of z = (f, tau), of three numbers in the plane, six in space.
  Rational squared_norm(const RationalRow& z) const;
  /// The same loads.
  friend bool operator==(const LoadBall& a, const LoadBall& b) {
    return a.radius == b.radius && a.length == b.length && a.about == b.about &&
           a.body == b.body;
  }
};

/// A tolerance for each kind of number; nothing: as it stands. That of normals is a slope, and
/// not relative.
struct Tolerances {
  std::optional<Tolerance> friction{};   ///< of each coefficient
  std::optional<Tolerance> stiffness{};  ///< of each stiffness
  std::optional<Tolerance> preload{};    ///< of each preload
  std::optional<Tolerance> position{};   ///< of each coordinate
  std::optional<Tolerance> normal{};     ///< of each slope
  std::optional<Tolerance> wrench{};     ///< of each component
  std::optional<LoadBall> ball{};        ///< in place of `wrench`

  /// Whether any is given.
  bool any() const {
    return friction || stiffness || preload || position || normal || wrench || ball;
  }
  /// The same tolerances.
  friend bool operator==(const Tolerances& a, const Tolerances& b) {
    return a.friction == b.friction && a.stiffness == b.stiffness && a.preload == b.preload &&
           a.position == b.position && a.normal == b.normal && a.wrench == b.wrench &&
           a.ball == b.ball;
  }
};

/// A tolerance and the kind of number that it is of: "friction".
struct NamedTolerance {
  const char* kind;     ///< as in parse_tolerances
  Tolerance tolerance;  ///< of each number of that kind
};

/// Those that are given, in the order of the members of Tolerances; a ball is none.
std::vector<NamedTolerance> given(const Tolerances& tolerances);

/// "friction=10%,normal=0.0175": decimals or fractions, each kind at most once; that of
/// `wrench` may be a ball, "wrench=ball:1/2:length=2:about=3:0:body=cup", of which all but the
/// radius may be left out. Throws InputError with the place "uncertain".
Tolerances parse_tolerances(std::string_view text);

/// A ball as parse_tolerances() reads it, without "wrench=".
std::string to_string(const LoadBall& ball);

/// Contacts and a wrench with numbers in intervals, all in the plane or all in space.
/// *Elements* are its contacts and then its springs, and a ContactId may be of either.
struct GraspBox {
  std::vector<UncertainContact> contacts;        ///< by ContactId
  WrenchBox wrench;                              ///< w, applied to the object
  GraspDescription description{};                ///< an outline in the plane, a body in space
  std::shared_ptr<const Mechanism> mechanism{};  ///< of several bodies; null: there is one
  std::vector<Spring> springs{};                 ///< of several bodies: ratchets first
  std::optional<LoadBall> ball{};                ///< beside a wrench that is certain
  /// B > 0: only equilibria with |d_j| <= B_j are asked about, a number for each coordinate of
  /// motions; empty: all are.
  RationalRow max_motion{};

  /// Whether motions are bounded.
  bool is_bounded() const { return !max_motion.empty(); }
  /// Whether a motion is within the bound, if there is one.
  bool allows(const RationalRow& motion) const;
  /// Whether it has three coordinates.
  bool in_space() const { return mechanism ? mechanism->in_space : wrench.size() == 6; }
  /// Whether it is one body in the plane.
  bool is_one_planar_body() const { return !mechanism && !in_space(); }
  /// How many contacts and springs.
  std::size_t elements() const { return contacts.size() + springs.size(); }
  /// How the body of the ball moves at its point: a row for each component of a force and a
  /// torque there, as a function of motions. Requires that there is a ball.
  std::vector<RationalRow> ball_motion() const;
  /// How far each of these components may be from 0.
  RationalRow ball_reach() const;
  /// Whether every interval is one number and every slope 0, and there is no ball.
  bool is_point() const;
  /// Throws InputError naming "contacts[i].<member>" or "wrench[j]" for a normal of 0, a
  /// friction coefficient or preload that may be below 0, a stiffness that may be 0 or below, a
  /// slope of 1 or more, or an interval whose ends are exchanged; and "uncertain" for a ball
  /// that cannot be here.
  void check() const;
  /// Widened by the tolerances, and checked. Throws InputError as check() does.
  GraspBox widened(const Tolerances& tolerances) const;
  /// Each interval shrunk or grown about the value in `centre`, one grasp inside it: its ends
  /// are centre + factor (end - centre); slopes and the ball times factor. factor >= 0. Throws
  /// as check().
  GraspBox scaled(const GraspBox& centre, const Rational& factor) const;
  /// The one grasp in the middle of every interval, with the normals n.
  GraspBox middle() const;
  /// The same, of a box in the plane.
  LoadedGrasp planar_middle() const;
};

/// Calls f of every number that may be an interval, in the order of a file. (The slope of a
/// normal is none, and no ball.)
template <class Box, class Function>
void for_each_number(Box& box, Function f) {
  for (auto& c : box.contacts) {
    for (auto& coordinate : c.position) f(coordinate);
    f(c.friction);
    f(c.stiffness);
    f(c.preload);
  }
  for (auto& spring : box.springs) {
    f(spring.stiffness);
    f(spring.force);
  }
  for (auto& component : box.wrench) f(component);
}

/// The wrench in the middle of every interval, in the plane.
Wrench planar_middle(const WrenchBox& wrench);

/// \{ A wrench in the plane as a row, and back.
RationalRow row_of(const Wrench& wrench);
Wrench wrench_of(const RationalRow& row);
/// \}

/// A twist or a wrench in space: translation x, y, z and rotation x, y, z, in radians; force
/// and torque.
using Vector6 = std::array<Rational, 6>;

/// A vector in space.
inline Vector3 vector3(const RationalRow& row) {
  return {row.at(0), row.at(1), row.at(2)};
}

/// A grasp with its load as files have it: one in the plane, in little memory; or all in a box,
/// perhaps of one point, in the plane or in space.
using AnyGrasp = std::variant<LoadedGrasp, GraspBox>;

/// Whether it has three coordinates.
bool in_space(const AnyGrasp& grasp);
/// What it says of several bodies; null: there is one.
const Mechanism* mechanism_of(const AnyGrasp& grasp);
/// What is known of it for people.
const GraspDescription& description_of(const AnyGrasp& grasp);
/// Its load.
WrenchBox wrench_of(const AnyGrasp& grasp);

/// \{ The box of one grasp, contact or wrench in the plane; a box is its own.
GraspBox box_of(const AnyGrasp& grasp);
GraspBox box_of(const LoadedGrasp& loaded);
UncertainContact box_of(const Contact& contact);
WrenchBox box_of(const Wrench& wrench);
/// \}

/// Whether 1/|n| of some contact that may have a preload is irrational, so that even the box of
/// one grasp is known by an enclosure only.
bool needs_enclosure(const GraspBox& box);

}  // namespace stickslip
