// SPDX-License-Identifier: MIT
// What the reader refuses, with file and place, and before any rule.
#include <gtest/gtest.h>

#include "support.hpp"

namespace stickslip_check {
namespace {

const std::string kGrasp = fig1("1", "0, 0, 0");
const std::string kForces = "[1, \"-1/2\"], [1, 0], [1, \"1/2\"]";
const std::string kStable = witness(header(3, "0, 0, 0"), "0, 0, 0", kForces);
const std::string kTree = refutation(header(3, "0, 0, 0"), {"[\"leaf\", 1, 0, 0]"});

void expect_malformed(const std::string& certificate, const std::string& place = "") {
  const Answer answer = ask(kGrasp, certificate);
  ASSERT_EQ(outcome(answer), "malformed") << certificate.substr(0, 400);
  const auto& malformed = std::get<Malformed>(answer);
  EXPECT_EQ(malformed.file, "certificate");
  EXPECT_FALSE(malformed.problem.empty());
  EXPECT_NE(malformed.place.find(place), std::string::npos) << malformed.place;
}

TEST(Malformed, TheBasesAreNot) {
  EXPECT_EQ(outcome(ask(kGrasp, kStable)), "accepted");
  EXPECT_EQ(outcome(ask(kGrasp, kTree)), "leaf-bound");
}

TEST(Malformed, NotJson) {
  for (const char* text :
       {"", " \n", "x", "{", "[]", "3", "\"a\"", "null", "{]", "{\"a\": 1,}", "{'format': 1}",
        "// c\n{}", "\xff", "{\"\xff\": 1}", "{\"a\": \"\n\"}", "{\"\\ud800\": 1}", "{}{}"}) {
    expect_malformed(text);
  }
  expect_malformed(std::string("\0", 1));
  expect_malformed("\xef\xbb\xbf" + kStable, "line 1, column 1");
}

TEST(Malformed, Members) {
  expect_malformed("{}", "top level");
  expect_malformed(replaced(kStable, "certificate/1", "certificate/2"), "format");
  expect_malformed(replaced(kStable, "\"stickslip-certificate/1\"", "1"), "format");
  expect_malformed(replaced(kStable, "\"verdict\": \"stable\"", "\"verdict\": \"Stable\""));
  expect_malformed(replaced(kStable, "\"verdict\": \"stable\"", "\"verdict\": \"unstable\""));
  expect_malformed(replaced(kStable, "\"verdict\": \"stable\",", ""));
  expect_malformed(replaced(kStable, "\"verdict\"", "\"verdict\": \"stable\", \"verdict\""));
  expect_malformed(replaced(kStable, "\"twist\": [0, 0, 0],", ""));
  expect_malformed(replaced(kStable, "\"twist\"", "\"extra\": 1, \"twist\""));
  expect_malformed(replaced(kStable, kForces + "]", kForces + "], \"tree\": []"));
  expect_malformed(replaced(kTree, "\"tree\"", "\"forces\""));
  expect_malformed(replaced(kStable, "\"question\"", "\"producer\": 7, \"question\""),
                   "producer");
  EXPECT_EQ(outcome(ask(kGrasp, replaced(kStable, "\"question\"",
                                         "\"producer\": \"x\\u0000\", \"question\""))),
            "accepted");
}

TEST(Malformed, Question) {
  expect_malformed(replaced(kStable, "\"contacts\": 3, ", ""), "question");
  expect_malformed(replaced(kStable, "\"contacts\": 3", "\"contacts\": -3"),
                   "question.contacts");
  expect_malformed(replaced(kStable, "\"contacts\": 3", "\"contacts\": \"3\""));
  expect_malformed(replaced(kStable, "\"contacts\": 3", "\"contacts\": 3.0"));
  expect_malformed(replaced(kStable, "\"contacts\": 3", "\"contacts\": 3, \"contacts\": 3"));
  expect_malformed(replaced(kStable, "\"contacts\": 3", "\"preload\": 3, \"contacts\": 3"));
  expect_malformed(replaced(kStable, "\"contacts\": 3", "\"what\": 3, \"contacts\": 3"));
  expect_malformed(replaced(kStable, "\"wrench\": [0, 0, 0]", "\"wrench\": [0, 0]"));
  expect_malformed(replaced(kStable, "\"wrench\": [0, 0, 0]", "\"wrench\": 0"));
  expect_malformed(replaced(kStable, "unilateral", "none"), "question.normal_law");
  expect_malformed(replaced(kStable, "\"unilateral\"", "\"unilateral\", \"normals\": 0"));
  expect_malformed(
      replaced(kStable, "\"unilateral\"", "\"unilateral\", \"normals\": [[0, 1]]"));
  expect_malformed(
      replaced(kStable, "\"unilateral\"", "\"unilateral\", \"normals\": [[\"0\", 1, 0]]"));
}

TEST(Malformed, Numbers) {
  for (const char* number :
       {"0.0",       "1e0",     "0.5",      "1e400",   "1e99999", "NaN",     "Infinity",
        "-Infinity", "nan",     "01",       "+1",      "-",       "0x1",     "true",
        "null",      "[]",      "{}",       "\"\"",    "\"1.0\"", "\"1e3\"", "\"+1\"",
        "\" 1\"",    "\"1/0\"", "\"1/-1\"", "\"--1\"", "\"1/\"",  "\"NaN\""}) {
    expect_malformed(replaced(kStable, "\"twist\": [0", std::string("\"twist\": [") + number));
    expect_malformed(replaced(kTree, "[\"leaf\", 1", std::string("[\"leaf\", ") + number));
  }
  const std::string zeros(4000, '0');
  EXPECT_EQ(
      outcome(ask(kGrasp, replaced(kTree, "\"leaf\", 1", "\"leaf\", 1" + zeros.substr(1)))),
      "leaf-bound");
  expect_malformed(replaced(kTree, "\"leaf\", 1", "\"leaf\", 1" + zeros));
  expect_malformed(replaced(kTree, "\"leaf\", 1", "\"leaf\", 1" + zeros + zeros));
  EXPECT_EQ(outcome(ask(kGrasp, replaced(kTree, "\"leaf\", 1",
                                         "\"leaf\", \"1" + std::string(65535, '0') + "\""))),
            "leaf-bound");
  expect_malformed(
      replaced(kTree, "\"leaf\", 1", "\"leaf\", \"1" + std::string(65536, '0') + "\""));
}

TEST(Malformed, Nodes) {
  for (const char* node : {"[]",
                           "{}",
                           "0",
                           "\"leaf\"",
                           "[1]",
                           "[\"leaf\"]",
                           "[\"leaf\", 1, 0]",
                           "[\"leaf\", 1, 0, 0, 0]",
                           "[\"leaf\", 1, 0, 0, [], []]",
                           "[\"leaf\", 1, 0, 0, [[0]]]",
                           "[\"leaf\", 1, 0, 0, [0, 1]]",
                           "[\"leaf\", 1, 0, 0, [[0, 1, 1]]]",
                           "[\"leaf\", 1, 0, 0, [[-1, 0]]]",
                           "[\"leaf\", 1, 0, 0, [[\"0\", 0]]]",
                           "[\"slip\"]",
                           "[\"slip\", 0, 0]",
                           "[\"slip\", -1]",
                           "[\"slip\", \"0\"]",
                           "[\"slip\", 0.0]",
                           "[\"separation\"]",
                           "[\"separation\", [0]]",
                           "[\"plane\", 1, 0, 0]",
                           "[\"plane\", 1, 0, 0, 0, 0]",
                           "[\"void\", 0]",
                           "[\"Leaf\", 1, 0, 0]",
                           "[null]",
                           "[[\"leaf\", 1, 0, 0]]"}) {
    expect_malformed(replaced(kTree, "[\"leaf\", 1, 0, 0]", node), "node 0");
  }
  expect_malformed(replaced(kTree, "\"tree\": [", "\"tree\": 0, \"x\": ["));
  expect_malformed(replaced(kStable, "[1, 0]", "[1]"), "forces[1]");
  expect_malformed(replaced(kStable, kForces, "[0, 0], [0, 0], [0, 0], [0, 0], [0, 0], 7"),
                   "forces[5]");
}

TEST(Malformed, AnywhereGoesBeforeAnyRule) {
  // The leaf is wrong, the wrench is another one, and the end is missing.
  expect_malformed(replaced(kTree, "]}\n", ""));
  expect_malformed(
      replaced(replaced(kTree, "\"wrench\": [0", "\"wrench\": [1"), "0]]}", "0], 0]}"));
}

TEST(Malformed, PlacesAreLines) {
  const Answer answer = ask(kGrasp, replaced(kTree, "[\"leaf\", 1, 0, 0]",
                                             "[\"slip\", 0],\n\n  [\"leaf\", 1, 0, true]"));
  ASSERT_EQ(outcome(answer), "malformed");
  EXPECT_EQ(std::get<Malformed>(answer).place, "line 7, node 1");
}

}  // namespace
}  // namespace stickslip_check
