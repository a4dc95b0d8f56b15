// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/svg.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

constexpr const char* kReplacement = "\uFFFD";

TEST(SvgNumber, HasAtMostTwoDecimalsAndNoMinusZero) {
  EXPECT_EQ(svg_number(0), "0");
  EXPECT_EQ(svg_number(-0.0), "0");
  EXPECT_EQ(svg_number(-0.004), "0");
  EXPECT_EQ(svg_number(12), "12");
  EXPECT_EQ(svg_number(100), "100");
  EXPECT_EQ(svg_number(12.5), "12.5");
  EXPECT_EQ(svg_number(-1.006), "-1.01");
  EXPECT_EQ(svg_number(2.0 / 3), "0.67");
  EXPECT_EQ(svg_number(1e-300), "0");
  EXPECT_EQ(svg_number(1e9), "1000000000");
}

TEST(SvgNumber, RefusesWhatIsNoPlace) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity(), 1.1e9}) {
    EXPECT_THROW(svg_number(bad), ContractError);
  }
}

TEST(SvgEscape, Markup) {
  EXPECT_EQ(svg_escape("<&\">'"), "&lt;&amp;&quot;&gt;'");
  EXPECT_EQ(svg_escape("]]>"), "]]&gt;");
  EXPECT_EQ(svg_escape("a\tb\nc"), "a b c");
  EXPECT_EQ(svg_escape(""), "");
}

TEST(SvgEscape, EveryByteAlone) {
  for (int byte = 0; byte < 256; ++byte) {
    const std::string text(1, static_cast<char>(byte));
    const std::string escaped = svg_escape(text);
    const bool is_blank = byte == '\t' || byte == '\n';
    if (byte >= 0x80 || (byte < 0x20 && !is_blank)) {
      EXPECT_EQ(escaped, kReplacement) << byte;
    } else if (is_blank) {
      EXPECT_EQ(escaped, " ");
    } else if (std::string("<>&\"").find(text) == std::string::npos) {
      EXPECT_EQ(escaped, text);
    }
  }
}

/// Every code point, against the definition of Char in XML 1.0.
TEST(SvgEscape, EveryCodePoint) {
  for (unsigned code = 0x80; code <= 0x110000; ++code) {
    std::string text;
    if (code < 0x800) {
      text = {static_cast<char>(0xC0 | code >> 6)};
    } else if (code < 0x10000) {
      text = {static_cast<char>(0xE0 | code >> 12), static_cast<char>(0x80 | (code >> 6 & 63))};
    } else {
      text = {static_cast<char>(0xF0 | code >> 18), static_cast<char>(0x80 | (code >> 12 & 63)),
              static_cast<char>(0x80 | (code >> 6 & 63))};
    }
    text += static_cast<char>(0x80 | (code & 63));
    const bool is_char = code <= 0xD7FF || (code >= 0xE000 && code <= 0xFFFD) ||
                         (code >= 0x10000 && code <= 0x10FFFF);
    const std::string escaped = svg_escape(text);
    if (is_char) {
      ASSERT_EQ(escaped, text) << code;
    } else {
      ASSERT_EQ(escaped.find(kReplacement), 0U) << code;
    }
    // Cut short, it is no character.
    ASSERT_EQ(svg_escape(text.substr(0, text.size() - 1)).find(kReplacement), 0U) << code;
  }
}

TEST(SvgEscape, OverlongFormsAreBroken) {
  EXPECT_EQ(svg_escape("\xC0\xBC"), std::string(kReplacement) + kReplacement);
  EXPECT_EQ(svg_escape("\xE0\x80\xBC").find('<'), std::string::npos);
  EXPECT_EQ(svg_escape("\xE0\x9F\xBF").find(kReplacement), 0U);
  EXPECT_EQ(svg_escape("\xF0\x8F\xBF\xBF").find(kReplacement), 0U);
}

TEST(SvgPath, Data) {
  EXPECT_EQ(SvgPath().move({1, 2}).line({3, 4.5}).close().data(), "M1 2L3 4.5Z");
  EXPECT_EQ(SvgPath().polyline({{0, 0}, {1, 0}}).data(), "M0 0L1 0");
  EXPECT_EQ(SvgPath().polygon({{0, 0}, {1, 0}, {0, 1}}).data(), "M0 0L1 0L0 1Z");
  EXPECT_TRUE(SvgPath().polygon({}).polyline({}).empty());
}

TEST(Svg, NestsAndEscapes) {
  Svg svg(10, 20, "<t>", ".stickslip a { fill: none }\n");
  svg.open("g", {{"class", "\"x\""}});
  svg.text({1, 2}, "c", "a < b");
  svg.path(SvgPath().move({0, 0}), "p", {{"data-state", "+-"}}, "tip & top");
  svg.close();
  const std::string text = svg.finish();
  EXPECT_NE(text.find("<title>&lt;t&gt;</title>"), std::string::npos);
  EXPECT_NE(text.find("<g class=\"&quot;x&quot;\">"), std::string::npos);
  EXPECT_NE(text.find("<text class=\"c\" x=\"1\" y=\"2\">a &lt; b</text>"), std::string::npos);
  EXPECT_NE(text.find("<path class=\"p\" data-state=\"+-\" d=\"M0 0\">"
                      "<title>tip &amp; top</title></path>"),
            std::string::npos);
  EXPECT_EQ(text.substr(text.size() - 7), "</svg>\n");
}

TEST(Svg, ElementsMustBeClosed) {
  Svg svg(1, 1, "", "");
  svg.open("g");
  EXPECT_THROW(svg.finish(), ContractError);
  Svg other(1, 1, "", "");
  other.finish();
  EXPECT_THROW(other.close(), ContractError);
}

}  // namespace
}  // namespace stickslip
