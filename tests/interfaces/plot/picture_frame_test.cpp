// SPDX-License-Identifier: GPL-3.0-or-later
#include "interfaces/plot/picture_frame.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "interfaces/plot/grasp_scene.hpp"

namespace stickslip {

using namespace plot_detail;
namespace {

Grasp grasp_at(const std::vector<Vector2>& positions) {
  std::vector<Contact> contacts;
  for (const Vector2& p : positions) contacts.push_back({p, {0, 1}});
  return Grasp(std::move(contacts));
}

/// 1, 2 or 5 times a power of ten.
bool is_round(Rational value) {
  while (value >= 10) value /= 10;
  while (value < 1) value *= 10;
  return value == 1 || value == 2 || value == 5;
}

TEST(RoundDown, IsTheLargestRoundNumberNotAbove) {
  EXPECT_EQ(round_down(1), 1);
  EXPECT_EQ(round_down(Rational(1999, 1000)), 1);
  EXPECT_EQ(round_down(2), 2);
  EXPECT_EQ(round_down(Rational(99, 20)), 2);
  EXPECT_EQ(round_down(5), 5);
  EXPECT_EQ(round_down(Rational(999999, 100000)), 5);
  EXPECT_EQ(round_down(10), 10);
  for (int numerator = 1; numerator < 130; ++numerator) {
    for (const int denominator : {1, 7, 10, 99, 100, 101, 9999}) {
      const Rational value(numerator, denominator);
      const Rational rounded = round_down(value);
      EXPECT_TRUE(is_round(rounded)) << value;
      EXPECT_LE(rounded, value);
      EXPECT_GT(rounded * Rational(5, 2), value);  // 2.5 is the largest step
    }
  }
}

TEST(RoundDown, BeyondTheRangeOfDoubles) {
  const Rational huge = parse_rational("3e4000");
  EXPECT_EQ(round_down(huge), parse_rational("2e4000"));
  EXPECT_EQ(round_down(1 / huge), parse_rational("2e-4001"));
}

TEST(ShortText, IsExactWhileShort) {
  EXPECT_EQ(short_text(Rational(3, 5)), "3/5");
  EXPECT_EQ(short_text(Rational(-3, 5)), "\u22123/5");
  EXPECT_EQ(short_tuple({0, -1, Rational(1, 2)}), "(0, \u22121, 1/2)");
  const std::string third = short_text(parse_rational("0.33333333333333333333"));
  EXPECT_EQ(third, "~0.333333");
  EXPECT_LT(short_text(parse_rational("-3e4000")).size(), 30U);
}

TEST(PointLabels, AreSpelledAlikeInOnePicture) {
  using Labels = std::vector<std::string>;
  EXPECT_EQ(point_labels({{Rational(-8, 3), 2}, {Rational(1, 2), 0}}),
            (Labels{"(\u22128/3, 2)", "(1/2, 0)"}));
  EXPECT_EQ(point_labels({{Rational(-8, 3), 2}, {Rational(1, 2), 0}, {Rational(100, 17), 7}}),
            (Labels{"~(\u22122.667, 2)", "(0.5, 0)", "~(5.882, 7)"}));
  EXPECT_EQ(point_labels({{parse_rational("99995e-5"), parse_rational("123456e400")}}),
            (Labels{"~(1, 1.235e405)"}));
}

TEST(PictureFrame, ContactsLieInTheUnitSquare) {
  const std::vector<std::vector<Vector2>> worlds = {
      {},
      {{0, 0}},
      {{5, -7}},
      {{5, -7}, {5, -7}},
      {{-1, 0}, {0, -1}, {1, 0}},
      {{1000, 1000}, {1001, 1000}},
      {{parse_rational("1e4096"), 0}, {0, parse_rational("1e-4096")}},
  };
  for (const auto& positions : worlds) {
    const Grasp grasp = grasp_at(positions);
    const PictureFrame frame = picture_frame(grasp);
    EXPECT_GT(frame.radius, 0);
    const Grasp scene = frame.in_scene(grasp);
    for (std::size_t i = 0; i < grasp.size(); ++i) {
      const Vector2& exact = scene.contacts()[i].position;
      EXPECT_LE(largest_entry(exact), 1);
      const InkPoint ink = frame.place(positions[i]);
      EXPECT_EQ(ink.x, to_double(exact.x));
      EXPECT_EQ(ink.y, to_double(exact.y));
    }
  }
}

TEST(PictureFrame, TheOriginIsTheCentreUnlessFarAway) {
  EXPECT_EQ(picture_frame(grasp_at({{-1, 0}, {0, -1}, {1, 0}})).centre, (Vector2{0, 0}));
  EXPECT_EQ(picture_frame(grasp_at({{-1, -1}, {1, -1}})).centre, (Vector2{0, 0}));
  EXPECT_EQ(picture_frame(grasp_at({{5, -7}})).centre, (Vector2{0, 0}));
  EXPECT_EQ(picture_frame(grasp_at({{99, 0}, {101, 0}})).centre, (Vector2{100, 0}));
}

TEST(BodyOutline, TouchesTheContactsOfAConvexBody) {
  const Grasp grasp(std::vector<Contact>{
      {{-1, 0}, {1, 0}}, {{0, -1}, {0, 1}}, {{1, 0}, {-1, 0}}, {{0, 1}, {0, -1}}});
  const PictureFrame frame = picture_frame(grasp);
  const std::vector<ContactInk> contacts = contact_ink(grasp, frame);
  const auto rings = body_outline(grasp, frame, contacts);
  ASSERT_EQ(rings.size(), 1U);
  const std::vector<InkPoint>& outline = rings[0];
  double twice_area = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const InkPoint a = outline[i];
    const InkPoint b = outline[(i + 1) % outline.size()];
    twice_area += a.x * b.y - a.y * b.x;
    EXPECT_LE(std::max(std::abs(a.x), std::abs(a.y)), 1);
  }
  EXPECT_GT(twice_area, 2);
  for (const ContactInk& c : contacts) {
    EXPECT_TRUE(std::any_of(outline.begin(), outline.end(),
                            [&](InkPoint p) { return length(p - c.at) == 0; }));
  }
  EXPECT_TRUE(body_outline(Grasp(), picture_frame(Grasp()), {}).empty());
}

TEST(BodyOutline, IsTheOneThatWasGiven) {
  const Polygon square{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}},
                       {{0, 0}, {0, Rational(1, 2)}, {Rational(1, 2), 0}}};
  const Grasp grasp(std::vector<Contact>{{{-1, 0}, {1, 0}}},
                    GraspDescription{"", {square}, {}});
  const PictureFrame frame = picture_frame(grasp);
  const auto rings = body_outline(grasp, frame, contact_ink(grasp, frame));
  ASSERT_EQ(rings.size(), 2U);
  for (std::size_t k = 0; k < rings.size(); ++k) {
    ASSERT_EQ(rings[k].size(), square[k].size());
    for (std::size_t i = 0; i < rings[k].size(); ++i) {
      EXPECT_EQ(length(rings[k][i] - frame.place(square[k][i])), 0);
    }
  }
}

}  // namespace
}  // namespace stickslip
