// SPDX-License-Identifier: MIT
// Proofs at rest (FORMAT.md §6), where a plate shows by hand how much friction holds. Rules and
// places are compared with check.py's in tests/check_py/test_rest.py.
#include <gtest/gtest.h>

#include "support.hpp"

namespace stickslip_check {
namespace {

/// Contacts in the middle of the sides of a square, with friction 1/2 and P = 1: each holds up
/// to 1/2 along its side, so all hold a torque up to 2, and two of them a force up to 1.
std::string plate(const std::string& wrench, const std::string& last = R"("1/2", "preload": 1)",
                  const std::string& x = "-1") {
  return R"({"format": "stickslip-grasp/2", "defaults": {"friction": "1/2", "preload": 1},
 "contacts": [{"position": [)" +
         x + R"(, 0], "normal": [1, 0]}, {"position": [1, 0], "normal": [-1, 0]},
  {"position": [0, -1], "normal": [0, 1]},
  {"position": [0, 1], "normal": [0, -1], "friction": )" +
         last + R"(}], "wrench": [)" + wrench + "]}";
}

const char* const kAnswers =
    R"([0, [0, "1/2", "-1/4"]], [1, [0, "-1/2", "-1/4"]], [2, ["-1/2", 0, "-1/4"]],
   [3, ["1/2", 0, "-1/4"]])";

std::string at_rest(const std::string& wrench, const std::string& reach,
                    const std::string& rest = "", const std::string& answers = kAnswers) {
  return header(4, wrench) + R"( "verdict": "stable", "parts": [{"rest": [)" + rest +
         R"(], "answers": [)" + answers + R"(], "reach": [)" + reach + "]}]}";
}

TEST(Rest, AsMuchAsFrictionHolds) {
  const auto expect = [](const std::string& wrench, const std::string& reach, const char* rule,
                         const std::string& rest = "") {
    const Answer answer = ask(plate(wrench), at_rest(wrench, reach, rest));
    EXPECT_EQ(outcome(answer), rule) << explain(answer);
    if (const auto* rejected = std::get_if<Rejected>(&answer)) {
      EXPECT_EQ(rejected->path, "part 0");
      EXPECT_FALSE(rejected->node);
    }
  };
  expect("0, 0, 2", "0, 0, 2", "accepted");
  expect("0, 0, -2", "0, 0, 2", "accepted");
  expect("1, -1, 0", "1, 1, 0", "accepted");
  expect("1, -1, 0", R"(1, "999999/1000000", 0)", "rest-reach");
  expect("0, 0, 2", R"(0, 0, "1999999/1000000")", "rest-reach");
  expect("0, 0, 2", R"(0, "-1/1000000", 2)", "rest-reach");
  expect("0, 0, 2", R"(0, "1/1000000", 2)", "rest-cone");
  expect("0, 0, 2", R"(0, 0, "2000001/1000000")", "rest-cone");
  expect("1, 1, 1", "1, 1, 1", "rest-cone");
  // What forces that are stated balance is not left.
  const char* const most = R"([0, "1/2"], [1, "1/2"], [2, "1/2"], [3, "1/2"])";
  expect("0, 0, 2", "0, 0, 0", "accepted", most);
  expect("0, 0, 2", "0, 0, 0", "rest-reach", replaced(most, R"(0, "1/2")", R"(0, "2/5")"));
  expect("0, 0, 2", "0, 0, 0", "rest-reach");
  expect("0, 0, 2", "0, 0, 0", "rest-share", std::string(most) + R"(, [3, 0])");
  expect("0, 0, 2", "0, 0, 0", "rest-share", std::string(most) + R"(, [4, 0])");
}

TEST(Rest, AllOfABoxCounts) {
  const std::string turn = "0, 0, 2";
  const auto expect = [](const std::string& grasp, const std::string& proof, const char* rule) {
    const Answer answer = ask(grasp, proof);
    EXPECT_EQ(outcome(answer), rule) << explain(answer);
  };
  const auto rubs = [&](const char* friction) {
    return plate(turn, friction + std::string(R"(, "preload": 1)"));
  };
  expect(rubs(R"({"min": "1/2", "max": 1})"), at_rest(turn, turn), "accepted");
  expect(rubs(R"({"min": "49/100", "max": 1})"), at_rest(turn, turn), "rest-cone");
  // A preload between 1 and 2 is not balanced by that at the other side: 1 is left.
  const auto presses = [](const char* preload, const std::string& wrench) {
    return plate(wrench, R"("1/2", "preload": )" + std::string(preload));
  };
  const char* const preload = R"({"min": 1, "max": 2})";
  expect(presses(preload, "0, 0, 0"), at_rest("0, 0, 0", "0, 1, 0"), "accepted");
  expect(presses(preload, "0, 0, 0"), at_rest("0, 0, 0", R"(0, "99/100", 0)"), "rest-reach");
  expect(presses(R"({"min": "99/100", "max": 2})", "0, 1, 0"), at_rest("0, 1, 0", "0, 1, 0"),
         "rest-reach");
  expect(presses(R"({"min": "99/100", "max": 1})", turn), at_rest(turn, R"(0, "1/100", 2)"),
         "rest-cone");
  // At x in [-1.1, -0.9] the first contact's half of a force of 1 along y turns the plate by up
  // to 0.05, and its fourth of a torque is 0.225 to 0.275.
  const std::string wide =
      plate("0, \"1/2\", 0", R"("1/2", "preload": 1)", R"({"min": "-11/10", "max": "-9/10"})");
  expect(wide, at_rest("0, \"1/2\", 0", R"(0, "1/2", "1/39")"), "accepted");
  expect(wide, at_rest("0, \"1/2\", 0", R"(0, "1/2", "999/39000")"), "rest-reach");
}

TEST(Rest, WhatIsMalformed) {
  const std::string good = at_rest("0, 0, 0", "0, 0, 0", "[0, 0]");
  EXPECT_EQ(outcome(ask(plate("0, 0, 0"), good)), "accepted");
  for (const auto& [from, to] :
       {std::pair("[0, 0]]", "[0, [0]]]"), std::pair("[0, 0]]", "[-1, 0]]"),
        std::pair("[0, 0]]", "[0, 0, 0]]"), std::pair("[0, [0, \"1/2\", \"-1/4\"]]", "[0, 0]"),
        std::pair("\"-1/4\"]]", "\"-1/4\", 0]]"), std::pair("\"-1/4\"]]", "[\"-1/4\"]]]"),
        std::pair("\"reach\": [0, 0, 0]", "\"reach\": [0, 0]"),
        std::pair(", \"reach\": [0, 0, 0]", ""), std::pair("\"answers\"", "\"answer\""),
        std::pair("{\"rest\"", "{\"twist\": [0, 0, 0], \"rest\"")}) {
    EXPECT_EQ(outcome(ask(plate("0, 0, 0"), replaced(good, from, to))), "malformed") << to;
  }
}

}  // namespace
}  // namespace stickslip_check
