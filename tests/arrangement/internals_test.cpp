// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the module that have no public header.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "assemble_states.hpp"
#include "families.hpp"
#include "generic_position.hpp"
#include "sign_rows.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/integer_vector.hpp"

namespace stickslip {
namespace {

std::string row_text(const SignRows& rows, std::size_t row) {
  std::string text;
  for (std::size_t c = 0; c < rows.circles(); ++c) text.push_back(to_char(rows.get(row, c)));
  return text;
}

// 31, 32, 33: around the number of signs in a word.
class SignRowsOfWidth : public testing::TestWithParam<std::size_t> {};

TEST_P(SignRowsOfWidth, SetGetFlipAgreeWithText) {
  const std::size_t width = GetParam();
  test::Random random(static_cast<std::uint32_t>(width));
  SignRows rows(width);
  std::string expected(width, '+');
  rows.add();
  for (int step = 0; step < 200 && width > 0; ++step) {
    const auto c = static_cast<std::size_t>(random.between(0, static_cast<int>(width) - 1));
    if (random.between(0, 1) == 0 && expected[c] != '0') {
      rows.flip(0, c);
      expected[c] = expected[c] == '+' ? '-' : '+';
    } else {
      const Sign sign = sign_of_int(random.between(-1, 1));
      rows.set(0, c, sign);
      expected[c] = to_char(sign);
    }
    ASSERT_EQ(row_text(rows, 0), expected);
    std::vector<Sign> unpacked;
    rows.unpack(0, unpacked);
    ASSERT_EQ(to_string(unpacked), expected);
  }
  EXPECT_EQ(row_text(rows, rows.add_copy(0)), expected);
}

TEST_P(SignRowsOfWidth, SortAgreesWithTexts) {
  const std::size_t width = GetParam();
  test::Random random(7);
  SignRows rows(width);
  std::vector<std::string> expected;
  for (int i = 0; i < 300; ++i) {
    const std::size_t row = rows.add();
    for (std::size_t c = 0; c < width; ++c) {
      // Long common prefixes, so that the later words decide.
      if (c + 4 > width) rows.set(row, c, sign_of_int(random.between(-1, 1)));
    }
    expected.push_back(row_text(rows, row));
  }
  std::sort(expected.begin(), expected.end());
  expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
  rows.sort_and_unique();
  ASSERT_EQ(rows.size(), expected.size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    EXPECT_EQ(row_text(rows, row), expected[row]);
  }
}

TEST_P(SignRowsOfWidth, FlipAllLeavesZeros) {
  const std::size_t width = GetParam();
  SignRows rows(width);
  const std::size_t row = rows.add();
  std::vector<bool> marked(width);
  std::string expected;
  for (std::size_t c = 0; c < width; ++c) {
    const Sign sign = sign_of_int(static_cast<int>(c % 3) - 1);
    marked[c] = c % 2 == 0;
    rows.set(row, c, sign);
    expected.push_back(to_char(marked[c] ? -sign : sign));
  }
  rows.flip_all(marked);
  EXPECT_EQ(row_text(rows, row), expected);

  // The same row by another way is the same row, so one of the two is dropped.
  const std::size_t twin = rows.add();
  for (std::size_t c = 0; c < width; ++c) rows.set(twin, c, rows.get(row, c));
  rows.sort_and_unique();
  EXPECT_EQ(rows.size(), 1u);
}

TEST_P(SignRowsOfWidth, DifferExactlyAt) {
  const std::size_t width = GetParam();
  for (std::size_t c = 0; c < width; ++c) {
    SignRows rows(width);
    const std::size_t a = rows.add();
    const std::size_t b = rows.add();
    EXPECT_FALSE(rows.differ_exactly_at(a, b, c));
    rows.flip(b, c);
    EXPECT_TRUE(rows.differ_exactly_at(a, b, c));
    if (width == 1) continue;
    rows.flip(b, (c + 1) % width);
    EXPECT_FALSE(rows.differ_exactly_at(a, b, c));
  }
}

INSTANTIATE_TEST_SUITE_P(Widths, SignRowsOfWidth,
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
  const auto cells = [] {
    SignRows rows(2);
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        const std::size_t row = rows.add();
        rows.set(row, 0, sign_of_int(x));
        rows.set(row, 1, sign_of_int(y));
      }
    }
    return rows;
  };
  ArrangementCounts counts;
  counts.vertices = 2;
  counts.edges = 4;
  counts.faces = 4;
  EXPECT_EQ(assemble_states(circles, cells(), counts).counts.distinct_states, 9u);

  ArrangementCounts no_euler = counts;
  no_euler.edges = 5;
  EXPECT_THROW(assemble_states(circles, cells(), no_euler), ContractError);

  ArrangementCounts no_antipodes = counts;
  no_antipodes.edges = 5;
  no_antipodes.faces = 5;
  EXPECT_THROW(assemble_states(circles, cells(), no_antipodes), ContractError);

  ArrangementCounts missing_states = counts;
  missing_states.edges = 6;
  missing_states.faces = 6;
  EXPECT_THROW(assemble_states(circles, cells(), missing_states), ContractError);
}

}  // namespace
}  // namespace stickslip
