// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Finds exactly the motions that no force sees, such as the turn of a body between two fingers
/// about the line through them (certificate/FORMAT.md, section 6, `degree-free`).
#pragma once

#include <optional>
#include <vector>

#include "stickslip/engine/motion_region.hpp"

namespace stickslip {

/// The span of all wrenches that contacts can exert, whatever the law's numbers are: of the
/// rows N_i, and of the rows S_i where there is friction.
class ForceSpan {
 public:
  /// Spans the wrenches of all contacts of the law, at every corner.
  explicit ForceSpan(const Law& law);
  /// Spans the wrenches of all contacts of the problem.
  explicit ForceSpan(const Problem& problem);
  /// Spans these wrenches, each of `motions` entries.
  ForceSpan(std::size_t motions, const std::vector<RationalRow>& wrenches);

  /// Returns independent rows of the same span in reduced echelon form: each is 1 in a column
  /// of its own and 0 in those of the others.
  const std::vector<RationalRow>& rows() const { return rows_; }
  /// Returns these columns, row by row.
  const std::vector<std::size_t>& columns() const { return columns_; }
  std::size_t rank() const { return rows_.size(); }  ///< the dimension of the span
  /// Returns a basis of the motions that none of these wrenches sees.
  std::vector<RationalRow> free_motions() const;
  /// Returns whether no load of the law, and no growth of a margin, does work on these motions.
  /// If one does, there is no equilibrium under that load.
  bool has_loads_of(const Law& law) const;
  /// Returns the same for the load of one grasp in the plane.
  bool has_load_of(const Problem& problem) const;

 private:
  void add(RationalRow row);

  std::size_t motions_;
  std::vector<RationalRow> rows_;
  std::vector<std::size_t> columns_;
};

/// Returns the load nearest to `load` that does no work on free motions. It differs from `load`
/// by the part that nothing opposes. Exact; torques are measured divided by `length`.
RationalRow opposed_part(const ForceSpan& span, const Law& law, const RationalRow& load,
                         const Rational& length);

/// Returns a free motion on which the load in the middle of the law's box does negative work,
/// as a virtual twist, if this refutes the root of all regions. A search in doubles would miss
/// it by a little.
std::optional<Row> unopposed_twist(const Law& law);

}  // namespace stickslip
