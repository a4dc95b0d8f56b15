// SPDX-License-Identifier: MIT
/// \file
/// The rules of a leaf whose twist moves (FORMAT.md §4). Each B(r, r') is enclosed first in
/// doubles, which prove most leaves, and found exactly where they do not.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "region.hpp"

namespace stickslip_check {

/// The numbers that a moving leaf lists for a contact.
struct OwnSlip {
  Integer contact;
  Rational kappa;
  Vector psi;  ///< as many numbers as its slip has
};

/// y(x) = c d + h y.
struct MovingTwist {
  Vector y;
  Rational c;
  std::vector<OwnSlip> slips;
};

/// `moving-list`: why it does not hold, or nothing.
std::optional<std::string> list_refusal(const Box& box, const MovingTwist& twist);

/// `leaf-bound`: why it does not hold, or nothing. The list must be right. Doubles are asked
/// first, and `*exact` says whether they left it open.
std::optional<std::string> leaf_refusal(const Box& box, const Generators& region,
                                        const MovingTwist& twist, bool* exact);

/// `leaf-direction` of list 2, where A e is these functions of points: as above.
std::optional<std::string> direction_refusal(const Generators& region, const MovingTwist& twist,
                                             const std::vector<Vector>& direction);

}  // namespace stickslip_check
