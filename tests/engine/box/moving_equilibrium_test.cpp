// SPDX-License-Identifier: GPL-3.0-or-later
// Where an equilibrium is lost, on a grasp that says so in closed form.
#include "engine/degree/moving_equilibrium.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "box_cases.hpp"
#include "engine/degree/prove_stable.hpp"
#include "stickslip/engine/grasp_law.hpp"

namespace stickslip {
namespace {

using test::two_pads;

// Two pads press from the left and the right, with 1, and carry a weight of 1/2: nothing moves,
// and each of them has half of the load. They let go where 1/4 (1 + s) is all that there may
// be, 1/2 (1 - s/5) (1 - s/10): at this part s of the way to less friction, less preload and
// more load.
TEST(MovingEquilibrium, ALoadThatMovesNothingIsLostWhereFrictionEnds) {
  const double expected = (0.8 - std::sqrt(0.6)) / 0.04;
  for (const bool in_space : {false, true}) {
    WrenchBox load{{}, {-1, 0}, {}};
    if (in_space) load.resize(6);
    const GraspBox box = two_pads({Rational(9, 10), Rational(11, 10)}, load);
    box.check();
    const GraspLaw law(box, NormalLaw::kUnilateral);
    const RoundedBox rounded(law);
    const std::vector<NearEquilibrium> found =
        Newton(rounded.at(rounded.middle())).solve_from(3);
    ASSERT_FALSE(found.empty());
    const RoundedBox::Place to =
        RoundedBox::Place::Constant(static_cast<Eigen::Index>(rounded.numbers().size()), -1);
    const EquilibriumPath path = MovingEquilibrium(rounded, found.front()).follow(to);
    EXPECT_LE(path.part, expected);
    EXPECT_GE(path.part, expected - 1.0 / 64);
  }
}

// Two pads press with 1, and each carries half of the load by friction of at least 2/5: at rest
// for all frictions up to 4/5. The load is a tenth less at its other end, where friction is
// stated: at either end of the load, or of the multiples of a margin.
TEST(AtRest, IsProvedUpToWhereTheLeastFrictionEnds) {
  constexpr NormalLaw kLaw = NormalLaw::kUnilateral;
  const Rational part(1, 10);
  for (const auto& [load, is_proved] :
       {std::pair{Rational(79, 100), true}, {Rational(81, 100), false}}) {
    const auto pads = [](const Rational& least, const Rational& most) {
      return two_pads(point_interval(1), {{}, {-most, -least}, {}});
    };
    const GraspLaw gentle(pads(load - part, load - part), kLaw);
    const RoundedBox rounded(gentle);
    const std::vector<NearEquilibrium> found =
        Newton(rounded.at(rounded.middle())).solve_from(3);
    ASSERT_FALSE(found.empty());
    const auto margin = [&](const GraspBox& at_0, int growth, const MultipleRange& range) {
      return GraspLaw(at_0, kLaw, kDefaultBits, Growth{{0, growth, 0}, {}}).within(range);
    };
    for (const GraspLaw& law :
         {GraspLaw(pads(load - part, load), kLaw), margin(pads(0, 0), -1, {load - part, load}),
          margin(pads(load, load), 1, {0, part})}) {
      EXPECT_EQ(prove_at_rest(law, found.front()).has_value(), is_proved) << load;
    }
    // Friction answers no torque where the pads may be anywhere.
    for (const Rational& most : {Rational(load - part), Rational(load)}) {
      GraspBox wide = pads(load - part, most);
      for (UncertainContact& c : wide.contacts) c.position[0] = {-9, 9};
      EXPECT_FALSE(prove_at_rest(GraspLaw(wide, kLaw), found.front()));
    }
  }
}

}  // namespace
}  // namespace stickslip
