// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The law of a grasp whose numbers are intervals, for motions of any number of coordinates.
/// Its contacts are rows at the corners of what is uncertain of their geometry, exactly and in
/// doubles (certificate/FORMAT.md, sections 1 and 6).
///
/// **Letters.** d is a motion. A contact with the normal n has the row N, so that N.d is how
/// far it moves along n times |n|, and S, so that s = S d is its slip (T in the plane, along n
/// turned by +90 degrees). mu is friction, P the preload, k the stiffness, P' = P / |n| and k'
/// = k / |n|^2: its force is a n + f with a = max(0, v), *separation* v = P' - k' N.d, and
/// friction f of at most mu L a with L = |n|. w is the load, u its growth in a margin.
///
/// **Points.** A point is (d, h, l) with D + 2 coordinates, up to a positive factor: the motion
/// d / h and, in a margin, the multiple l / h. So v = P' h - k' N.d is linear in points.
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

/// A slip or a friction force in doubles, by its coordinates in the orthonormal basis along
/// LawContact::directions, so that its length is their norm. There is one coordinate in the
/// plane, there are two in space and three with torsion; the others are 0.
using Double3 = std::array<double, 3>;

/// Returns the length of a slip or force.
inline double norm_of(const Double3& a) {
  return std::sqrt(dot(a, a));
}

/// Returns the ends of an interval, or the one end of a point.
std::vector<Rational> ends_of(const Interval& interval);

/// The rows N and S of a contact whose geometry is at one of its corners.
struct CornerRow {
  RationalRow normal;  ///< N
  /// S times slip_factor: one row in the plane, three in space, four with torsion. They are
  /// integers.
  std::vector<Row> slip;
  Rational slip_factor;               ///< > 0
  Reals normal_rounded{};             ///< N, in the law's units
  std::vector<Reals> slip_rounded{};  ///< S by direction, in the law's units

  /// Returns the rows of S as linear functions of points: with zeros up to so many coordinates,
  /// over their common divisor.
  std::vector<Row> slip_planes(std::size_t coordinates) const;
  /// Returns the wrench of a friction force, which has as many numbers as a slip.
  RationalRow wrench_of(const RationalRow& friction) const;
  /// Returns N plus the wrench of this friction force: the force of a contact with a = 1.
  RationalRow push_with(const RationalRow& friction) const;
  /// Sets the slip from `multiple`, which is `factor` times S. Requires factor > 0.
  void set_slip(const std::vector<RationalRow>& multiple, const Rational& factor);
};

/// The place of a contact: its point and normal, with their uncertainty.
struct ContactPlace {
  std::vector<Interval> geometry;  ///< the coordinates of p, then e of each turn
  RationalRow normal;              ///< n0, the normal before it is turned
  std::vector<Turn> turns;         ///< the turns of the normal
  CornerRow centre;                ///< the rows of the grasp in the middle
  /// G, how the one body moves relative to the other, as functions of states; empty if there is
  /// one body.
  std::vector<RationalRow> motion{};
};

/// The numbers of a contact in the plane with uncertain geometry, as integers: N and T times
/// `length`, mu times `cone`, k' times `law`, and P' times `law` and `length`.
struct WholeCorners {
  std::vector<Row> normals;          ///< N, by corner
  std::vector<Row> tangents;         ///< T, by corner
  std::array<Integer, 2> frictions;  ///< the ends of mu
  SpringEnds<Integer> ends;          ///< the ends of P' and k'
  Integer cone;                      ///< a common denominator of mu
  Rational weight;                   ///< the factor from bounds (corner_work.hpp) to work
};

/// A contact, ratchet or spring of a law.
struct LawContact {
  /// The rows at the 2^n corners of its geometry, if n numbers of it are uncertain. The first
  /// number changes fastest. As in the format, S in space is the motion seen along n in the
  /// plane across n0.
  std::vector<CornerRow> corners;
  Rational squared_length{1};  ///< L^2 of n0; friction is at most mu L a
  Interval friction;           ///< mu
  Interval preload;            ///< P'
  Interval rate{};             ///< P^u' in a margin: low where P' is low, high where it is high
  Interval stiffness;          ///< k'
  IntegerVector3 axis{};       ///< n0 in space, to which slips are perpendicular
  Rational spin_weight{0};     ///< e^2 / L^2, the weight of the fourth number in |s|^2
  /// An orthogonal basis of all friction forces.
  std::vector<RationalRow> directions{{1}};
  /// The place that the corners come from, if it is the contact of a grasp.
  std::optional<ContactPlace> place{};
  Rational tilt{0};  ///< delta in space, the largest |n|^2 / L^2 - 1 of a corner
  /// Whether it is a spring: its force is v, of either sign, and it neither opens nor slips.
  bool is_spring = false;

  /// \{ Members that complete() fills in. `separations` has v at all corners of all parameters,
  /// as primitive functions; `separation_factors` has the positive factors that make them v.
  std::vector<Row> separations{};
  std::vector<Rational> separation_factors{};
  bool has_certain_separation = false;  ///< whether v is one function up to positive factors
  std::optional<WholeCorners> whole{};  ///< the numbers in integers, if it is in the plane and
                                        ///< its geometry is uncertain
  /// \}

  /// \{ The numbers in doubles, which complete() fills in. Slopes are mu L. `size` is the size
  /// of the force of a = 1.
  std::array<double, 2> slopes{};
  double size = 1;
  double tilted = 0;  ///< 3/2 delta
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
  /// Returns the product <a, b> of two slips, in integers. With torsion it is multiplied by the
  /// denominator of spin_weight.
  template <class Slip>
  Integer product(const Slip& a, const Slip& b) const {
    Integer across = 0;
    for (std::size_t k = 0; k < std::min<std::size_t>(slip_numbers(), 3); ++k) {
      across += a[k] * b[k];
    }
    if (slip_numbers() < 4) return across;
    return denominator(spin_weight) * across + numerator(spin_weight) * a[3] * b[3];
  }
  /// Returns |f|^2 of a friction force.
  Rational squared_force(const RationalRow& f) const {
    Rational sum = 0;
    for (std::size_t k = 0; k < f.size(); ++k) {
      sum += k == 3 ? Rational(f[k] * f[k] / spin_weight) : Rational(f[k] * f[k]);
    }
    return sum;
  }
  /// Returns a friction force with these coordinates, each rounded to so many bits.
  RationalRow force_near(const Double3& coordinates, int bits) const;
  /// Returns the coordinates of a friction force. Requires a contact without torsion.
  Double3 coordinates_of(const RationalRow& force) const;
  /// Returns the coordinates of a slip, or of a multiple of it, scaled to norm 1. They are 0
  /// for 0, and perhaps where numbers are not moderate.
  Double3 direction_of(const IntegerVector<4>& slip) const;
};

/// A grasp as equations: all contacts, springs among them, and the load. In doubles,
/// coordinates of motions that are rotations are multiplied by `length`, and torques are
/// divided by it.
struct Law {
  std::size_t motions = 3;             ///< D, the number of coordinates of motions
  std::vector<char> rotates{0, 0, 1};  ///< whether a coordinate of motions is a rotation
  std::vector<LawContact> contacts{};  ///< the contacts and then the springs, by ContactId
  std::vector<Interval> wrench{};      ///< w
  std::optional<LoadHull> hull{};      ///< loads that are added to w
  std::optional<BallPart> ball{};      ///< loads that are added to w, which is then certain
  RationalRow growth{};                ///< u of a margin
  bool is_family = false;     ///< whether it is a margin, so that points have multiples
  MultipleRange multiples{};  ///< the multiples of a margin
  NormalLaw normal_law = NormalLaw::kUnilateral;  ///< the law of all contacts
  RationalRow max_motion{};  ///< B, by coordinate of motions; empty: no bound
  /// Far motions are those beyond this, by coordinate: rounding of the data decides what holds
  /// there (natural_bound()). It chooses where to search first, and decides nothing. If it is
  /// empty, no motion is far.
  RationalRow far_motion{};

  /// Returns whether a motion is within the bound, if there is one.
  bool allows(const RationalRow& motion) const;
  /// Returns whether normals look like decimals that were rounded to the length of doubles.
  /// Only then do far motions depend on their last digits.
  bool may_be_rounded() const;

  /// \{ Members that complete() fills in.
  double length = 1;                          ///< a typical distance
  double force = 1;                           ///< a typical force
  double reach = 1;                           ///< how far such a force moves the object
  std::vector<std::array<double, 2>> load{};  ///< the ends of w
  Reals growing{};                            ///< u in doubles
  /// Whether all numbers are 0 or between 2^-200 and 2^200. If not, doubles certify nothing.
  bool is_moderate = true;
  /// \}

  /// Fills in what follows from the other members. `distance` is a typical one, or 0 if
  /// there is none.
  void complete(double distance);
  /// Fills in what follows from the loads. It suffices after complete() if the loads alone have
  /// changed.
  void complete_loads();
  /// Returns the typical distance in few bits.
  Rational short_length() const;
  /// Returns the square of the length of a row, of which rotations and torques are divided by
  /// `about`: a length for a load, and its inverse for a motion.
  Rational squared_size(const RationalRow& row, const Rational& about) const;
  /// Returns the size of the force of a = 1, in doubles.
  double force_size(const LawContact& contact) const;
  /// Returns the largest work of a load on a virtual twist; for a ball of loads, a bound of it.
  Rational most_load_work(const Row& y) const;
  /// Returns the sum of |y_j| times the largest magnitude of component j of the load, at h = 1.
  double load_size(const Reals& y) const;
  /// Returns the number of coordinates of points: those of the motion, h and l.
  std::size_t coordinates() const { return motions + 2; }
  /// Returns the factor from a coordinate of points to the same coordinate in doubles.
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
  /// Returns plane.x over the norm of the plane, for a point x in doubles.
  double value_at(const Row& plane, const Reals& x) const;
  /// Returns a plane through x, nearly perpendicular to a - b, with short coefficients; 0 if a
  /// and b are too near.
  Row plane_between(const Reals& a, const Reals& b, const Reals& x) const;
  /// Returns the load h w + l u in doubles, for the w whose work on y is largest.
  Reals load_at(double height, double multiple, const Reals& y) const;
  /// Returns whether each slip and friction force is along a line, as in the plane.
  bool is_linear() const;
  /// Returns whether every number is certain, 1 / |n| of preloaded contacts included.
  bool is_point() const;
};

/// Returns the law of a problem in the plane. Requires that it is no family.
Law planar_law(const Problem& problem);

}  // namespace stickslip
