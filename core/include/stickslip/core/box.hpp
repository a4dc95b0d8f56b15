// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Boxes of grasps, in the plane or in space: some numbers are known only as intervals, and a
/// box is all grasps with numbers in these at once. A number that is known exactly is an
/// interval of one number.
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

/// A contact whose numbers may all be intervals. Vectors have two coordinates in the plane and
/// three in space. The normal has any direction whose angle to n has a tangent of at most the
/// slope.
struct UncertainContact {
  std::vector<Interval> position;  ///< the point of contact, in the object frame
  RationalRow normal;              ///< n, nonzero and of any length, points into the object
  Interval friction;               ///< the coefficient mu >= 0
  Interval stiffness{1, 1};  ///< the stiffness k > 0 of the normal spring, force per length
  Interval preload{};        ///< P >= 0, force
  Rational slope{0};         ///< the slope of the normal, 0 <= slope < 1

  /// The torsion e >= 0 of a contact in space, a length. The friction of a soft pad has a
  /// moment about the normal, at most e times as large as a force across it
  /// (certificate/FORMAT.md, section 15). If e is not 0, the normal is certain.
  Rational torsion{0};

  /// \{ The two of several bodies: `of` is pressed, and the normal points into it; `by` is the
  /// other one.
  BodyIndex of{};
  BodyIndex by{};
  /// \}
};

/// A way in which a normal may turn: n + e direction for some |e| <= most.
struct Turn {
  RationalRow direction;  ///< perpendicular to n
  Rational most;          ///< >= 0
};

/// Returns the turns of a contact; its normal may turn by all of them together. In the plane
/// there is one, by (-n_y, n_x) and the slope. In space there are two, by perpendicular vectors
/// u and v (certificate/FORMAT.md, section 6). Every normal of the contact is among n + e_u u +
/// e_v v, and so are some others, whose tangent is up to 1.42 times the slope.
std::vector<Turn> turns_of(const UncertainContact& contact);
/// Returns n + the sum of e_j direction_j.
RationalRow turned(RationalRow normal, const std::vector<Turn>& turns, const RationalRow& e);

/// The components of a wrench: (x, y, torque) in the plane, force x, y, z and torque x, y, z in
/// space, and for several bodies one for each coordinate of a state.
using WrenchBox = std::vector<Interval>;

/// A tolerance, how far numbers of a kind may be off: by t, or by t times their size.
struct Tolerance {
  Rational amount{0};     ///< t >= 0
  bool relative = false;  ///< whether t is a factor: 1/10 for 10 %

  /// Returns the interval widened at both ends: [A - t, B + t] or [A - t|A|, B + t|B|].
  Interval widen(const Interval& interval) const;
  /// Returns the number that spells it: 10 for 10 %.
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

  /// Sets the point. Two or three coordinates that are all 0 are stored as the origin.
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

/// Reads "friction=10%,normal=0.0175": decimals or fractions, each kind at most once. That of
/// `wrench` may be a ball, "wrench=ball:1/2:length=2:about=3:0:body=cup", of which all but the
/// radius may be left out. Throws InputError with the place "uncertain".
Tolerances parse_tolerances(std::string_view text);

/// Returns a ball as parse_tolerances() reads it, without "wrench=".
std::string to_string(const LoadBall& ball);

/// A box of grasps: contacts and a wrench with numbers in intervals, all in the plane or all in
/// space. Its *elements* are its contacts and then its springs, and a ContactId may be that of
/// either.
struct GraspBox {
  std::vector<UncertainContact> contacts;  ///< the contacts, by ContactId
  WrenchBox wrench;                        ///< w, applied to the object
  GraspDescription description{};          ///< an outline in the plane, a surface in space
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
  /// Returns whether it is one body in the plane.
  bool is_one_planar_body() const { return !mechanism && !in_space(); }
  /// Returns the number of contacts and springs.
  std::size_t elements() const { return contacts.size() + springs.size(); }
  /// Returns how the point of the ball moves with its body, and how that turns: a row for each
  /// component of a force and a torque at the point, as a linear function of motions. Requires
  /// that there is a ball.
  std::vector<RationalRow> ball_motion() const;
  /// Returns how far each component of a load in the ball may be from 0. Requires that there is
  /// a ball.
  RationalRow ball_reach() const;
  /// Returns whether every interval is one number and every slope 0, and there is no ball.
  bool is_point() const;
  /// Checks the numbers. Throws InputError naming "contacts[i].<member>", "wrench[j]" or the
  /// member of a spring in three cases: an interval has its ends exchanged; a normal is 0 or
  /// has a slope of 1 or more or below 0; or a number may be outside of its range. Friction
  /// coefficients, preloads, torsions and stiffnesses of springs are 0 or more; stiffnesses of
  /// contacts and ratchets are above 0; a normal with torsion has no slope. Throws InputError
  /// naming "uncertain" for a ball whose radius or length is not above 0, beside an uncertain
  /// wrench, on a body that is not there, or about a point of another dimension.
  void check() const;
  /// Returns the box widened by the tolerances, and checked. Throws InputError as check() does.
  GraspBox widened(const Tolerances& tolerances) const;
  /// Returns the box with each interval shrunk or grown about the value in `centre`, one grasp
  /// inside it: its ends are centre + factor (end - centre). Slopes and the radius of the ball
  /// are multiplied by the factor. Requires factor >= 0. Throws as check() does.
  GraspBox scaled(const GraspBox& centre, const Rational& factor) const;
  /// Returns the one grasp in the middle of every interval, with the normals n and without a
  /// ball.
  GraspBox middle() const;
  /// Returns middle() as a LoadedGrasp. Requires one body in the plane.
  LoadedGrasp planar_middle() const;
};

/// Calls f for every number that may be an interval, in the order of a file. The slope of a
/// normal and a ball are no such numbers.
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

/// Returns the wrench in the middle of every interval, in the plane.
Wrench planar_middle(const WrenchBox& wrench);

/// Returns the wrench of the force f at the point p, in the plane or in space: the force and
/// its torque about the origin. It is also the row of how far the point moves along f.
RationalRow wrench_at(const RationalRow& p, const RationalRow& f);
/// \{ Converts a wrench in the plane to a row, and back.
RationalRow row_of(const Wrench& wrench);
Wrench wrench_of(const RationalRow& row);
/// \}

/// A twist or a wrench in space: translation x, y, z and rotation x, y, z in radians; or force
/// x, y, z and torque x, y, z.
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

/// A grasp of any kind with its load, in the plane or in space, of one body or several, as a
/// file or a question has it. It is a box, which may be one point. A single grasp in the plane
/// may be kept as a LoadedGrasp, since a million contacts then take little memory; only what
/// works in the plane alone, and is made for so many, needs to know.
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
  /// Returns the grasp as a box, however it is kept. O(m).
  GraspBox as_box() const { return box() != nullptr ? *box() : box_of(*single()); }

  /// Returns whether it is in space, whose points have three coordinates.
  bool in_space() const { return box() != nullptr && box()->in_space(); }
  /// Returns the mechanism of several bodies; null if there is one body.
  const Mechanism* mechanism() const;
  /// Returns whether it is one body in the plane.
  bool is_one_planar_body() const { return box() == nullptr || box()->is_one_planar_body(); }
  /// Returns whether motions are bounded.
  bool is_bounded() const { return box() != nullptr && box()->is_bounded(); }
  /// Returns whether contacts and springs are certain, whatever the load is.
  bool has_certain_elements() const;
  /// Returns the description of the grasp for people.
  const GraspDescription& description() const;
  /// Returns the load.
  WrenchBox wrench() const;
  /// Returns the number of contacts.
  std::size_t contacts() const;
  /// Returns a contact. Requires that it is there.
  UncertainContact contact(ContactId id) const;
  /// Returns how many elements only push: the contacts, and the ratchets, which are the first
  /// springs.
  std::size_t pushing_elements() const;
  /// Returns the preloads by element; of intervals the low ends.
  std::vector<Rational> preloads() const;
  /// Gives each contact this preload. Throws InputError if it is negative.
  void set_preload(const Rational& preload);

 private:
  std::variant<LoadedGrasp, GraspBox> kept_;
};

/// Returns whether 1/|n| of some contact that may have a preload is irrational. Preloads are
/// divided by |n|, so that even one grasp is then known only as a box around such numbers.
bool needs_enclosure(const GraspBox& box);

}  // namespace stickslip
