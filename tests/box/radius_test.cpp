// SPDX-License-Identifier: GPL-3.0-or-later
// Radii: what is proved ends before what is refuted, and both are so.
#include "stickslip/box/radius.hpp"

#include <gtest/gtest.h>

#include <iostream>

#include "box_cases.hpp"

namespace stickslip {
namespace {

using test::RandomSource;
using test::Uncertain;

QuestionOptions of_law(NormalLaw law) {
  QuestionOptions options;
  options.law = law;
  return options;
}

TEST(Radius, ProvedIsBelowRefuted) {
  RandomSource random(11);
  RadiusOptions options;
  options.accuracy = Rational(1, 10);
  std::size_t both = 0;
  for (int round = 0; round < 8; ++round) {
    const Uncertain uncertain = random.pick<Uncertain>(
        {Uncertain::kFriction, Uncertain::kFriction, Uncertain::kWrench});
    const test::BoxCase about = test::random_box(random, uncertain);
    const LoadedGrasp centre = parse_grasp(about.grasp, "grasp").content;
    const GraspBox box = about.box();
    const NormalLaw law = about.options.law;
    const auto expect_in_order = [&](const Radius& radius) {
      if (radius.refuted) {
        EXPECT_LT(radius.proved, *radius.refuted) << describe(about);
      }
    };
    const Radius radius = find_radius(centre, box, law, options, expect_in_order);
    expect_in_order(radius);
    if (!radius.stable) continue;
    const char* verdict = *radius.stable ? "stable" : "unstable";
    if (!needs_enclosure(box_of(centre))) {
      EXPECT_EQ(test::verdict_of(centre, law), verdict);
    }
    if (radius.proof) {
      EXPECT_STREQ(name_of(radius.proof->verdict), verdict);
      test::expect_accepted_by_both(test::input_of(
          test::file_of(box.scaled(centre, radius.proved)), of_law(law), *radius.proof));
    }
    ASSERT_EQ(radius.refuted.has_value(), radius.example.has_value());
    if (!radius.refuted) continue;
    EXPECT_TRUE(test::lies_in(*radius.example, box.scaled(centre, *radius.refuted)));
    EXPECT_EQ(test::verdict_of(*radius.example, law), *radius.stable ? "unstable" : "stable")
        << describe(about);
    both += radius.proof ? 1 : 0;
    std::cout << verdict << ": proved " << to_double(radius.proved) << ", refuted "
              << to_double(*radius.refuted) << "\n";
  }
  EXPECT_GE(both, 2u);
}

}  // namespace
}  // namespace stickslip
