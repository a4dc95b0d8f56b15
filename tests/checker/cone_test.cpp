// SPDX-License-Identifier: MIT
// Double description against the definition of extreme rays, on small integer systems.
#include "cone.hpp"

#include <gtest/gtest.h>

#include <set>

#include "support.hpp"

namespace stickslip_check {
namespace {

using Row4 = std::array<Rational, 4>;
using Image = std::vector<Integer>;

/// A basis of {x : a.x = 0 for all rows a}, by Gaussian elimination.
std::vector<Row4> kernel(std::vector<Row4> rows) {
  std::vector<std::size_t> pivots;
  std::size_t rank = 0;
  for (std::size_t column = 0; column < 4 && rank < rows.size(); ++column) {
    std::size_t k = rank;
    while (k < rows.size() && rows[k][column] == 0) ++k;
    if (k == rows.size()) continue;
    std::swap(rows[k], rows[rank]);
    const Rational pivot = rows[rank][column];
    for (Rational& x : rows[rank]) x /= pivot;
    for (std::size_t other = 0; other < rows.size(); ++other) {
      if (other == rank) continue;
      const Rational factor = rows[other][column];
      for (std::size_t j = 0; j < 4; ++j) rows[other][j] -= factor * rows[rank][j];
    }
    pivots.push_back(column);
    ++rank;
  }
  std::vector<Row4> basis;
  for (std::size_t free = 0; free < 4; ++free) {
    if (std::find(pivots.begin(), pivots.end(), free) != pivots.end()) continue;
    Row4 x{};
    x[free] = 1;
    for (std::size_t i = 0; i < pivots.size(); ++i) x[pivots[i]] = -rows[i][free];
    basis.push_back(x);
  }
  return basis;
}

std::size_t rank(const std::vector<Row4>& rows) {
  return 4 - kernel(rows).size();
}

/// (a.x for all rows a) up to a positive factor: what x is modulo the cone's lines.
Image image(const std::vector<Row4>& rows, const Row4& x) {
  Image values;
  Integer den = 1;
  std::vector<Rational> exact;
  for (const Row4& a : rows) {
    exact.emplace_back(a[0] * x[0] + a[1] * x[1] + a[2] * x[2] + a[3] * x[3]);
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
std::set<Image> extreme_rays(const std::vector<Row4>& rows) {
  const std::size_t full = rank(rows);
  std::set<Image> found;
  for (std::size_t subset = 0; subset < (std::size_t{1} << rows.size()); ++subset) {
    std::vector<Row4> chosen;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if ((subset >> i & 1U) != 0) chosen.push_back(rows[i]);
    }
    if (rank(chosen) + 1 != full) continue;
    for (const Row4& x : kernel(chosen)) {
      for (const int sign : {1, -1}) {
        Row4 y = x;
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

Row4 row_of(const Vector& v) {
  return {Rational(v.x[0]), Rational(v.x[1]), Rational(v.x[2]), Rational(v.x[3])};
}

TEST(Cone, HalfSpace) {
  const Cone cone = Cone::half_space();
  EXPECT_EQ(cone.lines().size(), 3U);
  ASSERT_EQ(cone.rays().size(), 1U);
  EXPECT_EQ(cone.rays()[0]->v.x[3], 1);
}

TEST(Cone, AgreesWithBruteForce) {
  Random random(20181);
  std::size_t with_lines = 0;
  std::size_t pointed = 0;
  std::size_t degenerate = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    std::vector<Row4> rows{{0, 0, 0, 1}};
    Cone cone = Cone::half_space();
    const int cuts = between(random, 0, 6);
    const int reach = trial % 3 == 0 ? 40000 : (trial % 3 == 1 ? 1 : 3);
    for (int k = 0; k < cuts; ++k) {
      Row4 a;
      for (Rational& c : a) c = between(random, -reach, reach);
      const int kind = between(random, 0, 5);
      const Vector v = make_vector(a);
      Row4 opposite = a;
      for (Rational& c : opposite) c = -c;
      if (kind == 0) {
        cone = cone.cut(v, Side::kZero);
        rows.push_back(a);
        rows.push_back(opposite);
      } else if (kind <= 3) {
        cone = cone.cut(v, Side::kAtLeastZero);
        rows.push_back(a);
      } else {
        cone = cone.cut(v, Side::kAtMostZero);
        rows.push_back(opposite);
      }
    }
    std::vector<Row4> lines;
    for (const Vector& line : cone.lines()) {
      lines.push_back(row_of(line));
      for (const Integer& value : image(rows, lines.back())) EXPECT_EQ(value, 0);
    }
    EXPECT_EQ(lines.size(), kernel(rows).size());
    EXPECT_EQ(rank(lines), lines.size());
    std::set<Image> images;
    for (const auto& ray : cone.rays()) {
      EXPECT_TRUE(images.insert(image(rows, row_of(ray->v))).second) << "a ray twice";
    }
    EXPECT_EQ(images, extreme_rays(rows)) << "trial " << trial;
    ++(lines.empty() ? pointed : with_lines);
    if (rows.size() > 2 && images.size() < 2) ++degenerate;
  }
  // The trials did cover both kinds.
  EXPECT_GT(with_lines, 100U);
  EXPECT_GT(pointed, 100U);
  EXPECT_GT(degenerate, 20U);
}

TEST(Cone, ManyCutsOfACone) {
  // h (1 + k^2) >= 2 k x - ..., tangents of a parabola: every cut adds a ray and removes none.
  Cone cone = Cone::half_space();
  cone = cone.cut(make_vector(Row4{1, 0, 0, 0}), Side::kZero);
  for (int k = -20; k <= 20; ++k) {
    cone = cone.cut(make_vector(Row4{0, Rational(-2 * k), 1, Rational(k * k)}),
                    Side::kAtLeastZero);
  }
  EXPECT_TRUE(cone.lines().empty());
  EXPECT_EQ(cone.rays().size(), 42U);  // 40 corners and two directions without end
}

TEST(Cone, SignsOfProductsAreExact) {
  Random random(7);
  std::size_t zeros = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    std::array<Integer, 4> a;
    std::array<Integer, 4> b;
    const int digits = between(random, 0, 6);
    for (std::size_t i = 0; i < 4; ++i) {
      a[i] = between(random, -9, 9);
      b[i] = between(random, -9, 9);
      for (int k = 0; k < digits; ++k) {
        a[i] = a[i] * 100000 + between(random, -99999, 99999);
        b[i] = b[i] * 100000 + between(random, -99999, 99999);
      }
    }
    if (trial % 2 == 0) {
      // Nearly orthogonal: the product is -1, 0 or 1 before common factors go.
      b = {a[1], -a[0], a[3], -a[2]};
      b[static_cast<std::size_t>(between(random, 0, 3))] += between(random, -1, 1);
    }
    const Vector u = make_vector(a);
    const Vector v = make_vector(b);
    EXPECT_EQ(sign_of_dot(u, v), sgn(dot(u, v)));
    EXPECT_EQ(sign_of_dot(negative(u), v), -sgn(dot(u, v)));
    if (dot(u, v) == 0) ++zeros;
  }
  EXPECT_GT(zeros, 100U);
}

TEST(Cone, VectorsArePrimitive) {
  Rational scale;
  const Vector v = make_vector(Row4{Rational(4, 3), Rational(-2, 5), 0, 6}, &scale);
  EXPECT_EQ(v.x, (std::array<Integer, 4>{10, -3, 0, 45}));
  EXPECT_EQ(scale, Rational(2, 15));
  EXPECT_EQ(make_vector(Row4{0, 0, 0, 0}).x, (std::array<Integer, 4>{0, 0, 0, 0}));
}

}  // namespace
}  // namespace stickslip_check
