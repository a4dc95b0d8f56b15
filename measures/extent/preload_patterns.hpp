// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The preloads that a search may choose: sums of patterns, each of sum 1, with weights of 0 or
/// more.
#pragma once

#include <optional>
#include <vector>

#include "stickslip/measures/preload.hpp"

namespace stickslip::extent_detail {

class PreloadPatterns {
 public:
  /// Makes one pattern for each group, for each contact in none, and for the grasp's own
  /// preloads; or, if `balanced`, the extreme ones among the preloads that are equal within
  /// each group and that friction can balance without a load and a motion. Throws InputError if
  /// these are not known: that takes one body in the plane, few contacts and rational lengths.
  /// Requires one grasp.
  PreloadPatterns(const GraspBox& grasp, bool balanced, const ContactGroups& alike);

  /// Returns true if each contact has its own pattern, so that weights are preloads.
  bool are_contacts() const { return are_contacts_; }
  std::size_t size() const { return patterns_.size(); }
  /// Returns the preloads with these weights; their sum is that of the weights.
  RationalRow preloads(const RationalRow& weights) const;
  /// Returns weights with which these are the preloads; nothing if there are none.
  std::optional<RationalRow> weights(const RationalRow& preloads) const;

 private:
  bool are_contacts_;
  std::size_t contacts_;
  std::vector<RationalRow> patterns_;
};

}  // namespace stickslip::extent_detail
