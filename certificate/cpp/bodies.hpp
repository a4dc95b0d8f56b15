// SPDX-License-Identifier: MIT
/// \file
/// Bodies, links and joints, and what an element of several bodies sees of their motion
/// (FORMAT.md §14).
///
/// The motion of one body is d: 3 numbers in the plane, 6 in space. The motion of all of them
/// has D numbers, the state z; body b moves by J_b z.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "number.hpp"

namespace stickslip_check {

inline constexpr std::size_t kPlanar = 3;   ///< of one body: translation x, y and rotation
inline constexpr std::size_t kSpatial = 6;  ///< translation x, y, z and rotation x, y, z
inline constexpr std::size_t kMostCoordinates = 30;  ///< of boxes, trees and margins
inline constexpr std::size_t kMostInFile = 65536;    ///< the largest D (FORMAT.md §14)

/// A row by its entries that are not 0, each with its column, in their order.
using SparseRow = std::vector<std::pair<std::size_t, Rational>>;

/// A matrix of few entries.
struct Matrix {
  std::size_t columns = 0;
  std::vector<SparseRow> rows = {};
};

/// The matrix that leaves vectors of `size` numbers as they are.
Matrix unit_matrix(std::size_t size);
/// A body as the grasp file gives it.
struct Body {
  std::string name;
  std::optional<Vector> way;  ///< of a link: eta, its motion as its joint turns by 1
  std::optional<std::size_t>
      on;  ///< of a link: the body before it that it is on, or the ground
};

/// Of a slide along g; and of a hinge at a point, about an axis, which the plane has none of.
Vector way_of_slide(const Vector& g);
Vector way_of_hinge(const Vector& point, const Vector& axis);

/// The numbers of `turns` or `over`, by the number of a link.
using Turns = std::map<std::size_t, Rational>;

/// D.
std::size_t dimension_of(const std::vector<Body>& bodies, std::size_t joints, bool in_space);

class Mechanism {
 public:
  Mechanism(std::vector<Body> bodies, const std::vector<Turns>& joints, bool in_space);

  std::size_t dimension() const { return dimension_; }
  std::size_t joints() const { return joints_; }
  /// The first column of a body that is no link.
  std::size_t first_of(std::size_t body) const { return first_[body]; }
  /// J_b; nothing is the ground.
  Matrix motion(std::optional<std::size_t> body) const;
  /// G = J_of - J_by
  Matrix motion_between(std::size_t of, std::optional<std::size_t> by) const;
  /// e_q.
  SparseRow row_of_joint(std::size_t q) const;
  /// That of `over`.
  SparseRow row(const Turns& over) const;

  /// J_b d of all bodies, in time linear in what the file says of them.
  std::vector<Vector> moved(const Vector& d) const;
  /// Adds J_b^T times the wrench on b, for all bodies; one may be empty for 0. Likewise.
  void add_pulled(std::vector<Vector> wrenches, Vector& to) const;

 private:
  std::vector<Body> bodies_;
  std::vector<std::size_t> first_;  ///< by body; 0 of a link
  std::vector<SparseRow> turns_;    ///< by body: c_bq, by columns of joints
  std::size_t size_;                ///< of a motion of one body
  std::size_t joints_;
  std::size_t dimension_;
};

/// What makes a contact one of several bodies; or what an element is that is no contact.
struct Element {
  enum class Kind : std::int8_t { kContact, kRatchet, kSpring };

  Kind kind;
  /// G of a contact, unless there are more than 30 coordinates; of the others the one row.
  Matrix rows;
  std::string place;    ///< of the others in the grasp file, such as joints[0],
  std::string preload;  ///< and the name that P' has there
  std::size_t of = 0;   ///< the bodies of a contact
  std::optional<std::size_t> by = {};
};
/// Nothing for a contact of the one body of versions 1 and 2.
using Sight = std::shared_ptr<const Element>;

inline bool is_contact(const Sight& sight) {
  return !sight || sight->kind == Element::Kind::kContact;
}
inline bool is_spring(const Sight& sight) {
  return sight && sight->kind == Element::Kind::kSpring;
}

/// The wrench, or the twist row, of a force at a point.
Vector at_point(const Vector& point, const Vector& force);

/// B of a length for all translations and an angle for all rotations, where there is no joint
/// (FORMAT.md §1).
Vector bound_of(const Rational& length, const Rational& angle, std::size_t dimension,
                bool in_space);

/// The sum of the rows of a matrix, each by its factor.
Vector combined(const Matrix& matrix, const Vector& factors);

/// G^T row.
Vector seen(const Sight& sight, const Vector& row);

/// A motion as elements see it, G d, in memory linear in the number of bodies.
class BodyMotions {
 public:
  /// Without a mechanism there is one body.
  BodyMotions(const Mechanism* mechanism, Vector d);

  Vector seen_by(const Sight& sight) const;

 private:
  Vector d_;
  std::vector<Vector> motions_;
};

/// The sum of G^T row of many elements and rows, likewise.
class BodyForces {
 public:
  BodyForces(const Mechanism* mechanism, std::size_t dimension)
      : mechanism_(mechanism), sum_(dimension) {}

  void add(const Sight& sight, const Vector& row);
  Vector total();

 private:
  const Mechanism* mechanism_;
  Vector sum_;
  std::vector<Vector> wrenches_;  ///< by body
};

}  // namespace stickslip_check
