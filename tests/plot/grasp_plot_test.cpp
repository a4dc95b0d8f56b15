// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/plot/grasp_plot.hpp"

#include <gtest/gtest.h>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

Question pushed_from_below() {
  Question question;
  question.loaded.grasp = Grasp({{{0, -1}, {0, 1}, Rational(1, 2)}}, "one");
  question.loaded.wrench = {0, -1, 0};
  return question;
}

TEST(PlotGrasp, AWitnessOfAnotherGraspIsRefused) {
  EXPECT_THROW(plot_grasp(pushed_from_below(), Stable{{{0, -1, 0}, {}}}), ContractError);
}

TEST(PlotGrasp, AMotionThatTurnsAboutTheOnlyContact) {
  Question question;
  question.loaded.grasp = Grasp(std::vector<Contact>{{{0, 0}, {0, 1}}});
  for (const char* turn : {"1", "-1e-400", "1e400"}) {
    const Witness witness{{0, 0, parse_rational(turn)}, {{0, 0}}};
    ASSERT_FALSE(find_violation(Problem(question.loaded, question.law), witness));
    const std::string svg = plot_grasp(question, Stable{witness});
    EXPECT_NE(svg.find("class=\"ghost\""), std::string::npos);
    EXPECT_EQ(svg.find("class=\"motion\""), std::string::npos);
  }
}

TEST(PlotGrasp, Undecided) {
  const std::string svg = plot_grasp(pushed_from_below(), Undecided{"1 node"});
  EXPECT_NE(svg.find("one: undecided"), std::string::npos);
  EXPECT_NE(svg.find("given up at 1 node"), std::string::npos);
}

TEST(PlotGrasp, NoMotionIsAllowed) {
  const std::string svg = plot_grasp(pushed_from_below(), Unstable{{VoidLeaf{}}});
  EXPECT_NE(svg.find("allows no motion"), std::string::npos);
}

}  // namespace
}  // namespace stickslip
