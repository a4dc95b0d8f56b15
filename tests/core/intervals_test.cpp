// SPDX-License-Identifier: GPL-3.0-or-later
// Uncertain numbers of grasp files: read and written where they are taken, refused elsewhere.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "error_of.hpp"
#include "random_numbers.hpp"
#include "stickslip/core/grasp_file.hpp"

namespace stickslip {
namespace {

using ::testing::HasSubstr;
using testing::Random;

const std::string kFolder = STICKSLIP_GRASP_CORPUS "/uncertain/";

GraspFile read_uncertain(const std::string& name) {
  return read_grasp_file(kFolder + name, Intervals::kAllowed);
}

/// How a reader that takes no intervals refuses the text.
InputError refusal_of(const std::string& text) {
  return test::error_of([&] { parse_grasp(text, "f"); });
}

/// A file with this contact and wrench.
std::string file_with(const std::string& contact, const std::string& wrench = "[0, 0, 0]",
                      const std::string& more = "") {
  return R"({"format": "stickslip-grasp/2", "contacts": [{"position": [0, 0], "normal": [1, 0], )"
         R"("friction": 1}, {)" +
         contact + R"(}], "wrench": )" + wrench + more + "}";
}

const std::string kRest = R"("position": [0, 0], "normal": [1, 0], )";

TEST(Intervals, AreRead) {
  const GraspFile file = read_uncertain("all.json");
  const GraspBox* box = file.content.box();
  ASSERT_NE(box, nullptr);
  const std::vector<UncertainContact>& c = box->contacts;
  ASSERT_EQ(c.size(), 3U);
  const Interval friction{Rational(2, 5), Rational(3, 5)};
  EXPECT_EQ(c[0].position[0], point_interval(-2));
  EXPECT_EQ(c[0].position[1], (Interval{Rational(-1, 10), Rational(1, 10)}));
  EXPECT_EQ(c[0].normal, (RationalRow{3, 4}));
  EXPECT_EQ(c[0].slope, Rational(7, 400));
  EXPECT_EQ(c[0].friction, friction);
  EXPECT_EQ(c[0].stiffness, (Interval{1, 2}));
  EXPECT_EQ(c[0].preload, (Interval{0, Rational(1, 10)}));
  // What a contact gives itself is not the default's.
  EXPECT_EQ(c[1].friction, point_interval(1));
  EXPECT_EQ(c[1].stiffness, point_interval(3));
  EXPECT_EQ(c[1].preload, point_interval(0));
  EXPECT_EQ(c[1].slope, 0);
  // On the outline position and normal are certain, the rest need not be.
  EXPECT_EQ(c[2].position[0], point_interval(0));
  EXPECT_EQ(c[2].position[1], point_interval(-2));
  EXPECT_EQ(c[2].normal, (RationalRow{0, 1}));
  EXPECT_EQ(c[2].friction, point_interval(0));
  EXPECT_EQ(c[2].stiffness, (Interval{1, 2}));
  EXPECT_EQ(box->wrench, (WrenchBox{Interval{}, Interval{-11, -10}, Interval{}}));
  EXPECT_TRUE(file.assumed_stiffness.empty());
  // The wrench of a case is the sum, end by end.
  ASSERT_EQ(file.cases.size(), 2U);
  EXPECT_EQ(file.cases[0].wrench, box->wrench);
  EXPECT_EQ(file.cases[1].wrench, (WrenchBox{Interval{-1, 1}, Interval{-11, -10}, Interval{}}));
  // The middle.
  const LoadedGrasp middle = loaded_of(box->middle());
  const Contact& first = middle.grasp.contacts()[0];
  EXPECT_EQ(first.position, (Vector2{-2, 0}));
  EXPECT_EQ(first.normal, (Vector2{3, 4}));
  EXPECT_EQ(first.friction, Rational(1, 2));
  EXPECT_EQ(first.stiffness, Rational(3, 2));
  EXPECT_EQ(first.preload, Rational(1, 20));
  EXPECT_EQ(middle.wrench, (Wrench{0, Rational(-21, 2), 0}));
}

TEST(Intervals, OfOneCaseLeaveTheOthersCertain) {
  const GraspFile file = read_uncertain("one_case.json");
  EXPECT_TRUE(file.content.single() != nullptr);
  for (const Interval& w : file.cases[0].wrench) EXPECT_TRUE(w.is_point());
  EXPECT_EQ(file.cases[1].wrench, (WrenchBox{Interval{}, Interval{-2, -1}, Interval{}}));
  EXPECT_EQ(file.assumed_stiffness, (std::vector<ContactId>{ContactId(0)}));
}

TEST(Intervals, OfOneNumberAreThatNumber) {
  const GraspFile file = parse_grasp(
      file_with(R"("position": [{"min": 1, "max": 1.0}, 0], "friction": {"max": 1, "min": 1},
                   "normal": {"direction": [3, 4], "slope": 0})"),
      "f", Intervals::kAllowed);
  ASSERT_TRUE(file.content.single() != nullptr);
  EXPECT_EQ(file.loaded().grasp.contacts()[1].position, (Vector2{1, 0}));
  EXPECT_EQ(file.loaded().grasp.contacts()[1].normal, (Vector2{3, 4}));
}

TEST(Intervals, AreWrittenAndReadBack) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    SCOPED_TRACE(entry.path());
    const std::string text = write_grasp_file(read_uncertain(entry.path().filename()));
    EXPECT_THAT(text, HasSubstr(R"({"min": )"));
    EXPECT_EQ(write_grasp_file(parse_grasp(text, "again", Intervals::kAllowed)), text);
    ++files;
  }
  EXPECT_EQ(files, 2);
  EXPECT_EQ(write_grasp_file(read_uncertain("one_case.json")),
            R"({"format": "stickslip-grasp/2",
 "contacts": [
  {"position": [0, 0], "normal": [0, 1], "friction": 1, "preload": 0}],
 "wrench": [0, 0, 0],
 "cases": [
  {"name": "a", "wrench": [0, -1, 0]},
  {"name": "b", "wrench": [0, {"min": -2, "max": -1}, 0]}]}
)");
  const std::string all = write_grasp_file(read_uncertain("all.json"));
  for (const char* part :
       {R"("position": [-2, {"min": "-1/10", "max": "1/10"}])",
        R"("normal": {"direction": [3, 4], "slope": "7/400"})",
        R"("friction": {"min": "2/5", "max": "3/5"}, "stiffness": {"min": 1, "max": 2})",
        R"("wrench": [0, {"min": -11, "max": -10}, 0])",
        R"({"name": "certain", "wrench": [0, 0, 0]})",
        R"({"name": "uncertain", "wrench": [{"min": -1, "max": 1}, 0, 0]})"}) {
    EXPECT_THAT(all, HasSubstr(part));
  }
}

TEST(Intervals, RandomOnesComeBack) {
  Random random(1717);
  const auto wide = [&](const Rational& low) {
    return Interval{low, low + abs(random.small())};
  };
  for (int i = 0; i < 200; ++i) {
    GraspBox box;
    for (int k = random.integer(0, 4); k > 0; --k) {
      const Contact c = random.contact();
      box.contacts.push_back({{wide(c.position.x), wide(c.position.y)},
                              {c.normal.x, c.normal.y},
                              wide(c.friction),
                              wide(c.stiffness),
                              wide(c.preload),
                              Rational(random.integer(0, 9), 10)});
    }
    for (int j = 0; j < 3; ++j) box.wrench.push_back(wide(random.small()));
    box.description.name = "random";
    const GraspFile file{box};
    const std::string text = write_grasp_file(file);
    const GraspFile again = parse_grasp(text, "again", Intervals::kAllowed);
    const GraspBox* read = again.content.box();
    ASSERT_EQ(read == nullptr, box.is_point());
    EXPECT_EQ(write_grasp_file(again), text);
    if (read == nullptr) continue;
    EXPECT_EQ(read->wrench, box.wrench);
    for (std::size_t j = 0; j < box.contacts.size(); ++j) {
      const UncertainContact& a = read->contacts[j];
      const UncertainContact& b = box.contacts[j];
      EXPECT_TRUE(a.position == b.position && a.normal == b.normal && a.slope == b.slope &&
                  a.friction == b.friction && a.stiffness == b.stiffness &&
                  a.preload == b.preload);
    }
  }
}

TEST(Intervals, AreRefusedUnlessAsked) {
  const struct {
    std::string text;
    const char* place;
  } files[] = {
      {file_with(kRest + R"("friction": {"min": 0, "max": 1})"), "contacts[1].friction"},
      {file_with(kRest + R"("friction": 1, "preload": {"min": 0, "max": 1})"),
       "contacts[1].preload"},
      {file_with(R"("position": [0, {"min": 0, "max": 1}], "normal": [1, 0], "friction": 1)"),
       "contacts[1].position[1]"},
      {file_with(R"("position": [0, 0], "normal": {"direction": [1, 0], "slope": 0.1}, )"
                 R"("friction": 1)"),
       "contacts[1].normal"},
      {file_with(kRest + R"("friction": 1)", R"([0, 0, {"min": 0, "max": 1}])"), "wrench[2]"},
      {file_with(kRest + R"("friction": 1)", "[0, 0, 0]",
                 R"(, "defaults": {"stiffness": {"min": 1, "max": 2}})"),
       "defaults.stiffness"},
      {file_with(kRest + R"("friction": 1)", "[0, 0, 0]",
                 R"(, "cases": [{"name": "a", "wrench": [{"min": 1, "max": 2}, 0, 0]}])"),
       "cases[0].wrench[0]"},
      // Also where it is one number: a command takes intervals or it does not.
      {file_with(kRest + R"("friction": {"min": 1, "max": 1})"), "contacts[1].friction"}};
  for (const auto& [text, place] : files) {
    EXPECT_NO_THROW(parse_grasp(text, "f", Intervals::kAllowed)) << text;
    const InputError error = refusal_of(text);
    EXPECT_EQ(error.place(), place) << text;
    EXPECT_EQ(error.file(), "f");
    EXPECT_THAT(error.problem(), HasSubstr("uncertain"));
    EXPECT_THAT(error.remedy(), HasSubstr("stickslip decide, radius and batch"));
    std::string version1 = text;
    version1[version1.find("/2") + 1] = '1';
    if (text.find("cases") != std::string::npos) continue;
    try {
      parse_grasp(version1, "f", Intervals::kAllowed);
      ADD_FAILURE() << text;
    } catch (const InputError& newer) {
      EXPECT_EQ(newer.place(), place);
      EXPECT_THAT(newer.remedy(), HasSubstr("\"stickslip-grasp/2\""));
    }
  }
}

}  // namespace
}  // namespace stickslip
