// SPDX-License-Identifier: GPL-3.0-or-later
#include "margin_chain.hpp"

#include <algorithm>
#include <utility>

#include "stickslip/core/error.hpp"

namespace stickslip::margin_detail {

ModePoint FamilyModes::Piece::at(const Rational& multiple) const {
  const Rational rise = multiple - low.x[4];
  if (rise.is_zero()) return low;
  if (has_high() && multiple == high.x[4]) return high;
  // A multiple of a ray is added to the low end; a point between two ends is a combination of
  // both.
  const Rational share = has_high() ? rise / (high.x[4] - low.x[4]) : rise;
  ModePoint point = low;
  const auto move = [&](Rational& from, const Rational& to) {
    from += share * (has_high() ? to - from : to);
  };
  for (std::size_t j = 0; j < 5; ++j) move(point.x[j], high.x[j]);
  for (std::size_t k = 0; k < point.friction.size(); ++k) {
    move(point.friction[k].second, high.friction[k].second);
  }
  return point;
}

FamilyModes::Piece FamilyModes::Piece::part(const Rational& from,
                                            const std::optional<Rational>& to) const {
  const ModePoint start = at(std::max(from, low.x[4]));
  if (!to) return {mode, start, high};
  return {mode, start, at(has_high() ? std::min(high.x[4], *to) : *to)};
}

std::optional<FamilyModes::Piece> FamilyModes::piece_of(const FamilyMode& mode) {
  count_();
  std::optional<ModeEnds> ends = lines_.ends(mode);
  if (!ends) return std::nullopt;
  return Piece{mode, std::move(ends->low), std::move(ends->high)};
}

std::optional<FamilyModes::Piece> FamilyModes::next_piece(const FamilyMode& mode,
                                                          const ModePoint& point, bool up) {
  // Candidates for the next mode: all contacts that end the mode here change together, and a
  // few of them alone. If no candidate leads on, the search finds the next mode.
  constexpr std::size_t kMostAlone = 8;
  FamilyMode all = mode;
  std::vector<FamilyMode> candidates;
  const auto change = [&](std::size_t contact, ContactMode state) {
    all[contact] = state;
    if (candidates.size() == kMostAlone) return;
    candidates.push_back(mode);
    candidates.back()[contact] = state;
  };
  signs_.go_to(point.x);
  auto friction = point.friction.begin();
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const bool touches = signs_.of(signs_.separation(i)) == Sign::kZero;
    if (touches && family_.law() == NormalLaw::kUnilateral) {
      change(i, {!mode[i].closed, signs_.of(signs_.slip(i))});
    } else if (sticks(family_, mode, i)) {
      while (friction->first != i) ++friction;
      const Rational& b = friction->second;
      const ContactId contact(i);
      if (abs(b) == family_.row(contact).friction * dot(family_.separation(contact), point.x)) {
        change(i, {true, sign_of_int(-b.sign())});
      }
    } else if (mode[i].closed && !family_.row(ContactId(i)).friction.is_zero() &&
               signs_.of(signs_.slip(i)) == Sign::kZero) {
      change(i, {true, Sign::kZero});
    }
  }
  if (candidates.size() > 1) candidates.insert(candidates.begin(), all);
  for (const FamilyMode& candidate : candidates) {
    std::optional<Piece> piece = piece_of(candidate);
    if (!piece) continue;
    const Rational& multiple = point.x[4];
    const bool begins_below = piece->low.x[4] <= multiple;
    const bool ends_above = !piece->has_high() || piece->high.x[4] >= multiple;
    const bool goes_on =
        up ? !piece->has_high() || piece->high.x[4] > multiple : piece->low.x[4] < multiple;
    if (begins_below && ends_above && goes_on) return piece;
  }
  return std::nullopt;
}

ShortWitness FamilyModes::witness_at(const FamilyMode& mode, const ModePoint& point) {
  ShortWitness witness{{point.x[0], point.x[1], point.x[2]}, {}};
  signs_.go_to(point.x);
  auto friction = point.friction.begin();
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const ContactId contact(i);
    const Rational& mu = family_.row(contact).friction;
    if (!mode[i].closed || mu.is_zero()) continue;
    Rational share = -to_int(mode[i].slip);
    if (mode[i].slip == Sign::kZero) {
      const Rational& b = (friction++)->second;
      if (b.is_zero()) continue;
      share = b / (mu * dot(family_.separation(contact), point.x));
    } else if (signs_.of(signs_.slip(i)) != Sign::kZero ||
               signs_.of(signs_.separation(i)) == Sign::kZero) {
      continue;
    }
    witness.shares.emplace_back(contact, std::move(share));
  }
  return witness;
}

MarginSegment FamilyModes::segment_of(const Piece& piece) {
  std::optional<Rational> high;
  if (piece.has_high()) high = piece.high.x[4];
  return {piece.low.x[4], witness_at(piece.mode, piece.low), std::move(high),
          witness_at(piece.mode, piece.high)};
}

std::vector<MarginSegment> FamilyModes::chain_through(const MarginPoint& point,
                                                      const Rational& low,
                                                      const std::optional<Rational>& high) {
  const std::optional<Piece> middle =
      piece_of(modes_of(family_.at(point.multiple), point.witness.twist));
  require(middle.has_value(), "an equilibrium lies in its own mode");
  std::vector<Piece> downwards{middle->part(low, high)};
  while (downwards.back().low.x[4] > low) {
    const Piece& last = downwards.back();
    const std::optional<Piece> next = next_piece(last.mode, last.low, false);
    if (!next) break;
    downwards.push_back(next->part(low, last.low.x[4]));
  }
  std::vector<Piece> chain(std::make_move_iterator(downwards.rbegin()),
                           std::make_move_iterator(downwards.rend()));
  while (chain.back().has_high() && (!high || chain.back().high.x[4] < *high)) {
    const Piece& last = chain.back();
    const std::optional<Piece> next = next_piece(last.mode, last.high, true);
    if (!next) break;
    chain.push_back(next->part(last.high.x[4], high));
  }
  std::vector<MarginSegment> segments;
  for (const Piece& piece : chain) segments.push_back(segment_of(piece));
  return segments;
}

}  // namespace stickslip::margin_detail
