// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Modes and the multiples of a family that they resist.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "stickslip/equilibrium/contact_mode.hpp"
#include "stickslip/equilibrium/margin.hpp"
#include "stickslip/equilibrium/search/region_program.hpp"

namespace stickslip::equilibrium_detail {

/// A mode as a set of motions: closed means v >= 0 on all of it, and where there is friction
/// slip has the sign throughout.
using FamilyMode = std::vector<ContactMode>;

class FamilyModes {
 public:
  /// A family for all l >= 0. `count` is called before each linear program.
  FamilyModes(Problem family, std::function<void()> count)
      : family_(std::move(family)), count_(std::move(count)) {}

  /// Segments, each beginning where the one before ends, that contain the point and go as far
  /// down to `low` and up to `high` as the modes next to each other reach.
  std::vector<MarginSegment> chain_through(const MarginPoint& point, const Rational& low,
                                           const std::optional<Rational>& high);

 private:
  /// All that one mode resists, and the mode.
  struct Piece {
    FamilyMode mode;
    MarginPoint lowest;
    std::optional<Rational> high;
    Witness end;

    Witness at(const Rational& multiple) const;
    MarginSegment part(const Rational& low, const std::optional<Rational>& high) const;
  };

  std::optional<Piece> piece_of(const FamilyMode& mode);
  /// A mode next to this one at the point that goes further, up or down.
  std::optional<Piece> next_piece(const FamilyMode& mode, const MarginPoint& point, bool up);

  Problem family_;
  std::function<void()> count_;
};

}  // namespace stickslip::equilibrium_detail
