// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Motions that no force sees, such as the turn of a body between two fingers about the line
/// through them (certificate/FORMAT.md, section 6, `degree-free`), exactly.
#pragma once

#include <optional>
#include <vector>

#include "stickslip/engine/motion_region.hpp"

namespace stickslip {

/// All wrenches that contacts can exert, whatever the law's numbers are: the rows N_i, and
/// those of S_i where there is friction.
class ForceSpan {
 public:
  /// Of all of its contacts.
  explicit ForceSpan(const Law& law);
  explicit ForceSpan(const Problem& problem);  ///< likewise
  /// Of these wrenches.
  ForceSpan(std::size_t motions, const std::vector<RationalRow>& wrenches);

  /// Independent rows that span it, in reduced echelon form: each is 1 in a column of its own
  /// and 0 in those of the others.
  const std::vector<RationalRow>& rows() const { return rows_; }
  const std::vector<std::size_t>& columns() const { return columns_; }  ///< of the rows
  std::size_t rank() const { return rows_.size(); }                     ///< how many
  /// A basis of the motions that none of these wrenches sees.
  std::vector<RationalRow> free_motions() const;
  /// No load of the law, and of a margin no growth, sees these motions either. (Else there is
  /// no equilibrium.)
  bool has_loads_of(const Law& law) const;
  bool has_load_of(const Problem& problem) const;  ///< likewise, of one grasp

 private:
  void add(RationalRow row);

  std::size_t motions_;
  std::vector<RationalRow> rows_;
  std::vector<std::size_t> columns_;
};

/// Returns the load nearest to `load` that no free motion sees, with torques over this length:
/// such a load differs from `load` by the part that nothing opposes. Exact.
RationalRow opposed_part(const ForceSpan& span, const Law& law, const RationalRow& load,
                         const Rational& length);

/// The free motion that the load in the middle of the law's box is most against, if it refutes
/// the root of all regions. In doubles it would be missed by a little.
std::optional<Row> unopposed_twist(const Law& law);

}  // namespace stickslip
