// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Proofs by degree, in the plane and in space: a parallelepiped of motions on whose walls
/// there is no equilibrium (certificate/FORMAT.md, section 6).
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "stickslip/motion/reals.hpp"
#include "stickslip/motion/strict_cone.hpp"

namespace stickslip {

/// There is an equilibrium in a body of motions; with trees of such nodes.
template <class Node>
struct DegreeProofIn : ConvexBody {
  std::vector<RationalRow> direction{};  ///< A, by rows
  std::vector<Node> trees{};  ///< list 1 unless it is not needed, and list 2; one for each wall
};

/// The exact rank of a matrix of these rows.
std::size_t rank_of(const std::vector<RationalRow>& rows);

/// `degree-walls` and `degree-direction`: both have this rank, that of all forces.
template <class Node>
bool has_rank(const DegreeProofIn<Node>& proof, std::size_t rank) {
  return rank_of(proof.walls) == rank && rank_of(proof.direction) == rank;
}

/// What list 2 asks of a leaf besides, `leaf-direction`: y.A(d - h d0) >= 0.
class PullRule {
 public:
  /// A and d0.
  PullRule(const std::vector<RationalRow>& matrix, const RationalRow& twist);
  /// A(d - h d0) by its rows, as functions of points.
  explicit PullRule(const std::vector<RationalRow>& rows);

  /// Whether the function is below 0 at none of the points.
  template <class Twist, class Point>
  bool holds(const Twist& y, const std::vector<Point>& points) const {
    Row function(rows_.front().size());
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      for (std::size_t k = 0; k < function.size(); ++k) function[k] += y[j] * rows_[j][k];
    }
    return std::none_of(points.begin(), points.end(),
                        [&](const Point& x) { return value(function, x).sign() < 0; });
  }
  /// -A(d - h d0) at a point, up to a positive factor. Exactly up to the last step, as d - h d0
  /// may be small beside d.
  template <class Point>
  Reals against(const Point& x) const {
    Row exact;
    for (const Row& row : rows_) exact.emplace_back(-value(row, x));
    return in_doubles(exact);
  }

 private:
  template <class Point>
  static Integer value(const Row& function, const Point& x) {
    Integer sum = 0;
    for (std::size_t k = 0; k < function.size(); ++k) sum += function[k] * x[k];
    return sum;
  }

  std::vector<Row> rows_;  ///< of A(d - h d0), times one positive number
};

/// `degree-law`: every contact is closed at the vertices of the body, which are the rays of the
/// walls' regions.
template <class Region, class Model, class Proof>
bool all_closed_inside(const Model& model, const Proof& proof) {
  for (std::size_t wall = 0; wall < proof.wall_count(); ++wall) {
    const Region region = Region::wall(model, proof, wall);
    for (std::size_t i = 0; i < model.contacts.size(); ++i) {
      if (region.separation(i) != Separation::kClosed) return false;
    }
  }
  return true;
}

}  // namespace stickslip
