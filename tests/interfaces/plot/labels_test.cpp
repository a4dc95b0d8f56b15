// SPDX-License-Identifier: GPL-3.0-or-later
#include "interfaces/plot/labels.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace stickslip {

using namespace plot_detail;
namespace {

std::string joined(const std::vector<std::string>& lines, const std::string& by) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : by) + line;
  return text;
}

TEST(Labels, WidthsDependOnTextAndClass) {
  EXPECT_EQ(text_width("", ""), 0);
  EXPECT_LT(text_width("", "ill"), text_width("", "WWW"));
  EXPECT_LT(text_width("small", "0.5"), text_width("", "0.5"));
  EXPECT_LT(text_width("", "g"), text_width("title", "g"));
  // A character of more than one byte is one character.
  EXPECT_LT(text_width("", "\u4e2d"), text_width("", "WW"));
}

TEST(Labels, BoxesHangOnTheirAnchor) {
  const double width = text_width("", "abc");
  EXPECT_EQ(text_box({10, 20}, "", "abc").low.x, 10);
  EXPECT_EQ(text_box({10, 20}, "end", "abc").high.x, 10);
  EXPECT_NEAR(text_box({10, 20}, "middle halo", "abc").low.x, 10 - width / 2, 1e-9);
  EXPECT_LT(text_box({10, 20}, "", "abc").low.y, 20);
  EXPECT_GT(text_box({10, 20}, "", "abc").high.y, 20);
}

TEST(Labels, WrapKeepsEveryCharacterAndTheWidth) {
  const std::string text =
      "a caption of some words, and averyveryverylongword \u00e9\u00e9\u00e9";
  for (const double width : {20.0, 60.0, 100.0, 1000.0}) {
    const std::vector<std::string> lines = wrap(text, "", width);
    for (const std::string& line : lines) EXPECT_LE(text_width("", line), width) << line;
    std::string all = joined(lines, "");
    std::string given = text;
    for (std::string* s : {&all, &given}) {
      s->erase(std::remove(s->begin(), s->end(), ' '), s->end());
    }
    EXPECT_EQ(all, given);
  }
  EXPECT_EQ(joined(wrap(text, "", 1000), "|"), text);
  EXPECT_EQ(joined(wrap("one two", "", text_width("", "one tw")), "|"), "one|two");
  EXPECT_EQ(joined(wrap("at (1, 2)", "", text_width("", "at (1, ")), "|"), "at|(1, 2)");
  EXPECT_TRUE(wrap("", "", 10).empty());
}

TEST(Labels, FitCutsBetweenCharacters) {
  EXPECT_EQ(fit("abc", "", 1000), "abc");
  EXPECT_EQ(fit("\u00e9\u00e9\u00e9", "", text_width("", "\u00e9\u2026")), "\u00e9\u2026");
  EXPECT_EQ(fit("abc", "", 0), "\u2026");
}

TEST(LabelPlacer, TakesTheCheapestFreePlaceInTheFrame) {
  Svg svg(100, 100, "", "");
  LabelPlacer labels({{0, 0}, {100, 100}});
  const LabelPlace out{{1, 50}, 0};
  const LabelPlace dear{{70, 50}, 3};
  const LabelPlace cheap{{30, 50}, 1};
  EXPECT_FALSE(labels.place(svg, "", "a", {out}));
  EXPECT_TRUE(labels.place(svg, "", "a", {out, dear, cheap}));
  EXPECT_FALSE(labels.place(svg, "", "b", {cheap}));
  EXPECT_TRUE(labels.place(svg, "", "b", {cheap, dear}));
  EXPECT_FALSE(labels.place(svg, "", "c", {cheap, dear}));
  const std::string text = svg.finish();
  EXPECT_NE(text.find("<text class=\" middle\" x=\"30\""), std::string::npos);
  EXPECT_EQ(text.find(">c<"), std::string::npos);
}

TEST(LabelPlacer, AvoidsInkWhereItCan) {
  Svg svg(100, 100, "", "");
  LabelPlacer labels({{0, 0}, {100, 100}});
  labels.avoid({0, 20}, {100, 20});
  EXPECT_TRUE(labels.place(svg, "", "a", {{{50, 20}, 0}, {{50, 60}, 1}}));
  EXPECT_NE(svg.finish().find("x=\"50\" y=\"6"), std::string::npos);
}

TEST(Box, LinesThroughIt) {
  const Box box{{0, 0}, {10, 4}};
  EXPECT_TRUE(crosses({-5, 2}, {15, 2}, box));
  EXPECT_TRUE(crosses({5, -5}, {5, 20}, box));
  EXPECT_TRUE(crosses({1, 1}, {2, 2}, box));  // inside
  EXPECT_TRUE(crosses({-1, 3}, {3, 7}, {{0, 0}, {10, 5}}));
  EXPECT_FALSE(crosses({-2, 3}, {2, 7}, box));    // past the corner
  EXPECT_FALSE(crosses({-5, 2}, {-1, 2}, box));   // ends before it
  EXPECT_FALSE(crosses({-5, 4}, {15, 4}, box));   // touches it
  EXPECT_FALSE(crosses({10, -5}, {10, 9}, box));  // likewise
}

TEST(LabelPlacer, NoLabelCoversWhatIsKeptOff) {
  Svg svg(100, 100, "t", "");
  LabelPlacer labels({{0, 0}, {100, 100}});
  labels.keep_off({0, 50}, {100, 50});
  EXPECT_FALSE(labels.place(svg, "", "a", {{{50, 50}, 0}}));
  EXPECT_TRUE(labels.place(svg, "", "a", {{{50, 50}, 0}, {{50, 20}, 99}}));
  // On the near side of it, though that is dearer.
  const InkPoint anchor{20, 60};
  EXPECT_TRUE(labels.place(svg, "", "b", {{{20, 40}, 0}, {{20, 80}, 3}}, &anchor));
  EXPECT_FALSE(labels.place(svg, "", "c", {{{20, 80}, 0}}));
}

TEST(LabelPlacer, ALineLeadsFromAfarAndIsNotCovered) {
  Svg svg(200, 200, "", "");
  LabelPlacer labels({{0, 0}, {200, 200}});
  const InkPoint anchor{20, 100};
  EXPECT_TRUE(labels.place(svg, "", "a", {{{150, 100}, 0}}, &anchor));
  EXPECT_FALSE(labels.place(svg, "", "b", {{{80, 100}, 0}}));
  EXPECT_TRUE(labels.place(svg, "", "b", {{{30, 80}, 0}}, &anchor));
  const std::string text = svg.finish();
  EXPECT_NE(text.find("leader"), std::string::npos);
  EXPECT_EQ(text.find("leader"), text.rfind("leader"));
}

TEST(LabelPlacer, PlacesInsideOfAPolygonAreInside) {
  const std::vector<InkPoint> triangle{{0, 0}, {100, 0}, {0, 100}};
  const std::vector<LabelPlace> places = places_inside(triangle, "", "ab");
  EXPECT_FALSE(places.empty());
  const double half = text_width("", "ab") / 2;
  for (const LabelPlace& place : places) {
    EXPECT_GE(place.middle.x - half, -1e-9);
    EXPECT_LE(place.middle.x + half + place.middle.y, 100);
  }
  EXPECT_TRUE(places_inside(triangle, "", "a text that is longer than the triangle").empty());
  EXPECT_TRUE(places_inside({}, "", "a").empty());
}

}  // namespace
}  // namespace stickslip
