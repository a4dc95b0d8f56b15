// SPDX-License-Identifier: MIT
// The grasp file (docs/grasp_file.md) and the rows of FORMAT.md §1.
#include "question.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <utility>

#include "support.hpp"

namespace stickslip_check {
namespace {

Question ask_of(const std::string& text, const Options& options = {}) {
  return pose(read(text), options, "grasp");
}

TEST(Question, GoodGraspsAreRead) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(GRASP_CORPUS "/good")) {
    EXPECT_NO_THROW(read(read_file(entry.path()))) << entry.path();
    ++count;
  }
  EXPECT_GT(count, 0U);
}

TEST(Question, BadGraspsAreNot) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(GRASP_CORPUS "/bad")) {
    EXPECT_THROW(read(read_file(entry.path())), Malformed) << entry.path();
    ++count;
  }
  EXPECT_GT(count, 0U);
}

TEST(Question, PrecedenceOfValues) {
  const Grasp q = read(R"({"wrench": [0.1, "1e-3", -2], "format": "stickslip-grasp/1",
    "contacts": [{"normal": [0, 2], "position": ["1/3", 0.5]},
                 {"normal": [0, 2], "position": [0, 0], "friction": 0, "stiffness": 3,
                  "preload": 0}],
    "defaults": {"friction": "1/2", "preload": 7}})");
  EXPECT_EQ(q.wrench, (Wrench{Rational(1, 10), Rational(1, 1000), Rational(-2)}));
  EXPECT_EQ(q.contacts[0].position, (Wrench{Rational(1, 3), Rational(1, 2)}));
  EXPECT_EQ(q.contacts[0].friction, Rational(1, 2));
  EXPECT_EQ(q.contacts[0].stiffness, 1);
  EXPECT_EQ(q.contacts[0].preload, 7);
  EXPECT_EQ(q.contacts[1].friction, 0);
  EXPECT_EQ(q.contacts[1].stiffness, 3);
  EXPECT_EQ(q.contacts[1].preload, 0);
}

/// The preload coefficients and those of their growth, for unit normals the values themselves.
std::pair<Vector, Vector> preloads(const Question& question) {
  std::pair<Vector, Vector> result;
  for (std::size_t i = 0; i < question.box->size(); ++i) {
    const ContactBox& contact = question.box->contact(i);
    result.first.push_back(contact[Parameter::kPreload].low);
    result.second.push_back(contact.growth.low);
  }
  return result;
}

TEST(Question, TheBasePoint) {
  // FORMAT.md §1, the table. The file: wrench (0, 0, 5), preloads 3.
  const std::string text = fig1("3", "0, 0, 5");
  const Vector file{0, 0, 5};
  const Vector zero{0, 0, 0};
  const Vector u{1, 0, 0};
  const Vector threes{3, 3, 3};
  const Vector numbers{1, 0, 2};
  struct Case {
    bool direction;
    std::optional<PreloadDirection> growth;
    Vector w, p, p_u;
  };
  const PreloadDirection scale{true, {}};
  const PreloadDirection by_numbers{false, numbers};
  const Case cases[] = {
      {false, std::nullopt, file, threes, zero},  {true, std::nullopt, zero, threes, zero},
      {false, by_numbers, file, threes, numbers}, {false, scale, file, zero, threes},
      {true, by_numbers, zero, threes, numbers},  {true, scale, zero, zero, threes}};
  for (const Case& c : cases) {
    Options options;
    if (c.direction) options.direction = u;
    options.preload_direction = c.growth;
    Question question = ask_of(text, options);
    EXPECT_EQ(question.wrench, Wrench(c.w.begin(), c.w.end()));
    EXPECT_EQ(question.growth, c.direction ? u : zero);
    EXPECT_EQ(preloads(question), std::pair(c.p, c.p_u));
    // What replaces them.
    options.wrench = Vector{7, 7, 7};
    options.preload = Rational(1, 2);
    question = ask_of(text, options);
    EXPECT_EQ(question.wrench, Wrench(3, 7));
    const Vector halves(3, Rational(1, 2));
    EXPECT_EQ(preloads(question).first, c.p == threes ? halves : c.p);
    EXPECT_EQ(preloads(question).second, c.p_u == threes ? halves : c.p_u);
  }
}

TEST(Question, WhatCannotBeAsked) {
  const auto refuses = [](const Options& options) {
    EXPECT_THROW(ask_of(fig1("0", "0, 0, 0"), options), Malformed);
  };
  Options options;
  options.preload = Rational(-1);
  refuses(options);
  options = {};
  options.direction = Vector(3);
  refuses(options);
  options.preload_direction = PreloadDirection{true, {}};
  refuses(options);
  options.preload_direction = PreloadDirection{false, {0, 0, 0}};
  refuses(options);
  options.preload_direction->values = {0, 1};
  refuses(options);
  options.preload_direction->values = {0, 1, -1};
  refuses(options);
  options.preload_direction->values = {0, 1, 0};
  EXPECT_NO_THROW(ask_of(fig1("0", "0, 0, 0"), options));
}

TEST(Question, ErrorsNameFileAndPlace) {
  try {
    read(replaced(fig1("1", "0, 0, 0"), R"("normal": [0, 1])", R"("normal": [0, true])"));
    FAIL();
  } catch (const Malformed& error) {
    EXPECT_EQ(error.file, "grasp");
    EXPECT_EQ(error.place, "line 5, contacts[1].normal[1]");
    EXPECT_NE(error.problem.find("found true, expected a number"), std::string::npos);
  }
}

TEST(Question, RowsOfAnyLength) {
  const Contact contact{{2, 5}, {3, 4}, Rational(1, 2), 7, 10};
  const Grasp grasp{{contact}, Wrench(3)};
  Options options;
  options.preload_direction = PreloadDirection{false, {15}};
  const Question question = pose(grasp, options, "grasp");
  const Row& row = question.box->row(0);
  ASSERT_TRUE(row.certain);
  // N = (3, 4, 2 * 4 - 5 * 3), T = (-4, 3, 2 * 3 + 5 * 4), v = (-7/25 N, 2, 3).
  EXPECT_EQ(row.v, (std::vector<Form>{{-21, -28, 49, 50, 75}}));
  EXPECT_EQ(row.tau, (std::vector<Form>{{-4, 3, 26, 0, 0}}));
  EXPECT_EQ(row.normals, (std::vector<Form>{{3, 4, -7}}));
  EXPECT_EQ(row.slips, (std::vector<std::vector<Form>>{{{-4, 3, 26}}}));
  EXPECT_EQ(row.scale, 1);
  EXPECT_EQ(row.edges[0], (std::vector<Form>{{10, 5, -40}}));  // 2 N - T
  EXPECT_EQ(row.edges[3], (std::vector<Form>{{2, 11, 12}}));
  EXPECT_EQ(row.weight, Rational(1, 50));
}

TEST(Question, IrrationalLengthsWhereTheyAreNeeded) {
  Grasp grasp{{{{0, 0}, {1, 1}, 0, 7, 0}}, Wrench(3)};
  Options options;
  const Question plain = pose(grasp, options, "grasp");
  EXPECT_FALSE(plain.is_box);
  EXPECT_EQ(plain.box->contact(0)[Parameter::kStiffness], Rational(7, 2));
  Contact contact = grasp.contacts[0];
  contact.preload = 1;
  grasp.contacts.set(0, contact);
  EXPECT_TRUE(pose(grasp, options, "grasp").is_box);
  contact.preload = 0;
  grasp.contacts.set(0, contact);
  options.preload_direction = PreloadDirection{false, {1}};
  try {
    pose(grasp, options, "grasp");
    FAIL();
  } catch (const Malformed& error) {
    EXPECT_EQ(error.file, "grasp");
    EXPECT_EQ(error.place, "contacts[0].normal");
    EXPECT_NE(error.problem.find("stickslip snap GRASP -o FILE"), std::string::npos);
  }
}

}  // namespace
}  // namespace stickslip_check
