// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Polyhedral cones of points x = (d, h, l) (problem.hpp), with motions d of 3 coordinates in
/// the plane and 6 in space, kept by generators and cut by one plane at a time: the double
/// description method (Motzkin, Raiffa, Thompson, Thrall, 1953; Fukuda and Prodon, "Double
/// description method revisited", 1996), in integers.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "stickslip/core/row.hpp"
#include "stickslip/core/sign.hpp"
#include "stickslip/core/twist.hpp"

namespace stickslip {

/// The constraints of a cone count from 0 in the order in which they were cut.
using ConstraintIndex = std::uint32_t;

/// A generator of a cone, of which nonnegative multiples count.
template <class Vector>
struct RayOf {
  Vector x;                            ///< primitive
  std::vector<ConstraintIndex> tight;  ///< the constraints that are 0 at x, increasing
};

/// \{ Of a vector whose length is fixed; else 0.
template <class Vector>
constexpr std::size_t kCoordinates = 0;
template <std::size_t n>
constexpr std::size_t kCoordinates<IntegerVector<n>> = n;
/// \}

/// In the plane.
using Ray = RayOf<IntegerVector5>;

/// Which side of a plane to keep, the plane included: plane.x >= 0, = 0 or <= 0.
enum class Side { kPositive, kZero, kNegative };

/// { sum of nonnegative multiples of rays and any multiples of lines }. The lines are a basis
/// of the lineality space, and the rays one for each extreme ray modulo it. All constraints are
/// 0 on the lines. A Vector is an IntegerVector<D + 2> for motions of D coordinates, or a Row
/// of as many.
template <class Vector>
class ConeOf {
 public:
  /// The multiples of a new cone: l = 0, or any.
  enum class Multiples { kZero, kAny };

  /// {h >= 0}; this is constraint 0. How many coordinates points have a Row does not say.
  explicit ConeOf(Multiples multiples = Multiples::kZero,
                  std::size_t coordinates = kCoordinates<Vector>);

  const std::vector<Vector>& lines() const { return lines_; }             ///< primitive
  const std::vector<RayOf<Vector>>& rays() const { return rays_; }        ///< modulo the lines
  ConstraintIndex constraint_count() const { return constraint_count_; }  ///< cuts, plus 1
  /// Of rays on opposite sides of the last plane: how many were tested for being neighbours.
  std::size_t pairs() const { return pairs_; }

  /// The rays' directions, and each line both ways.
  std::vector<Vector> directions() const;

  /// Keeps the part with plane.x >= 0, = 0 or <= 0; this is the next constraint.
  /// O(R^3) for R rays in the worst case (the adjacency test), O(R) when no ray changes side.
  void cut(const Vector& plane, Side side);

  /// The parts with plane.x >= 0 and <= 0, for which this is the next constraint; as two cuts,
  /// but what both share is computed once. (The pairs are counted in the first.)
  std::pair<ConeOf, ConeOf> halves(const Vector& plane) const;

 private:
  bool cut_along_a_line(const Vector& plane, Side side);
  std::vector<Integer> heights_over(const Vector& plane) const;
  std::vector<RayOf<Vector>> rays_between(const std::vector<Integer>& heights);
  void keep(Side side, const std::vector<Integer>& heights, std::vector<RayOf<Vector>> between);

  std::size_t dimension_;  ///< of the space of points
  std::vector<Vector> lines_;
  std::vector<RayOf<Vector>> rays_;
  ConstraintIndex constraint_count_ = 1;
  std::size_t pairs_ = 0;
};

/// In the plane.
using Cone = ConeOf<IntegerVector5>;

extern template class ConeOf<IntegerVector5>;
extern template class ConeOf<Row>;

/// The signs that a linear function takes on a cone.
struct SignRange {
  bool negative = false;  ///< on some ray or line
  bool zero = false;      ///< on some ray or on all of the cone
  bool positive = false;  ///< on some ray or line

  /// \{ On all of the cone, 0 included.
  bool is_nonnegative() const { return !negative; }
  bool is_nonpositive() const { return !positive; }
  bool is_zero() const { return !negative && !positive; }
  /// \}
  /// The plane cuts the cone's relative interior.
  bool is_mixed() const { return negative && positive; }
};

/// The signs of linear functions on one cone, which has to outlive this: from doubles where
/// their error bounds tell, else from integers.
class ConeSigns {
 public:
  /// Rounds its rays.
  explicit ConeSigns(const Cone& cone);

  /// Those of plane.x for x in the cone. O(rays + lines).
  SignRange on(const IntegerVector5& plane) const;
  /// The rays on which plane.x = 0.
  std::vector<const Ray*> rays_in(const IntegerVector5& plane) const;

 private:
  /// `visit(ray, sign)`
  template <class Visit>
  void for_each_sign(const IntegerVector5& plane, const Visit& visit) const;

  const Cone& cone_;
  std::vector<std::array<double, 5>> rounded_;  ///< by ray
};

}  // namespace stickslip
