// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Modes next to each other, along the multiples of a family.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "mode_ends.hpp"
#include "stickslip/measures/margin.hpp"

namespace stickslip::margin_detail {

class FamilyModes {
 public:
  /// A family for all l >= 0. `count` is called before each mode's ends are looked for.
  FamilyModes(Problem family, std::function<void()> count)
      : family_(std::move(family)),
        count_(std::move(count)),
        lines_(family_),
        signs_(family_) {}
  FamilyModes(const FamilyModes&) = delete;
  FamilyModes& operator=(const FamilyModes&) = delete;

  /// Returns segments, each beginning where the one before ends, that contain the point. They
  /// go down to `low` and up to `high` as far as neighbouring modes reach.
  std::vector<MarginSegment> chain_through(const MarginPoint& point, const Rational& low,
                                           const std::optional<Rational>& high);

 private:
  /// A mode, and a part of the multiples that it resists.
  struct Piece {
    FamilyMode mode;
    ModePoint low, high;

    bool has_high() const { return !high.x[3].is_zero(); }
    /// Returns the equilibrium of this multiple, which must be in the piece.
    ModePoint at(const Rational& multiple) const;
    Piece part(const Rational& from, const std::optional<Rational>& to) const;
  };

  /// Returns all that the mode resists.
  std::optional<Piece> piece_of(const FamilyMode& mode);
  /// Returns the piece of a neighbouring mode at the point that goes further, up or down.
  std::optional<Piece> next_piece(const FamilyMode& mode, const ModePoint& point, bool up);
  ShortWitness witness_at(const FamilyMode& mode, const ModePoint& point);
  MarginSegment segment_of(const Piece& piece);

  Problem family_;
  std::function<void()> count_;
  ModeLines lines_;
  PointSigns signs_;
};

}  // namespace stickslip::margin_detail
