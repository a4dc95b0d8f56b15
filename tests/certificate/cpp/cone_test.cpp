// SPDX-License-Identifier: MIT
// Double description against the definition of extreme rays, on small integer systems.
#include "cone.hpp"

#include <gtest/gtest.h>

#include <set>

#include "support.hpp"

namespace stickslip_check {
namespace {

using Row5 = Vector;
using Image = std::vector<Integer>;
constexpr std::size_t kColumns = 5;

/// A basis of {x : a.x = 0 for all rows a}, by Gaussian elimination.
std::vector<Row5> kernel(std::vector<Row5> rows) {
  std::vector<std::size_t> pivots;
  std::size_t rank = 0;
  for (std::size_t column = 0; column < kColumns && rank < rows.size(); ++column) {
    std::size_t k = rank;
    while (k < rows.size() && rows[k][column] == 0) ++k;
    if (k == rows.size()) continue;
    std::swap(rows[k], rows[rank]);
    const Rational pivot = rows[rank][column];
    for (Rational& x : rows[rank]) x /= pivot;
    for (std::size_t other = 0; other < rows.size(); ++other) {
      if (other == rank) continue;
      const Rational factor = rows[other][column];
      for (std::size_t j = 0; j < kColumns; ++j) rows[other][j] -= factor * rows[rank][j];
    }
    pivots.push_back(column);
    ++rank;
  }
  std::vector<Row5> basis;
  for (std::size_t free = 0; free < kColumns; ++free) {
    if (std::find(pivots.begin(), pivots.end(), free) != pivots.end()) continue;
    Row5 x(kColumns);
    x[free] = 1;
    for (std::size_t i = 0; i < pivots.size(); ++i) x[pivots[i]] = -rows[i][free];
    basis.push_back(x);
  }
  return basis;
}

std::size_t rank(const std::vector<Row5>& rows) {
  return kColumns - kernel(rows).size();
}

/// (a.x for all rows a) up to a positive factor: what x is modulo the cone's lines.
Image image(const std::vector<Row5>& rows, const Row5& x) {
  Image values;
  Integer den = 1;
  std::vector<Rational> exact;
  for (const Row5& a : rows) {
    exact.push_back(dot(a, x));
    den = lcm(den, exact.back().get_den());
  }
  Integer divisor;
  for (const Rational& value : exact) {
    values.emplace_back(value.get_num() * (den / value.get_den()));
    divisor = gcd(divisor, values.back());
  }
  for (Integer& value : values) {
    if (divisor != 0) value /= divisor;
  }
  return values;
}

bool nonnegative(const Image& values) {
  return std::all_of(values.begin(), values.end(), [](const Integer& v) { return v >= 0; });
}

/// Images of the extreme rays of {x : a.x >= 0} modulo its lines: x is one iff the rows that
/// are zero at x have rank one less than all rows.
std::set<Image> extreme_rays(const std::vector<Row5>& rows) {
  const std::size_t full = rank(rows);
  std::set<Image> found;
  for (std::size_t subset = 0; subset < (std::size_t{1} << rows.size()); ++subset) {
    std::vector<Row5> chosen;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if ((subset >> i & 1U) != 0) chosen.push_back(rows[i]);
    }
    if (rank(chosen) + 1 != full) continue;
    for (const Row5& x : kernel(chosen)) {
      for (const int sign : {1, -1}) {
        Row5 y = x;
        for (Rational& c : y) c *= sign;
        const Image values = image(rows, y);
        const bool line =
            std::all_of(values.begin(), values.end(), [](const Integer& v) { return v == 0; });
        if (!line && nonnegative(values)) found.insert(values);
      }
    }
  }
  return found;
}

Row5 row_of(const Form& x) {
  return {x.begin(), x.end()};
}

TEST(Cone, HalfSpace) {
  const Cone cone = Cone(kColumns).cut({0, 0, 0, 1, 0});
  EXPECT_EQ(cone.lines().size(), 4U);
  ASSERT_EQ(cone.rays().size(), 1U);
  EXPECT_EQ(cone.rays()[0]->x[3], 1);
  EXPECT_EQ(cone.cuts(), 1U);
}

TEST(Cone, AgreesWithBruteForce) {
  Random random(20181);
  std::size_t with_lines = 0;
  std::size_t pointed = 0;
  std::size_t degenerate = 0;
  for (int trial = 0; trial < rounds(1500); ++trial) {
    std::vector<Row5> rows{{0, 0, 0, 1, 0}};
    Cone cone = Cone(kColumns).cut({0, 0, 0, 1, 0});
    std::vector<Row5> conditions = rows;  // by their numbers in the cone
    const int cuts = between(random, 0, 6);
    const int width = between(random, 2, 5);
    const int reach = trial % 3 == 0 ? 40000 : (trial % 3 == 1 ? 1 : 3);
    for (int k = 0; k < cuts; ++k) {
      Row5 a(kColumns);
      for (int j = 0; j < width; ++j)
        a[static_cast<std::size_t>(j)] = between(random, -reach, reach);
      const bool equality = between(random, 0, 5) == 0;
      cone = cone.cut(make_form(a), equality);
      rows.push_back(a);
      conditions.push_back(a);
      if (!equality) continue;
      for (Rational& c : a) c = -c;
      rows.push_back(a);
    }
    std::vector<Row5> lines;
    for (const Form& line : cone.lines()) {
      lines.push_back(row_of(line));
      for (const Integer& value : image(rows, lines.back())) EXPECT_EQ(value, 0);
    }
    EXPECT_EQ(lines.size(), kernel(rows).size());
    EXPECT_EQ(rank(lines), lines.size());
    std::set<Image> images;
    for (const auto& ray : cone.rays()) {
      EXPECT_TRUE(images.insert(image(rows, row_of(ray->x))).second) << "a ray twice";
      Set zero;
      for (std::size_t k = 0; k < conditions.size(); ++k) {
        if (dot(conditions[k], row_of(ray->x)) == 0) insert(zero, k);
      }
      EXPECT_EQ(intersection(zero, ray->zero), intersection(ray->zero, ray->zero));
      EXPECT_EQ(intersection(zero, ray->zero), intersection(zero, zero));
    }
    EXPECT_EQ(images, extreme_rays(rows)) << "trial " << trial;
    ++(lines.empty() ? pointed : with_lines);
    if (rows.size() > 2 && images.size() < 2) ++degenerate;
  }
  // The trials did cover both kinds.
  EXPECT_GT(with_lines, rounds(100U));
  EXPECT_GT(pointed, rounds(100U));
  EXPECT_GT(degenerate, rounds(20U));
}

TEST(Cone, ManyCutsOfACone) {
  // h (1 + k^2) >= 2 k x - ..., tangents of a parabola: every cut adds a ray and removes none.
  Cone cone = Cone(4).cut({0, 0, 0, 1}).cut({1, 0, 0, 0}, true);
  for (int k = -20; k <= 20; ++k) cone = cone.cut({0, -2 * k, 1, k * k});
  EXPECT_TRUE(cone.lines().empty());
  EXPECT_EQ(cone.rays().size(), 42U);  // 40 corners and two directions without end
}

TEST(Cone, FormsArePrimitive) {
  Rational scale;
  const Form form = make_form({Rational(4, 3), Rational(-2, 5), 0, 6}, &scale);
  EXPECT_EQ(form, (Form{10, -3, 0, 45}));
  EXPECT_EQ(scale, Rational(2, 15));
  EXPECT_EQ(make_form({0, 0, 0, 0}), (Form{0, 0, 0, 0}));
  EXPECT_EQ(sign_of_dot(form, {0, 1, 0, 0}), -1);
  EXPECT_EQ(sign_of_dot(form, {3, 10, 7, 0}), 0);
  EXPECT_EQ(sign_of_dot(negative(form), {0, 1, 0, 0}), 1);
}

TEST(Cone, SetsOfAnySize) {
  Set a;
  Set b;
  for (const std::size_t k : {0U, 63U, 64U, 200U}) insert(a, k);
  for (const std::size_t k : {63U, 64U, 65U}) insert(b, k);
  Set both;
  for (const std::size_t k : {63U, 64U}) insert(both, k);
  EXPECT_EQ(intersection(a, b), both);
  EXPECT_EQ(intersection(b, a), both);
}

}  // namespace
}  // namespace stickslip_check
