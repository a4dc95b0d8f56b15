// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts of grasps of many coordinates: by closed forms, and where there are few, as the
// search decides them.
#include "engine/large/decide_large.hpp"

#include <gtest/gtest.h>

#include <random>

#include "stickslip/core/grasp_file.hpp"

namespace stickslip {
namespace {

/// Boxes of width 2 and height 1 upon each other, each on two contacts.
struct Tower {
  int boxes = 1;
  std::vector<int> weights = std::vector<int>(static_cast<std::size_t>(boxes), 1);
  std::string friction = "1/2";
  std::string push = "0";  ///< to the right, on the highest, in the middle of its height
  std::string more{};      ///< members of the file

  GraspBox grasp() const {
    std::string bodies;
    std::string contacts;
    std::string loads;
    for (int k = 0; k < boxes; ++k) {
      const std::string name = "\"b" + std::to_string(k) + '"';
      const std::string comma = k == 0 ? "" : ", ";
      bodies += comma + R"({"name": )" + name + "}";
      const std::string by = k == 0 ? "" : R"(, "by": "b)" + std::to_string(k - 1) + '"';
      for (const char* side : {"-1", "1"}) {
        contacts += (contacts.empty() ? "" : ", ") + std::string(R"({"of": )") + name + by +
                    R"(, "position": [)" + side + ", " + std::to_string(k) +
                    R"(], "normal": [0, 1]})";
      }
      loads += comma + R"({"body": )" + name + R"(, "weight": )" +
               std::to_string(weights[static_cast<std::size_t>(k)]) + R"(, "at": [0, )" +
               std::to_string(k) + "]}";
    }
    loads += R"(, {"body": "b)" + std::to_string(boxes - 1) + R"(", "force": [")" + push +
             R"(", 0], "at": [0, ")" + std::to_string(2 * boxes - 1) + R"(/2"]})";
    return parse_any_grasp(R"({"format": "stickslip-grasp/3", "bodies": [)" + bodies +
                               R"(], "defaults": {"friction": ")" + friction +
                               R"("}, "contacts": [)" + contacts + R"(], "loads": [)" + loads +
                               "]" + more + "}",
                           "a tower")
        .content.as_box();
  }
};

/// Every contact of a tower at rest bears half of what is above it, and gives by as much.
TEST(DecideLarge, ATowerSinksByWhatIsAbove) {
  const Tower tower{20};
  const GraspBox grasp = tower.grasp();
  ASSERT_TRUE(is_large(grasp));
  const BoxDecision decision = decide_large(grasp, NormalLaw::kBilateral);
  ASSERT_TRUE(std::holds_alternative<Stable>(decision.verdict));
  const auto& witness = std::get<ShareWitness>(std::get<Stable>(decision.verdict).proof);
  RationalRow motion;
  Rational sunk = 0;
  for (int k = 0; k < tower.boxes; ++k) {
    sunk += Rational(tower.boxes - k, 2);
    motion.insert(motion.end(), {0, -sunk, 0});
  }
  EXPECT_EQ(witness.twist, motion);
  EXPECT_TRUE(witness.shares.empty());
}

/// A push slides the highest box if it is above friction, and turns it over if the torque about
/// its edge is above that of its weight: 1/2 of the push against 1.
TEST(DecideLarge, APushSlidesTheHighestBox) {
  for (const auto& [push, is_stable] :
       {std::pair("49/100", true), std::pair("51/100", false)}) {
    Tower tower{15};
    tower.push = push;
    const GraspBox grasp = tower.grasp();
    const BoxDecision decision = decide_large(grasp, NormalLaw::kUnilateral);
    EXPECT_EQ(stickslip::is_stable(decision.verdict), is_stable) << push;
    if (is_stable) continue;
    const Trees& tree = std::get<Unstable>(decision.verdict).tree;
    ASSERT_EQ(tree.size(), 1U);
    const Row& y = std::get<TwistLeaf>(tree.front()).twist;
    RationalRow load;
    for (const Interval& w : grasp.wrench) load.push_back(w.low);
    EXPECT_LT(dot(y, load), 0);
  }
}

/// Statics balances the weights, and the springs give by more than the bound.
TEST(DecideLarge, SaysWhyItIsUndecided) {
  Tower tower{15};
  tower.more = R"(, "max_motion": {"length": "1/10", "angle": 1})";
  const BoxDecision decision = decide_large(tower.grasp(), NormalLaw::kUnilateral);
  const auto* undecided = std::get_if<Undecided>(&decision.verdict);
  ASSERT_NE(undecided, nullptr);
  EXPECT_EQ(undecided->reason, "size");
  EXPECT_NE(undecided->limit.find("too large"), std::string::npos);
}

TEST(DecideLarge, DecidesFewBodiesAsTheSearchDoes) {
  std::mt19937 random(3);
  int stable = 0;
  int unstable = 0;
  for (int round = 0; round < 40; ++round) {
    Tower tower{2 + static_cast<int>(random() % 2)};
    for (int& weight : tower.weights) weight = 1 + static_cast<int>(random() % 4);
    tower.friction = std::to_string(1 + random() % 9) + "/10";
    tower.push = std::to_string(random() % 40) + "/11";
    const GraspBox grasp = tower.grasp();
    ASSERT_FALSE(is_large(grasp));
    const auto verdict = is_stable(decide_large(grasp, NormalLaw::kUnilateral).verdict);
    if (!verdict) continue;
    ++(*verdict ? stable : unstable);
    EXPECT_EQ(verdict, is_stable(decide_box(grasp, NormalLaw::kUnilateral).verdict))
        << tower.friction << ' ' << tower.push;
  }
  EXPECT_GT(stable, 8);
  EXPECT_GT(unstable, 8);
}

}  // namespace
}  // namespace stickslip
