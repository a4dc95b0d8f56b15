// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Polyhedral cones of points x = (d, h, l) (problem.hpp), for motions d of 3 coordinates in
/// the plane, 6 in space, and more for several bodies. A cone is kept by its generators and cut
/// by one plane at a time: the double description method (Motzkin, Raiffa, Thompson, Thrall,
/// 1953; Fukuda and Prodon, "Double description method revisited", 1996), in integers.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "stickslip/core/row.hpp"
#include "stickslip/core/sign.hpp"
#include "stickslip/core/twist.hpp"

namespace stickslip {

/// The index of a constraint of a cone: its place, from 0, in the order of the cuts.
using ConstraintIndex = std::uint32_t;

/// A generator of a cone, which contains all its nonnegative multiples.
template <class Vector>
struct RayOf {
  Vector x;                            ///< primitive
  std::vector<ConstraintIndex> tight;  ///< the constraints that are 0 at x, increasing
};

/// \{ The number of entries of a vector of fixed length; 0 for any other vector.
template <class Vector>
constexpr std::size_t kCoordinates = 0;
template <std::size_t n>
constexpr std::size_t kCoordinates<IntegerVector<n>> = n;
/// \}

/// A ray of a cone in the plane.
using Ray = RayOf<IntegerVector5>;

/// The side of a plane to keep, with the plane itself: plane.x >= 0, = 0 or <= 0.
enum class Side { kPositive, kZero, kNegative };

/// The sums of nonnegative multiples of rays and any multiples of lines. The lines are a basis
/// of the lineality space, and there is one ray for each extreme ray modulo that space. All
/// constraints are 0 on the lines. `Vector` is an IntegerVector<D + 2> for motions of D
/// coordinates, or a Row of as many entries.
template <class Vector>
class ConeOf {
 public:
  /// The multiples l of a new cone: 0 alone, or any number.
  enum class Multiples { kZero, kAny };

  /// Makes the cone {h >= 0}, which is constraint 0. Points have so many coordinates; a Row has
  /// to be told, as its type does not say.
  explicit ConeOf(Multiples multiples = Multiples::kZero,
                  std::size_t coordinates = kCoordinates<Vector>);

  /// Returns the lines, each as one primitive vector.
  const std::vector<Vector>& lines() const { return lines_; }
  /// Returns the extreme rays modulo the lines.
  const std::vector<RayOf<Vector>>& rays() const { return rays_; }
  /// Returns the number of cuts, plus 1.
  ConstraintIndex constraint_count() const { return constraint_count_; }
  /// Returns how many pairs of rays on opposite sides of the last plane were tested for being
  /// neighbours.
  std::size_t pairs() const { return pairs_; }

  /// Returns the lines, each both ways, and then the rays.
  std::vector<Vector> directions() const;

  /// Keeps the part with plane.x >= 0, = 0 or <= 0, which becomes the next constraint. Takes
  /// O(R^3) for R rays in the worst case (the adjacency test), and O(R) when no ray changes
  /// side.
  void cut(const Vector& plane, Side side);

  /// Returns the parts on some sides of a plane, for which this is the next constraint. It
  /// gives what as many cuts would, but computes once what they share. (The pairs are counted
  /// in the first part.)
  std::vector<ConeOf> parts(const Vector& plane, const std::vector<Side>& sides) const;

 private:
  /// Leaves nothing of use behind.
  std::vector<ConeOf> split(const Vector& plane, const std::vector<Side>& sides);
  bool move_along_a_line(const Vector& plane);
  std::vector<RayOf<Vector>> rays_between(const std::vector<Integer>& heights);

  std::size_t dimension_;  ///< the dimension of the space of points
  std::vector<Vector> lines_;
  std::vector<RayOf<Vector>> rays_;
  ConstraintIndex constraint_count_ = 1;
  std::size_t pairs_ = 0;
};

/// A cone in the plane.
using Cone = ConeOf<IntegerVector5>;

extern template class ConeOf<IntegerVector5>;
extern template class ConeOf<Row>;

/// The signs that a linear function takes on a cone.
struct SignRange {
  bool negative = false;  ///< on some ray or line
  bool zero = false;      ///< on some ray or on all of the cone
  bool positive = false;  ///< on some ray or line

  /// \{ Returns whether the function is >= 0, <= 0 or 0 on all of the cone.
  bool is_nonnegative() const { return !negative; }
  bool is_nonpositive() const { return !positive; }
  bool is_zero() const { return !negative && !positive; }
  /// \}
  /// Returns whether the plane cuts the cone's relative interior.
  bool is_mixed() const { return negative && positive; }
};

/// Finds the signs of linear functions on one cone, which has to outlive this. It takes them
/// from doubles where their error bounds tell, else from integers.
class ConeSigns {
 public:
  /// Rounds the rays of the cone.
  explicit ConeSigns(const Cone& cone);

  /// Returns the signs that plane.x takes on the cone. O(rays + lines).
  SignRange on(const IntegerVector5& plane) const;
  /// Returns the rays on which plane.x = 0.
  std::vector<const Ray*> rays_in(const IntegerVector5& plane) const;

 private:
  /// Calls `visit(ray, sign)` for each ray.
  template <class Visit>
  void for_each_sign(const IntegerVector5& plane, const Visit& visit) const;

  const Cone& cone_;
  std::vector<std::array<double, 5>> rounded_;  ///< one point for each ray
};

}  // namespace stickslip
