// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Trees that refute all loads of a cell at once (region_proof.hpp).
#pragma once

#include <vector>

#include "load_cell.hpp"
#include "stickslip/engine/law.hpp"
#include "stickslip/engine/motion_region.hpp"
#include "stickslip/measures/region_proof.hpp"

namespace stickslip::resistance_detail {

/// Makes one refutation after another, under a common limit.
class CellRefuter {
 public:
  /// The arguments must outlive this.
  CellRefuter(const Problem& problem, const WrenchPlane& plane,
              const RegionProofOptions& options, RegionProofWork& work);

  /// Appends a tree about a cell none of whose loads is resisted. At the limit appends nothing
  /// and returns false.
  bool refute(const LoadCell& cell, std::vector<RegionNode>& tree);

 private:
  TreeNode decide(const MotionRegion& region);

  const WrenchPlane& plane_;
  const RegionProofOptions& options_;
  RegionProofWork& work_;
  Law law_;  ///< the law; its loads are those of one cell after another
  MotionRegion root_;
};

}  // namespace stickslip::resistance_detail
