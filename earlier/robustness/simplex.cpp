// SPDX-License-Identifier: GPL-3.0-or-later
#include "earlier/robustness/simplex.hpp"

#include <cmath>
#include <limits>

namespace stickslip::robustness_detail {
namespace {

constexpr double kZero = 1e-9;
constexpr double kNoise = 1e-12;
constexpr std::size_t kMostPivots = 3000;
/// After so many pivots without progress the first column that helps is taken (Bland 1977).
constexpr std::size_t kStalled = 40;

}  // namespace

Simplex::Simplex(std::size_t rows, std::size_t columns)
    : tableau_(rows, std::vector<double>(columns + rows)), right_(rows), cost_(columns + rows) {
  for (std::size_t r = 0; r < rows; ++r) {
    tableau_[r][columns + r] = 1;
    basis_.push_back(columns + r);
    identity_.push_back(columns + r);
  }
}

void Simplex::pivot(std::size_t row, std::size_t column) {
  std::vector<double>& from = tableau_[row];
  const double inverse = 1 / from[column];
  nonzero_.clear();
  for (std::size_t j = 0; j < from.size(); ++j) {
    if (std::abs(from[j]) < kNoise) {
      from[j] = 0;
      continue;
    }
    from[j] *= inverse;
    nonzero_.push_back(j);
  }
  from[column] = 1;
  right_[row] *= inverse;
  const bool is_dense = 3 * nonzero_.size() > from.size();
  const auto subtract = [&](std::vector<double>& to, double factor) {
    if (is_dense) {
      double* __restrict out = to.data();
      const double* __restrict in = from.data();
      for (std::size_t j = 0; j < from.size(); ++j) out[j] -= factor * in[j];
    } else {
      for (const std::size_t j : nonzero_) to[j] -= factor * from[j];
    }
    to[column] = 0;
  };
  for (std::size_t r = 0; r < tableau_.size(); ++r) {
    const double factor = tableau_[r][column];
    if (r == row || factor == 0) continue;
    subtract(tableau_[r], factor);
    right_[r] -= factor * right_[row];
    if (std::abs(right_[r]) < kNoise) right_[r] = 0;
  }
  const double factor = reduced_[column];
  if (factor != 0) {
    subtract(reduced_, factor);
    objective_ -= factor * right_[row];
  }
  basis_[row] = column;
}

bool Simplex::ascend() {
  std::size_t stalled = 0;
  for (std::size_t pivots = 0; pivots < kMostPivots; ++pivots) {
    std::size_t column = columns();
    double best = kZero;
    for (std::size_t j = 0; j < columns(); ++j) {
      if (reduced_[j] <= best) continue;
      column = j;
      if (stalled > kStalled) break;
      best = reduced_[j];
    }
    if (column == columns()) return true;
    std::size_t row = rows();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t r = 0; r < rows(); ++r) {
      const double entry = tableau_[r][column];
      if (entry <= kZero) continue;
      const double ratio = right_[r] / entry;
      if (ratio < least || (ratio == least && basis_[r] < basis_[row])) {
        least = ratio;
        row = r;
      }
    }
    if (row == rows()) return false;
    const double before = objective_;
    pivot(row, column);
    stalled = objective_ < before - kNoise * (1 + std::abs(before)) ? 0 : stalled + 1;
  }
  return false;
}

bool Simplex::maximise() {
  reduced_ = cost_;
  objective_ = 0;
  for (std::size_t r = 0; r < rows(); ++r) {
    const double cost = cost_[basis_[r]];
    if (cost == 0) continue;
    for (std::size_t j = 0; j < columns(); ++j) reduced_[j] -= cost * tableau_[r][j];
    objective_ -= cost * right_[r];
  }
  return ascend();
}

std::size_t Simplex::add_column(const std::vector<double>& entries, double cost) {
  double reduced = cost;
  std::vector<double> column(rows());
  for (std::size_t s = 0; s < rows(); ++s) {
    if (entries[s] == 0) continue;
    for (std::size_t r = 0; r < rows(); ++r) {
      column[r] += entries[s] * tableau_[r][identity_[s]];
    }
    reduced -= dual(s) * entries[s];
  }
  for (std::size_t r = 0; r < rows(); ++r) tableau_[r].push_back(column[r]);
  cost_.push_back(cost);
  reduced_.push_back(reduced);
  return columns() - 1;
}

bool Simplex::add_row(const std::vector<double>& entries, double right) {
  std::vector<double> row = entries;
  for (std::size_t r = 0; r < rows(); ++r) {
    const double factor = row[basis_[r]];
    if (factor == 0) continue;
    for (std::size_t j = 0; j < columns(); ++j) row[j] -= factor * tableau_[r][j];
    row[basis_[r]] = 0;
    right -= factor * right_[r];
  }
  for (std::vector<double>& other : tableau_) other.push_back(0);
  row.push_back(1);
  tableau_.push_back(std::move(row));
  right_.push_back(right);
  cost_.push_back(0);
  reduced_.push_back(0);
  basis_.push_back(columns() - 1);
  identity_.push_back(columns() - 1);
  return repair() && ascend();
}

/// The dual simplex method, from a basis whose reduced costs are not above 0.
bool Simplex::repair() {
  for (std::size_t pivots = 0; pivots < kMostPivots; ++pivots) {
    std::size_t row = rows();
    double least = -kZero;
    for (std::size_t r = 0; r < rows(); ++r) {
      if (right_[r] >= least) continue;
      least = right_[r];
      row = r;
    }
    if (row == rows()) {
      for (double& value : right_) {
        if (value < 0) value = 0;
      }
      return true;
    }
    std::size_t column = columns();
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < columns(); ++j) {
      const double entry = tableau_[row][j];
      if (entry >= -kZero) continue;
      const double ratio = reduced_[j] / entry;
      if (ratio < best) {
        best = ratio;
        column = j;
      }
    }
    if (column == columns()) return false;
    pivot(row, column);
  }
  return false;
}

std::vector<double> Simplex::values() const {
  std::vector<double> result(columns());
  for (std::size_t r = 0; r < rows(); ++r) result[basis_[r]] = right_[r];
  return result;
}

}  // namespace stickslip::robustness_detail
