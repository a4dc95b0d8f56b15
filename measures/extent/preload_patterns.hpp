// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What preloads a search may choose: sums of patterns, each of sum 1, with weights of 0 or
/// more.
#pragma once

#include <vector>

#include "stickslip/core/box.hpp"

namespace stickslip::extent_detail {

class PreloadPatterns {
 public:
  /// One for each contact alone; or, `balanced`, the extreme ones of those that friction can
  /// balance without a load and a motion. Of one grasp; throws InputError where that is not
  /// known: unless it is one body in the plane, with few contacts and rational lengths.
  PreloadPatterns(const GraspBox& grasp, bool balanced);

  /// Whether there is one for each contact, so that weights are preloads.
  bool are_contacts() const { return are_contacts_; }
  std::size_t size() const { return patterns_.size(); }
  /// The preloads with these weights, of the same sum.
  RationalRow preloads(const RationalRow& weights) const;

 private:
  bool are_contacts_;
  std::size_t contacts_;
  std::vector<RationalRow> patterns_;
};

}  // namespace stickslip::extent_detail
