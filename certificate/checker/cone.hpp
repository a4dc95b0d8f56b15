// SPDX-License-Identifier: MIT
/// \file
/// Polyhedral cones in Q^4 by their generators (FORMAT.md §4, "Generators"), cut by one
/// half-space or plane at a time with the double description method: T. S. Motzkin, H. Raiffa,
/// G. L. Thompson, R. M. Thrall, "The double description method", 1953; K. Fukuda, A. Prodon,
/// "Double description method revisited", 1996.
///
/// A cone is the set of sums of arbitrary multiples of its lines and nonnegative multiples of
/// its rays. The lines are linearly independent; the rays are the extreme rays modulo the
/// lines. All are integer vectors without a common factor.
///
/// Cutting by a.x >= 0:
///  - If a.l != 0 for a line l, turned so that a.l > 0, every other generator g moves along l
///    onto the plane, g' = (a.l) g - (a.g) l, and l becomes a ray. (Every x is g' + c l up to a
///    positive factor, and a.x >= 0 iff c >= 0.)
///  - Else the rays with a.r >= 0 stay, and each adjacent pair r, s with a.r > 0 > a.s adds the
///    ray of its span on the plane, (a.r) s - (a.s) r. Two extreme rays are *adjacent* iff no
///    third ray is tight on all the inequalities that both are tight on (the combinatorial
///    test, Fukuda & Prodon, Proposition 7).
/// A cut by a.x = 0 keeps only what lies on the plane. Inequalities that cut nothing off are
/// not recorded: the others describe the same cone, and that is all the adjacency test needs.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "number.hpp"

namespace stickslip_check {

/// An integer vector without a common factor (or 0) and, for the signs of products, its leading
/// bits: x_i = (lead_i + e_i) 2^s with the same s >= 0 for all i, |lead_i| < 2^30, |e_i| < 1,
/// and s = 0, e_i = 0 if `is_short`.
struct Vector {
  std::array<Integer, 4> x;
  std::array<std::int64_t, 4> lead{};
  bool is_short = true;
};

/// The positive multiple of `x` without a common factor.
Vector make_vector(std::array<Integer, 4> x);
/// The same for rationals; if `scale` is given, x = *scale times the result, *scale > 0.
Vector make_vector(const std::array<Rational, 4>& x, Rational* scale = nullptr);

Vector negative(Vector a);
Integer dot(const Vector& a, const Vector& b);
/// The sign of a.b, exactly; cheap unless a.b is very nearly 0.
int sign_of_dot(const Vector& a, const Vector& b);

struct Ray {
  Vector v;
  std::vector<std::uint32_t> tight;  ///< the recorded inequalities with equality, ascending
};

enum class Side { kAtLeastZero, kZero, kAtMostZero };

class Cone {
 public:
  /// {x : x_3 >= 0}: three lines and a ray.
  static Cone half_space();

  Cone cut(const Vector& a, Side side) const;

  const std::vector<Vector>& lines() const { return lines_; }
  /// Shared with the cones this one was cut from.
  const std::vector<std::shared_ptr<const Ray>>& rays() const { return rays_; }

 private:
  Cone cut_line(const Vector& a, Side side, std::size_t line) const;
  bool adjacent(std::size_t i, std::size_t j) const;

  std::vector<Vector> lines_;
  std::vector<std::shared_ptr<const Ray>> rays_;
  std::uint32_t recorded_ = 0;  ///< number of inequalities recorded
};

}  // namespace stickslip_check
