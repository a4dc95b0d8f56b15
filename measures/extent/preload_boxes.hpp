// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Boxes of preloads, and what is known of one grasp with these.
#pragma once

#include <utility>
#include <vector>

#include "stickslip/measures/preload.hpp"

namespace stickslip::extent_detail {

/// An interval a contact.
using PreloadBox = std::vector<Interval>;

/// Those of a grasp, by contact; of a box the least.
RationalRow preloads_of(const GraspBox& grasp);
/// \{ The grasp with these preloads.
GraspBox with_preloads(GraspBox grasp, const RationalRow& preloads);
GraspBox with_preloads(GraspBox grasp, const PreloadBox& preloads);
/// \}

Rational sum_of(const RationalRow& row);
/// The corner of the least preloads, and that of the most.
RationalRow low_corner(const PreloadBox& box);
RationalRow high_corner(const PreloadBox& box);
RationalRow middle_of(const PreloadBox& box);

/// Without what has a larger sum in any case. Requires that some preloads have not.
PreloadBox below_sum(PreloadBox box, const Rational& most);
/// Cut at the middle of its widest side.
std::pair<PreloadBox, PreloadBox> halves(const PreloadBox& box);

/// The least power of two that is as large as the largest number of a load; 1 if it is 0.
Rational size_of(const WrenchBox& wrench);

/// Whether it seems that one grasp resists its load: a proposal. In the plane that is decided;
/// else Newton's method finds an equilibrium, or misses it, which takes much less time.
bool seems_held(const GraspBox& point, NormalLaw law, const SearchOptions& options);

/// What one of many proofs may take: less than one that was asked for alone.
SearchOptions of_many(SearchOptions options, const GraspBox& grasp);

/// Whether a load may be refused throughout a box of preloads: it seems to be by a few grasps
/// in it.
bool may_refuse(const GraspBox& load, const PreloadBox& box, NormalLaw law,
                const SearchOptions& options);
/// A proof of it, if one is found.
std::optional<ProvedPreloads> refuse(const GraspBox& load, const PreloadBox& box, NormalLaw law,
                                     const SearchOptions& options);

/// What is known of multiples of the preloads of these loads, which hold them.
PreloadRange range_of(const std::vector<GraspBox>& held, NormalLaw law,
                      const SearchOptions& options);

}  // namespace stickslip::extent_detail
