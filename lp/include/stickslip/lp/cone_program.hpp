// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Two systems over cones, in doubles. Exactly one of them has a solution, by Farkas' lemma
/// for cones, except perhaps for a load w on the border between the two:
///
///     w + sum A_i z_i = 0,   z_i in K_i    (forces z),                                   (1)
///     w.x > 0,   A_i^T x in K_i            (a motion x),                                 (2)
///
/// where K_i are the z with z_0 >= |(z_1, ..., z_k)|: a half line, or a cone of second order.
/// Each A_i has few columns. Either answer is a proposal, which exact arithmetic has to judge.
///
/// **Method.** An interior-point method follows the central path of the homogeneous self-dual
/// embedding of both systems, with Nesterov and Todd's scaling. The limit of the path is as far
/// inside the cones as the equations allow, so that it stays in them when it is rounded. A step
/// factors one sparse matrix, of as many rows as x has entries, by Eigen.
///
/// Sources: Andersen, Roos, Terlaky, "On implementing a primal-dual interior-point method for
/// conic quadratic optimization", Math. Program. 95, 2003; Vandenberghe, "The CVXOPT linear and
/// quadratic cone program solvers", 2010.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace stickslip {

namespace lp_detail {
class ConePath;
}  // namespace lp_detail

/// A column of few entries: pairs of a row and a number, each row at most once.
using DoubleColumn = std::vector<std::pair<std::size_t, double>>;

/// The numbers of the two systems.
struct ConePair {
  std::vector<double> load;                      ///< w
  std::vector<std::vector<DoubleColumn>> cones;  ///< A_i, by its columns
};

/// A proposal for each of the two systems. At most one can be a solution.
struct ConeProposal {
  bool rests = false;  ///< whether (1) seems to have a solution, and not (2)
  std::vector<std::vector<double>> forces{};  ///< z of (1), by cone
  std::vector<double> motion{};               ///< x of (2), with entries of magnitude up to 1
  /// How deep A_i^T x is in K_i, by cone: y_0 - |(y_1, ..., y_k)| for the y that the path has
  /// in place of A_i^T x, over the largest entry of A_i.
  std::vector<double> gaps{};
  int steps = 0;  ///< the number of steps
};

/// Follows the path of a pair of systems to its end, and keeps the matrix that was factored
/// there.
class ConeSearch {
 public:
  /// Follows the path in doubles, or to its end in long doubles, whose steps take about four
  /// times as long.
  explicit ConeSearch(const ConePair& pair, bool is_long = false);
  ConeSearch(const ConeSearch&) = delete;
  ConeSearch& operator=(const ConeSearch&) = delete;
  ~ConeSearch();

  /// Returns the proposal. Near the border between the two systems neither part of it needs to
  /// be even nearly a solution.
  const ConeProposal& proposal() const;
  /// Returns changes z of the forces, by cone, that balance one more load: load + sum A_i z_i =
  /// 0 but for rounding. Forces deep in their cones change much, others little.
  std::vector<std::vector<double>> changes(const std::vector<double>& load) const;

 private:
  std::unique_ptr<lp_detail::ConePath> path_;
};

}  // namespace stickslip
