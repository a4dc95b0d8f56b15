// SPDX-License-Identifier: GPL-3.0-or-later
// What the reader accepts, what the writer writes. Refusals: grasp_file_errors_test.cpp.
#include "stickslip/core/grasp_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>
#include <iostream>
#include <sstream>

#include "random_numbers.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using testing::Random;
using testing::same;

GraspFile read_good(const std::string& name) {
  return read_grasp_file(STICKSLIP_GRASP_CORPUS "/good/" + name + ".json");
}

void expect_same(const LoadedGrasp& a, const LoadedGrasp& b) {
  EXPECT_EQ(a.grasp.name(), b.grasp.name());
  EXPECT_EQ(a.grasp.description().outline, b.grasp.description().outline);
  EXPECT_EQ(a.grasp.description().units, b.grasp.description().units);
  EXPECT_EQ(a.wrench, b.wrench);
  ASSERT_EQ(a.grasp.size(), b.grasp.size());
  for (std::size_t i = 0; i < a.grasp.size(); ++i) {
    EXPECT_TRUE(same(a.grasp.contacts()[i], b.grasp.contacts()[i])) << i;
  }
}

TEST(ReadGrasp, Fig1) {
  const GraspFile file = read_good("fig1");
  EXPECT_EQ(file.loaded().grasp.name(), "fig1");
  EXPECT_EQ(file.loaded().wrench, (Wrench{0, Rational(-11, 10), 0}));
  const std::vector<Contact>& c = file.loaded().grasp.contacts();
  ASSERT_EQ(c.size(), 3U);
  EXPECT_TRUE(same(c[0], {{-1, 0}, {1, 0}, Rational(1, 2), 1, 1}));
  EXPECT_TRUE(same(c[1], {{0, -1}, {0, 1}, Rational(1, 2), 1, 1}));
  EXPECT_TRUE(same(c[2], {{1, 0}, {-1, 0}, Rational(1, 2), 1, 1}));
}

TEST(ReadGrasp, NumbersAreTheDecimalsTheySpell) {
  const GraspFile file = read_good("exact_numbers");
  const std::vector<Contact>& c = file.loaded().grasp.contacts();
  ASSERT_EQ(c.size(), 3U);
  EXPECT_TRUE(same(c[0], {{Rational(1, 10), Rational(-1, 1000)},
                          {Rational(3, 5), Rational(-4, 5)},
                          100,
                          10,
                          Rational(1, 10)}));
  EXPECT_EQ(c[1].position.x, Rational(Integer("123456789012345678901234567890")));
  EXPECT_EQ(c[1].position.y, Rational(Integer("-9223372036854775808")));
  EXPECT_EQ(c[1].normal.x, Rational(Integer("18446744073709551615")));
  EXPECT_EQ(c[1].normal.y, 0);
  EXPECT_EQ(c[1].friction, 0);
  EXPECT_EQ(c[2].position.x, parse_rational("1e-4096"));
  EXPECT_EQ(c[2].position.y, parse_rational("1e4096"));
  EXPECT_EQ(c[2].normal.x, 0);
  EXPECT_EQ(c[2].normal.y, parse_rational("5e-324"));
  EXPECT_EQ(file.loaded().wrench.x, Rational(3, 2));
  EXPECT_EQ(file.loaded().wrench.y, parse_rational("0.3333333333333333333333333333333333"));
  EXPECT_EQ(file.loaded().wrench.torque, Rational(-5, 2));
}

TEST(ReadGrasp, ContactsOnTheOutline) {
  const GraspFile frame = read_good("outline");
  const std::vector<Contact>& c = frame.loaded().grasp.contacts();
  const Rational half(1, 2);
  ASSERT_EQ(c.size(), 5U);
  EXPECT_TRUE(same(c[0], {{2, 0}, {0, 1}, half, 1, 1}));
  EXPECT_TRUE(same(c[1], {{3, 3}, {0, -1}, half, 1, 1}));
  EXPECT_TRUE(same(c[2], {{2, 1}, {0, -1}, half, 1, 1}));  // in the hole
  EXPECT_TRUE(same(c[3], {{1, 1}, {-1, 0}, half, 1, 1}));
  EXPECT_TRUE(same(c[4], {{0, 1}, {1, 0}, half, 1, 1}));
  const std::vector<Contact> d = read_good("outlines").loaded().grasp.contacts();
  ASSERT_EQ(d.size(), 2U);
  EXPECT_TRUE(same(d[0], {{Rational(4, 3), 2}, {Rational(-3, 5), Rational(-4, 5)}, 1, 1, 2}));
  EXPECT_TRUE(same(d[1], {{Rational(11, 2), half}, {-1, -1}, 0, 1, 0}));  // not scaled
}

TEST(ReadGrasp, OutlinesAsTheyAreWritten) {
  const auto outline_of = [](const std::string& name) {
    return read_good(name).loaded().grasp.description().outline;
  };
  const Ring square{{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  const Ring hole{{1, 1}, {3, 1}, {3, 2}, {1, 2}};
  EXPECT_EQ(outline_of("outline"), (std::vector<Polygon>{Polygon{square, hole}}));
  EXPECT_EQ(outline_of("outlines"),
            (std::vector<Polygon>{Polygon{Ring{{0, 0}, {0, 3}, {4, 0}}},
                                  Polygon{Ring{{5, 0}, {6, 0}, {5, 1}}}}));
  EXPECT_EQ(outline_of("ring"),
            (std::vector<Polygon>{Polygon{Ring{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}}));
  EXPECT_TRUE(outline_of("fig1").empty());
}

TEST(ReadGrasp, Units) {
  const GraspFile file = read_good("units");
  EXPECT_EQ(file.loaded().grasp.description().units, (Units{"\u00b5m", "kN"}));
  EXPECT_EQ(file.loaded().grasp.description().units->torque(), "kN \u00b5m");
  EXPECT_EQ(write_grasp(file.content),
            "{\"format\": \"stickslip-grasp/2\",\n"
            " \"units\": {\"length\": \"\u00b5m\", \"force\": \"kN\"},\n"
            " \"contacts\": [],\n \"wrench\": [0, 0, 0]}\n");
  EXPECT_EQ(read_good("fig1").loaded().grasp.description().units, std::nullopt);
}

TEST(ReadGrasp, LoadsAreSummedExactly) {
  // (0, -10) at (1, 2), (3, -4) at (0, 1), (1, -2) at (3, 4/3), and the torque 1/3.
  EXPECT_EQ(read_good("loads").loaded().wrench, (Wrench{4, -16, -20}));
  EXPECT_TRUE(read_good("loads").cases.empty());
}

TEST(ReadGrasp, CasesHaveTheCommonLoad) {
  const GraspFile file = read_good("cases");
  EXPECT_EQ(file.loaded().wrench, (Wrench{0, -10, -20}));
  ASSERT_EQ(file.cases.size(), 3U);
  EXPECT_EQ(file.cases[0].name, "at rest");
  EXPECT_EQ(file.cases[0].wrench, box_of(Wrench{0, -10, -20}));
  EXPECT_EQ(file.cases[1].name, "pushed");
  EXPECT_EQ(file.cases[1].wrench, box_of(Wrench{Rational(3, 2), -10, Rational(-49, 2)}));
  EXPECT_EQ(file.cases[2].name, "lifted");
  EXPECT_EQ(file.cases[2].wrench, box_of(Wrench{0, 1, -19}));
}

TEST(ReadGrasp, DefaultsYieldToTheContactAndMayComeLast) {
  const Contact c = read_good("late_defaults").loaded().grasp.contacts()[0];
  EXPECT_EQ(c.friction, 0);
  EXPECT_EQ(c.stiffness, 1);
  EXPECT_EQ(c.preload, 0);
  const GraspFile file = parse_grasp(
      R"({"format": "stickslip-grasp/1", "wrench": [0, 0, 0],
          "defaults": {"friction": 1, "stiffness": 2, "preload": 3},
          "contacts": [{"position": [0, 0], "normal": [1, 0], "friction": 4},
                       {"position": [0, 0], "normal": [1, 0], "stiffness": 5, "preload": 0}]})",
      "");
  EXPECT_TRUE(same(file.loaded().grasp.contacts()[0], {{0, 0}, {1, 0}, 4, 2, 3}));
  EXPECT_TRUE(same(file.loaded().grasp.contacts()[1], {{0, 0}, {1, 0}, 1, 5, 0}));
}

TEST(ReadGrasp, NoContactAtAll) {
  EXPECT_EQ(read_good("no_contact").loaded().grasp.size(), 0U);
}

TEST(ReadGrasp, NamesInAnyScript) {
  EXPECT_EQ(read_good("unicode_name").loaded().grasp.name(),
            "Gr\u00fc\u00dfe \"\\\n\U0001f916 \u00e9");
}

/// A program around the library may have set a locale with a decimal comma.
TEST(ReadGrasp, IgnoresTheLocale) {
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  if (std::setlocale(LC_NUMERIC, "de_DE.UTF-8") == nullptr) GTEST_SKIP() << "no de_DE locale";
  const Rational x = read_good("exact_numbers").loaded().grasp.contacts()[0].position.x;
  std::setlocale(LC_NUMERIC, before.c_str());
  EXPECT_EQ(x, Rational(1, 10));
}

TEST(ReadGrasp, StandardInput) {
  std::istringstream text(write_grasp(read_good("fig4").loaded()));
  std::streambuf* const before = std::cin.rdbuf(text.rdbuf());
  const GraspFile file = read_grasp_file("-");
  std::cin.rdbuf(before);
  expect_same(file.loaded(), read_good("fig4").loaded());
}

TEST(ReadGrasp, ManyContacts) {
  std::string text = R"({"format": "stickslip-grasp/1", "wrench": [0, 0, 0], "contacts": [)";
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    text += (i == 0 ? "" : ",") + std::string(R"({"position": [)") + std::to_string(i) +
            R"(, 0.5], "normal": [1, 0], "friction": 1})";
  }
  const GraspFile file = parse_grasp(text + "]}", "");
  ASSERT_EQ(file.loaded().grasp.size(), static_cast<std::size_t>(kCount));
  EXPECT_EQ(file.loaded().grasp.contacts().back().position,
            (Vector2{kCount - 1, Rational(1, 2)}));
}

TEST(WriteGrasp, Bytes) {
  EXPECT_EQ(write_grasp(read_good("fig1").loaded()),
            R"({"format": "stickslip-grasp/1",
 "name": "fig1",
 "contacts": [
  {"position": [-1, 0], "normal": [1, 0], "friction": "1/2", "stiffness": 1, "preload": 1},
  {"position": [0, -1], "normal": [0, 1], "friction": "1/2", "stiffness": 1, "preload": 1},
  {"position": [1, 0], "normal": [-1, 0], "friction": "1/2", "stiffness": 1, "preload": 1}],
 "wrench": [0, "-11/10", 0]}
)");
  EXPECT_EQ(write_grasp(LoadedGrasp{}),
            "{\"format\": \"stickslip-grasp/1\",\n \"contacts\": [],\n"
            " \"wrench\": [0, 0, 0]}\n");
}

TEST(WriteGrasp, CasesWithoutWhatIsCommon) {
  EXPECT_EQ(write_grasp_file(read_good("cases")),
            R"({"format": "stickslip-grasp/2",
 "name": "shelf",
 "contacts": [
  {"position": [0, 0], "normal": [0, 1], "friction": "1/2", "preload": 0},
  {"position": [4, 0], "normal": [0, 1], "friction": "1/2", "preload": 0}],
 "wrench": [0, -10, -20],
 "cases": [
  {"name": "at rest", "wrench": [0, 0, 0]},
  {"name": "pushed", "wrench": ["3/2", 0, "-9/2"]},
  {"name": "lifted", "wrench": [0, 11, 1]}]}
)");
}

TEST(WriteGrasp, Outlines) {
  EXPECT_EQ(write_grasp(read_good("outlines").loaded()),
            R"({"format": "stickslip-grasp/2",
 "name": "two triangles",
 "outline": [[[[0, 0], [0, 3], [4, 0]]],
  [[[5, 0], [6, 0], [5, 1]]]],
 "contacts": [
  {"position": ["4/3", 2], "normal": ["-3/5", "-4/5"], "friction": 1, "stiffness": 1, "preload": 2},
  {"position": ["11/2", "1/2"], "normal": [-1, -1], "friction": 0, "stiffness": 1, "preload": 0}],
 "wrench": [0, 0, 0]}
)");
}

TEST(WriteGrasp, AssumedStiffnessesStayAssumed) {
  const GraspFile file = parse_grasp(
      R"({"format": "stickslip-grasp/1", "wrench": [0, 0, 0], "defaults": {"friction": 1},
          "contacts": [{"position": [0, 0], "normal": [1, 0]},
                       {"position": [0, 0], "normal": [1, 0], "stiffness": 1},
                       {"position": [0, 0], "normal": [1, 0]}]})",
      "");
  ASSERT_EQ(file.assumed_stiffness, (std::vector<ContactId>{ContactId(0), ContactId(2)}));
  const GraspFile again = parse_grasp(write_grasp_file(file), "");
  EXPECT_EQ(again.assumed_stiffness, file.assumed_stiffness);
  expect_same(again.loaded(), file.loaded());
  EXPECT_TRUE(parse_grasp(write_grasp(file.content), "").assumed_stiffness.empty());
}

TEST(WriteGrasp, IntegersThatADoubleWouldRoundAreStrings) {
  const Integer limit = Integer(1) << 53;
  const std::string text = write_grasp({Grasp(), {limit - 1, -limit, Rational(1 - limit)}});
  EXPECT_THAT(text, ::testing::HasSubstr(
                        R"([9007199254740991, "-9007199254740992", -9007199254740991])"));
}

TEST(WriteGrasp, RoundTripsRandomGrasps) {
  Random random(41);
  for (int i = 0; i < 300; ++i) {
    std::vector<Contact> contacts = random.contacts(random.integer(0, 6));
    for (Contact& c : contacts) {
      c.position = {random.big(50), random.big(50)};
      c.preload = rational_from_double(1.0 / (1 + random.integer(0, 1000)));
    }
    std::string name;
    for (int k = random.integer(0, 8); k > 0; --k) {
      name += static_cast<char>(random.integer(0, 127));  // control characters, quotes, ...
    }
    const LoadedGrasp content{Grasp(contacts, name), random.wrench()};
    expect_same(parse_grasp(write_grasp(content), "random").loaded(), content);
  }
}

TEST(WriteGrasp, RefusesWhatAFileCannotHold) {
  EXPECT_THROW(write_grasp({Grasp({}, "\xff"), {}}), InputError);
  const Rational huge(stickslip::pow(Integer(10), kMaxNumberLength));
  EXPECT_THROW(write_grasp({Grasp(), {huge, 0, 0}}), InputError);
}

}  // namespace
}  // namespace stickslip
