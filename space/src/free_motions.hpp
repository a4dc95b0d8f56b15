// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Motions that no force sees, such as the turn of a body between two fingers about the line
/// through them (certificate/FORMAT.md, section 6, `degree-free`).
#pragma once

#include <optional>
#include <vector>

#include "space_model.hpp"

namespace stickslip::space_detail {

/// All wrenches that contacts of a box can exert, whatever its numbers are: the rows N_i, and
/// those of S_i where there is friction.
class ForceSpan {
 public:
  explicit ForceSpan(const SpaceModel& box);

  /// Independent rows that span it, in reduced echelon form: each is 1 in a column of its own
  /// and 0 in those of the others.
  const std::vector<Vector6>& rows() const { return rows_; }
  const std::vector<std::size_t>& columns() const { return columns_; }  ///< of the rows
  std::size_t rank() const { return rows_.size(); }
  /// A basis of the motions that none of these wrenches sees.
  std::vector<Vector6> free_motions() const;
  /// No load of the box, and of a margin no growth, sees these motions either. (Else there is
  /// no equilibrium.)
  bool has_loads_of(const SpaceModel& box) const;
  /// The free motion that the load in the middle of the box is most against, if there is one: a
  /// virtual twist that refutes all motions if all loads of the box are against it.
  std::optional<Row> unopposed(const SpaceModel& box) const;

 private:
  void add(Vector6 row);

  std::vector<Vector6> rows_;
  std::vector<std::size_t> columns_;
};

}  // namespace stickslip::space_detail
