// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Boxes of grasps, in the plane or in space. Some numbers of a grasp are known only as
/// intervals; the box is the set of all grasps whose numbers are in these intervals. A number
/// that is known exactly has an interval of one number.
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
#include <utility>
#include <variant>
#include <vector>

#include "stickslip/core/grasp.hpp"
#include "stickslip/core/mechanism.hpp"
#include "stickslip/core/row.hpp"

namespace stickslip {

/// A contact whose numbers may all be intervals. Vectors have two coordinates in the plane and
/// three in space. The normal is uncertain in direction: any whose angle to n has a tangent of
/// at most the slope.
struct UncertainContact {
  std::vector<Interval> position;  ///< the point of contact, in the object frame
  RationalRow normal;              ///< n, nonzero and of any length, points into the object
  Interval friction;               ///< the coefficient mu >= 0
  Interval stiffness{1, 1};  ///< the stiffness k > 0 of the normal spring, force per length
  Interval preload{};        ///< P >= 0, force
  Rational slope{0};         ///< the slope of the normal, 0 <= slope < 1

  /// The torsion e >= 0 of a contact in space, a length: with it friction is a tangential force
  /// f and a moment m about the normal, |f|^2 + m^2 / e^2 <= (mu c)^2 for the normal force c,
  /// as of a soft finger (certificate/FORMAT.md, section 15). If e is not 0, the normal is
  /// certain.
  Rational torsion{0};

  /// The most that the normal force may be, >= 0. Statics alone knows it: how a contact yields
  /// at its limit would be another law. If there is one, the normal has a rational length.
  std::optional<Rational> max_force{};

  /// \{ The two bodies in contact, if there are several: the normal points into the body `of`,
  /// which is pressed by the body `by`.
  BodyIndex of{};
  BodyIndex by{};
  /// \}

  /// Returns the position, the low ends of what is uncertain.
  RationalRow point() const;
};

/// A way in which a normal may turn: n becomes n + e direction, with any |e| <= most.
struct Turn {
  RationalRow direction;  ///< perpendicular to n
  Rational most;          ///< >= 0
};

/// Returns the turns of a contact; its normal may turn by all of them together. In the plane
/// there is one, with the direction (-n_y, n_x) and the slope as `most`. In space there are
/// two, with directions u and v that are perpendicular to n and to each other
/// (certificate/FORMAT.md, section 6). The normals n + e_u u + e_v v are all that the contact
/// may have, and some more, as they fill a square around a disc: the tangents of their angles
/// to n are up to 1.42 times the slope.
std::vector<Turn> turns_of(const UncertainContact& contact);
/// Returns n + the sum of e_j direction_j.
RationalRow turned(RationalRow normal, const std::vector<Turn>& turns, const RationalRow& e);

/// The components of a wrench: (x, y, torque) in the plane; force x, y, z and torque x, y, z in
/// space; the generalised force of several bodies, a component for each coordinate of a state
/// (mechanism.hpp).
using WrenchBox = std::vector<Interval>;

/// A tolerance: each number of a kind may be off by t, or by t times its magnitude.
struct Tolerance {
  Rational amount{0};     ///< t >= 0
  bool relative = false;  ///< whether t is a factor: 1/10 for 10 %

  /// Returns the interval widened at both ends: [A - t, B + t] or [A - t|A|, B + t|B|].
  Interval widen(const Interval& interval) const;
  /// Returns the number that a user writes for it: t, or 10 for 10 %.
  Rational spelled() const { return relative ? Rational(100 * amount) : amount; }
  /// Compares both members.
  friend bool operator==(const Tolerance& a, const Tolerance& b) {
    return a.amount == b.amount && a.relative == b.relative;
  }
};

/// A ball of loads around one certain load (certificate/FORMAT.md, section 6): that load
/// together with every force f and torque tau at a point of the body with |f|^2 + |tau|^2 /
/// length^2 <= radius^2.
struct LoadBall {
  Rational radius;      ///< > 0, a force
  Rational length{1};   ///< the length > 0 that torques are divided by
  RationalRow about{};  ///< the point; empty: the origin
  std::string body{};   ///< the loaded one of several bodies; else empty

  /// Sets the point. If all of its two or three coordinates are 0, `about` becomes empty.
  void set_about(RationalRow point);
  /// Returns |f|^2 + |tau|^2 / length^2 of z = (f, tau), three numbers in the plane and six in
  /// space.
  Rational squared_norm(const RationalRow& z) const;
  /// Compares all members.
  friend bool operator==(const LoadBall& a, const LoadBall& b) {
    return a.radius == b.radius && a.length == b.length && a.about == b.about &&
           a.body == b.body;
  }
};

/// A tolerance for each kind of number; numbers without one stay as they are. That of normals
/// is a slope, and not relative.
struct Tolerances {
  std::optional<Tolerance> friction{};   ///< for each coefficient of friction
  std::optional<Tolerance> stiffness{};  ///< for each stiffness
  std::optional<Tolerance> preload{};    ///< for each preload, and force of a spring
  std::optional<Tolerance> position{};   ///< for each coordinate of a position
  std::optional<Tolerance> normal{};     ///< for each slope
  std::optional<Tolerance> wrench{};     ///< for each component of the wrench
  std::optional<LoadBall> ball{};        ///< a ball of loads, instead of `wrench`

  /// Returns whether any is given.
  bool any() const {
    return friction || stiffness || preload || position || normal || wrench || ball;
  }
  /// Compares all members.
  friend bool operator==(const Tolerances& a, const Tolerances& b) {
    return a.friction == b.friction && a.stiffness == b.stiffness && a.preload == b.preload &&
           a.position == b.position && a.normal == b.normal && a.wrench == b.wrench &&
           a.ball == b.ball;
  }
};

/// A tolerance and the name of its kind of number, "friction".
struct NamedTolerance {
  const char* kind;     ///< the name, as parse_tolerances reads it
  Tolerance tolerance;  ///< the tolerance of each number of that kind
};

/// Returns the tolerances that are given, in the order of the members of Tolerances, without a
/// ball.
std::vector<NamedTolerance> given(const Tolerances& tolerances);

/// Reads tolerances from words such as "friction=10%,normal=0.0175": decimals or fractions,
/// each kind at most once. That of `wrench` may be a ball,
/// "wrench=ball:1/2:length=2:about=3:0:body=cup", of which all but the radius, here 1/2, may be
/// left out. Throws InputError with the place "uncertain" for anything else.
Tolerances parse_tolerances(std::string_view text);

/// Returns a ball as parse_tolerances() reads it, without "wrench=".
std::string to_string(const LoadBall& ball);

/// A box of grasps: contacts, springs and a wrench whose numbers are intervals, all in the
/// plane or all in space. Its *elements* are its contacts and then its springs, counted
/// together: a ContactId may be that of either.
struct GraspBox {
  std::vector<UncertainContact> contacts;  ///< the contacts, by ContactId
  WrenchBox wrench;                        ///< w, applied to the object
  GraspDescription description{};          ///< name, units, outline or surface, for people
  /// The mechanism of several bodies; null if there is one body.
  std::shared_ptr<const Mechanism> mechanism{};
  std::vector<Spring> springs{};   ///< the springs of several bodies, ratchets first
  std::optional<LoadBall> ball{};  ///< a ball of loads that are added to a certain wrench
  /// The bound B > 0 of motions, a number for each coordinate: only equilibria with |d_j| <=
  /// B_j are asked about. If it is empty, all are.
  RationalRow max_motion{};

  /// Returns whether motions are bounded.
  bool is_bounded() const { return !max_motion.empty(); }
  /// Returns whether a motion is within the bound, if there is one.
  bool allows(const RationalRow& motion) const;
  /// Returns whether it is in space, whose points have three coordinates.
  bool in_space() const { return mechanism ? mechanism->in_space : wrench.size() == 6; }
  /// Returns the number of contacts and springs.
  std::size_t elements() const { return contacts.size() + springs.size(); }
  /// Returns how the loaded body moves at the point of the ball: the translation of that point
  /// and the rotation of the body, each component a row, a linear function of motions. Throws
  /// ContractError if there is no ball, and InputError if its body is not there.
  std::vector<RationalRow> ball_motion() const;
  /// Returns the largest magnitude of each component of a load in the ball, a force and a
  /// torque at its point: the radius, and radius times length. Throws ContractError if there is
  /// no ball.
  RationalRow ball_reach() const;
  /// Returns the elements whose force is limited, increasing, and the most that it may be: of a
  /// contact its limit over the length of the normal, and of a joint that of the torque, of
  /// either sign.
  std::vector<std::pair<std::size_t, Rational>> force_limits() const;
  /// Returns whether the box is one grasp: every interval is one number, every slope is 0, and
  /// there is no ball.
  bool is_point() const;
  /// Checks that all numbers are in their ranges. These are required:
  ///
  /// - the low end of an interval is at most the high end;
  /// - normals are not 0, and 0 <= slope < 1; a contact with torsion has the slope 0;
  /// - friction coefficients, preloads, torsions, limits of forces and stiffnesses of springs
  ///   are 0 or more, and stiffnesses of contacts and ratchets are above 0, in all of their
  ///   intervals; the normal of a contact with a limit has a rational length;
  /// - a ball has a radius and a length above 0, the right dimension of its point, a certain
  ///   wrench beside it, and of several bodies the name of one.
  ///
  /// Throws InputError naming "contacts[i].<member>", "wrench[j]", the member of a spring, or,
  /// for a ball, "uncertain".
  void check() const;
  /// Returns the box widened by the tolerances, and checked before and after. A ball replaces
  /// that of the box. Throws InputError as check() does, and ContractError for a tolerance of
  /// normals that is relative.
  GraspBox widened(const Tolerances& tolerances) const;
  /// Returns the box with each interval shrunk or grown about its number in `centre`, one grasp
  /// inside the box: its ends are centre + factor (end - centre). Slopes and the radius of the
  /// ball are multiplied by the factor; with the factor 0 there is no ball. Throws
  /// ContractError if factor < 0 or `centre` is not one grasp inside, and InputError as check()
  /// does.
  GraspBox scaled(const GraspBox& centre, const Rational& factor) const;
  /// Returns the one grasp in the middle of every interval, with the normals n and without a
  /// ball.
  GraspBox middle() const;
};

/// Calls f with every Interval of a box: those of contacts, then of springs, then of the
/// wrench. The slope of a normal and a ball are not among them.
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

/// Returns the middle of each interval, as of a wrench.
RationalRow middle_of(const std::vector<Interval>& intervals);

/// Returns the wrench of the force f at the point p, in the plane or in space: the force and
/// its torque about the origin. The product of this row with a twist is f.u, where the twist
/// moves p by u.
RationalRow wrench_at(const RationalRow& p, const RationalRow& f);
/// \{ Converts a wrench in the plane to a row, and back.
RationalRow row_of(const Wrench& wrench);
Wrench wrench_of(const RationalRow& row);
/// \}

/// A twist in space, translation x, y, z and rotation x, y, z in radians; or a wrench in space,
/// force x, y, z and torque x, y, z.
using Vector6 = std::array<Rational, 6>;

/// Returns the vector in space with these three coordinates.
inline Vector3 vector3(const RationalRow& row) {
  return {row.at(0), row.at(1), row.at(2)};
}

/// \{ Returns the box of one grasp, contact or wrench in the plane.
GraspBox box_of(const LoadedGrasp& loaded);
UncertainContact box_of(const Contact& contact);
WrenchBox box_of(const Wrench& wrench);
/// \}
/// Returns the grasp of which box_of() makes this box. Requires one grasp of one body in the
/// plane; a bound of its motions is lost.
LoadedGrasp loaded_of(const GraspBox& point);

/// A grasp of any kind with its load, in the plane or in space, of one body or several, as a
/// file or a question has it. It is a GraspBox, which may be one grasp. One grasp in the plane
/// may be kept as a LoadedGrasp instead, in which a million contacts take little memory. Only
/// code for such grasps asks for single(); all other code asks for as_box(), or for what both
/// have.
class AnyGrasp {
 public:
  /// Makes a grasp in the plane without contacts.
  AnyGrasp() = default;
  /// \{ Makes the grasp, and keeps it as it is given.
  AnyGrasp(LoadedGrasp single) : kept_(std::move(single)) {}  // NOLINT(*-explicit-*)
  AnyGrasp(GraspBox box) : kept_(std::move(box)) {}           // NOLINT(*-explicit-*)
  /// \}

  /// \{ Returns the single grasp in the plane if it is kept as one, or null.
  const LoadedGrasp* single() const { return std::get_if<LoadedGrasp>(&kept_); }
  LoadedGrasp* single() { return std::get_if<LoadedGrasp>(&kept_); }
  /// \}
  /// \{ Returns the box, or null if the grasp is kept as a LoadedGrasp.
  const GraspBox* box() const { return std::get_if<GraspBox>(&kept_); }
  GraspBox* box() { return std::get_if<GraspBox>(&kept_); }
  /// \}
  /// Returns the single grasp in the plane. Throws ContractError unless it is kept as one.
  const LoadedGrasp& loaded() const;
  /// Returns the grasp as a box, however it is kept. O(m).
  GraspBox as_box() const { return box() != nullptr ? *box() : box_of(*single()); }

  /// Returns whether it is in space, whose points have three coordinates.
  bool in_space() const { return box() != nullptr && box()->in_space(); }
  /// Returns the mechanism of several bodies; null if there is one body.
  const Mechanism* mechanism() const;
  /// Returns whether motions are bounded.
  bool is_bounded() const { return box() != nullptr && box()->is_bounded(); }
  /// Returns whether all numbers of contacts and springs are certain; the load may be
  /// uncertain.
  bool has_certain_elements() const;
  /// Returns the description of the grasp for people.
  const GraspDescription& description() const;
  /// Returns the load.
  WrenchBox wrench() const;
  /// Returns the number of contacts.
  std::size_t contacts() const;
  /// Returns a contact. Requires that it is there.
  UncertainContact contact(ContactId id) const;
  /// Returns the number of elements that push and never pull: the contacts, and the ratchets,
  /// which are the first springs.
  std::size_t pushing_elements() const;
  /// Returns the preload of each contact, and then the force of each spring; of an interval the
  /// low end.
  std::vector<Rational> preloads() const;
  /// Gives each contact this preload, and leaves springs as they are. Requires preload >= 0: a
  /// grasp that is kept as a LoadedGrasp throws InputError if it is negative, and for a
  /// GraspBox GraspBox::check() does later.
  void set_preload(const Rational& preload);

 private:
  std::variant<LoadedGrasp, GraspBox> kept_;
};

/// Returns whether some contact that may have a preload has a normal n of irrational length.
/// The preload enters as P' = P / |n|, so that even one grasp is then decided as a box, in
/// which P' is an interval.
bool needs_enclosure(const GraspBox& box);

}  // namespace stickslip
