// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Two systems over cones of which one has a solution, in doubles and with few columns a cone:
///
///     w + sum A_i z_i = 0,   z_i in K_i    (forces z),                                   (1)
///     w.x > 0,   A_i^T x in K_i            (a motion x),                                 (2)
///
/// where K_i are the z with z_0 >= |(z_1, ..., z_k)|: a half line, or a cone of second order.
/// Either answer is a proposal, which exact arithmetic has to judge.
///
/// **Method.** An interior-point method follows the central path of the homogeneous self-dual
/// embedding of both systems, with Nesterov and Todd's scaling. Its limit is deep within the
/// cones, as far as they leave room, so that rounded numbers stay in them. A step factors one
/// sparse matrix, of as many rows as x has entries, by Eigen.
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

/// The two systems, which have the same numbers.
struct ConePair {
  std::vector<double> load;                      ///< w
  std::vector<std::vector<DoubleColumn>> cones;  ///< A_i, by its columns
};

/// Proposals for both systems, of which one has a solution.
struct ConeProposal {
  bool rests = false;                         ///< whether it is (1) that seems to have one
  std::vector<std::vector<double>> forces{};  ///< z of (1), by cone
  std::vector<double> motion{};               ///< x of (2), with entries of at most 1
  std::vector<double> gaps{};  ///< (A_i^T x)_0 - |(A_i^T x)_1..| over the size of A_i, by cone
  int steps = 0;               ///< how often the matrix was factored
};

/// Follows the path to its end and keeps what was factored there.
class ConeSearch {
 public:
  /// Follows it in doubles, or in long doubles, which take about ten times as long.
  explicit ConeSearch(const ConePair& pair, bool is_long = false);
  ConeSearch(const ConeSearch&) = delete;
  ConeSearch& operator=(const ConeSearch&) = delete;
  ~ConeSearch();

  /// Returns what is proposed. Near the border of both systems that may be not even nearly a
  /// solution of one.
  const ConeProposal& proposal() const;
  /// Returns changes z, by cone, with load + sum A_i z_i = 0 but for rounding: large ones of
  /// forces that are deep in their cones, and small ones of others.
  std::vector<std::vector<double>> changes(const std::vector<double>& load) const;

 private:
  std::unique_ptr<lp_detail::ConePath> path_;
};

}  // namespace stickslip
