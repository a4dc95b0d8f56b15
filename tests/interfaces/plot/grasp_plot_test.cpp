// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/grasp_plot.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

Question pushed_from_below() {
  Question question;
  question.grasp = LoadedGrasp{Grasp({{{0, -1}, {0, 1}, Rational(1, 2)}}, "one"), {0, -1, 0}};
  return question;
}

TEST(PlotGrasp, AWitnessOfAnotherGraspIsRefused) {
  EXPECT_THROW(plot_grasp(pushed_from_below(), Stable{Witness{{0, -1, 0}, {}}}), ContractError);
}

TEST(PlotGrasp, AMotionThatTurnsAboutTheOnlyContact) {
  Question question;
  question.grasp = LoadedGrasp{Grasp(std::vector<Contact>{{{0, 0}, {0, 1}}}), {}};
  for (const char* turn : {"1", "-1e-400", "1e400"}) {
    const Witness witness{{0, 0, parse_rational(turn)}, {{0, 0}}};
    ASSERT_FALSE(find_violation(Problem(question.loaded(), question.law), witness));
    const std::string svg = plot_grasp(question, Stable{witness});
    EXPECT_NE(svg.find("class=\"ghost\""), std::string::npos);
    EXPECT_EQ(svg.find("class=\"motion\""), std::string::npos);
  }
}

TEST(PlotGrasp, Undecided) {
  const std::string svg =
      plot_grasp(pushed_from_below(),
                 Verdict(Undecided{"a limit was reached", "nodes", "a higher one may help"}));
  EXPECT_NE(svg.find("one: undecided"), std::string::npos);
  EXPECT_NE(svg.find("Undecided: a limit was reached; a higher one may help."),
            std::string::npos);
}

TEST(PlotGrasp, NoMotionIsAllowed) {
  const std::string svg = plot_grasp(pushed_from_below(), Unstable{{TwistLeaf{Row(3)}}});
  EXPECT_NE(svg.find("allows no motion"), std::string::npos);
}

/// The marks of contacts 0, 1, ....
std::vector<std::string> marks(const std::string& svg) {
  const std::string key = "data-contact-state=\"";
  const std::string scene = svg.substr(0, svg.find("class=\"key\""));
  std::vector<std::string> found;
  for (std::size_t at = 0; (at = scene.find(key, at)) != std::string::npos;) {
    at += key.size();
    found.push_back(scene.substr(at, scene.find('"', at) - at));
  }
  return found;
}

TEST(PlotGrasp, WhichContactsLose) {
  // Pulled out from between two fingers; the third could only push it further.
  Question question;
  question.grasp = LoadedGrasp{Grasp({{{-1, 0}, {1, 0}, Rational(1, 2)},
                                      {{1, 0}, {-1, 0}, Rational(1, 2)},
                                      {{0, -1}, {0, 1}, Rational(1, 2)}},
                                     "pulled"),
                               {0, 9, 0}};
  const TwistLeaf down{{0, -1, 0}};
  const std::string loses = "loses";
  const std::string cannot = "cannot oppose";
  const std::string whole = plot_grasp(question, Unstable{{down}});
  EXPECT_EQ(marks(whole), (std::vector<std::string>{loses, loses, cannot}));
  EXPECT_NE(whole.find("The load drives this motion; contacts 0, 1 oppose it and lose; contact "
                       "2 cannot oppose it."),
            std::string::npos);
  EXPECT_NE(whole.find("virtual-ghost"), std::string::npos);
  EXPECT_EQ(whole.find("virtual-pivot\""), std::string::npos);
  // Where contact 0 slips +, friction pulls it down; where it slips -, up; open, not at all.
  const auto largest = [&](const TreeNode& split, std::size_t which, std::size_t of) {
    Trees tree{split};
    for (std::size_t k = 0; k < of; ++k) {
      tree.push_back(k == which ? TreeNode(down) : TreeNode(TwistLeaf{Row(3)}));
    }
    return marks(plot_grasp(question, Unstable{tree}))[0];
  };
  EXPECT_EQ(largest(SlipSplit{ContactId(0)}, 0, 3), loses);
  EXPECT_EQ(largest(SlipSplit{ContactId(0)}, 1, 3), loses);
  EXPECT_EQ(largest(SlipSplit{ContactId(0)}, 2, 3), cannot);
  EXPECT_EQ(largest(SeparationSplit{ContactId(0)}, 0, 2), loses);
  EXPECT_EQ(largest(SeparationSplit{ContactId(0)}, 1, 2), cannot);
}

TEST(PlotGrasp, AVirtualTwistTurnsAboutItsCentre) {
  const Trees turn{TwistLeaf{{0, 0, -1}}};
  const std::string svg = plot_grasp(pushed_from_below(), Unstable{turn});
  EXPECT_NE(svg.find("class=\"virtual-pivot\""), std::string::npos);
  const Trees far{TwistLeaf{{-9, 0, -1}}};
  EXPECT_EQ(plot_grasp(pushed_from_below(), Unstable{far}).find("class=\"virtual-pivot\""),
            std::string::npos);
}

TEST(PlotGrasp, ACaseWithoutATwistHasNoMotion) {
  const Trees none{TwistLeaf{{0, 0, 0}}};
  const std::string svg = plot_grasp(pushed_from_below(), Unstable{none});
  EXPECT_EQ(svg.find("class=\"virtual\""), std::string::npos);
}

Question pushed_down() {
  GraspBox grasp{{}, WrenchBox(6), {"one"}};
  grasp.contacts.push_back({std::vector<Interval>(3),
                            {0, 0, 1},
                            point_interval(Rational(1, 2)),
                            point_interval(1),
                            {}});
  QuestionOptions asked;
  asked.wrench = RationalRow{0, 0, -1, 0, 0, 0};
  return ask({grasp}, asked);
}

TEST(PlotSpatialGrasp, UndecidedOrUnstableHasNoForces) {
  const std::string undecided = plot_grasp(pushed_down(), Verdict(Undecided{"7 nodes"}));
  EXPECT_NE(undecided.find("one: undecided"), std::string::npos);
  EXPECT_NE(undecided.find("Undecided: 7 nodes."), std::string::npos);
  const std::string unstable =
      plot_grasp(pushed_down(), Verdict(Unstable{{TwistLeaf{Row(6)}}}));
  EXPECT_NE(unstable.find("proved by one virtual twist."), std::string::npos);
  for (const std::string& svg : {undecided, unstable}) {
    EXPECT_EQ(svg.find("class=\"force\""), std::string::npos);
    EXPECT_EQ(svg.find("class=\"motion\""), std::string::npos);
  }
}

TEST(PlotSpatialGrasp, AMotionThatTurnsAboutTheOnlyContact) {
  for (const char* turn : {"1", "-1e-400", "1e400"}) {
    const RationalRow d{0, 0, -1, 0, 0, parse_rational(turn)};
    const std::string svg = plot_grasp(pushed_down(), Verdict(Stable{ShareWitness{d, {}}, d}));
    EXPECT_NE(svg.find("class=\"ghost\""), std::string::npos);
    EXPECT_NE(svg.find("data-value=\"0,0,1\""), std::string::npos);  // of the force
  }
}

}  // namespace
}  // namespace stickslip
