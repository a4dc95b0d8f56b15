// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Proofs by degree, in the plane and in space: a parallelepiped of motions on whose walls
/// there is no equilibrium (certificate/FORMAT.md, section 6).
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "stickslip/equilibrium/search/scaled_point.hpp"
#include "stickslip/equilibrium/search/strict_cone.hpp"

namespace stickslip {

/// There is an equilibrium in a body of motions of D coordinates; with trees of such nodes.
template <std::size_t D, class Node>
struct DegreeProofIn : ConvexBody<D> {
  SquareMatrix<D> direction{};  ///< A
  std::vector<Node> trees;  ///< list 1 unless it is not needed, and list 2; one for each wall
};

/// The exact rank of a matrix of these rows. For D = 3 and 6.
template <std::size_t D>
std::size_t rank_of(const std::vector<std::array<Rational, D>>& rows);

/// `degree-walls` and `degree-direction` where no motion is free: both have the rank D.
template <std::size_t D, class Node>
bool has_full_rank(const DegreeProofIn<D, Node>& proof) {
  return rank_of<D>(proof.walls) == D &&
         rank_of<D>({proof.direction.begin(), proof.direction.end()}) == D;
}

/// What `leaf-direction` asks of list 2: y.A(d - h d0) >= 0.
template <std::size_t D>
class Direction {
 public:
  /// A and d0.
  Direction(const SquareMatrix<D>& matrix, const std::array<Rational, D>& twist);
  /// By its rows, as functions of points.
  explicit Direction(const std::array<std::array<Rational, D + 2>, D>& rows);

  /// Whether the function is below 0 at none of the points.
  bool holds(const IntegerVector<D>& y, const std::vector<IntegerVector<D + 2>>& points) const;
  /// -A(d - h d0) at a point, with torques over `length`, over its norm.
  std::array<double, D> against(const IntegerVector<D + 2>& x, double length) const;

 private:
  std::array<IntegerVector<D + 2>, D> rows_{};  // A(d - h d0), times one positive number
};

template <std::size_t D>
Direction<D>::Direction(const std::array<std::array<Rational, D + 2>, D>& rows) {
  Integer common = 1;
  for (const auto& row : rows) {
    for (const Rational& entry : row) common = lcm(common, denominator(entry));
  }
  for (std::size_t j = 0; j < D; ++j) {
    for (std::size_t k = 0; k < D + 2; ++k) {
      rows_[j][k] = numerator(rows[j][k]) * (common / denominator(rows[j][k]));
    }
  }
}

template <std::size_t D>
Direction<D>::Direction(const SquareMatrix<D>& matrix, const std::array<Rational, D>& twist)
    : Direction([&] {
        std::array<std::array<Rational, D + 2>, D> rows{};
        for (std::size_t j = 0; j < D; ++j) {
          std::copy(matrix[j].begin(), matrix[j].end(), rows[j].begin());
          rows[j][D] = -dot(matrix[j], twist);
        }
        return rows;
      }()) {}

template <std::size_t D>
bool Direction<D>::holds(const IntegerVector<D>& y,
                         const std::vector<IntegerVector<D + 2>>& points) const {
  IntegerVector<D + 2> function{};
  for (std::size_t j = 0; j < D; ++j) {
    for (std::size_t k = 0; k < D + 2; ++k) function[k] += y[j] * rows_[j][k];
  }
  return std::none_of(points.begin(), points.end(), [&](const IntegerVector<D + 2>& x) {
    return dot(function, x).sign() < 0;
  });
}

/// Exactly up to the last step, as d - h d0 may be small beside d.
template <std::size_t D>
std::array<double, D> Direction<D>::against(const IntegerVector<D + 2>& x,
                                            double length) const {
  IntegerVector<D> exact;
  for (std::size_t j = 0; j < D; ++j) exact[j] = -dot(rows_[j], x);
  std::array<double, D> result = in_doubles(exact);
  for (std::size_t j = equilibrium_detail::kFirstRotation<D>; j < D; ++j) result[j] /= length;
  equilibrium_detail::normalize(result);
  return result;
}

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
