// SPDX-License-Identifier: MIT
/// \file
/// Polyhedral cones in Q^n by their generators (FORMAT.md §4, "Generators"), cut by one
/// condition a.x >= 0 or a.x = 0 at a time with the double description method: T. S. Motzkin,
/// H. Raiffa, G. L. Thompson, R. M. Thrall, "The double description method", 1953; K. Fukuda,
/// A. Prodon, "Double description method revisited", 1996.
///
/// A cone is the set of sums of arbitrary multiples of its lines and nonnegative multiples of
/// its rays. The lines are linearly independent; the rays are the extreme rays modulo the
/// lines. Each ray knows which of the conditions are zero on it; on lines all are.
///
/// Cutting by a.x >= 0:
///  - If a.l != 0 for a line l, turned so that a.l > 0, every other generator g moves along l
///    onto the plane, g' = (a.l) g - (a.g) l, and l becomes a ray. (Every x is g' + c l up to a
///    positive factor, and a.x >= 0 iff c >= 0.)
///  - Else the rays with a.r >= 0 stay, and each adjacent pair r, s with a.r > 0 > a.s adds the
///    ray of its span on the plane, (a.r) s - (a.s) r. Two extreme rays are *adjacent* iff all
///    conditions that are zero on both are zero together on no third ray (the combinatorial
///    test, Fukuda & Prodon, Proposition 7), of which there are n - 2 or more, less the lines.
/// A cut by a.x = 0 keeps only what lies on the plane.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "number.hpp"

namespace stickslip_check {

/// A set of conditions, by their numbers; of any size, missing words are 0.
using Set = std::vector<std::uint64_t>;
void insert(Set& set, std::size_t condition);
Set intersection(const Set& a, const Set& b);

struct Ray {
  Form x;
  Set zero;  ///< the conditions that are zero on it
};

class Cone {
 public:
  /// All of Q^n: lines only.
  explicit Cone(std::size_t n);

  /// The part with a.x >= 0, or with a.x = 0. The condition's number is cuts().
  Cone cut(const Form& a, bool equality = false) const;

  std::size_t cuts() const { return cuts_; }
  const std::vector<Form>& lines() const { return lines_; }
  /// Shared with the cones this one was cut from.
  const std::vector<std::shared_ptr<const Ray>>& rays() const { return rays_; }

 protected:
  void add(Form x, Set zero);

 private:
  Cone() = default;
  Cone cut_line(const Form& a, bool equality, std::size_t line) const;

  std::vector<Form> lines_;
  std::vector<std::shared_ptr<const Ray>> rays_;
  std::size_t cuts_ = 0;
};

}  // namespace stickslip_check
