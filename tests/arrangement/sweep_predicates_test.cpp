// SPDX-License-Identifier: GPL-3.0-or-later
// The filtered predicates of the sweep against naive exact twins, and which stage decides.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "circle_order.hpp"
#include "families.hpp"
#include "filtered_normals.hpp"
#include "stickslip/core/integer_vector.hpp"
#include "sweep_checks.hpp"

namespace stickslip {
namespace {

using arrangement_detail::CircleOrder;
using arrangement_detail::ExactSigns;
using arrangement_detail::FilteredNormals;

using test::Random;

// The naive twins: rational arithmetic, nothing else.

Vector3 naive_cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Sign naive_dot(const Vector3& a, const Vector3& b) {
  return sign_of(Rational(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]));
}

Sign naive_determinant(const Vector3& a, const Vector3& b, const Vector3& c) {
  return naive_dot(naive_cross(a, b), c);
}

Vector3 to_rational(const IntegerVector3& n) {
  return {Rational(n[0]), Rational(n[1]), Rational(n[2])};
}

std::vector<Vector3> oriented(const FilteredNormals& normals) {
  std::vector<Vector3> result;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    result.push_back(to_rational(normals.exact(i)));
  }
  return result;
}

FilteredNormals filtered(const std::vector<Vector3>& planes) {
  return FilteredNormals(merge_planes(planes).normals);
}

/// Doubles as rationals: two random planes, one generic, and sums of planes before, rounded to
/// doubles. Almost concurrent, and their determinants need some 160 bits.
std::vector<Vector3> double_planes(std::size_t m, std::uint32_t seed) {
  Random random(seed);
  std::vector<std::array<double, 3>> doubles;
  for (std::size_t i = 0; i < m; ++i) {
    std::array<double, 3> n{};
    for (std::size_t c = 0; c < 3; ++c) {
      n[c] = i < 3 ? random.between(-1000000, 1000000) / 999983.0
                   : doubles[i - 1][c] + doubles[i - 3][c];
    }
    doubles.push_back(n);
  }
  std::vector<Vector3> planes;
  for (const auto& n : doubles) {
    planes.push_back(
        {rational_from_double(n[0]), rational_from_double(n[1]), rational_from_double(n[2])});
  }
  return planes;
}

std::vector<Vector3> scaled(std::vector<Vector3> planes, const Vector3& factors) {
  for (Vector3& n : planes) {
    for (std::size_t c = 0; c < 3; ++c) n[c] *= factors[c];
  }
  return planes;
}

/// Entries of up to `bits` bits.
std::vector<Vector3> long_planes(std::size_t m, unsigned bits, std::uint32_t seed) {
  Random random(seed);
  std::vector<Vector3> planes(m);
  for (Vector3& n : planes) {
    for (Rational& entry : n) {
      Integer value = 0;
      for (unsigned b = 0; b < bits; ++b) value = 2 * value + random.between(0, 1);
      entry = random.between(0, 1) == 0 ? value : Integer(-value);
    }
  }
  return planes;
}

std::vector<std::vector<Vector3>> all_kinds() {
  std::vector<std::vector<Vector3>> result;
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    result.push_back(test::simple_planes(9, seed));
    result.push_back(test::grid_planes(14, 1 + static_cast<int>(seed % 3), seed));
    result.push_back(test::pencil_planes(2 + seed, seed));
    result.push_back(test::axis_aligned_planes(14, 3, seed));
    result.push_back(double_planes(9, seed));
    for (const char* epsilon : {"1e-9", "1e-15", "1e-18", "1e-60", "1e-400"}) {
      result.push_back(test::near_grid_planes(9, 1, parse_rational(epsilon), seed));
    }
    for (const unsigned bits : {20u, 40u, 41u, 42u, 60u, 63u, 64u, 65u, 300u}) {
      result.push_back(long_planes(6, bits, seed));
    }
  }
  result.push_back(scaled(test::moment_planes(20), {1, parse_rational("1e-30"), 1}));
  result.push_back(scaled(test::moment_planes(20), {parse_rational("1e-700"), 1, 1}));
  return result;
}

TEST(FilteredNormals, OrientedToOneVector) {
  for (const std::vector<Vector3>& planes : all_kinds()) {
    const GreatCircles circles = merge_planes(planes);
    const FilteredNormals normals(circles.normals);
    bool found = false;
    for (int s = 7; !found && s < 200; ++s) {
      found = true;
      for (std::size_t i = 0; i < normals.size(); ++i) {
        found =
            found && naive_dot({1, s, s * s}, to_rational(normals.exact(i))) == Sign::kPositive;
      }
    }
    EXPECT_TRUE(found);
    for (std::size_t i = 0; i < normals.size(); ++i) {
      EXPECT_EQ(normals.exact(i),
                normals.is_reversed(i) ? negated(circles.normals[i]) : circles.normals[i]);
    }
  }
}

TEST(FilteredNormals, SearchGoesOnPastBadPoles) {
  std::vector<Vector3> planes;
  for (int s = 0; s < 20; ++s) {
    planes.push_back({0, s, -1});
    planes.push_back({s, -1, 0});
  }
  EXPECT_EQ(enumerate_slip_states_sweep(planes).states,
            enumerate_slip_states_cgal(planes).states);
}

/// Within 2^-53 of a power of two times `exact`, the largest entry between 1/2 and 1.
void expect_is_rounded(const std::array<double, 3>& actual, const Vector3& exact) {
  double largest = 0;
  for (const double entry : actual) largest = std::max(largest, std::abs(entry));
  EXPECT_GE(largest, 0.5);
  EXPECT_LE(largest, 1.0);
  Rational size = 0;
  for (const Rational& entry : exact) size = std::max(size, Rational(abs(entry)));
  Rational scale = 1;
  while (size * scale >= 1) scale /= 2;
  while (size * scale < Rational(1, 2)) scale *= 2;
  for (std::size_t c = 0; c < 3; ++c) {
    const Rational error = exact[c] * scale - rational_from_double(actual[c]);
    EXPECT_LE(Rational(abs(error)), rational_from_double(0x1p-53));
  }
}

TEST(FilteredNormals, DoublesAreAsCloseAsTheBoundsAssume) {
  for (const std::vector<Vector3>& planes : all_kinds()) {
    const FilteredNormals normals = filtered(planes);
    ExactSigns signs(normals);
    const auto& d = normals.approximate();
    for (std::size_t i = 0; i < normals.size(); ++i) {
      const Vector3 n = to_rational(normals.exact(i));
      expect_is_rounded({d[0][i], d[1][i], d[2][i]}, n);
      for (std::size_t j = 0; j < i; ++j) {
        const Vector3 other = to_rational(normals.exact(j));
        expect_is_rounded(signs.cross(i, j), naive_cross(n, other));
      }
    }
  }
}

TEST(ExactSigns, AgreeWithTheirTwins) {
  for (const std::vector<Vector3>& planes : all_kinds()) {
    const FilteredNormals normals = filtered(planes);
    const std::vector<Vector3> n = oriented(normals);
    ExactSigns signs(normals);
    for (std::size_t i = 0; i < n.size(); ++i) {
      for (std::size_t j = 0; j < n.size(); ++j) {
        const Vector3 product = naive_cross(n[i], n[j]);
        for (std::size_t c = 0; c < 3; ++c) {
          EXPECT_EQ(signs.cross_coordinate(i, j, c), sign_of(product[c]));
        }
        for (std::size_t k = 0; k < n.size(); ++k) {
          EXPECT_EQ(signs.determinant(i, j, k), naive_determinant(n[i], n[j], n[k]));
        }
      }
    }
  }
}

// The largest entries of each length, where 128 bits are just enough or not.
TEST(ExactSigns, StagesChangeAtTheStatedLengths) {
  const auto decided_by_int128 = [](unsigned bits_0, unsigned bits_1, unsigned bits_2) {
    const auto full = [](unsigned bits) { return Integer((Integer(1) << bits) - 1); };
    const Integer a = full(bits_0), b = full(bits_1), c = full(bits_2);
    const FilteredNormals normals({{a, -a, a - 1}, {b, b - 1, -b}, {-c, c, c - 2}});
    ExactSigns signs(normals);
    const std::vector<Vector3> n = oriented(normals);
    EXPECT_EQ(signs.determinant(0, 1, 2), naive_determinant(n[0], n[1], n[2]));
    EXPECT_EQ(signs.work().by_int128 + signs.work().by_gmp, 1u);
    return signs.work().by_int128 == 1;
  };
  EXPECT_TRUE(decided_by_int128(41, 41, 42));
  EXPECT_TRUE(decided_by_int128(63, 30, 31));
  EXPECT_FALSE(decided_by_int128(42, 42, 41));
  EXPECT_FALSE(decided_by_int128(64, 10, 10));
}

/// Every property that circle_order.hpp states, by naive arithmetic.
void expect_is_order(CircleOrder& order, const std::vector<Vector3>& n, std::size_t i) {
  const std::size_t r = i == 0 ? 1 : 0;
  const auto point = [&](std::size_t j) {
    Vector3 p = naive_cross(n[i], n[j]);
    for (Rational& entry : p) entry *= order.side(j);
    return p;
  };
  const auto starts = [&](std::size_t j) {
    return std::find(order.begin(0), order.end(0), j) != order.end(0);
  };
  std::size_t seen = 0;
  for (std::size_t q = 0; q < order.half_points(); ++q) {
    seen += order.multiplicity(q) - 1;
    const std::size_t first = *order.begin(q);
    for (const std::uint32_t* j = order.begin(q); j != order.end(q); ++j) {
      EXPECT_EQ(naive_determinant(n[i], n[first], n[*j]), Sign::kZero);
      // The same point, not its antipode.
      EXPECT_EQ(naive_dot(point(first), point(*j)), Sign::kPositive);
    }
    if (q == 0) {
      EXPECT_TRUE(starts(r));
      EXPECT_EQ(order.side(r), 1);
    } else {
      EXPECT_EQ(naive_dot(naive_cross(n[i], n[r]), n[first]), sign_of_int(order.side(first)));
      if (q > 1) {
        // Both in the open half after the start: the angle grows.
        EXPECT_EQ(naive_dot(naive_cross(point(*order.begin(q - 1)), point(first)), n[i]),
                  Sign::kPositive);
      }
    }
    const std::vector<std::uint32_t> slopes = order.by_slope(q);
    EXPECT_EQ(slopes.size(), order.multiplicity(q));
    EXPECT_NE(std::find(slopes.begin(), slopes.end(), i), slopes.end());
    for (std::size_t b = 0; b < slopes.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a) {
        EXPECT_EQ(naive_dot(naive_cross(n[slopes[a]], n[slopes[b]]), point(first)),
                  Sign::kPositive);
      }
    }
  }
  EXPECT_EQ(seen, n.size() - 1);
}

TEST(CircleOrder, HasTheStatedProperties) {
  for (const std::vector<Vector3>& planes : all_kinds()) {
    const FilteredNormals normals = filtered(planes);
    if (normals.size() < 2) continue;
    const std::vector<Vector3> n = oriented(normals);
    CircleOrder order(normals);
    for (std::size_t i = 0; i < n.size(); ++i) {
      order.sort(i);
      expect_is_order(order, n, i);
    }
  }
}

SweepWork work_of(const std::vector<Vector3>& planes) {
  SweepWork work;
  count_cells(planes, 1, &work);
  return work;
}

std::vector<Vector3> nearly_concurrent(const char* epsilon) {
  return {{1, 0, 0}, {0, 1, 0}, {1, 1, parse_rational(epsilon)}, {1, 2, 3}};
}

// Three planes within epsilon of concurrent: each of their circles has one close decision.
TEST(Stages, NearlyConcurrentPlanes) {
  const SweepWork far = work_of(nearly_concurrent("1/10"));
  EXPECT_EQ(far.by_gmp, 0u);

  const SweepWork near = work_of(nearly_concurrent("1e-9"));
  EXPECT_EQ(near.by_double, far.by_double);
  EXPECT_EQ(near.by_int128, far.by_int128);
  EXPECT_EQ(near.by_gmp, 0u);

  const SweepWork closer = work_of(nearly_concurrent("1e-18"));
  EXPECT_EQ(closer.by_double, far.by_double - 3);
  EXPECT_EQ(closer.by_int128, far.by_int128 + 3);
  EXPECT_EQ(closer.by_gmp, 0u);

  // 1e60 does not fit 64 bits: everything that doubles do not decide goes to GMP for this
  // plane, its start points as well.
  const SweepWork closest = work_of(nearly_concurrent("1e-60"));
  EXPECT_EQ(closest.by_double, far.by_double - 3);
  EXPECT_GE(closest.by_gmp, 3u);

  // A true tie is decided exactly, as small as the numbers are. The two others meet each of
  // the three circles in one point, so that no pair of points is left to compare there.
  const SweepWork tie = work_of(nearly_concurrent("0"));
  EXPECT_EQ(tie.by_double, far.by_double - 6);
  EXPECT_GT(tie.by_int128, far.by_int128);
  EXPECT_EQ(tie.by_gmp, 0u);
}

TEST(Stages, DoublesAsRationalsNeedGmp) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const std::vector<Vector3> planes = double_planes(7, seed);
    EXPECT_GT(work_of(planes).by_gmp, 0u);
    test::expect_equals_oracle(planes);
  }
}

TEST(Stages, GenericPlanesNeedDoublesAlone) {
  const std::size_t m = 150;
  const SweepWork work = work_of(test::grid_planes(m, 1000000, 1));
  // Beside one coordinate of the start point on each circle.
  EXPECT_EQ(work.by_int128, m);
  EXPECT_EQ(work.by_gmp, 0u);
  EXPECT_EQ(work.by_double, m * (m - 2) + m * (m - 3));
  EXPECT_EQ(work.exact_sorts, 0u);
}

// A regular linear map keeps the states, but here doubles see one circle instead of 64: their
// order is worthless, and all comparisons are exact.
TEST(Stages, ACollapsedBundleIsSortedExactly) {
  std::vector<Vector3> planes = test::moment_planes(64);
  std::reverse(planes.begin(), planes.end());
  const SlipStates expected = enumerate_slip_states_sweep(planes);
  EXPECT_EQ(work_of(planes).exact_sorts, 0u);

  const std::vector<Vector3> collapsed =
      scaled(planes, {1, parse_rational("1e-30"), parse_rational("1e-60")});
  SweepWork work;
  const SlipStates actual = enumerate_slip_states_sweep(collapsed, &work);
  EXPECT_EQ(actual.states, expected.states);
  EXPECT_EQ(actual.counts.cells(), 4u * 64 * 63 + 2);
  EXPECT_GT(work.exact_sorts, 0u);
  EXPECT_GT(work.by_gmp, 0u);
}

TEST(Stages, OtherEndsOfTheRangeOfDoubles) {
  for (const char* factor : {"1e-300", "1e300", "1e-700"}) {
    const std::vector<Vector3> planes =
        scaled(test::moment_planes(12), {parse_rational(factor), 1, 1});
    EXPECT_EQ(enumerate_slip_states_sweep(planes).states,
              enumerate_slip_states_cgal(test::moment_planes(12)).states);
  }
}

}  // namespace
}  // namespace stickslip
