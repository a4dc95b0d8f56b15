// SPDX-License-Identifier: GPL-3.0-or-later
// Minimum cycle bases against exhaustion. That they are the faces of the arrangements
// (docs/paper_enumerator.md) is for paper_steps_test.cpp.
#include "paper_cycle_basis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bitset>
#include <boost/graph/connected_components.hpp>
#include <map>
#include <set>

#include "families.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using arrangement_detail::CycleBasis;
using arrangement_detail::DualPolyhedron;
using arrangement_detail::minimum_cycle_basis;

using EdgeList = std::vector<std::pair<std::size_t, std::size_t>>;
using EdgeSet = std::bitset<128>;

DualPolyhedron make_graph(std::size_t vertices, const EdgeList& edges) {
  DualPolyhedron graph(vertices);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    boost::add_edge(edges[e].first, edges[e].second, e, graph);
  }
  return graph;
}

/// Gaussian elimination over GF(2).
class Span {
 public:
  EdgeSet residue(EdgeSet v) const {
    for (const auto& [pivot, row] : rows_) {
      if (v.test(pivot)) v ^= row;
    }
    return v;
  }
  /// Whether v was not in the span before.
  bool add(const EdgeSet& v) {
    const EdgeSet rest = residue(v);
    if (rest.none()) return false;
    std::size_t pivot = 0;
    while (!rest.test(pivot)) ++pivot;
    // Rows are reduced in the order they came: each is free of the pivots before it.
    rows_.emplace_back(pivot, rest);
    return true;
  }

 private:
  std::vector<std::pair<std::size_t, EdgeSet>> rows_;
};

/// All simple cycles of at most `longest` edges, by length: from the lowest vertex of each.
std::map<std::size_t, std::set<std::string>> cycles_by_length(std::size_t vertices,
                                                              const EdgeList& edges,
                                                              std::size_t longest) {
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> adjacent(vertices);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    adjacent[edges[e].first].emplace_back(edges[e].second, e);
    adjacent[edges[e].second].emplace_back(edges[e].first, e);
  }
  std::map<std::size_t, std::set<std::string>> found;
  std::vector<bool> is_on_path(vertices, false);
  EdgeSet path;
  const auto extend = [&](auto&& self, std::size_t start, std::size_t here,
                          std::size_t length) -> void {
    for (const auto& [next, e] : adjacent[here]) {
      if (path.test(e) || next < start || length == longest) continue;
      path.set(e);
      if (next == start) {
        found[length + 1].insert(path.to_string());
      } else if (!is_on_path[next]) {
        is_on_path[next] = true;
        self(self, start, next, length + 1);
        is_on_path[next] = false;
      }
      path.reset(e);
    }
  };
  for (std::size_t v = 0; v < vertices; ++v) extend(extend, v, v, 0);
  return found;
}

/// The cycle space is a matroid: taking cycles by length, each that is independent of those
/// before, gives the least total length.
std::size_t least_total_length(std::size_t vertices, const EdgeList& edges) {
  Span span;
  std::size_t total = 0;
  for (const auto& [length, cycles] : cycles_by_length(vertices, edges, vertices)) {
    for (const std::string& cycle : cycles) {
      if (span.add(EdgeSet(cycle))) total += length;
    }
  }
  return total;
}

std::size_t expect_basis(std::size_t vertices, const EdgeList& edges) {
  const DualPolyhedron graph = make_graph(vertices, edges);
  const CycleBasis basis = minimum_cycle_basis(graph);
  std::vector<std::size_t> component(vertices);
  const auto components =
      static_cast<std::size_t>(boost::connected_components(graph, component.data()));
  EXPECT_EQ(basis.components, components);
  EXPECT_EQ(basis.cycles.size(), edges.size() + components - vertices);
  Span span;
  std::size_t total = 0;
  for (const std::vector<std::size_t>& cycle : basis.cycles) {
    EdgeSet set;
    std::map<std::size_t, int> degree;
    for (const std::size_t e : cycle) {
      set.set(e);
      ++degree[edges[e].first];
      ++degree[edges[e].second];
    }
    EXPECT_TRUE(std::is_sorted(cycle.begin(), cycle.end()));
    EXPECT_EQ(set.count(), cycle.size());
    EXPECT_EQ(degree.size(), cycle.size());
    for (const auto& [vertex, count] : degree) EXPECT_EQ(count, 2) << vertex;
    EXPECT_TRUE(span.add(set)) << "the cycles are dependent";
    total += cycle.size();
  }
  return total;
}

EdgeList complete_graph(std::size_t vertices) {
  EdgeList edges;
  for (std::size_t a = 0; a < vertices; ++a) {
    for (std::size_t b = a + 1; b < vertices; ++b) edges.emplace_back(a, b);
  }
  return edges;
}

TEST(MinimumCycleBasis, KnownGraphs) {
  EXPECT_EQ(expect_basis(0, {}), 0u);
  EXPECT_EQ(expect_basis(4, {}), 0u);
  EXPECT_EQ(expect_basis(4, {{0, 1}, {1, 2}, {1, 3}}), 0u);
  EXPECT_EQ(expect_basis(2, {{0, 1}, {1, 0}, {0, 1}}), 4u);
  EXPECT_EQ(expect_basis(5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}}), 5u);
  for (std::size_t n = 3; n <= 7; ++n) {
    EXPECT_EQ(expect_basis(n, complete_graph(n)), 3 * (n - 1) * (n - 2) / 2);
  }
  EdgeList petersen;
  for (std::size_t i = 0; i < 5; ++i) {
    petersen.emplace_back(i, (i + 1) % 5);
    petersen.emplace_back(i, i + 5);
    petersen.emplace_back(i + 5, (i + 2) % 5 + 5);
  }
  EXPECT_EQ(expect_basis(10, petersen), 30u);
  EdgeList bipartite;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 3; b < 6; ++b) bipartite.emplace_back(a, b);
  }
  EXPECT_EQ(expect_basis(6, bipartite), 16u);
}

// Why the theorem needs more than a convex polyhedron: two hexagons, each joined by a belt of
// three triangles and three quadrilaterals to a triangle between them, which is no face. It
// stands in the basis, and both hexagons are missing.
TEST(MinimumCycleBasis, NeedNotConsistOfFacesOfAPolyhedron) {
  EdgeList edges = {{0, 1}, {1, 2}, {2, 0}};
  for (const std::size_t hexagon : {3u, 9u}) {
    for (std::size_t i = 0; i < 6; ++i) {
      edges.emplace_back(hexagon + i, hexagon + (i + 1) % 6);
      edges.emplace_back(i / 2, hexagon + i);
    }
  }
  const std::size_t faces = 6 * 3 + 6 * 4 + 2 * 6;
  EXPECT_EQ(15 + 14, edges.size() + 2);  // Euler
  EXPECT_EQ(expect_basis(15, edges), faces - 2 * 6 + 3);
}

TEST(MinimumCycleBasis, LoopBreaksTheContract) {
  EXPECT_THROW(minimum_cycle_basis(make_graph(2, {{0, 1}, {1, 1}})), ContractError);
}

TEST(MinimumCycleBasis, AgreesWithExhaustionOnRandomGraphs) {
  for (std::uint32_t seed = 0; seed < 400; ++seed) {
    test::Random random(seed);
    const auto n = static_cast<std::size_t>(random.between(2, 7));
    const int count = random.between(0, 12);
    EdgeList edges;
    for (int i = 0; i < count; ++i) {
      const int a = random.between(0, static_cast<int>(n) - 1);
      const int b = random.between(0, static_cast<int>(n) - 1);
      if (a == b) continue;
      edges.emplace_back(a, b);
    }
    EXPECT_EQ(expect_basis(n, edges), least_total_length(n, edges)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace stickslip
