// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The law of a grasp whose numbers are intervals, for motions of any number of coordinates:
/// its contacts as rows at the corners of what is uncertain of their geometry, exactly and in
/// doubles (certificate/FORMAT.md, sections 1 and 6).
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

/// Of a slip or of a friction force, in doubles: coordinates by LawContact::directions, so that
/// lengths and products are those of numbers. There is one in the plane, there are two in space
/// and three with torsion; the others are 0.
using Double3 = std::array<double, 3>;

/// Its length.
inline double norm_of(const Double3& a) {
  return std::sqrt(dot(a, a));
}

/// The different ends of an interval.
std::vector<Rational> ends_of(const Interval& interval);

/// N and S with a contact's geometry at one of its corners.
struct CornerRow {
  RationalRow normal;  ///< N
  /// S times slip_factor: one row in the plane, three in space, four with torsion.
  std::vector<Row> slip;
  Rational slip_factor;               ///< > 0
  Reals normal_rounded{};             ///< N, in the law's units
  std::vector<Reals> slip_rounded{};  ///< S by direction, in the law's units

  /// S as functions of so many coordinates of points, primitive.
  std::vector<Row> slip_planes(std::size_t coordinates) const;
  /// That of friction, with as many numbers as a slip has.
  RationalRow wrench_of(const RationalRow& friction) const;
  /// From a multiple of S.
  void set_slip(const std::vector<RationalRow>& multiple, const Rational& factor);
};

/// Where a contact is.
struct ContactPlace {
  std::vector<Interval> geometry;  ///< coordinates of p, then e of each turn
  RationalRow normal;              ///< n0
  std::vector<Turn> turns;         ///< of the normal
  CornerRow centre;                ///< the rows of the middle
  /// Of several bodies how the one moves beside the other, G; empty: there is one.
  std::vector<RationalRow> motion{};
};

/// Numbers of a contact in the plane, of uncertain geometry, in integers: N and T times
/// `length`, mu times `cone`, k' times `law` and P' times `law` and `length`.
struct WholeCorners {
  std::vector<Row> normals;          ///< N by corner
  std::vector<Row> tangents;         ///< T by corner
  std::array<Integer, 2> frictions;  ///< ends of mu
  SpringEnds<Integer> ends;          ///< of P' and k'
  Integer cone;                      ///< the factor of mu, and of N in alpha
  Rational weight;                   ///< of bounds (corner_work.hpp)
};

/// A contact.
struct LawContact {
  /// Of n uncertain numbers of its geometry 2^n, the first number changing fastest.
  /// (S is as in the format, along n and in space across n0.)
  std::vector<CornerRow> corners;
  Rational squared_length{1};  ///< L^2, of n0: friction is at most mu L a
  Interval friction;           ///< mu
  Interval preload;            ///< P'
  Interval rate{};             ///< P^u' of a margin, whose ends go with those of P'
  Interval stiffness;          ///< k'
  IntegerVector3 axis{};       ///< in space: n0, across which slips are
  Rational spin_weight{0};     ///< e^2 / L^2: of the fourth number in |s|^2
  /// Friction forces, none of which does work on the slip of another: a basis of all.
  std::vector<RationalRow> directions{{1}};
  std::optional<ContactPlace> place{};  ///< of what the corners are, if it is a grasp's
  Rational tilt{0};        ///< in space: delta, the largest |n|^2 / L^2 - 1 of a corner
  bool is_spring = false;  ///< its force is v, of either sign: no law separates or rubs it

  /// \{ What follows, once complete() was called.
  /// v at all corners of all parameters: positive multiples, and factors that make them v.
  std::vector<Row> separations{};
  std::vector<Rational> separation_factors{};
  bool has_certain_separation = false;  ///< v is one function up to positive factors
  std::optional<WholeCorners> whole{};  ///< in the plane, of uncertain geometry
  /// \}

  /// \{ In doubles. Slopes are mu L; the size is that of a force, of a = 1.
  std::array<double, 2> slopes{};
  double size = 1;
  double tilted = 0;  ///< 3/2 delta
  std::array<double, 2> preloads{};
  std::array<double, 2> rates{};
  std::array<double, 2> stiffnesses{};
  std::vector<double> direction_sizes{};                 ///< their lengths
  std::vector<std::array<double, 4>> unit_directions{};  ///< of length 1
  /// Whether rows, preloads, rates and stiffnesses are 0 or between 2^-200 and 2^200, so that
  /// no product with a point of norm 1 overflows or vanishes. If not, doubles decide no sign.
  bool is_moderate = true;
  /// \}

  /// Whether there is one corner.
  bool geometry_is_certain() const { return corners.size() == 1; }
  /// How many numbers a slip is: 1 in the plane, 3 in space, 4 with torsion.
  std::size_t slip_numbers() const { return corners.front().slip.size(); }
  /// The dimension of the space that they are in: 1, 2 or 3.
  std::size_t slip_dimension() const { return directions.size(); }
  /// <a, b> of two slips, in integers: times the denominator of spin_weight.
  template <class Slip>
  Integer product(const Slip& a, const Slip& b) const {
    Integer across = 0;
    for (std::size_t k = 0; k < std::min<std::size_t>(slip_numbers(), 3); ++k) {
      across += a[k] * b[k];
    }
    if (slip_numbers() < 4) return across;
    return denominator(spin_weight) * across + numerator(spin_weight) * a[3] * b[3];
  }
  /// |f|^2 of a friction force.
  Rational squared_force(const RationalRow& f) const {
    Rational sum = 0;
    for (std::size_t k = 0; k < f.size(); ++k) {
      sum += k == 3 ? Rational(f[k] * f[k] / spin_weight) : Rational(f[k] * f[k]);
    }
    return sum;
  }
  /// A friction force with these coordinates, each rounded to so many bits.
  RationalRow force_near(const Double3& coordinates, int bits) const;
  /// The coordinates of a friction force without torsion.
  Double3 coordinates_of(const RationalRow& force) const;
  /// The coordinates of a slip, or a multiple of it, of norm 1; 0 of 0, and perhaps where
  /// numbers are not moderate.
  Double3 direction_of(const IntegerVector<4>& slip) const;
};

/// All contacts, springs among them, and the load. Coordinates of motions that are rotations
/// are in doubles times `length`, and torques over it.
struct Law {
  std::size_t motions = 3;                 ///< D
  std::vector<char> rotates{0, 0, 1};      ///< by coordinate of motions
  std::vector<LawContact> contacts{};      ///< by ContactId
  std::vector<Interval> wrench{};          ///< w
  std::optional<LoadHull> hull{};          ///< of loads that are added to w
  std::optional<BallPart> ball{};          ///< likewise; w is certain
  RationalRow growth{};                    ///< u, of a margin
  bool is_family = false;                  ///< a margin: points have multiples
  MultipleRange multiples{};               ///< of a margin
  NormalLaw law = NormalLaw::kUnilateral;  ///< of all contacts
  RationalRow max_motion{};                ///< B by coordinate of motions; empty: no bound
  /// Motions beyond this, by coordinate, are far: rounding of the data decides what holds there
  /// (natural_bound()). For proposals; empty: none are.
  RationalRow far_motion{};

  /// Returns whether a motion is within the bound, if there is one.
  bool allows(const RationalRow& motion) const;
  /// Returns whether contacts have numbers as long as those of doubles, the last digits of
  /// which are rounding: only then do far motions turn on these.
  bool may_be_rounded() const;

  /// \{ What follows, once complete() was called.
  double length = 1;                          ///< a typical distance
  double force = 1;                           ///< a typical force
  double reach = 1;                           ///< how far it moves the object
  std::vector<std::array<double, 2>> load{};  ///< ends of w
  Reals growing{};                            ///< u
  /// Whether all numbers are 0 or between 2^-200 and 2^200: else doubles certify nothing.
  bool is_moderate = true;
  /// \}

  /// Fills in what follows from the rest; `farthest` is a typical distance, or 0.
  void complete(double farthest);
  /// The same where the loads alone are others.
  void complete_loads();
  /// How large the force of a = 1 is, in doubles.
  double force_size(const LawContact& contact) const;
  /// The largest work of a load on a virtual twist, or, of a ball, a bound.
  Rational most_load_work(const Row& y) const;
  /// A sum of its entries' largest magnitudes, times those of y, at h = 1.
  double load_size(const Reals& y) const;
  /// The number of coordinates of points.
  std::size_t coordinates() const { return motions + 2; }
  /// One in doubles over one as it stands, of a coordinate of points.
  double unit(std::size_t coordinate) const {
    return coordinate < motions && rotates[coordinate] != 0 ? length : 1;
  }
  /// \{ A motion, or more coordinates of a point, in doubles; and a function of these.
  void scale(Reals& motion) const {
    for (std::size_t j = 0; j < motions; ++j) motion[static_cast<Eigen::Index>(j)] *= unit(j);
  }
  void scale_function(Reals& function) const {
    for (std::size_t j = 0; j < motions; ++j) function[static_cast<Eigen::Index>(j)] /= unit(j);
  }
  /// \}
  /// A point in doubles, of norm 1.
  Reals scaled(const Row& point) const;
  /// plane.x over the norm of the plane.
  double value_at(const Row& plane, const Reals& x) const;
  /// A plane through x and across the way from b to a, in few bits; 0 where these are too near.
  Row plane_between(const Reals& a, const Reals& b, const Reals& x) const;
  /// h w + l u of a point with these, in doubles, on y: where its work is largest.
  Reals load_at(double height, double multiple, const Reals& y) const;
  /// Returns whether each slip and friction force is along a line, as in the plane.
  bool is_linear() const;
  /// Whether the box, lengths of normals included, is one point.
  bool is_point() const;
};

/// Of a problem in the plane that is no family.
Law planar_law(const Problem& problem);

}  // namespace stickslip
