// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The simplex method in doubles, on a dense tableau that grows by rows and columns. Its
/// answers are proposals. That of lp/ starts anew from an exact system each time, and has no
/// multipliers.
#pragma once

#include <cstddef>
#include <vector>

namespace stickslip::robustness_detail {

/// The program: maximise c.x for A x + I z = b, x >= 0, z >= 0. Each row has a column of the
/// identity, z, of its own, which is basic at first.
class Simplex {
 public:
  /// Makes a program of zeros with these numbers of rows and of columns of A.
  Simplex(std::size_t rows, std::size_t columns);

  std::size_t rows() const { return tableau_.size(); }  ///< the number of rows
  std::size_t columns() const { return cost_.size(); }  ///< all columns, of A and I
  std::size_t identity(std::size_t row) const { return identity_[row]; }  ///< the column of z

  /// \{ Sets an entry of A, of b, or of c. It is for the time before the first solution, and
  /// requires b >= 0.
  void set(std::size_t row, std::size_t column, double value) { tableau_[row][column] = value; }
  void set_right(std::size_t row, double value) { right_[row] = value; }
  void set_cost(std::size_t column, double value) { cost_[column] = value; }
  /// \}

  /// Goes from the present basis to a best one. Returns false if it does not get there.
  bool maximise();
  /// Adds a column, with an entry for each row, and returns its index. The basis stays.
  std::size_t add_column(const std::vector<double>& entries, double cost);
  /// Adds the row a.x + z = b, with an entry for each present column, and goes on to the best
  /// basis. Requires that maximise() has returned true. Returns false if it does not get there.
  bool add_row(const std::vector<double>& entries, double right);

  double objective() const { return -objective_; }  ///< c.x
  /// Returns the values of all columns.
  std::vector<double> values() const;
  /// Returns the multiplier of a row: c - (multipliers) A <= 0 at a best basis.
  double dual(std::size_t row) const {
    return cost_[identity_[row]] - reduced_[identity_[row]];
  }

 private:
  void pivot(std::size_t row, std::size_t column);
  bool repair();
  bool ascend();

  std::vector<std::vector<double>> tableau_;
  std::vector<double> right_;
  std::vector<double> cost_;
  std::vector<double> reduced_;        ///< reduced costs; empty before the first solution
  double objective_ = 0;               ///< -c.x
  std::vector<std::size_t> basis_;     ///< the basic column of each row
  std::vector<std::size_t> identity_;  ///< the column of the identity of each row
  std::vector<std::size_t> nonzero_;   ///< the columns of a pivot's row that are not 0
};

}  // namespace stickslip::robustness_detail
