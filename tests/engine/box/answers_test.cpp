// SPDX-License-Identifier: GPL-3.0-or-later
// Answers about boxes: both checkers accept their certificates, single grasps of the box do not
// contradict them, and a box of one grasp has the verdict of that grasp.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

#include "box_cases.hpp"
#include "cases.hpp"
#include "rounds.hpp"
#include "stickslip/engine/decide_problem.hpp"

namespace stickslip {
namespace {

using test::BoxCase;
using test::RandomSource;
using test::Uncertain;

class Tally {
 public:
  void count(const BoxDecision& decision) { ++counts_[name_of(decision.verdict)]; }
  std::size_t of(const std::string& verdict) { return counts_[verdict]; }
  void print(const std::string& title) {
    std::cout << title << ":";
    for (const auto& [verdict, count] : counts_) std::cout << " " << count << " " << verdict;
    std::cout << ", " << samples << " grasps inside\n";
  }

  std::size_t samples = 0;

 private:
  std::map<std::string, std::size_t> counts_;
};

/// What the answer says of the whole box holds for grasps in it, and is proved.
void expect_right(RandomSource& random, const BoxCase& about, const BoxDecision& decision,
                  int samples, Tally& tally) {
  const GraspBox box = about.box();
  const NormalLaw law = about.options.law;
  if (const auto* fragile = std::get_if<Fragile>(&decision.verdict)) {
    for (const auto& [grasp, verdict] :
         {std::pair(&fragile->stable, "stable"), std::pair(&fragile->unstable, "unstable")}) {
      const LoadedGrasp one = loaded_of(*grasp);
      EXPECT_TRUE(grasp->is_point() && test::lies_in(one, box))
          << describe(about) << write_grasp(one);
      EXPECT_EQ(test::verdict_of(one, law), verdict) << describe(about);
    }
    return;
  }
  if (std::holds_alternative<Undecided>(decision.verdict)) return;
  test::expect_accepted_by_both(test::input_of(about.grasp, about.options, decision));
  for (int i = 0; i < samples; ++i) {
    const LoadedGrasp grasp = test::sample(random, box);
    ASSERT_TRUE(test::lies_in(grasp, box)) << describe(about) << write_grasp(grasp);
    if (needs_enclosure(box_of(grasp))) continue;
    ++tally.samples;
    EXPECT_EQ(test::verdict_of(grasp, law), name_of(decision.verdict))
        << describe(about) << write_grasp(grasp);
  }
}

void expect_right(Uncertain uncertain, std::uint64_t seed, int boxes, const char* title,
                  int samples = 12) {
  RandomSource random(seed);
  Tally tally;
  for (int round = 0; round < boxes && !::testing::Test::HasFatalFailure(); ++round) {
    const BoxCase about = test::random_box(random, uncertain);
    const BoxDecision decision = about.decide();
    tally.count(decision);
    expect_right(random, about, decision, samples, tally);
  }
  tally.print(title);
  EXPECT_GE(tally.of("stable"), 1u);
  EXPECT_GE(tally.of("unstable"), 1u);
}

/// The text of a grasp file of the corpus.
std::string box_named(const std::string& name) {
  std::ifstream file(STICKSLIP_CORPUS "/boxes/" + name + ".json");
  return {std::istreambuf_iterator<char>(file), {}};
}

// Proofs by degree have walls of the grasp in the middle, of whose contacts nothing is
// uncertain: nothing may be left of their corners in the box.
TEST(BoxAnswers, OfAWideBoxAreAboutTheGraspInItsMiddle) {
  const BoxCase wide{box_named("wide_middle")};
  const BoxDecision decision = wide.decide();
  EXPECT_STREQ(name_of(decision.verdict), "stable");
  test::expect_accepted_by_both(test::input_of(wide.grasp, wide.options, decision));
}

TEST(RandomBoxes, FrictionAlone) {
  expect_right(Uncertain::kFriction, 1, test::rounds(24), "friction");
}
TEST(RandomBoxes, EveryNumber) {
  expect_right(Uncertain::kAll, 2, test::rounds(24), "all");
}
TEST(RandomBoxes, WrenchAlone) {
  expect_right(Uncertain::kWrench, 3, test::rounds(24), "wrench");
}
TEST(RandomBoxes, IntervalsInTheFile) {
  expect_right(Uncertain::kInFile, 4, 10, "in the file");
}
TEST(RandomBoxes, IrrationalLengths) {
  expect_right(Uncertain::kLengths, 5, 16, "lengths", 0);
}

TEST(RandomBoxes, TwentyThousandGraspsInsideProvedOnes) {
  if (test::kSanitized) GTEST_SKIP() << "nothing new is run";
  constexpr std::size_t kOfEach = 5000;
  RandomSource random(7);
  for (const Uncertain uncertain :
       {Uncertain::kFriction, Uncertain::kAll, Uncertain::kWrench, Uncertain::kInFile}) {
    Tally tally;
    while (tally.samples < kOfEach && !HasFailure()) {
      const BoxCase about = test::random_box(random, uncertain);
      const BoxDecision decision = about.decide();
      tally.count(decision);
      expect_right(random, about, decision, 100, tally);
    }
    tally.print("many");
    EXPECT_GE(tally.of("stable"), 5u);
    EXPECT_GE(tally.of("unstable"), 5u);
  }
}

// One contact leaves motions that no force opposes; a load that is against one of them by 5e-10
// of its size balances as doubles see it.
TEST(IrrationalLengths, WhatNoForceOpposesIsFoundExactly) {
  const Rational one = parse_rational("1.000000001");
  Contact contact{{-1, -1}, {1, parse_rational("1e-9")}};
  contact.friction = 1;
  contact.stiffness = Rational(1, 2);
  contact.preload = one;
  const LoadedGrasp loaded{
      Grasp({contact}), {parse_rational("-1.0000000005"), one, parse_rational("-2.000000001")}};
  ASSERT_TRUE(needs_enclosure(box_of(loaded)));
  EXPECT_STREQ(name_of(decide_box(box_of(loaded), NormalLaw::kUnilateral).verdict), "unstable");
}

// Turned by 45 degrees and grown by sqrt 2, preloads alone hold or do not hold as before; but
// all lengths have become irrational. (Where contacts may open, all of them open is an
// equilibrium.)
TEST(IrrationalLengths, AGraspTurnedHasTheSameVerdict) {
  RandomSource random(6);
  Tally tally;
  for (int round = 0; round < test::rounds(60); ++round) {
    const Grasp grasp =
        test::generic_grasp(random, static_cast<std::size_t>(random.between(3, 5)));
    const NormalLaw law = NormalLaw::kBilateral;
    const auto turned = [](const Vector2& v) { return Vector2{v.x - v.y, v.x + v.y}; };
    std::vector<Contact> contacts = grasp.contacts();
    for (Contact& c : contacts) {
      c.position = turned(c.position);
      c.normal = turned(c.normal);
    }
    const LoadedGrasp other{Grasp(std::move(contacts)), {}};
    if (!needs_enclosure(box_of(other))) continue;
    const BoxDecision decision = decide_box(box_of(other), law);
    tally.count(decision);
    if (std::holds_alternative<Undecided>(decision.verdict)) continue;
    EXPECT_EQ(name_of(decision.verdict), test::verdict_of({grasp, {}}, law))
        << write_grasp(other);
  }
  tally.print("turned by 45 degrees");
  EXPECT_GE(tally.of("stable") + tally.of("unstable"), test::rounds(10u));
}

/// The file's grasp, with its own loads and under both laws: a box of one point.
void expect_as_decided(const std::string& name, const GraspFile& file, Tally& tally) {
  std::vector<QuestionOptions> all;
  for (const NormalLaw law : {NormalLaw::kUnilateral, NormalLaw::kBilateral}) {
    QuestionOptions options;
    options.law = law;
    if (file.cases.empty()) all.push_back(options);
    for (const NamedLoad& load : file.cases) {
      options.case_name = load.name;
      all.push_back(options);
    }
  }
  for (const QuestionOptions& options : all) {
    const Question question = ask(file, options);
    if (question.box() != nullptr) continue;
    const BoxDecision decision = decide_box(box_of(question.loaded()), question.law);
    tally.count(decision);
    if (std::holds_alternative<Undecided>(decision.verdict)) continue;
    EXPECT_STREQ(name_of(decision.verdict), name_of(decide(problem_of(question)).verdict))
        << name << ", " << to_string(question.law);
  }
}

TEST(ABoxOfOneGrasp, HasItsVerdict) {
  Tally tally;
  for (const char* folder : {STICKSLIP_CORPUS "/grasps/good", STICKSLIP_PAPER_GRASPS}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() != ".json") continue;
      expect_as_decided(entry.path().string(),
                        read_grasp_file(entry.path().string(), Intervals::kAllowed), tally);
    }
  }
  for (const test::CommittedCertificate& one : test::committed_certificates()) {
    expect_as_decided(one.name, parse_grasp(one.input.grasp, one.name), tally);
  }
  tally.print("one grasp");
  EXPECT_GE(tally.of("stable"), 20u);
  EXPECT_GE(tally.of("unstable"), 20u);
}

}  // namespace
}  // namespace stickslip
