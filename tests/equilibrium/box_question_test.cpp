// SPDX-License-Identifier: GPL-3.0-or-later
// Which questions are boxes, and that nothing takes a box for the grasp in its middle.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stickslip/core/error.hpp"
#include "stickslip/equilibrium/question.hpp"

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
  GraspBox box = box_of(certain().content);
  box.contacts[0].friction = {Rational(1, 4), Rational(3, 4)};
  return {box};
}

QuestionOptions widened_by(const char* tolerances) {
  QuestionOptions options;
  options.uncertain = parse_tolerances(tolerances);
  return options;
}

TEST(BoxQuestion, OneGraspIsNone) {
  EXPECT_EQ(ask(certain(), {}).box(), nullptr);
  const Question none = ask(certain(), widened_by("friction=0,preload=0%,normal=0"));
  EXPECT_EQ(none.box(), nullptr);
  EXPECT_TRUE(none.uncertain.any());  // as asked
  EXPECT_EQ(problem_of(none).size(), 2U);
}

TEST(BoxQuestion, IntervalsOfTheFile) {
  const Question question = ask(uncertain(), {});
  ASSERT_NE(question.box(), nullptr);
  EXPECT_EQ(question.box()->contacts[0].friction, (Interval{Rational(1, 4), Rational(3, 4)}));
  EXPECT_FALSE(question.wrench_as_asked);
  EXPECT_THROW(problem_of(question), InputError);
}

TEST(BoxQuestion, TolerancesComeAfterWhatIsReplaced) {
  QuestionOptions options = widened_by("preload=50%,wrench=1,friction=1/8,normal=1/9");
  options.preload = 4;
  options.wrench = RationalRow{1, 2, 3};
  const Question question = ask(uncertain(), options);
  ASSERT_NE(question.box(), nullptr);
  for (const UncertainContact& c : question.box()->contacts) {
    EXPECT_EQ(c.preload, (Interval{2, 6}));
    EXPECT_EQ(c.slope, Rational(1, 9));
  }
  EXPECT_EQ(question.box()->contacts[0].friction, (Interval{Rational(1, 8), Rational(7, 8)}));
  EXPECT_EQ(question.box()->contacts[1].friction, (Interval{Rational(7, 8), Rational(9, 8)}));
  EXPECT_EQ(question.box()->wrench,
            (WrenchBox{Interval{0, 2}, Interval{1, 3}, Interval{2, 4}}));
  EXPECT_EQ(question.wrench_as_asked, box_of(Wrench{1, 2, 3}));
  EXPECT_EQ(question.uncertain, options.uncertain);
}

TEST(BoxQuestion, WhatIsReplacedMayLeaveOneGrasp) {
  GraspBox box = box_of(certain().content);
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

TEST(BoxQuestion, OfACaseItsOwnLoad) {
  GraspFile file = certain();
  file.cases = {{"one", box_of(Wrench{1, 0, 0})},
                {"many", {Interval{1, 3}, Interval{}, Interval{}}}};
  QuestionOptions options;
  options.case_name = "one";
  EXPECT_EQ(ask(file, options).box(), nullptr);
  options.case_name = "many";
  const Question many = ask(file, options);
  ASSERT_NE(many.box(), nullptr);
  EXPECT_EQ(many.box()->wrench[0], (Interval{1, 3}));
  EXPECT_EQ(many.box()->wrench, file.cases[1].wrench);
  // What is asked for is w; tolerances widen it, and its middle may move.
  options.uncertain = parse_tolerances("wrench=100%");
  const Question widened = ask(file, options);
  EXPECT_EQ(widened.box()->wrench[0], (Interval{0, 6}));
  EXPECT_EQ(widened.wrench_as_asked, file.cases[1].wrench);
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
  // A preload that may be above 0 is enough.
  GraspBox box = box_of(file.content);
  box.contacts[1].preload = {0, 0};
  EXPECT_EQ(ask({box}, {}).box(), nullptr);
  box.contacts[1].preload = {0, Rational(1, 1000)};
  EXPECT_NE(ask({box}, {}).box(), nullptr);
}

TEST(BoxQuestion, MarginsNeedNumbers) {
  const auto error_of = [](const GraspFile& file, QuestionOptions options) {
    options.direction = RationalRow{0, 1, 0};
    try {
      ask(file, options);
    } catch (const InputError& error) {
      return error;
    }
    return InputError("", "", "no error", "");
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

TEST(BoxQuestion, BadBoxesNameTheirPlace) {
  try {
    ask(uncertain(), widened_by("friction=0.3"));
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), "contacts[0].friction");
    EXPECT_THAT(error.problem(), HasSubstr("[-1/20, 21/20]"));
  }
}

}  // namespace
}  // namespace stickslip
