// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The best preloads P_i >= 0 of the contacts of a grasp: those of the least sum that hold
/// given loads, and those of a given sum that resist the largest ball of loads.
///
/// What is resisted is not monotone in preloads, and not convex: a local search finds good
/// ones, and a branch and bound over boxes of preloads proves how much better others might be.
/// A box is done with when one load is refused throughout it (certificate/FORMAT.md, section
/// 6); those boxes cover all preloads of a smaller sum. In M contacts, if all serve alike, it
/// takes about (M/a)^(M-1)/(M-1)! boxes to come to a part a of the sum: of many contacts the
/// bound is weak, but a bound.
#pragma once

#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include "stickslip/engine/question.hpp"
#include "stickslip/measures/quality.hpp"
#include "stickslip/measures/spatial_margin.hpp"

namespace stickslip {

/// How far a search for preloads goes.
struct PreloadOptions {
  SearchOptions box{};  ///< of each proof
  /// Seek preloads that friction can balance without a load, as those of a hand that closes
  /// before the load comes; bounds are about all preloads even so.
  bool balanced = false;
  Rational accuracy{1, 20};    ///< stops when found and bound differ by this part
  std::size_t most_boxes = 0;  ///< of preloads that are looked at for the bound; 0: 1000 for
                               ///< a sum and 200 for a ball
};

/// A box of preloads with a load, and what proves its verdict; nothing for one grasp, which is
/// decided whenever it is asked about.
struct ProvedPreloads {
  GraspBox box;                        ///< with all numbers but preloads certain
  std::optional<BoxDecision> proof{};  ///< of the box
};

/// Of one load, which multiples of preloads hold it.
struct PreloadMargin {
  Question question;                           ///< with preloads that grow in proportion
  std::variant<Margin, SpatialMargin> margin;  ///< exact in the plane
};

/// Which multiples of preloads hold all loads.
struct PreloadRange {
  std::vector<MarginInterval> multiples{};  ///< increasing; 1 is in one, if any is known
  std::vector<PreloadMargin> margins{};     ///< one a load, which prove it; or
  /// one a load: every choice between the preloads and the last multiple holds it.
  std::vector<ProvedPreloads> boxes{};
};

/// Preloads that hold all loads.
struct LeastPreload {
  std::optional<RationalRow> preloads{};  ///< by contact; nothing: none were found
  std::vector<ProvedPreloads> held{};     ///< one a load
  PreloadRange range{};                   ///< of multiples of them
  Rational bound{0};  ///< no preloads whose sum is below this hold all loads; 0: nothing known
  std::vector<ProvedPreloads> refused{};  ///< which cover these, one load of each
  Rational limit{0};                      ///< no preloads of a larger sum were sought
};

/// The least sum. `loads` are one grasp, with a load or a ball of loads each; their preloads
/// are tried, too. Throws InputError as GraspBox::check() does. Deterministic. `progress` is
/// called with what is known so far.
LeastPreload find_least_preload(const std::vector<GraspBox>& loads, NormalLaw law,
                                const PreloadOptions& options = {},
                                const std::function<void(const LeastPreload&)>& progress = {});

/// Preloads of at most a given sum, and the ball that they resist.
struct BallPreload {
  RationalRow preloads{};                 ///< by contact
  Quality quality{};                      ///< of the grasp with these
  PreloadRange range{};                   ///< of the ball that is proved, if one is
  std::optional<Rational> bound{};        ///< no preloads of such a sum resist a larger ball
  std::vector<ProvedPreloads> refused{};  ///< which cover these, a load of each
};

/// The largest ball of this length, point and body (its radius is of no matter) about the load
/// of one grasp. Deterministic. Throws and calls as find_least_preload().
BallPreload find_ball_preload(const GraspBox& grasp, NormalLaw law, const LoadBall& shape,
                              const Rational& budget, const PreloadOptions& options = {},
                              const std::function<void(const BallPreload&)>& progress = {});

}  // namespace stickslip
