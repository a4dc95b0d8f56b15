// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Which loads of a ball are too much, as doubles say. They only propose: a decision of each
/// load disposes.
#pragma once

#include <optional>

#include "engine/box/examples.hpp"
#include "stickslip/engine/box_verdict.hpp"
#include "stickslip/engine/near_equilibrium.hpp"

namespace stickslip::extent_detail {

/// A way from the centre of a ball, and a factor of the ball at which doubles find no
/// equilibrium on it.
struct Suspect {
  box_detail::Place place;
  Rational factor;
};

class LostLoads {
 public:
  /// Nothing if doubles know of no equilibrium of the centre. `box` is the centre with the
  /// ball, of which multiples up to `limit` are of interest. Both must outlive this.
  static std::optional<LostLoads> of(const GraspBox& centre, const GraspBox& box, NormalLaw law,
                                     const Rational& accuracy, const Rational& limit);

  /// Whether doubles find no equilibrium there and a little beyond, as Newton's method misses
  /// one at times.
  bool contains(const Suspect& load) const;
  /// Where on this way from the centre the equilibrium is lost first, up to a factor of two.
  std::optional<Suspect> first_along(const box_detail::Place& place) const;
  /// To where its way begins to be lost, within an eighth of the accuracy.
  void draw_in(Suspect& load) const;

 private:
  LostLoads(const GraspBox& centre, const GraspBox& box, NormalLaw law,
            const Rational& accuracy, const Rational& limit, NearEquilibrium at_centre);

  bool has_equilibrium(const Suspect& load) const;

  const GraspBox& centre_;
  const GraspBox& box_;
  NormalLaw law_;
  Rational accuracy_;
  Rational limit_;
  NearEquilibrium at_centre_;
  mutable NearEquilibrium last_;  ///< that was found, from which the next is sought first
};

}  // namespace stickslip::extent_detail
