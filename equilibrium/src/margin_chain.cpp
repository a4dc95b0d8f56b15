// SPDX-License-Identifier: GPL-3.0-or-later
#include "margin_chain.hpp"

#include <algorithm>
#include <utility>

#include "stickslip/core/error.hpp"

namespace stickslip::equilibrium_detail {
namespace {

/// first + factor * second
Witness sum(const Witness& first, const Rational& factor, const Witness& second) {
  Witness result = first;
  result.twist.x += factor * second.twist.x;
  result.twist.y += factor * second.twist.y;
  result.twist.r += factor * second.twist.r;
  for (std::size_t i = 0; i < result.forces.size(); ++i) {
    result.forces[i].normal += factor * second.forces[i].normal;
    result.forces[i].tangential += factor * second.forces[i].tangential;
  }
  return result;
}

}  // namespace

Witness FamilyModes::Piece::at(const Rational& multiple) const {
  const Rational rise = multiple - lowest.multiple;
  if (rise.is_zero()) return lowest.witness;
  if (!high) return sum(lowest.witness, rise, end);
  const Rational share = rise / (*high - lowest.multiple);
  return sum(sum(lowest.witness, -share, lowest.witness), share, end);
}

MarginSegment FamilyModes::Piece::part(const Rational& from,
                                       const std::optional<Rational>& to) const {
  const Rational start = std::max(from, lowest.multiple);
  if (!high && !to) return {{start, at(start)}, std::nullopt, end};
  const Rational stop = !high ? *to : !to ? *high : std::min(*high, *to);
  return {{start, at(start)}, stop, at(stop)};
}

std::optional<FamilyModes::Piece> FamilyModes::piece_of(const FamilyMode& mode) {
  Region region = Region::root(family_);
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const ContactId contact(i);
    if (family_.law() == NormalLaw::kUnilateral) {
      region = std::move(region).separation_child(
          family_, contact, mode[i].closed ? Separation::kClosed : Separation::kOpen);
    }
    if (mode[i].closed && !family_.row(contact).friction.is_zero()) {
      region = std::move(region).slip_child(family_, contact, mode[i].slip);
    }
  }
  count_();
  std::optional<MultipleExtent> extent = multiple_extent(family_, region);
  if (!extent) return std::nullopt;
  require(!extent->lowest.broken && !extent->highest.broken, "a mode has nothing to split");
  std::optional<Rational> high;
  if (!extent->highest.is_ray) high = extent->highest.multiple;
  return Piece{mode,
               {extent->lowest.multiple, std::move(extent->lowest.witness)},
               std::move(high),
               std::move(extent->highest.witness)};
}

std::optional<FamilyModes::Piece> FamilyModes::next_piece(const FamilyMode& mode,
                                                          const MarginPoint& point, bool up) {
  // What ends the mode here: all changes together, and a few by themselves. Where none of these
  // leads on, the search finds what does.
  constexpr std::size_t kMostAlone = 8;
  const Problem problem = family_.at(point.multiple);
  FamilyMode all = mode;
  std::vector<FamilyMode> candidates;
  const auto change = [&](std::size_t contact, ContactMode state) {
    all[contact] = state;
    if (candidates.size() == kMostAlone) return;
    candidates.push_back(mode);
    candidates.back()[contact] = state;
  };
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    const ContactForce& force = point.witness.forces[i];
    const Sign slip = mode_of(problem, ContactId(i), point.witness.twist).slip;
    const bool touches = row.normal_coefficient(point.witness.twist).is_zero();
    if (touches && family_.law() == NormalLaw::kUnilateral) {
      change(i, {!mode[i].closed, slip});
    } else if (mode[i].closed && !row.friction.is_zero()) {
      const Rational limit = row.friction * force.normal;
      if (mode[i].slip != Sign::kZero && slip == Sign::kZero) {
        change(i, {true, Sign::kZero});
      } else if (mode[i].slip == Sign::kZero && abs(force.tangential) == limit) {
        change(i, {true, sign_of_int(-force.tangential.sign())});
      }
    }
  }
  if (candidates.size() > 1) candidates.insert(candidates.begin(), all);
  for (const FamilyMode& candidate : candidates) {
    std::optional<Piece> piece = piece_of(candidate);
    if (!piece) continue;
    const bool begins_below = piece->lowest.multiple <= point.multiple;
    const bool ends_above = !piece->high || *piece->high >= point.multiple;
    const bool goes_on = up ? !piece->high || *piece->high > point.multiple
                            : piece->lowest.multiple < point.multiple;
    if (begins_below && ends_above && goes_on) return piece;
  }
  return std::nullopt;
}

std::vector<MarginSegment> FamilyModes::chain_through(const MarginPoint& point,
                                                      const Rational& low,
                                                      const std::optional<Rational>& high) {
  std::optional<Piece> piece =
      piece_of(modes_of(family_.at(point.multiple), point.witness.twist));
  require(piece.has_value(), "an equilibrium lies in its own mode");
  std::vector<MarginSegment> chain{piece->part(low, high)};
  const FamilyMode middle = piece->mode;
  while (chain.back().high && (!high || *chain.back().high < *high)) {
    const MarginPoint top{*chain.back().high, chain.back().end};
    piece = next_piece(piece->mode, top, true);
    if (!piece) break;
    chain.push_back(piece->part(top.multiple, high));
  }
  FamilyMode mode = middle;
  while (chain.front().start.multiple > low) {
    const MarginPoint bottom = chain.front().start;
    piece = next_piece(mode, bottom, false);
    if (!piece) break;
    mode = piece->mode;
    chain.insert(chain.begin(), piece->part(low, bottom.multiple));
  }
  return chain;
}

}  // namespace stickslip::equilibrium_detail
