// SPDX-License-Identifier: MIT
/// \file
/// The bound g(r) of a leaf (FORMAT.md §4, "Leaf").
///
/// With c_i = alpha_i (times theta_i where the rule says so), g is
///     g(x) = h (y.w) + sum of c_i v_i(x)         over the contacts with a linear bound
///                    + sum of c_i max(0, v_i(x)) over the mixed contacts with alpha_i >= 0.
/// There are two ways to see that g(r) <= 0 (or < 0):
///  - `upper`: an integer that is at least 2^shift g(r). The c_i are rounded to integers over
///    2^shift, and for a linear bound the rounding error, below 1, is covered by adding
///    |v_i(r)| or something larger. Most rays are settled by this, without any large
///    denominator.
///  - `exact`: the sum of the definition in rationals, for the rays where `upper` does not
///  tell.
/// The contacts with v_i >= 0 on the region and a sign need no choice at the leaf; their sum is
/// linear in y as well as in x, so it is kept as a matrix (Aggregate) that sub-regions inherit.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "cone.hpp"
#include "question.hpp"

namespace stickslip_check {

/// v_i on a region: of both signs (or not known yet), >= 0 on all rays, <= 0 on all rays.
enum class Gap : std::int8_t { kMixed, kClosed, kOpen };
/// FORMAT.md: a contact "has the sign" + or -, or none.
enum class SlipSign : std::int8_t { kNone, kPlus, kMinus };

struct Status {
  Gap gap = Gap::kMixed;
  SlipSign sign = SlipSign::kNone;
};

/// The work of a contact on y, y.(N - mu T) or y.(N + mu T), times the scale of v_i.
struct Work {
  std::array<Integer, 3> row;      ///< without a common factor
  Rational weight;                 ///< > 0: alpha_i v_i(x) = weight (row.y) (v.x)
  std::array<Integer, 3> shifted;  ///< floor(2^shift weight row)
};

/// A contact as the walk uses it: v_i(x) is a positive multiple of v.x, tau_i of tau.x.
struct WalkContact {
  Vector v;
  Vector tau;
  Integer v_max;  ///< largest |v_j|, so that |v.x| <= v_max (sum of |x_j|)
  Work plus;      ///< N - mu T
  Work minus;     ///< N + mu T
};

/// Sum over some contacts of shifted (row) times v (column), and of their v_max.
struct Aggregate {
  std::array<std::array<Integer, 4>, 3> form;
  Integer slack;
};

struct Problem {
  std::vector<WalkContact> contacts;
  std::size_t shift = 0;
};
Problem make_problem(const std::vector<Row>& rows);

void add(Aggregate& sum, const WalkContact& contact, SlipSign sign);

/// The bound at one leaf under a load w. `status` must outlive it and be that of the leaf's
/// region; `undecided` must list every contact that is neither open nor in `decided`.
class LeafBound {
 public:
  LeafBound(const Problem& problem, const Vector3& load, const std::vector<Status>& status,
            const std::vector<std::size_t>& undecided, const Aggregate& decided,
            const Vector3& y, const std::map<std::size_t, Rational>& thetas);

  /// At least 2^shift D g(r), where D > 0 is the same for all r.
  Integer upper(const Vector& r) const;
  /// D g(r).
  Rational exact(const Vector& r) const;
  /// The common factor D.
  const Integer& scale() const { return scale_; }

 private:
  const Work& work(std::size_t contact) const;
  Rational theta(std::size_t contact) const;

  const Problem& problem_;
  const std::vector<Status>& status_;
  const std::map<std::size_t, Rational>& thetas_;
  Integer scale_;
  std::array<Integer, 3> y_;       ///< D y, integers
  Rational power_;                 ///< D (y.w)
  std::array<Integer, 4> linear_;  ///< of all linear bounds and h (y.w), rounded
  Integer slack_;                  ///< rounding error of linear_ per sum of |x_j|
  std::vector<std::pair<std::size_t, Integer>> mixed_;  ///< contacts and ceil(2^shift c_i)
};

}  // namespace stickslip_check
