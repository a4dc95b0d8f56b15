// SPDX-License-Identifier: MIT
// The grasp file (docs/grasp_file.md) and the rows of FORMAT.md §1.
#include "question.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "support.hpp"

namespace stickslip_check {
namespace {

Question read(const std::string& text, const QuestionOptions& options = {}) {
  std::istringstream in(text);
  return read_question(in, "grasp", options);
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
  const Question q = read(R"({"wrench": [0.1, "1e-3", -2], "format": "stickslip-grasp/1",
    "contacts": [{"normal": [0, 2], "position": ["1/3", 0.5]},
                 {"normal": [0, 2], "position": [0, 0], "friction": 0, "stiffness": 3,
                  "preload": 0}],
    "defaults": {"friction": "1/2", "preload": 7}})");
  EXPECT_EQ(q.wrench, (Vector3{Rational(1, 10), Rational(1, 1000), Rational(-2)}));
  EXPECT_EQ(q.contacts[0].position, (Vector2{Rational(1, 3), Rational(1, 2)}));
  EXPECT_EQ(q.contacts[0].friction, Rational(1, 2));
  EXPECT_EQ(q.contacts[0].stiffness, 1);
  EXPECT_EQ(q.contacts[0].preload, 7);
  EXPECT_EQ(q.contacts[1].friction, 0);
  EXPECT_EQ(q.contacts[1].stiffness, 3);
  EXPECT_EQ(q.contacts[1].preload, 0);
}

TEST(Question, OptionsReplace) {
  QuestionOptions options;
  options.wrench = Vector3{1, 2, 3};
  options.preload = Rational(5);
  options.bilateral = true;
  options.snap_tolerance = Rational(1, 4);
  const Question q = read(fig1("1", "0, 0, 0"), options);
  EXPECT_EQ(q.wrench, *options.wrench);
  EXPECT_EQ(q.preload, Rational(5));
  for (const GraspContact& contact : q.contacts) EXPECT_EQ(contact.preload, 5);
  EXPECT_TRUE(q.bilateral);
  EXPECT_EQ(q.snap_tolerance, Rational(1, 4));
  options.preload = Rational(-1);
  EXPECT_THROW(read(fig1("1", "0, 0, 0"), options), Malformed);
  options.preload = Rational(1);
  options.snap_tolerance = Rational(1);
  EXPECT_THROW(read(fig1("1", "0, 0, 0"), options), Malformed);
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
  GraspContact contact{{Rational(2), Rational(5)},
                       {Rational(3), Rational(4)},
                       Rational(1, 2),
                       Rational(7),
                       Rational(10)};
  const Row row = make_row(contact).value();
  EXPECT_EQ(row.normal, (Vector3{3, 4, 2 * 4 - 5 * 3}));
  EXPECT_EQ(row.tangent, (Vector3{-4, 3, 2 * 3 + 5 * 4}));
  EXPECT_EQ(row.preload, 2);
  EXPECT_EQ(row.stiffness, Rational(7, 25));
  contact.normal = {Rational(1), Rational(1)};
  EXPECT_FALSE(make_row(contact));
  contact.preload = 0;
  EXPECT_EQ(make_row(contact).value().stiffness, Rational(7, 2));
}

TEST(Question, SnappedNormals) {
  GraspContact contact;
  contact.normal = {Rational(1), Rational(1)};
  const Vector2 near{Rational(20, 29), Rational(21, 29)};  // 1.4 degrees off, 0.0244
  EXPECT_FALSE(snap_refusal(contact, near, Rational(25, 1000)));
  EXPECT_TRUE(snap_refusal(contact, near, Rational(24, 1000)));
  EXPECT_TRUE(snap_refusal(contact, {Rational(-20, 29), Rational(-21, 29)}, Rational(99, 100)));
  EXPECT_TRUE(snap_refusal(contact, {Rational(20, 29), Rational(20, 29)}, Rational(25, 1000)));
  // |u - n/|n||^2 = 2 - 2 (41/29)/sqrt 2 = 0.000595...
  EXPECT_EQ(decimal_above_sqrt(snap_distance_squared(contact, near)), "2.44e-2");
  // A normal of rational length is kept, even by itself.
  contact.normal = {Rational(3), Rational(4)};
  EXPECT_TRUE(snap_refusal(contact, {Rational(3, 5), Rational(4, 5)}, Rational(1, 2)));
}

}  // namespace
}  // namespace stickslip_check
