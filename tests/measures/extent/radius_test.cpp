// SPDX-License-Identifier: GPL-3.0-or-later
// Radii: what is proved ends before what is refuted, and both are so.
#include "stickslip/measures/radius.hpp"

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
    const GraspBox centre = box_of(parse_grasp(about.grasp, "grasp").loaded());
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
    if (!needs_enclosure(centre)) {
      EXPECT_EQ(test::verdict_of(loaded_of(centre), law), verdict);
    }
    if (radius.proof) {
      EXPECT_STREQ(name_of(radius.proof->verdict), verdict);
      test::expect_accepted_by_both(test::input_of(
          test::file_of(box.scaled(centre, radius.proved)), of_law(law), *radius.proof));
    }
    ASSERT_EQ(radius.refuted.has_value(), radius.example.has_value());
    if (!radius.refuted) continue;
    EXPECT_TRUE(test::lies_in(loaded_of(*radius.example), box.scaled(centre, *radius.refuted)));
    EXPECT_EQ(test::verdict_of(loaded_of(*radius.example), law),
              *radius.stable ? "unstable" : "stable")
        << describe(about);
    both += radius.proof ? 1 : 0;
    std::cout << verdict << ": proved " << to_double(radius.proved) << ", refuted "
              << to_double(*radius.refuted) << "\n";
  }
  EXPECT_GE(both, 2u);
}

// What numbers of thousands of digits near others of few say is what the short ones said, and
// is found by a few proofs about long numbers, each of which is reported.
TEST(Radius, LongNumbersAreConfirmedWhereShortOnesSearched) {
  const Rational little = Rational(1) / parse_rational("1" + std::string(3000, '0') + "7");
  const auto grasp_with = [](const Rational& friction, const Rational& pull) {
    return box_of(LoadedGrasp{Grasp({{{1, 0}, {-1, 0}, friction, 1, 1},
                                     {{-1, 0}, {1, 0}, friction, 2, 1},
                                     {{0, -1}, {0, 1}, friction, 1, 1}}),
                              {Rational(1, 8), pull, 0}});
  };
  const auto search = [](const GraspBox& centre, std::size_t& reports) {
    const GraspBox box = centre.widened(parse_tolerances("friction=10%,wrench=10%"));
    const auto count = [&](const Radius&) { ++reports; };
    return std::pair(box, find_radius(centre, box, NormalLaw::kUnilateral, {}, count));
  };
  std::size_t short_reports = 0;
  std::size_t long_reports = 0;
  const auto brief = search(grasp_with(Rational(1, 2), 1), short_reports).second;
  const GraspBox centre = grasp_with(Rational(1, 2) + little, 1 - little);
  const auto& [box, radius] = search(centre, long_reports);
  EXPECT_EQ(radius.stable, brief.stable);
  ASSERT_TRUE(radius.proof && radius.refuted && brief.refuted);
  const double near = 1e-3;
  EXPECT_NEAR(to_double(radius.proved), to_double(brief.proved), near);
  EXPECT_NEAR(to_double(*radius.refuted), to_double(*brief.refuted), near);
  EXPECT_LT(radius.proved, *radius.refuted);
  EXPECT_GT(short_reports, 4U);
  EXPECT_LE(long_reports, 2U);
  const GraspBox proved = box.scaled(centre, radius.proved);
  test::expect_accepted_by_both(test::input_of(test::file_of(proved), {}, *radius.proof));
  EXPECT_TRUE(test::lies_in(loaded_of(*radius.example), box.scaled(centre, *radius.refuted)));
  EXPECT_EQ(test::verdict_of(loaded_of(*radius.example), NormalLaw::kUnilateral),
            *radius.stable ? "unstable" : "stable");
}

}  // namespace
}  // namespace stickslip
