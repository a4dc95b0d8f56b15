// SPDX-License-Identifier: GPL-3.0-or-later
// Segments of margins proved by degree: against those proved by equilibria, and against
// verdicts. Made wrong they are in tests/rules.
#include <gtest/gtest.h>

#include <iostream>

#include "both_checkers.hpp"
#include "family.hpp"
#include "grasps.hpp"
#include "judged.hpp"
#include "loads.hpp"
#include "rounds.hpp"
#include "stickslip/measures/margin.hpp"

namespace stickslip {
namespace {

using bench::Layout;
using test::RandomSource;
using test::rounds;

Margin margin_of(const Question& question, SegmentForm form, MarginWork* work = nullptr) {
  return std::get<Margin>(find_margin(problem_of(question), {}, work, {}, form));
}

std::size_t count_proofs(const Margin& margin) {
  return static_cast<std::size_t>(
      std::count_if(margin.segments.begin(), margin.segments.end(),
                    [](const MarginSegment& segment) { return segment.proof.has_value(); }));
}

bool same(const std::vector<MarginInterval>& a, const std::vector<MarginInterval>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.low == y.low && x.high == y.high;
  });
}

Question pulled(Layout layout, std::size_t contacts, std::uint64_t seed, NormalLaw law,
                bool preloaded = true) {
  Question question =
      bench::plain_question(bench::make_grasp(layout, contacts, preloaded, seed), {}, law);
  question.direction = row_of(bench::pulling_load(layout, seed));
  return question;
}

/// The same intervals in both forms, and verdicts inside what is proved by degree.
void expect_both_forms(const Question& question, std::size_t& proofs, std::size_t& endless) {
  const Margin by_points = margin_of(question, SegmentForm::kEquilibria);
  const Margin by_degree = margin_of(question, SegmentForm::kDegree);
  EXPECT_EQ(count_proofs(by_points), 0U);
  EXPECT_TRUE(same(by_points.resisted, by_degree.resisted));
  test::expect_accepted_by_both(question, by_degree);
  for (const MarginSegment& segment : by_degree.segments) {
    if (!segment.proof) continue;
    ++proofs;
    if (!segment.high) ++endless;
    const Rational high = segment.high.value_or(3 * segment.low + 7);
    for (const Rational& share : {Rational(0), Rational(2, 7), Rational(1)}) {
      const Rational multiple = segment.low + share * (high - segment.low);
      EXPECT_EQ(test::judged_verdict({test::member(question, multiple), question.law}),
                "stable")
          << "at " << to_string(multiple);
    }
  }
}

TEST(MarginByDegree, AgreesWithEquilibria) {
  RandomSource random(811);
  std::size_t proofs = 0;
  std::size_t endless = 0;
  std::size_t margins = 0;
  for (const Layout layout :
       {Layout::kRound, Layout::kVaried, Layout::kArc, Layout::kEdges, Layout::kJaws}) {
    for (int round = 0; round < rounds(4); ++round) {
      const auto contacts = static_cast<std::size_t>(random.between(4, 12));
      const auto seed = static_cast<std::uint64_t>(random.between(1, 1000));
      const NormalLaw law = round % 2 == 0 ? NormalLaw::kUnilateral : NormalLaw::kBilateral;
      SCOPED_TRACE(std::string(name_of(layout)) + " " + std::to_string(contacts) + " " +
                   std::to_string(seed) + " " + std::to_string(round));
      expect_both_forms(pulled(layout, contacts, seed, law), proofs, endless);
      ++margins;
    }
  }
  std::cout << margins << " margins, " << proofs << " segments by degree, " << endless
            << " of them without end\n";
  EXPECT_GE(proofs, margins);
  EXPECT_GE(endless, rounds(2U));
}

TEST(MarginByDegree, AgreesAlongPreloads) {
  RandomSource random(812);
  std::size_t proofs = 0;
  std::size_t endless = 0;
  for (int round = 0; round < rounds(8); ++round) {
    const auto contacts = static_cast<std::size_t>(random.between(4, 10));
    const NormalLaw law = round % 2 == 0 ? NormalLaw::kUnilateral : NormalLaw::kBilateral;
    const LoadedGrasp loaded{
        bench::make_grasp(Layout::kRound, contacts, true,
                          static_cast<std::uint64_t>(random.between(1, 1000))),
        {Rational(1, 2), Rational(-1, 3), Rational(1, 5)}};
    expect_both_forms(
        test::margin_question(loaded, law, std::nullopt, PreloadDirection{true, {}}), proofs,
        endless);
  }
  EXPECT_GE(proofs, rounds(8U));
}

// Without preload and load all multiples have one verdict, and one proof.
TEST(MarginByDegree, OneProofWhereNothingIsButWhatGrows) {
  const Question question = pulled(Layout::kRound, 12, 3, NormalLaw::kUnilateral, false);
  const Margin margin = margin_of(question, SegmentForm::kDegree);
  ASSERT_EQ(margin.segments.size(), 1U);
  EXPECT_TRUE(margin.segments.front().proof.has_value());
  EXPECT_EQ(margin.segments.front().low, 0);
  EXPECT_FALSE(margin.segments.front().high.has_value());
  test::expect_accepted_by_both(question, margin);
}

TEST(MarginByDegree, OnlyWhereEquilibriaAreLong) {
  MarginWork work;
  const Question round = pulled(Layout::kRound, 60, 1, NormalLaw::kUnilateral);
  const Margin by_points = margin_of(round, SegmentForm::kByLength, &work);
  EXPECT_EQ(work.proofs, 0U);
  EXPECT_EQ(count_proofs(by_points), 0U);
  const Question varied = pulled(Layout::kVaried, 60, 1, NormalLaw::kUnilateral);
  const Margin by_degree = margin_of(varied, SegmentForm::kByLength, &work);
  EXPECT_EQ(count_proofs(by_degree), by_degree.segments.size());
  EXPECT_EQ(work.modes, 0U);  // no equilibrium was computed
  EXPECT_LT(by_degree.segments.size(), 10U);
  const test::CheckerInput input = test::input_of(varied, by_degree);
  EXPECT_LT(input.certificate.size(), 40000U);
  test::expect_accepted_by_both(varied, by_degree);
}

}  // namespace
}  // namespace stickslip
