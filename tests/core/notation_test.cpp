// SPDX-License-Identifier: GPL-3.0-or-later
// Masses, gravity, frictions by name, and angles. What is refused is in refused.txt of the
// corpus, and grasp_corpus_test.cpp asks the checkers about the same pairs.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "core/src/angle.hpp"
#include "stickslip/core/grasp_file.hpp"

namespace stickslip {
namespace {

using core_detail::direction_at;

TEST(Notation, SaysTheSameAsPlainFiles) {
  std::ifstream pairs(STICKSLIP_GRASP_CORPUS "/notation.txt");
  const std::string separator = " || ";
  std::size_t count = 0;
  for (std::string line; std::getline(pairs, line);) {
    if (line[0] == '#') continue;
    const std::size_t at = line.find(separator);
    ASSERT_NE(at, std::string::npos) << line;
    const std::string text = line.substr(0, at);
    const std::string plain = line.substr(at + separator.size());
    EXPECT_EQ(write_grasp_file(parse_any_grasp(text, "new")),
              write_grasp_file(parse_any_grasp(plain, "plain")))
        << line;
    ++count;
  }
  EXPECT_GE(count, 10u);
}

TEST(Notation, TellsWhatWasAssumedAndRounded) {
  const auto described = [](const std::string& rest) {
    return parse_any_grasp(R"({"format": "stickslip-grasp/2", "defaults": {"friction": 1}, )" +
                               rest + "}",
                           "")
        .description();
  };
  using Row = std::vector<Rational>;
  const Rational usual(-981, 100);
  EXPECT_EQ(described(R"("contacts": [], "loads": [{"weight": 1, "at": [0, 0]}])").gravity, Row());
  EXPECT_EQ(described(R"("contacts": [], "loads": [{"mass": 1, "at": [0, 0]}])").gravity,
            (Row{0, usual}));
  EXPECT_EQ(described(R"("contacts": [], "cases": [{"name": "a", "loads":
                         [{"mass": 1, "at": [0, 0]}]}], "gravity": [1, 2])")
                .gravity,
            (Row{1, 2}));
  EXPECT_EQ(described(R"("contacts": [{"position": [0, 0, 0], "normal": [0, 0, 1]}],
                         "loads": [{"mass": 1, "at": [0, 0, 0]}])")
                .gravity,
            (Row{0, 0, usual}));
  const auto rounded = described(R"("wrench": [0, 0, 0], "contacts": [
      {"position": [0, 0], "normal": {"angle": 45}},
      {"position": [0, 0], "normal": {"angle": 44.9}},
      {"position": [0, 0], "normal": {"angle": 270}},
      {"position": [0, 0], "normal": {"angle": -1, "slope": 0.1}}])")
                           .rounded_normals;
  ASSERT_EQ(rounded.size(), 2u);
  EXPECT_EQ(rounded[0].contact, ContactId(1));
  EXPECT_EQ(rounded[0].degrees, Rational(449, 10));
  EXPECT_EQ(rounded[1].contact, ContactId(3));
}

TEST(Notation, AnglesAreNearTheirDirections) {
  const double pi = std::acos(-1.0);
  for (int k = -7300; k <= 7300; ++k) {
    const Rational degrees(k, 10);
    const auto [n, is_rounded] = direction_at(degrees);
    ASSERT_EQ(is_rounded, k % 450 != 0) << degrees;
    const Rational square = n.x * n.x + n.y * n.y;
    ASSERT_EQ(square, k % 450 == 0 && k % 900 != 0 ? 2 : 1) << degrees;
    const double length = std::sqrt(to_double(square));
    const double angle = k * pi / 1800;
    ASSERT_LT(std::hypot(to_double(n.x) / length - std::cos(angle),
                         to_double(n.y) / length - std::sin(angle)),
              1e-9)
        << degrees;
    const Vector2 turned = direction_at(degrees + 90).vector;
    ASSERT_EQ(turned, (Vector2{-n.y, n.x})) << degrees;
  }
  // Between directions that were rounded alike there may be any number of digits.
  EXPECT_EQ(direction_at(parse_rational("1e-30")).vector, (Vector2{1, 0}));
  EXPECT_TRUE(direction_at(parse_rational("1e-30")).is_rounded);
  EXPECT_EQ(direction_at(parse_rational("36e4000")).vector, (Vector2{1, 0}));
}

}  // namespace
}  // namespace stickslip
