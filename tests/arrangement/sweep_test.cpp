// SPDX-License-Identifier: GPL-3.0-or-later
// The sweep at scale: against CGAL, against formulas, and against itself. Small inputs, state
// by state, are in the tests that call expect_equals_oracle.
#include "stickslip/arrangement/sweep.hpp"

#include <gtest/gtest.h>

#include <set>

#include "families.hpp"
#include "rounds.hpp"
#include "stickslip/core/error.hpp"
#include "sweep_checks.hpp"

namespace stickslip {
namespace {

using test::checksum;

/// Of all slip states, by streaming: the cells, and all-stick as often as it is a state.
std::uint64_t streamed_checksum(const std::vector<Vector3>& planes) {
  std::uint64_t sum = 0;
  visit_cells(planes,
              [&](CellKind, const PackedSigns& signs) { sum += checksum(signs.unpack()); });
  const std::uint64_t all_stick = checksum(SlipState(planes.size(), Sign::kZero));
  const int rank = merge_planes(planes).rank;
  if (rank == 3) sum += all_stick;
  if (rank == 2) sum -= all_stick;
  return sum;
}

void expect_same_counts(const ArrangementCounts& a, const ArrangementCounts& b) {
  EXPECT_EQ(a.planes, b.planes);
  EXPECT_EQ(a.circles, b.circles);
  EXPECT_EQ(a.rank, b.rank);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.edges, b.edges);
  EXPECT_EQ(a.faces, b.faces);
  EXPECT_EQ(a.distinct_states, b.distinct_states);
}

void expect_equals_cgal(const std::vector<Vector3>& planes) {
  const SlipStates reference = enumerate_slip_states_cgal(planes);
  std::uint64_t expected = 0;
  for (const SlipState& state : reference.states) expected += checksum(state);
  EXPECT_EQ(streamed_checksum(planes), expected);
  expect_same_counts(count_cells(planes), reference.counts);
  expect_same_counts(ArrangementStructure(planes).counts(), reference.counts);
  const SlipStates actual = enumerate_slip_states_sweep(planes);
  expect_same_counts(actual.counts, reference.counts);
  EXPECT_TRUE(actual.states == reference.states);
}

TEST(SweepAgainstCgal, EveryFamily) {
  constexpr std::size_t kMany = test::rounds(std::size_t{200});
  for (const std::size_t m :
       {std::size_t{31}, std::size_t{32}, std::size_t{33}, std::size_t{64}, kMany / 2, kMany}) {
    expect_equals_cgal(test::moment_planes(m));
  }
  for (const int bound : {1, 2, 3, 10}) {
    expect_equals_cgal(test::grid_planes(kMany, bound, static_cast<std::uint32_t>(bound)));
  }
  for (const char* epsilon : {"1e-9", "1e-18", "1e-60"}) {
    expect_equals_cgal(test::near_grid_planes(test::rounds(80), 2, parse_rational(epsilon), 3));
  }
  std::vector<Vector3> pencil_and_others = test::pencil_planes(kMany / 2, 2);
  for (const Vector3& n : test::grid_planes(20, 3, 2)) pencil_and_others.push_back(n);
  for (const std::vector<Vector3>& planes :
       {test::simple_planes(60, 5), test::pencil_planes(kMany, 1), pencil_and_others,
        test::axis_aligned_planes(kMany, 60, 1), test::axis_aligned_planes(kMany, 5, 2)}) {
    expect_equals_cgal(planes);
  }
}

TEST(SweepCounts, SimpleArrangements) {
  for (const std::size_t m : {2u, 3u, 9u, 300u, 1000u}) {
    const ArrangementCounts counts = count_cells(test::moment_planes(m));
    EXPECT_EQ(counts.vertices, m * (m - 1));
    EXPECT_EQ(counts.edges, 2 * m * (m - 1));
    EXPECT_EQ(counts.faces, m * (m - 1) + 2);
    EXPECT_EQ(counts.cells(), 4 * m * (m - 1) + 2);
  }
  EXPECT_EQ(count_cells(test::moment_planes(1000)).cells(), 3996002u);
}

// a circles through one axis and b through another: a grid of a * b simple crossings on each
// half of the sphere, and the four ends of the axes, of degree a and b.
TEST(SweepCounts, TwoPencils) {
  const std::size_t a = 120;
  const std::size_t b = 90;
  std::vector<Vector3> planes;
  for (std::size_t i = 1; i <= a; ++i) planes.push_back({1, 0, i});
  for (std::size_t i = 1; i <= b; ++i) planes.push_back({0, 1, i});
  const ArrangementCounts counts = count_cells(planes, 3);
  EXPECT_EQ(counts.vertices, 2 * a * b + 4);
  EXPECT_EQ(counts.edges, a * (2 * b + 2) + b * (2 * a + 2));
  EXPECT_EQ(counts.vertices + counts.faces, counts.edges + 2);
}

// Points of a k x k grid in the plane z = 1 dualise to k^2 circles; each line with n grid
// points to two vertices with n circles. Line counts by brute force.
TEST(SweepCounts, GridOfPoints) {
  const int k = 9;
  std::vector<Vector3> planes;
  std::set<std::string> lines;
  for (int x = 0; x < k; ++x) {
    for (int y = 0; y < k; ++y) {
      const Vector3 n = {x, y, 1};
      for (const Vector3& other : planes) {
        const Vector3 line = {n[1] - other[1], other[0] - n[0],
                              n[0] * other[1] - n[1] * other[0]};
        const Rational lead = line[0] != 0 ? line[0] : line[1];
        lines.insert(to_string(Rational(line[0] / lead)) + " " +
                     to_string(Rational(line[1] / lead)) + " " +
                     to_string(Rational(line[2] / lead)));
      }
      planes.push_back(n);
    }
  }
  const ArrangementCounts counts = count_cells(planes);
  EXPECT_EQ(counts.vertices, 2 * lines.size());
  expect_same_counts(ArrangementStructure(planes).counts(), counts);
}

// A hundred planes on each of two circles, in both orientations.
TEST(SweepCounts, ManyCoincidentPlanes) {
  std::vector<Vector3> planes;
  for (int i = 1; i <= 100; ++i) {
    planes.push_back({i, 0, 0});
    planes.push_back({0, i % 2 == 0 ? -i : i, 0});
  }
  const ArrangementCounts counts = count_cells(planes);
  EXPECT_EQ(counts.planes, 200u);
  EXPECT_EQ(counts.circles, 2u);
  EXPECT_EQ(counts.cells(), 10u);
  EXPECT_EQ(counts.distinct_states, 9u);
  expect_equals_cgal(planes);
  planes.push_back({1, 1, 1});
  expect_equals_cgal(planes);
}

TEST(Sweep, ZeroNormalBreaksTheContract) {
  const std::vector<Vector3> planes = {{1, 0, 0}, {0, 0, 0}};
  EXPECT_THROW(count_cells(planes), ContractError);
  EXPECT_THROW(visit_cells(planes, [](CellKind, const PackedSigns&) {}), ContractError);
  EXPECT_THROW(enumerate_slip_states_sweep(planes), ContractError);
  EXPECT_THROW(enumerate_slip_states_cgal(planes), ContractError);
  EXPECT_THROW(ArrangementStructure{planes}, ContractError);
}

TEST(Sweep, WithoutCircles) {
  std::size_t calls = 0;
  visit_cells({}, [&](CellKind kind, const PackedSigns& signs) {
    ++calls;
    EXPECT_EQ(kind, CellKind::kFace);
    EXPECT_EQ(signs.size(), 0u);
    EXPECT_EQ(signs.word_count(), 1u);
  });
  EXPECT_EQ(calls, 1u);
  const ArrangementStructure structure({});
  EXPECT_EQ(structure.faces(), 1u);
  EXPECT_FALSE(structure.boundary(FaceId(0)).has_value());
  EXPECT_EQ(structure.antipode(FaceId(0)), FaceId(0));
}

TEST(Sweep, OneCircleHasNoVertex) {
  const ArrangementStructure structure({{0, -2, 0}});
  EXPECT_EQ(structure.vertices(), 0u);
  EXPECT_EQ(structure.edges(), 1u);
  EXPECT_EQ(structure.next(HalfedgeId(1)), HalfedgeId(1));
  EXPECT_EQ(structure.antipode(EdgeId(0)), EdgeId(0));
  EXPECT_EQ(structure.antipode(FaceId(0)), FaceId(1));
  EXPECT_THROW(structure.origin(HalfedgeId(0)), ContractError);
}

TEST(Sweep, AnExceptionOfAVisitorComesThrough) {
  struct Stop {};
  const std::vector<Vector3> planes = test::moment_planes(20);
  std::size_t seen = 0;
  EXPECT_THROW(visit_cells(planes,
                           [&](CellKind, const PackedSigns&) {
                             if (++seen == 100) throw Stop{};
                           }),
               Stop);
  EXPECT_EQ(seen, 100u);
}

TEST(Determinism, ThreadsDoNotMatter) {
  for (const std::vector<Vector3>& planes :
       {test::moment_planes(70), test::grid_planes(90, 3, 4), test::pencil_planes(20, 4),
        test::axis_aligned_planes(60, 9, 4), std::vector<Vector3>{{1, 2, 3}},
        test::near_grid_planes(60, 2, parse_rational("1e-18"), 4)}) {
    SweepWork work_1;
    const ArrangementCounts counts = count_cells(planes, 1, &work_1);
    const ArrangementStructure structure(planes, 1);
    for (const unsigned threads : {1u, 2u, 4u, 0u}) {
      SweepWork work;
      expect_same_counts(count_cells(planes, threads, &work), counts);
      EXPECT_EQ(work.by_double, work_1.by_double);
      EXPECT_EQ(work.by_int128, work_1.by_int128);
      EXPECT_EQ(work.by_gmp, work_1.by_gmp);
      EXPECT_EQ(work.exact_sorts, work_1.exact_sorts);

      const ArrangementStructure other(planes, threads);
      ASSERT_EQ(other.halfedges(), structure.halfedges());
      for (std::size_t i = 0; i < structure.halfedges(); ++i) {
        const HalfedgeId h(i);
        ASSERT_EQ(other.next(h), structure.next(h));
        ASSERT_EQ(other.face(h), structure.face(h));
        if (structure.vertices() > 0) {
          ASSERT_EQ(other.origin(h), structure.origin(h));
        }
      }
    }
  }
}

TEST(Structure, LargerOnesAreValid) {
  for (const std::vector<Vector3>& planes :
       {test::moment_planes(30), test::grid_planes(40, 2, 6),
        test::axis_aligned_planes(40, 8, 6), test::pencil_planes(25, 6),
        test::near_grid_planes(30, 2, parse_rational("1e-9"), 6)}) {
    const ArrangementStructure structure(planes);
    expect_same_counts(structure.counts(), count_cells(planes));
    test::expect_valid_structure(structure);
  }
}

TEST(Structure, AThousandCirclesInLittleMemory) {
  const std::vector<Vector3> planes = test::moment_planes(1000);
  const ArrangementStructure structure(planes, 0);
  EXPECT_EQ(structure.counts().cells(), 3996002u);
  EXPECT_LT(structure.memory_bytes(), 60'000'000u);
  // A few faces by substitution: the sum of a face's vertices is in it, when it has some that
  // are not in one plane; its signs must be the structure's.
  for (std::size_t f = 0; f < structure.faces(); f += 99901) {
    const SlipState signs = structure.signs(FaceId(f));
    const HalfedgeId start = *structure.boundary(FaceId(f));
    HalfedgeId h = start;
    Vector3 sum = {0, 0, 0};
    do {
      // The vertex, as the cross product of the normals of the two edges that meet there.
      const Vector3& a = planes[structure.circle(ArrangementStructure::edge(h)).index()];
      const HalfedgeId next = structure.next(h);
      const Vector3& b = planes[structure.circle(ArrangementStructure::edge(next)).index()];
      // Left turns: the corner is on the side of both where the face is.
      const int side = to_int(structure.sign_to_the_left(h) * structure.sign_to_the_left(next));
      sum[0] += side * (a[1] * b[2] - a[2] * b[1]);
      sum[1] += side * (a[2] * b[0] - a[0] * b[2]);
      sum[2] += side * (a[0] * b[1] - a[1] * b[0]);
      h = next;
    } while (h != start);
    for (std::size_t p = 0; p < planes.size(); ++p) {
      const Vector3& n = planes[p];
      const Rational value = n[0] * sum[0] + n[1] * sum[1] + n[2] * sum[2];
      ASSERT_EQ(sign_of(value), signs[p]);
    }
  }
}

}  // namespace
}  // namespace stickslip
