// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Boxes of preloads, and proofs about one grasp with these preloads.
#pragma once

#include <utility>
#include <vector>

#include "stickslip/measures/preload.hpp"

namespace stickslip::extent_detail {

/// One interval for each contact.
using PreloadBox = std::vector<Interval>;

/// Returns the preloads of a grasp by contact; of uncertain ones the least.
RationalRow preloads_of(const GraspBox& grasp);
/// \{ Return the grasp with these preloads.
GraspBox with_preloads(GraspBox grasp, const RationalRow& preloads);
GraspBox with_preloads(GraspBox grasp, const PreloadBox& preloads);
/// \}

/// \{ Return the corner of the least preloads, or that of the most.
RationalRow low_corner(const PreloadBox& box);
RationalRow high_corner(const PreloadBox& box);
/// \}

/// Returns the box without preloads whose sum is larger than `most` whatever the others are.
/// Requires that some preloads of the box have no larger sum.
PreloadBox below_sum(PreloadBox box, const Rational& most);
/// Cuts the box at the middle of its widest side.
std::pair<PreloadBox, PreloadBox> halves(const PreloadBox& box);

/// Returns the least power of two that is as large as the largest number of a load; 1 if the
/// load is 0.
Rational size_of(const WrenchBox& wrench);

/// Returns true if one grasp seems to resist its load: a proposal. It is a decision if that
/// comes soon (Effort::decides_singles); else Newton's method finds an equilibrium, or misses
/// it, which takes much less time.
bool seems_held(const GraspBox& point, NormalLaw law, const SearchOptions& options);

/// Returns options for one of many proofs, which may take less than one that was asked for
/// alone.
SearchOptions of_many(SearchOptions options, const GraspBox& grasp);

/// Returns true if some load may be refused throughout a box of preloads: a few grasps in the
/// box seem to refuse it.
bool may_refuse(const GraspBox& load, const PreloadBox& box, NormalLaw law,
                const SearchOptions& options);
/// Returns a proof that the load is refused throughout the box, if one is found.
std::optional<ProvedPreloads> refuse(const GraspBox& load, const PreloadBox& box, NormalLaw law,
                                     const SearchOptions& options);

/// Returns which multiples of their preloads hold these loads, as far as is known. Requires
/// that the preloads hold them.
PreloadRange range_of(const std::vector<GraspBox>& held, NormalLaw law,
                      const SearchOptions& options);

}  // namespace stickslip::extent_detail
