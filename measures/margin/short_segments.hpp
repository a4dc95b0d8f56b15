// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Shorter statements of the segments of a margin.
#pragma once

#include <vector>

#include "stickslip/measures/margin.hpp"

namespace stickslip::margin_detail {

/// Keeps the motions and chooses few shares of friction (few_shares.hpp) at both ends of each
/// segment. Where one segment ends as the next begins, both get the same shares, so that they
/// need be checked only once.
void shorten(std::vector<MarginSegment>& segments, const Problem& family);

}  // namespace stickslip::margin_detail
