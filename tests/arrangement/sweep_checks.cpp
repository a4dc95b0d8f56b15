// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep_checks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "families.hpp"

namespace stickslip::test {
namespace {

using Cells = std::map<CellKind, std::vector<std::string>>;

void expect_counts(const ArrangementCounts& actual, const OracleResult& expected) {
  EXPECT_EQ(actual.rank, expected.rank);
  EXPECT_EQ(actual.vertices, expected.vertices);
  EXPECT_EQ(actual.edges, expected.edges);
  EXPECT_EQ(actual.faces, expected.faces);
  EXPECT_EQ(actual.distinct_states, expected.states.size());
}

Cells sorted(Cells cells) {
  for (auto& [kind, states] : cells) std::sort(states.begin(), states.end());
  return cells;
}

Cells visited_cells(const std::vector<Vector3>& planes) {
  Cells cells;
  visit_cells(planes, [&](CellKind kind, const PackedSigns& signs) {
    cells[kind].push_back(to_string(signs.unpack()));
  });
  return sorted(cells);
}

template <class Id>
std::vector<std::string> structure_texts(const ArrangementStructure& s, std::size_t count) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < count; ++i) result.push_back(to_string(s.signs(Id(i))));
  return result;
}

Cells structure_cells(const ArrangementStructure& s) {
  Cells cells;
  if (s.vertices() > 0) {
    cells[CellKind::kVertex] = structure_texts<VertexId>(s, s.vertices());
  }
  if (s.edges() > 0) cells[CellKind::kEdge] = structure_texts<EdgeId>(s, s.edges());
  cells[CellKind::kFace] = structure_texts<FaceId>(s, s.faces());
  return sorted(cells);
}

/// Every state on one cell, except that all-stick is on two vertices at rank 2, and on no cell
/// at rank 3.
void expect_states(const Cells& cells, const OracleResult& expected) {
  std::vector<std::string> all;
  for (const auto& [kind, states] : cells) all.insert(all.end(), states.begin(), states.end());
  const std::string all_stick(expected.states.front().size(), '0');
  if (expected.rank == 3) all.push_back(all_stick);
  std::sort(all.begin(), all.end());
  if (expected.rank == 2) all.erase(std::find(all.begin(), all.end(), all_stick));
  EXPECT_EQ(all, expected.states);
}

std::size_t zeros(const SlipState& state, const GreatCircles& circles) {
  std::set<std::size_t> zero_circles;
  for (std::size_t p = 0; p < state.size(); ++p) {
    if (state[p] == Sign::kZero) zero_circles.insert(circles.circle[p].index());
  }
  return zero_circles.size();
}

SlipState negated_state(SlipState state) {
  for (Sign& sign : state) sign = -sign;
  return state;
}

void expect_valid_halfedges(const ArrangementStructure& s) {
  std::vector<int> arrivals(s.halfedges(), 0);
  for (std::size_t i = 0; i < s.halfedges(); ++i) {
    const HalfedgeId h(i);
    const HalfedgeId twin = ArrangementStructure::twin(h);
    ++arrivals[s.next(h).index()];
    EXPECT_EQ(s.face(s.next(h)), s.face(h));
    EXPECT_NE(s.face(twin), s.face(h));
    EXPECT_EQ(s.sign_to_the_left(h), -s.sign_to_the_left(twin));
    if (s.vertices() > 0) {
      EXPECT_EQ(s.origin(s.next(h)), s.target(h));
      EXPECT_EQ(s.origin(s.clockwise(h)), s.origin(h));
    }
    // The face has the signs of the edge, but for the planes of the edge's circle.
    const CircleId circle = s.circle(ArrangementStructure::edge(h));
    SlipState expected = s.signs(ArrangementStructure::edge(h));
    for (std::size_t p = 0; p < expected.size(); ++p) {
      const bool is_on_circle = s.circles().circle[p] == circle;
      EXPECT_EQ(expected[p] == Sign::kZero, is_on_circle);
      if (is_on_circle) expected[p] = s.circles().orientation[p] * s.sign_to_the_left(h);
    }
    EXPECT_EQ(to_string(s.signs(s.face(h))), to_string(expected));
  }
  EXPECT_TRUE(std::all_of(arrivals.begin(), arrivals.end(), [](int n) { return n == 1; }));
}

void expect_valid_vertices(const ArrangementStructure& s) {
  std::size_t outgoing = 0;
  for (std::size_t i = 0; i < s.vertices(); ++i) {
    const VertexId v(i);
    std::size_t degree = 0;
    HalfedgeId h = s.outgoing(v);
    do {
      EXPECT_EQ(s.origin(h), v);
      h = s.clockwise(h);
      ++degree;
    } while (h != s.outgoing(v));
    EXPECT_EQ(degree, 2 * zeros(s.signs(v), s.circles()));
    outgoing += degree;
    EXPECT_EQ(s.antipode(s.antipode(v)), v);
    EXPECT_EQ(s.signs(s.antipode(v)), negated_state(s.signs(v)));
  }
  if (s.vertices() > 0) {
    EXPECT_EQ(outgoing, s.halfedges());
  }
}

void expect_antipodes(const ArrangementStructure& s) {
  for (std::size_t i = 0; i < s.edges(); ++i) {
    const EdgeId e(i);
    EXPECT_EQ(s.antipode(s.antipode(e)), e);
    EXPECT_EQ(s.circle(s.antipode(e)), s.circle(e));
    EXPECT_EQ(s.signs(s.antipode(e)), negated_state(s.signs(e)));
  }
  for (std::size_t i = 0; i < s.faces(); ++i) {
    const FaceId f(i);
    EXPECT_EQ(s.antipode(s.antipode(f)), f);
    EXPECT_EQ(s.signs(s.antipode(f)), negated_state(s.signs(f)));
    if (s.boundary(f)) {
      EXPECT_EQ(s.face(*s.boundary(f)), f);
    }
  }
}

}  // namespace

void expect_valid_structure(const ArrangementStructure& structure) {
  expect_valid_halfedges(structure);
  expect_valid_vertices(structure);
  expect_antipodes(structure);
}

void expect_sweep_equals(const std::vector<Vector3>& planes, const OracleResult& expected) {
  const SlipStates states = enumerate_slip_states_sweep(planes);
  expect_counts(states.counts, expected);
  EXPECT_EQ(texts(states.states), expected.states);

  expect_counts(count_cells(planes), expected);

  const Cells visited = visited_cells(planes);
  const auto count_of = [&](CellKind kind) {
    return visited.count(kind) == 0 ? 0 : visited.at(kind).size();
  };
  EXPECT_EQ(count_of(CellKind::kVertex), expected.vertices);
  EXPECT_EQ(count_of(CellKind::kEdge), expected.edges);
  EXPECT_EQ(count_of(CellKind::kFace), expected.faces);
  expect_states(visited, expected);

  const ArrangementStructure structure(planes);
  expect_counts(structure.counts(), expected);
  EXPECT_EQ(structure_cells(structure), visited);
  expect_valid_structure(structure);
}

std::vector<Vector3> moment_planes(std::size_t m) {
  std::vector<Vector3> planes;
  for (std::size_t t = 0; t < m; ++t) planes.push_back({1, t, t * t});
  return planes;
}

std::uint64_t checksum(const SlipState& state) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const Sign sign : state) {
    hash = (hash ^ static_cast<std::uint64_t>(2 + to_int(sign))) * 0x100000001b3;
  }
  return hash * 0x9e3779b97f4a7c15;
}

}  // namespace stickslip::test
