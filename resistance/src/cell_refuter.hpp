// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Trees that refute all loads of a cell at once (region_proof.hpp).
#pragma once

#include <vector>

#include "load_cell.hpp"
#include "stickslip/equilibrium/search/region.hpp"
#include "stickslip/equilibrium/search/tree_walk.hpp"
#include "stickslip/resistance/region_proof.hpp"

namespace stickslip::resistance_detail {

/// One search after another, with a common limit.
class CellRefuter {
 public:
  /// All must outlive this.
  CellRefuter(const Problem& problem, const WrenchPlane& plane,
              const RegionProofOptions& options, RegionProofWork& work);

  /// Appends a tree about a cell none of whose loads is resisted. False at the limit, and then
  /// `tree` has some nodes more.
  bool refute(const LoadCell& cell, std::vector<RegionNode>& tree);

 private:
  using Step = equilibrium_detail::Branch<RegionNode, Region>;
  struct Loads;
  class View;

  std::optional<Step> examine(const Region& region, const Loads& loads);
  Step split_at(const Region& region, const ContactSplit& at) const;

  const Problem& problem_;
  const WrenchPlane& plane_;
  const RegionProofOptions& options_;
  RegionProofWork& work_;
  double length_ = 1;  ///< by which torques are divided
};

}  // namespace stickslip::resistance_detail
