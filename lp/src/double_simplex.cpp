// SPDX-License-Identifier: GPL-3.0-or-later
//
// The simplex method in double precision: fast, fallible, and asked only for a proposal.
//
// Dictionaries b_i = T_i0 + sum_j T_ij v_j, as in the exact method (integer_simplex.cpp), but
// with pivots chosen for speed and stability. The tolerances below choose what to propose;
// nothing here decides an answer.
//
// Three kinds of line are no longer touched once they cannot matter to the choice of pivots:
// rows of basic free variables, rows of redundant equations, and columns of slacks of
// equations. They are swapped behind the active part.
#include <cmath>
#include <limits>
#include <utility>

#include "steps.hpp"

namespace stickslip::lp_detail {
namespace {

constexpr double kZeroCoefficient = 1e-9;  // for rows scaled to largest coefficient 1
constexpr double kFeasible = 1e-9;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class DoubleSimplex {
 public:
  explicit DoubleSimplex(const ScaledSystem& system)
      : system_(system),
        active_rows_(system.row_count()),
        active_columns_(system.variable_count()),
        width_(std::size_t{system.variable_count()} + 1),
        cells_(width_ * (std::size_t{system.row_count()} + 2), 0.0),
        rows_(system.row_count()),
        pivots_left_(100 + 10 * (long{system.row_count()} + long{system.variable_count()})) {
    const Index n = system.variable_count();
    const Index m = system.row_count();
    for (Index i = 0; i < m; ++i) {
      rows_[i] = {&cells_[width_ * i], n + i, system.domain(n + i)};
      system.approximate_row(i, rows_[i].cells);
    }
    cost_ = &cells_[width_ * m];
    weight_ = &cells_[width_ * (m + std::size_t{1})];
    if (system.has_objective()) system.approximate_row(m, cost_);
    columns_.resize(width_);
    for (Index j = 0; j < n; ++j) columns_[j + 1] = {j, system.domain(j)};
  }

  Proposal run() {
    proposal_.kind = Proposal::Kind::kNone;
    if (remove_equations() && reach_feasibility() && reach_optimality()) {
      proposal_.kind = Proposal::Kind::kOptimal;
    }
    proposal_.nonbasic.reserve(width_ - 1);
    for (std::size_t j = 1; j < width_; ++j) proposal_.nonbasic.push_back(columns_[j].variable);
    return std::move(proposal_);
  }

  long pivots() const { return pivots_; }

 private:
  struct Row {
    double* cells = nullptr;  // the constant, then one per column
    Index variable = 0;
    Domain domain = Domain::kFree;
  };
  struct Column {
    Index variable = 0;
    Domain domain = Domain::kFree;
  };

  // A phase returns true when the next may start; otherwise proposal_ says what was found.

  bool remove_equations() {
    for (std::size_t i = 0; i < active_rows_;) {
      if (rows_[i].domain != Domain::kZero) {
        ++i;
        continue;
      }
      const double* const row = rows_[i].cells;
      std::size_t entering = 0;
      double best = kZeroCoefficient;
      for (std::size_t j = 1; j <= active_columns_; ++j) {
        double score = std::abs(row[j]);
        if (!(score > kZeroCoefficient)) continue;
        // Free variables go first; then those that enter with a value >= 0.
        if (columns_[j].domain == Domain::kFree) {
          score += 1e6;
        } else if ((row[j] > 0) != (row[0] > 0)) {
          score += 1e3;
        }
        if (score > best) {
          best = score;
          entering = j;
        }
      }
      if (entering != 0) {
        if (!pivot(i, entering)) return false;
        // The column is inactive now, and another row may have taken place i.
        if (i < active_rows_ && rows_[i].domain == Domain::kNonNegative) ++i;
      } else if (std::abs(row[0]) > kFeasible) {
        return found(Proposal::Kind::kInfeasible, rows_[i].variable, row[0] > 0 ? 1 : -1);
      } else {
        retire_row(i);
      }
    }
    return true;
  }

  /// Runs the dual simplex method for an invented cost, positive on every column >= 0 (all
  /// about 1, distinct so that ratios do not tie).
  bool reach_feasibility() {
    weight_[0] = 0;
    for (std::size_t j = 1; j <= active_columns_; ++j) {
      const auto spread = static_cast<double>((columns_[j].variable * 7919U) % 997U);
      weight_[j] = columns_[j].domain == Domain::kFree ? 0 : 1 + spread / 4000;
    }
    for (;;) {
      std::size_t leaving = active_rows_;
      double lowest = -kFeasible;
      for (std::size_t i = 0; i < active_rows_; ++i) {
        if (rows_[i].cells[0] < lowest) {
          lowest = rows_[i].cells[0];
          leaving = i;
        }
      }
      if (leaving == active_rows_) return true;
      const double* const row = rows_[leaving].cells;
      std::size_t entering = 0;
      double largest_free = kZeroCoefficient;
      double ratio = kInfinity;
      for (std::size_t j = 1; j <= active_columns_; ++j) {
        if (columns_[j].domain == Domain::kFree) {
          if (std::abs(row[j]) > largest_free) {
            largest_free = std::abs(row[j]);
            ratio = -1;
            entering = j;
          }
        } else if (row[j] > kZeroCoefficient && weight_[j] < ratio * row[j]) {
          ratio = weight_[j] / row[j];
          entering = j;
        }
      }
      if (entering == 0) {
        return found(Proposal::Kind::kInfeasible, rows_[leaving].variable, -1);
      }
      if (!pivot(leaving, entering)) return false;
    }
  }

  /// Runs the primal simplex method, by the steepest coefficient.
  bool reach_optimality() {
    if (!system_.has_objective()) return true;
    for (;;) {
      std::size_t entering = 0;
      double best = kZeroCoefficient;
      for (std::size_t j = 1; j <= active_columns_; ++j) {
        const double gain =
            columns_[j].domain == Domain::kFree ? std::abs(cost_[j]) : -cost_[j];
        if (gain > best) {
          best = gain;
          entering = j;
        }
      }
      if (entering == 0) return true;
      const int direction = cost_[entering] < 0 ? 1 : -1;
      std::size_t leaving = active_rows_;
      double ratio = kInfinity;
      double size = 0;
      for (std::size_t i = 0; i < active_rows_; ++i) {
        const double fall = -rows_[i].cells[entering] * direction;
        if (!(fall > kZeroCoefficient)) continue;
        const double bound = rows_[i].cells[0] > 0 ? rows_[i].cells[0] / fall : 0;
        if (bound < ratio || (bound == ratio && fall > size)) {
          ratio = bound;
          size = fall;
          leaving = i;
        }
      }
      if (leaving == active_rows_) {
        return found(Proposal::Kind::kUnbounded, columns_[entering].variable, direction);
      }
      if (!pivot(leaving, entering)) return false;
    }
  }

  bool found(Proposal::Kind kind, Index witness, int direction) {
    proposal_.kind = kind;
    proposal_.witness = witness;
    proposal_.direction = direction;
    return false;
  }

  /// Returns false when the limit is reached or the numbers have left the range of double.
  bool pivot(std::size_t r, std::size_t c) {
    if (pivots_left_-- == 0) return false;
    ++pivots_;
    double* const row = rows_[r].cells;
    const double inverse = 1 / row[c];
    if (!std::isfinite(inverse) || !std::isfinite(row[0])) return false;
    const std::size_t end = active_columns_ + 1;
    for (std::size_t j = 0; j < end; ++j) row[j] *= -inverse;
    row[c] = inverse;
    for (std::size_t i = 0; i < active_rows_; ++i) {
      if (i != r) eliminate(rows_[i].cells, row, c, end);
    }
    if (system_.has_objective()) eliminate(cost_, row, c, end);
    eliminate(weight_, row, c, end);
    std::swap(rows_[r].variable, columns_[c].variable);
    std::swap(rows_[r].domain, columns_[c].domain);
    if (columns_[c].domain == Domain::kZero) retire_column(c);
    if (rows_[r].domain == Domain::kFree) retire_row(r);
    return true;
  }

  static void eliminate(double* target, const double* row, std::size_t c, std::size_t end) {
    const double factor = target[c];
    if (factor == 0) return;
    target[c] = 0;
    for (std::size_t j = 0; j < end; ++j) target[j] += factor * row[j];
  }

  void retire_row(std::size_t r) { std::swap(rows_[r], rows_[--active_rows_]); }

  void retire_column(std::size_t c) {
    const std::size_t last = active_columns_--;
    std::swap(columns_[c], columns_[last]);
    // The old entries of column c are not needed again.
    for (std::size_t i = 0; i < active_rows_; ++i) rows_[i].cells[c] = rows_[i].cells[last];
    cost_[c] = cost_[last];
    weight_[c] = weight_[last];
  }

  const ScaledSystem& system_;
  std::size_t active_rows_;
  std::size_t active_columns_;
  std::size_t width_;
  std::vector<double> cells_;
  std::vector<Row> rows_;
  std::vector<Column> columns_;  // indexed from 1, like the cells
  double* cost_ = nullptr;
  double* weight_ = nullptr;
  long pivots_left_;
  long pivots_ = 0;
  Proposal proposal_;
};

}  // namespace

Proposal propose(const ScaledSystem& system, LpWork& work) {
  DoubleSimplex simplex(system);
  Proposal proposal = simplex.run();
  work.double_pivots += simplex.pivots();
  return proposal;
}

}  // namespace stickslip::lp_detail
