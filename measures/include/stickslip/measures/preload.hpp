// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The best preloads P_i >= 0 of the contacts of a grasp: those of the least sum that hold
/// given loads, and those of a given sum that resist the largest ball of loads.
///
/// The set of loads that a grasp resists is neither monotone in the preloads nor convex. So a
/// local search finds good preloads, and a branch and bound over boxes of preloads proves how
/// much better others might be. A box is done with when one load is refused throughout it
/// (certificate/FORMAT.md, section 6); such boxes cover all preloads of a smaller sum. If M
/// contacts all serve alike, it takes about (M/a)^(M-1)/(M-1)! boxes to come to a part a of the
/// sum: for many contacts the bound is weak, but still a bound.
#pragma once

#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include "stickslip/engine/question.hpp"
#include "stickslip/measures/quality.hpp"
#include "stickslip/measures/spatial_margin.hpp"

namespace stickslip {

/// Returns the sum of preloads. O(contacts).
Rational sum_of(const RationalRow& preloads);

/// Groups of contacts that press alike, such as those of one jaw: indices of contacts, each in
/// one group at most. Contacts in none are by themselves.
using ContactGroups = std::vector<std::vector<std::size_t>>;

/// Returns the groups of two or more contacts whose normals have one direction.
ContactGroups contacts_of_one_direction(const GraspBox& grasp);

/// How far a search for preloads goes.
struct PreloadOptions {
  SearchOptions box{};  ///< the options of each proof
  /// Seek preloads that friction can balance without a load, as those of a hand that closes
  /// before the load comes. Bounds are about all preloads even so.
  bool balanced = false;
  /// Seek preloads that are equal within each group, or multiples of the grasp's own. Bounds
  /// are about all preloads even so.
  ContactGroups alike{};
  Rational accuracy{1, 20};    ///< stops when found and bound differ by this part
  std::size_t most_boxes = 0;  ///< boxes of preloads that are looked at for the bound; 0: as
                               ///< many as the next two say

  /// Returns the limit for a sum.
  std::size_t most_boxes_of_sum() const { return most_boxes == 0 ? 1000 : most_boxes; }
  /// Returns the limit for a ball.
  std::size_t most_boxes_of_ball() const { return most_boxes == 0 ? 200 : most_boxes; }
};

/// A box of preloads with a load, and the proof of its verdict. One grasp has no proof here: it
/// is decided whenever it is asked about.
struct ProvedPreloads {
  GraspBox box;                        ///< all numbers but the preloads are certain
  std::optional<BoxDecision> proof{};  ///< the proof about the box
};

/// The multiples of preloads that hold one load.
struct PreloadMargin {
  Question question;  ///< the grasp with preloads that grow in proportion
  std::variant<Margin, SpatialMargin> margin;  ///< exact in the plane
};

/// The multiples of preloads that hold all loads, with `margins` or `boxes` as proof.
struct PreloadRange {
  std::vector<MarginInterval> multiples{};  ///< increasing; 1 is in one, if any is known
  std::vector<PreloadMargin> margins{};     ///< one a load
  /// One a load: every choice between the preloads and the last multiple holds it.
  std::vector<ProvedPreloads> boxes{};
};

/// Preloads that hold all loads.
struct LeastPreload {
  std::optional<RationalRow> preloads{};  ///< by contact; nothing: none were found
  std::vector<ProvedPreloads> held{};     ///< one a load
  PreloadRange range{};  ///< the multiples of these preloads that hold the loads
  Rational bound{0};  ///< no preloads whose sum is below this hold all loads; 0: nothing known
  std::vector<ProvedPreloads> refused{};  ///< boxes that cover the preloads of a sum below the
                                          ///< bound, with one refused load each
  std::size_t looked = 0;                 ///< boxes that were looked at for the bound
  Rational limit{0};                      ///< no preloads of a larger sum were sought
};

/// Returns preloads of nearly the least sum that hold all loads. `loads` are one grasp, with a
/// load or a ball of loads each; the search also tries their preloads. Deterministic. Throws
/// InputError as GraspBox::check() does. Calls `progress` with what is known so far.
LeastPreload find_least_preload(const std::vector<GraspBox>& loads, NormalLaw law,
                                const PreloadOptions& options = {},
                                const std::function<void(const LeastPreload&)>& progress = {});

/// Preloads of at most a given sum, and the ball that they resist.
struct BallPreload {
  RationalRow preloads{};  ///< by contact
  Quality quality{};       ///< the quality of the grasp with these preloads
  PreloadRange range{};    ///< the multiples that hold the ball that is proved, if one is
  std::optional<Rational> bound{};        ///< no preloads of such a sum resist a larger ball
  std::vector<ProvedPreloads> refused{};  ///< boxes that cover the preloads of such a sum, with
                                          ///< one refused load each
  std::size_t looked = 0;                 ///< boxes that were looked at for the bound
};

/// Returns preloads that resist nearly the largest ball of this length, point and body about
/// the load of one grasp; the radius of `shape` does not matter. Deterministic. Throws
/// InputError and calls `progress` as find_least_preload() does.
BallPreload find_ball_preload(const GraspBox& grasp, NormalLaw law, const LoadBall& shape,
                              const Rational& budget, const PreloadOptions& options = {},
                              const std::function<void(const BallPreload&)>& progress = {});

}  // namespace stickslip
