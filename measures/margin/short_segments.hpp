// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The segments of a margin in few words.
#pragma once

#include <vector>

#include "stickslip/measures/margin.hpp"

namespace stickslip::margin_detail {

/// The same motions, with few shares of friction (few_shares.hpp) at both ends of each segment,
/// and where one ends as the next begins the same, so that it need be checked once only.
void shorten(std::vector<MarginSegment>& segments, const Problem& family);

}  // namespace stickslip::margin_detail
