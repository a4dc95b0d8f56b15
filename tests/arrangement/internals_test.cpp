// SPDX-License-Identifier: GPL-3.0-or-later
// Packed signs, and the parts of the module that have no public header.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "assemble_states.hpp"
#include "families.hpp"
#include "filtered_normals.hpp"
#include "stickslip/arrangement/sweep.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/integer_vector.hpp"

namespace stickslip {
namespace {

using arrangement_detail::assemble_states;
using arrangement_detail::complete_counts;
using arrangement_detail::in_generic_position;
using arrangement_detail::StateList;

using Words = std::vector<PackedSigns::Word>;

/// As PackedSigns documents it: 32 digits a word, the first in the most significant bits.
Words packed(const std::string& text) {
  Words words(text.size() / 32 + 1, 0);
  for (std::size_t p = 0; p < text.size(); ++p) {
    const PackedSigns::Word digit = text[p] == '+' ? 0 : text[p] == '-' ? 1 : 2;
    words[p / 32] |= digit << (62 - 2 * (p % 32));
  }
  words.resize(PackedSigns::words_for(text.size()));
  return words;
}

// 31, 32, 33: around the number of signs in a word.
class PackedSignsOfWidth : public testing::TestWithParam<std::size_t> {};

TEST_P(PackedSignsOfWidth, ReadAsTheirText) {
  const std::size_t width = GetParam();
  test::Random random(static_cast<std::uint32_t>(width));
  for (int step = 0; step < 200; ++step) {
    std::string expected;
    while (expected.size() < width) {
      expected.push_back(to_char(sign_of_int(random.between(-1, 1))));
    }
    const Words words = packed(expected);
    const PackedSigns signs(words.data(), width);
    ASSERT_EQ(signs.size(), width);
    ASSERT_EQ(signs.word_count(), words.size());
    std::string text;
    for (std::size_t p = 0; p < width; ++p) text.push_back(to_char(signs[p]));
    ASSERT_EQ(text, expected);
    ASSERT_EQ(to_string(signs.unpack()), expected);
  }
}

TEST_P(PackedSignsOfWidth, SortAsTexts) {
  const std::size_t width = GetParam();
  test::Random random(7);
  std::vector<std::string> texts;
  std::vector<Words> rows;
  for (int i = 0; i < 300; ++i) {
    std::string text(width, '+');
    for (std::size_t p = 0; p < width; ++p) {
      // Long common prefixes, so that the later words decide.
      if (p + 4 > width) text[p] = to_char(sign_of_int(random.between(-1, 1)));
    }
    texts.push_back(text);
    rows.push_back(packed(text));
  }
  std::sort(texts.begin(), texts.end());
  std::sort(rows.begin(), rows.end());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const PackedSigns signs(rows[i].data(), width);
    EXPECT_EQ(to_string(signs.unpack()), texts[i]);
    if (i == 0) continue;
    EXPECT_EQ(PackedSigns(rows[i - 1].data(), width) == signs, texts[i - 1] == texts[i]);
  }
}

INSTANTIATE_TEST_SUITE_P(Widths, PackedSignsOfWidth,
                         testing::Values(0, 1, 3, 31, 32, 33, 64, 65, 100));

void expect_generic(const std::vector<IntegerVector3>& mapped) {
  for (std::size_t i = 0; i < mapped.size(); ++i) {
    EXPECT_NE(mapped[i][2], 0);
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(cross(mapped[i], mapped[j])[1], 0);
  }
}

Integer determinant(const IntegerVector3& a, const IntegerVector3& b, const IntegerVector3& c) {
  return dot(cross(a, b), c);
}

/// The signs of all determinants, kept or all reversed: what an arrangement depends on.
void expect_same_chirotope(const std::vector<IntegerVector3>& normals,
                           const std::vector<IntegerVector3>& mapped) {
  int orientation = 0;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        const int before = determinant(normals[i], normals[j], normals[k]).sign();
        const int after = determinant(mapped[i], mapped[j], mapped[k]).sign();
        ASSERT_EQ(before == 0, after == 0);
        if (before == 0) continue;
        if (orientation == 0) orientation = before * after;
        ASSERT_EQ(before * after, orientation);
      }
    }
  }
}

TEST(GenericPosition, AcceptedMapsKeepTheChirotope) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const std::vector<IntegerVector3> normals =
        merge_planes(test::grid_planes(10, 2, seed)).normals;
    const std::vector<IntegerVector3> mapped = in_generic_position(normals);
    ASSERT_EQ(mapped.size(), normals.size());
    expect_generic(mapped);
    expect_same_chirotope(normals, mapped);
  }
}

// Circles that pass through the pole of the first few maps tried, so that the search must go
// on: a = (1, s, s^2) is orthogonal to (0, s, -1) and to (s, -1, 0).
TEST(GenericPosition, SearchGoesOnPastBadPoles) {
  std::vector<IntegerVector3> normals;
  for (int s = 0; s < 20; ++s) {
    normals.push_back({0, s, -1});
    normals.push_back({s, -1, 0});
  }
  expect_generic(in_generic_position(normals));
}

// Vertices on the meridian of the first few maps tried: two circles that cross along a
// direction orthogonal to b = (s, st - 1, -t).
TEST(GenericPosition, SearchGoesOnPastBadMeridians) {
  const int s = 7;
  std::vector<IntegerVector3> normals;
  for (int t = 0; t < 12; ++t) {
    const IntegerVector3 b = {s, s * t - 1, -t};
    const IntegerVector3 vertex = cross(b, {1, 2, 5 + t});
    normals.push_back(cross(vertex, {3, 1, -4}));
    normals.push_back(cross(vertex, {-2, 7, 1 + t}));
  }
  expect_generic(in_generic_position(normals));
}

TEST(GenericPosition, HopelessSearchesEnd) {
  EXPECT_TRUE(in_generic_position({}).empty());
  EXPECT_THROW(in_generic_position({{1, 2, 3}, {0, 0, 0}}), ContractError);
  EXPECT_THROW(in_generic_position({{1, 2, 3}, {-1, -2, -3}}), ContractError);
  EXPECT_THROW(in_generic_position({{1, 0, 0}, {0, 1, 0}, {2, 0, 0}}), ContractError);
}

TEST(AssembleStates, ContradictoryCountsAreRejected) {
  const GreatCircles circles = merge_planes({{1, 0, 0}, {0, 1, 0}});
  const auto assembled = [&](ArrangementCounts counts) {
    StateList cells(2);
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        cells.add_over_planes(circles, {sign_of_int(x), sign_of_int(y)});
      }
    }
    complete_counts(counts, circles);
    return assemble_states(cells, counts);
  };
  ArrangementCounts counts;
  counts.vertices = 2;
  counts.edges = 4;
  counts.faces = 4;
  EXPECT_EQ(assembled(counts).counts.distinct_states, 9u);

  ArrangementCounts no_euler = counts;
  no_euler.edges = 5;
  EXPECT_THROW(assembled(no_euler), ContractError);

  ArrangementCounts no_antipodes = counts;
  no_antipodes.edges = 5;
  no_antipodes.faces = 5;
  EXPECT_THROW(assembled(no_antipodes), ContractError);

  ArrangementCounts missing_states = counts;
  missing_states.edges = 6;
  missing_states.faces = 6;
  EXPECT_THROW(assembled(missing_states), ContractError);
}

}  // namespace
}  // namespace stickslip
