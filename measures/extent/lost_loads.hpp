// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A proposal by doubles: which loads of a ball are too much. Each such load is decided before
/// it counts.
#pragma once

#include <optional>
#include <vector>

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
  /// Returns nothing if doubles find no equilibrium of the centre. `box` is the centre with the
  /// ball; its multiples up to `limit` are of interest. Both must outlive this.
  static std::optional<LostLoads> of(const GraspBox& centre, const GraspBox& box, NormalLaw law,
                                     const Rational& accuracy, const Rational& limit);

  /// Returns true if doubles find no equilibrium at this load, nor a little beyond it (Newton's
  /// method misses one at times).
  bool contains(const Suspect& load) const;
  /// Returns true if a search from many motions, which takes long, finds none at this load.
  bool has_none(const Suspect& load) const;
  /// Makes all that follows search so long: the load may be held far from where others are.
  void look_longer() { looks_longer_ = true; }
  bool looks_longer() const { return looks_longer_; }  ///< whether that was called
  /// Returns where on this way from the centre the equilibrium is lost first, up to a factor of
  /// two; nothing if it is not lost below the limit.
  std::optional<Suspect> first_along(const box_detail::Place& place) const;
  /// Returns some of a few loads at random on the border of the ball with this factor: those at
  /// which doubles find no equilibrium.
  std::vector<Suspect> at_random(const Rational& factor) const;
  /// Moves the load along its way to where the equilibrium is first lost, within an eighth of
  /// the accuracy.
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
  bool looks_longer_ = false;
  mutable NearEquilibrium last_;  ///< the last one found, where the search for the next begins
};

}  // namespace stickslip::extent_detail
