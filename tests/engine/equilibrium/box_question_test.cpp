// SPDX-License-Identifier: GPL-3.0-or-later
// These tests say which questions are boxes, where the command does not show it
// (tests/interfaces/cli/test_box.py).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "error_of.hpp"
#include "stickslip/engine/question.hpp"

namespace stickslip {
namespace {

using ::testing::HasSubstr;

GraspFile certain() {
  return {
      LoadedGrasp{Grasp({{{-1, 0}, {1, 0}, Rational(1, 2), 1, 2}, {{1, 0}, {-3, 4}, 1, 1, 0}}),
                  {0, -4, 0}}};
}

/// The same, with the friction of contact 0 in [1/4, 3/4].
GraspFile uncertain() {
  GraspBox box = certain().content.as_box();
  box.contacts[0].friction = {Rational(1, 4), Rational(3, 4)};
  return {box};
}

QuestionOptions widened_by(const char* tolerances) {
  QuestionOptions options;
  options.uncertain = parse_tolerances(tolerances);
  return options;
}

TEST(BoxQuestion, WhatIsReplacedMayLeaveOneGrasp) {
  GraspBox box = certain().content.as_box();
  box.contacts[0].preload = {1, 3};
  box.wrench[1] = {-5, -3};
  const GraspFile file{box};
  EXPECT_NE(ask(file, {}).box(), nullptr);
  QuestionOptions options;
  options.preload = 1;
  EXPECT_NE(ask(file, options).box(), nullptr);
  EXPECT_EQ(ask(file, options).box()->wrench,
            (WrenchBox{Interval{}, Interval{-5, -3}, Interval{}}));
  options.wrench = RationalRow{0, -1, 0};
  const Question question = ask(file, options);
  EXPECT_EQ(question.box(), nullptr);
  EXPECT_EQ(question.loaded().grasp.contacts()[0].preload, 1);
  EXPECT_EQ(problem_of(question).wrench(), (Wrench{0, -1, 0}));
}

TEST(BoxQuestion, PreloadsAlongIrrationalNormals) {
  GraspFile file = certain();
  std::vector<Contact> contacts = file.loaded().grasp.contacts();
  contacts[1].normal = {-1, 1};
  file.content = LoadedGrasp{Grasp(contacts), file.loaded().wrench};
  EXPECT_EQ(ask(file, {}).box(), nullptr);  // not preloaded
  EXPECT_EQ(ask(file, widened_by("preload=0")).box(), nullptr);
  EXPECT_NE(ask(file, widened_by("preload=50%")).box(), nullptr);  // contact 0: [1, 3]
  QuestionOptions options;
  options.preload = 1;
  const Question question = ask(file, options);
  ASSERT_NE(question.box(), nullptr);
  EXPECT_TRUE(question.box()->is_point());
  try {
    problem_of(question);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), "contacts[1].normal");
    EXPECT_THAT(error.remedy(), HasSubstr("stickslip snap GRASP -o FILE"));
  }
  // A margin is a list of claims then, also if the preload only grows; and within a bound.
  options.direction = RationalRow{0, 1, 0};
  EXPECT_TRUE(ask(file, options).has_claims());
  EXPECT_EQ(test::error_of([&] { problem_of(ask(file, options)); }).place(),
            "contacts[1].normal");
  options.preload.reset();
  EXPECT_FALSE(ask(file, options).has_claims());
  options.max_motion = MotionBound{{1, 1}, {}};
  EXPECT_TRUE(ask(file, options).has_claims());
  EXPECT_EQ(test::error_of([&] { problem_of(ask(file, options)); }).place(), "max_motion");
  options.max_motion.reset();
  for (const bool grows : {false, true}) {
    options.preload_direction = PreloadDirection{false, {1, grows ? 1 : 0}};
    const Question along = ask(file, options);
    EXPECT_EQ(along.has_claims(), grows);
    EXPECT_EQ(test::error_of([&] { problem_of(along); }).place(),
              grows ? "contacts[1].normal" : "");
  }
  // A preload that may be above 0 is enough.
  GraspBox box = file.content.as_box();
  box.contacts[1].preload = {0, 0};
  EXPECT_EQ(ask({box}, {}).box(), nullptr);
  box.contacts[1].preload = {0, Rational(1, 1000)};
  EXPECT_NE(ask({box}, {}).box(), nullptr);
}

TEST(BoxQuestion, MarginsNeedNumbers) {
  const auto error_of = [](const GraspFile& file, QuestionOptions options) {
    options.direction = RationalRow{0, 1, 0};
    return test::error_of([&] { ask(file, options); });
  };
  EXPECT_EQ(error_of(certain(), {}).problem(), "no error");
  for (const auto& [file, tolerances] :
       {std::pair{uncertain(), "friction=0"}, std::pair{certain(), "friction=10%"},
        std::pair{certain(), "friction=0"}}) {
    const InputError error = error_of(file, widened_by(tolerances));
    EXPECT_EQ(error.place(), "uncertain");
    EXPECT_THAT(error.problem(), HasSubstr("a margin needs numbers"));
    EXPECT_THAT(error.remedy(), HasSubstr("give one number"));
  }
  EXPECT_EQ(error_of(uncertain(), {}).place(), "uncertain");
}

}  // namespace
}  // namespace stickslip
