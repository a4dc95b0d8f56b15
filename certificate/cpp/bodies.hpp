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
/// to + factor row
SparseRow plus(const SparseRow& to, const Rational& factor, const SparseRow& row);

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
  Mechanism(const std::vector<Body>& bodies, std::vector<Turns> joints, bool in_space);

  std::size_t dimension() const { return dimension_; }
  std::size_t joints() const { return joints_.size(); }
  /// J_b; nothing is the ground.
  const Matrix& motion(std::optional<std::size_t> body) const {
    return body ? motions_[*body] : ground_;
  }
  /// e_q.
  SparseRow row_of_joint(std::size_t q) const;
  /// That of `over`.
  SparseRow row(const Turns& over) const;

 private:
  std::vector<Turns> joints_;
  std::size_t dimension_;
  Matrix ground_;
  std::vector<Matrix> motions_;
};

/// What makes a contact one of several bodies; or what an element is that is no contact.
struct Element {
  enum class Kind : std::int8_t { kContact, kRatchet, kSpring };

  Kind kind;
  Matrix rows;          ///< G of a contact; of the others the one row
  std::string place;    ///< of the others in the grasp file, such as joints[0],
  std::string preload;  ///< and the name that P' has there
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
/// Adds that sum, in as many steps as the matrix has entries.
void add_combined(Vector& to, const Matrix& matrix, const Vector& factors);
/// The products of the rows with a motion.
Vector moved(const Matrix& matrix, const Vector& motion);

/// G^T row.
Vector seen(const Sight& sight, const Vector& row);

}  // namespace stickslip_check
