// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The law of a grasp whose numbers are intervals: the equations of its contacts and the load,
/// for motions of any number of coordinates (certificate/FORMAT.md, sections 1 and 6). The
/// numbers of a contact's geometry, its point and normal, lie in a box. A contact has its rows
/// N and S at each *corner* of that box, exactly and in doubles.
///
/// **Letters.** d is a motion, and r its displacement of the contact's point; of two bodies,
/// that of the pressed one relative to the other. mu is friction, P the preload, k the
/// stiffness. n is the normal, of any length, and n0 the normal before it is turned, if it is
/// uncertain. w is the load, and l u the load that a margin adds at its multiple l. A contact
/// has
///
/// - the row N, with N.d = n.r;
/// - the rows S, whose S d is the slip s: in the plane the one number t.r, with t = n turned by
///   +90 degrees (S is the row T); in space r - (n0.r / L^2) n with L = |n0|, what is left of r
///   in the plane across n0 when a multiple of n is taken away;
/// - P' = P / |n|, k' = k / |n|^2, and the *separation* v = P' - k' N.d;
/// - the force a n + f in space, with a = max(0, v) and the friction f, |f| <= mu L a; in the
///   plane the force a n + f t, with the number f and L = 1.
///
/// **Points.** A point is (d, h, l) with D + 2 coordinates, up to a positive factor: the motion
/// d / h and, in a margin, the multiple l / h. So v = P' h - k' N.d, plus P^u' l in a margin,
/// is linear in points.
///
/// **Doubles.** Members in doubles are in *the law's units*, in which the typical distance
/// Law::length is 1: rotations are multiplied by it, torques are divided by it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/core/row.hpp"
#include "stickslip/engine/ball_part.hpp"
#include "stickslip/engine/corner_work.hpp"
#include "stickslip/engine/load_hull.hpp"
#include "stickslip/engine/problem.hpp"
#include "stickslip/engine/reals.hpp"

namespace stickslip {

/// A slip or a friction force in doubles: its coordinates in the orthonormal basis that
/// LawContact::directions have if they are scaled to length 1. Its length is their norm. There
/// is one coordinate in the plane, there are two in space and three with torsion; the others
/// are 0.
using Double3 = std::array<double, 3>;

/// Returns the length of a slip or force.
inline double norm_of(const Double3& a) {
  return std::sqrt(dot(a, a));
}

/// Returns the ends of an interval, or the one end of a point.
std::vector<Rational> ends_of(const Interval& interval);

/// The rows N and S of a contact at one corner of its uncertain geometry.
struct CornerRow {
  RationalRow normal;  ///< N
  /// S times slip_factor, in integers: one row in the plane, three in space, four with torsion.
  std::vector<Row> slip;
  Rational slip_factor;    ///< > 0
  Reals normal_rounded{};  ///< N, in the law's units
  /// The coordinates of a slip (Double3) as functions of the motion, in the law's units: a row
  /// for each of LawContact::directions.
  std::vector<Reals> slip_rounded{};

  /// Returns each row of S as a linear function of points: a positive multiple in coprime
  /// integers, with zeros appended up to `coordinates` entries.
  std::vector<Row> slip_planes(std::size_t coordinates) const;
  /// Returns S^T f, the wrench of the friction force f, which has as many numbers as a slip.
  RationalRow wrench_of(const RationalRow& friction) const;
  /// Returns N + S^T f: the wrench of the contact with a = 1 and this friction force f.
  RationalRow push_with(const RationalRow& friction) const;
  /// Sets `slip` and `slip_factor`, from rows that are `factor` times S. Requires factor > 0.
  void set_slip(const std::vector<RationalRow>& multiple, const Rational& factor);
};

/// The place of a contact: its point and normal, with their uncertainty.
struct ContactPlace {
  /// The coordinates of the point p, then the e of each turn, in [-Turn::most, Turn::most].
  std::vector<Interval> geometry;
  RationalRow normal;       ///< n0, the normal before it is turned
  std::vector<Turn> turns;  ///< the turns of the normal
  CornerRow centre;         ///< the rows at the middle of all intervals of `geometry`
  /// G, the twist of the pressed body relative to the other one as a function of the state
  /// (Mechanism::motion_between); empty if there is one body.
  std::vector<RationalRow> motion{};
};

/// The numbers of a contact in the plane with uncertain geometry, as integers. Each is
/// multiplied by common denominators: A of the entries of N and T, B of P' and k', and `cone`
/// of mu.
struct WholeCorners {
  std::vector<Row> normals;          ///< A N, by corner
  std::vector<Row> tangents;         ///< A T, by corner
  std::array<Integer, 2> frictions;  ///< `cone` times the ends of mu
  SpringEnds<Integer> ends;          ///< the ends of A B P' and of B k'
  Integer cone;                      ///< a common denominator of the ends of mu
  /// The factor from a bound that CornerWork finds with these integers to the work itself: 1 /
  /// (A^2 B cone corners).
  Rational weight;
};

/// A contact, ratchet or spring of a law.
struct LawContact {
  /// The rows at the 2^n corners of its geometry, if n numbers of ContactPlace::geometry are
  /// uncertain. The first of these changes fastest from corner to corner.
  std::vector<CornerRow> corners;
  Rational squared_length{1};  ///< L^2: |n0|^2 in space, 1 in the plane
  Interval friction;           ///< mu
  Interval preload;            ///< P', for a spring its force P
  /// P^u', the growth of P' in a margin for each unit of the multiple. Its low end goes with
  /// the low end of P', its high end with the high one.
  Interval rate{};
  Interval stiffness;     ///< k'
  IntegerVector3 axis{};  ///< n0 in space, as coprime integers; slips are perpendicular to it
  /// e^2 / L^2 with the torsion e: |s|^2 = s1^2 + s2^2 + s3^2 + spin_weight s4^2.
  Rational spin_weight{0};
  /// An orthogonal basis of the space of friction forces, of vectors of any length.
  std::vector<RationalRow> directions{{1}};
  /// The place that the corners come from; nothing for ratchets and springs, and for contacts
  /// of a Problem (planar_law()).
  std::optional<ContactPlace> place{};
  Rational tilt{0};  ///< delta in space, the largest |n|^2 / L^2 - 1 of a corner
  /// Whether it is a spring: its force is v, of either sign, and it neither opens nor slips.
  bool is_spring = false;

  /// \{ Members that Law::complete() fills in. `separations` has v as a function of points, in
  /// coprime integers, for each corner and, at each, for each end of k' and of P'.
  /// `separation_factors` has the positive factors that turn these into v.
  std::vector<Row> separations{};
  std::vector<Rational> separation_factors{};
  bool has_certain_separation = false;  ///< whether all `separations` are equal
  std::optional<WholeCorners> whole{};  ///< the numbers in integers, if it is in the plane and
                                        ///< its geometry is uncertain
  /// \}

  /// \{ The numbers in doubles, which Law::complete() fills in; pairs are the low and the high
  /// end of an interval. Slopes are mu L. `size` is Law::force_size().
  std::array<double, 2> slopes{};
  double size = 1;
  /// 3/2 delta. Friction against a slip of the direction sigma does at most the work mu L a
  /// (-sigma.(S y) + 3/2 delta |S y|) on a virtual twist y, however the normal turns in space
  /// (certificate/FORMAT.md, section 7).
  double tilted = 0;
  std::array<double, 2> preloads{};
  std::array<double, 2> rates{};
  std::array<double, 2> stiffnesses{};
  std::vector<double> direction_sizes{};                 ///< the lengths of `directions`
  std::vector<std::array<double, 4>> unit_directions{};  ///< `directions`, of length 1
  /// Whether rows, preloads, rates and stiffnesses are 0 or between 2^-200 and 2^200, so that
  /// no product with a point of norm 1 overflows or vanishes. If not, doubles decide no sign.
  bool is_moderate = true;
  /// \}

  /// Returns whether there is only one corner.
  bool geometry_is_certain() const { return corners.size() == 1; }
  /// Returns how many numbers a slip has: 1 in the plane, 3 in space, 4 with torsion.
  std::size_t slip_numbers() const { return corners.front().slip.size(); }
  /// Returns the dimension of the space that slips are in: 1, 2 or 3.
  std::size_t slip_dimension() const { return directions.size(); }
  /// Returns the product <a, b> of two slips, a1 b1 + a2 b2 + a3 b3 + spin_weight a4 b4 with as
  /// many terms as slips have numbers. With torsion it is multiplied by the denominator of
  /// spin_weight, so that it is an integer.
  template <class Slip>
  Integer product(const Slip& a, const Slip& b) const {
    Integer across = 0;
    for (std::size_t k = 0; k < std::min<std::size_t>(slip_numbers(), 3); ++k) {
      across += a[k] * b[k];
    }
    if (slip_numbers() < 4) return across;
    return denominator(spin_weight) * across + numerator(spin_weight) * a[3] * b[3];
  }
  /// Returns |f|^2 = f1^2 + f2^2 + f3^2 + f4^2 / spin_weight of a friction force, with as many
  /// terms as it has numbers.
  Rational squared_force(const RationalRow& f) const {
    Rational sum = 0;
    for (std::size_t k = 0; k < f.size(); ++k) {
      sum += k == 3 ? Rational(f[k] * f[k] / spin_weight) : Rational(f[k] * f[k]);
    }
    return sum;
  }
  /// Returns a friction force whose coordinates are near these: its multiple of each vector of
  /// `directions` is rounded to so many bits.
  RationalRow force_near(const Double3& coordinates, int bits) const;
  /// Returns the coordinates of a friction force. Throws ContractError for a contact with
  /// torsion.
  Double3 coordinates_of(const RationalRow& force) const;
  /// Returns the coordinates of a slip, scaled to norm 1; any positive multiple of the slip
  /// gives the same. They are 0 for the slip 0, and perhaps where numbers are not moderate.
  Double3 direction_of(const IntegerVector<4>& slip) const;
};

/// A grasp as equations: all contacts, springs among them, and the load.
struct Law {
  std::size_t motions = 3;             ///< D, the number of coordinates of motions
  std::vector<char> rotates{0, 0, 1};  ///< whether a coordinate of motions is a rotation
  std::vector<LawContact> contacts{};  ///< the contacts and then the springs, by ContactId
  std::vector<Interval> wrench{};      ///< w
  std::optional<LoadHull> hull{};      ///< a convex set of loads, any of which is added to w
  std::optional<BallPart> ball{};      ///< a ball of such loads; w is then certain
  RationalRow growth{};                ///< u of a margin
  bool is_family = false;     ///< whether it is a margin, so that points have multiples
  MultipleRange multiples{};  ///< the multiples of a margin
  NormalLaw normal_law = NormalLaw::kUnilateral;  ///< the law of all contacts
  RationalRow max_motion{};  ///< B, by coordinate of motions; empty: no bound
  /// The bound, by coordinate of motions, beyond which a motion is far, so that rounding of the
  /// data decides what holds there (natural_bound()). The search takes other motions first; no
  /// verdict depends on it. If it is empty, no motion is far.
  RationalRow far_motion{};

  /// Returns whether a motion is within the bound, if there is one.
  bool allows(const RationalRow& motion) const;
  /// Returns whether some row N has a numerator or denominator of more than 40 bits, as rows
  /// have that come from decimals as long as doubles. Only then do far motions depend on the
  /// last digits of the data.
  bool may_be_rounded() const;

  /// \{ Members that complete() fills in.
  double length = 1;  ///< a typical distance, the unit of length of doubles
  double force = 1;   ///< the largest force of loads and preloads; 1 if all are 0
  double reach = 1;   ///< how far `force` presses the stiffest contact
  std::vector<std::array<double, 2>> load{};  ///< the ends of w
  Reals growing{};                            ///< u
  /// Whether all numbers are 0 or between 2^-200 and 2^200. If not, doubles certify nothing.
  bool is_moderate = true;
  /// \}

  /// Fills in what follows from the other members. `distance` is a typical one, or 0 if
  /// there is none.
  void complete(double distance);
  /// Fills in what follows from the loads. It suffices after complete() if the loads alone have
  /// changed.
  void complete_loads();
  /// Returns `length` rounded to four bits.
  Rational short_length() const;
  /// Returns the sum of the squares of the entries of a row, of which those of rotations are
  /// first divided by `about`. For a load `about` is a length, as the entries are torques; for
  /// a motion it is the inverse of one.
  Rational squared_size(const RationalRow& row, const Rational& about) const;
  /// Returns the length of the part of N that is a force: |n| for a contact of one body. It is
  /// the length of all of N if no coordinate is a translation, and 1 if N is 0.
  double force_size(const LawContact& contact) const;
  /// Returns the largest work that a load does on the virtual twist y: any load of w with
  /// `hull` and `ball`, without growth. For a ball it is an upper bound.
  Rational most_load_work(const Row& y) const;
  /// Returns the sum over j of |y_j| times the largest magnitude of component j of the same
  /// loads. It bounds the terms of their work on y, and so the rounding error of that.
  double load_size(const Reals& y) const;
  /// Returns the number of coordinates of points: those of the motion, h and l.
  std::size_t coordinates() const { return motions + 2; }
  /// Returns the factor from a coordinate of points to the same coordinate in doubles: `length`
  /// for a rotation, else 1.
  double unit(std::size_t coordinate) const {
    return coordinate < motions && rotates[coordinate] != 0 ? length : 1;
  }
  /// \{ Puts a motion or a point, or a function of these, into the units of doubles.
  void scale(Reals& motion) const {
    for (std::size_t j = 0; j < motions; ++j) motion[static_cast<Eigen::Index>(j)] *= unit(j);
  }
  void scale_function(Reals& function) const {
    for (std::size_t j = 0; j < motions; ++j) function[static_cast<Eigen::Index>(j)] /= unit(j);
  }
  /// \}
  /// Returns a point in doubles, of norm 1.
  Reals scaled(const Row& point) const;
  /// Returns the signed distance of a point x in doubles from a plane through 0, which is given
  /// exactly by its normal.
  double value_at(const Row& plane, const Reals& x) const;
  /// Returns the normal of a plane through 0 and nearly through x, with a farther up than b: it
  /// is a - b without its part along x, rounded to a few bits. Returns 0 if a and b are too
  /// near, or if x is 0. All three points are in doubles.
  Row plane_between(const Reals& a, const Reals& b, const Reals& x) const;
  /// Returns h w + l u in doubles at h = `height` and l = `multiple`, for the load w, with
  /// `hull` and `ball`, whose work on y is largest.
  Reals load_at(double height, double multiple, const Reals& y) const;
  /// Returns whether each slip and friction force is along a line, as in the plane.
  bool is_linear() const;
  /// Returns whether every number is certain: P', which is enclosed where 1 / |n| is
  /// irrational, loads, and in a margin the multiple.
  bool is_point() const;
};

/// Returns the law of a problem in the plane. Requires that the problem is no family: what
/// grows would be left out.
Law planar_law(const Problem& problem);

}  // namespace stickslip
