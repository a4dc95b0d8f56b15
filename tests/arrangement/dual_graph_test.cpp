// SPDX-License-Identifier: GPL-3.0-or-later
// The dual graph through the algorithms of Boost.Graph.
#include "stickslip/arrangement/dual_graph.hpp"

#include <gtest/gtest.h>

#include <boost/graph/bipartite.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/graph_concepts.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <set>

#include "families.hpp"
#include "sweep_checks.hpp"

namespace stickslip {
namespace {

BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<DualGraph>));
BOOST_CONCEPT_ASSERT((boost::EdgeListGraphConcept<DualGraph>));
BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<DualGraph>));
BOOST_CONCEPT_ASSERT((boost::BidirectionalGraphConcept<DualGraph>));
BOOST_CONCEPT_ASSERT((boost::AdjacencyGraphConcept<DualGraph>));
BOOST_CONCEPT_ASSERT(
    (boost::ReadablePropertyGraphConcept<DualGraph, std::size_t, boost::vertex_index_t>));

std::vector<std::size_t> distances_from(const DualGraph& graph, std::size_t start) {
  std::vector<std::size_t> distance(num_vertices(graph), 0);
  boost::breadth_first_search(
      graph, start,
      boost::visitor(boost::make_bfs_visitor(boost::record_distances(
          boost::make_iterator_property_map(distance.begin(), get(boost::vertex_index, graph)),
          boost::on_tree_edge()))));
  return distance;
}

/// The number of circles that separate two faces.
std::size_t hamming_distance(const SlipState& a, const SlipState& b,
                             const GreatCircles& circles) {
  std::set<std::size_t> different;
  for (std::size_t p = 0; p < a.size(); ++p) {
    if (a[p] != b[p]) different.insert(circles.circle[p].index());
  }
  return different.size();
}

void expect_partial_cube(const DualGraph& graph) {
  const ArrangementStructure& s = graph.structure();
  std::vector<SlipState> signs;
  for (std::size_t f = 0; f < s.faces(); ++f) signs.push_back(s.signs(FaceId(f)));
  for (std::size_t f = 0; f < s.faces(); ++f) {
    const std::vector<std::size_t> distance = distances_from(graph, f);
    for (std::size_t g = 0; g < s.faces(); ++g) {
      ASSERT_EQ(distance[g], hamming_distance(signs[f], signs[g], s.circles()));
    }
  }
}

std::size_t components(const DualGraph& graph) {
  std::vector<std::size_t> component(num_vertices(graph));
  return boost::connected_components(
      graph,
      boost::make_iterator_property_map(component.begin(), get(boost::vertex_index, graph)));
}

/// What holds of the dual graph of any arrangement.
void expect_dual_graph(const std::vector<Vector3>& planes) {
  SCOPED_TRACE(test::describe(planes));
  const ArrangementStructure structure(planes);
  const DualGraph graph(structure);
  EXPECT_EQ(num_vertices(graph), structure.faces());
  EXPECT_EQ(num_edges(graph), structure.edges());
  EXPECT_EQ(components(graph), 1u);
  EXPECT_TRUE(boost::is_bipartite(graph));
  EXPECT_TRUE(boost::boyer_myrvold_planarity_test(graph));

  std::size_t degrees = 0;
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t v = 0; v < num_vertices(graph); ++v) {
    degrees += out_degree(v, graph);
    const auto [edge, edge_end] = out_edges(v, graph);
    auto neighbour = adjacent_vertices(v, graph).first;
    for (auto e = edge; e != edge_end; ++e, ++neighbour) {
      EXPECT_EQ(source(*e, graph), v);
      EXPECT_EQ(target(*e, graph), *neighbour);
      EXPECT_TRUE(pairs.emplace(v, *neighbour).second) << "a parallel edge";
    }
    for (auto [e, end] = in_edges(v, graph); e != end; ++e) EXPECT_EQ(target(*e, graph), v);
  }
  EXPECT_EQ(degrees, 2 * num_edges(graph));
  std::set<std::size_t> indices;
  for (auto [e, end] = edges(graph); e != end; ++e) {
    indices.insert(get(boost::edge_index, graph, *e));
    EXPECT_EQ(pairs.count({source(*e, graph), target(*e, graph)}), 1u);
  }
  EXPECT_EQ(indices.size(), num_edges(graph));
}

TEST(DualGraph, NoCircleOneVertex) {
  const ArrangementStructure structure({});
  const DualGraph graph(structure);
  EXPECT_EQ(num_vertices(graph), 1u);
  EXPECT_EQ(num_edges(graph), 0u);
  EXPECT_EQ(out_degree(0, graph), 0u);
  EXPECT_EQ(components(graph), 1u);
}

TEST(DualGraph, OneCircleOneEdge) {
  expect_dual_graph({{1, 2, 3}, {-1, -2, -3}});
  const ArrangementStructure structure({{1, 2, 3}});
  const DualGraph graph(structure);
  EXPECT_EQ(num_vertices(graph), 2u);
  EXPECT_EQ(num_edges(graph), 1u);
  EXPECT_EQ(*adjacent_vertices(0, graph).first, 1u);
}

TEST(DualGraph, PencilsAreCycles) {
  for (std::size_t k = 2; k <= 12; ++k) {
    const std::vector<Vector3> planes = test::pencil_planes(k, static_cast<std::uint32_t>(k));
    expect_dual_graph(planes);
    const ArrangementStructure structure(planes);
    const DualGraph graph(structure);
    EXPECT_EQ(num_vertices(graph), 2 * k);
    for (std::size_t v = 0; v < 2 * k; ++v) EXPECT_EQ(out_degree(v, graph), 2u);
    expect_partial_cube(graph);
  }
}

TEST(DualGraph, ThreeCoordinatePlanesAreTheCube) {
  const ArrangementStructure structure({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const DualGraph graph(structure);
  EXPECT_EQ(num_vertices(graph), 8u);
  for (std::size_t v = 0; v < 8; ++v) EXPECT_EQ(out_degree(v, graph), 3u);
  expect_partial_cube(graph);
}

// The permutohedron of A3: the truncated octahedron.
TEST(DualGraph, MirrorsOfA3) {
  const std::vector<Vector3> planes = {{1, 1, 0},  {1, -1, 0}, {1, 0, 1},
                                       {1, 0, -1}, {0, 1, 1},  {0, 1, -1}};
  expect_dual_graph(planes);
  const ArrangementStructure structure(planes);
  const DualGraph graph(structure);
  for (std::size_t v = 0; v < 24; ++v) EXPECT_EQ(out_degree(v, graph), 3u);
  expect_partial_cube(graph);
}

TEST(DualGraph, PartialCube) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    for (const std::vector<Vector3>& planes :
         {test::simple_planes(3 + seed, seed), test::grid_planes(12, 2, seed),
          test::axis_aligned_planes(12, 4, seed),
          test::near_grid_planes(8, 1, parse_rational("1e-18"), seed)}) {
      expect_dual_graph(planes);
      const ArrangementStructure structure(planes);
      expect_partial_cube(DualGraph(structure));
    }
  }
}

TEST(DualGraph, LargerOnesArePlanar) {
  expect_dual_graph(test::moment_planes(60));
  expect_dual_graph(test::grid_planes(80, 3, 1));
  expect_dual_graph(test::axis_aligned_planes(80, 20, 1));
}

// Antipodal faces are separated by all circles: the diameter of the graph.
TEST(DualGraph, AntipodesAreFarthest) {
  const ArrangementStructure structure(test::grid_planes(25, 3, 8));
  const DualGraph graph(structure);
  const std::size_t k = structure.circles().normals.size();
  for (std::size_t f = 0; f < structure.faces(); f += 37) {
    const std::vector<std::size_t> distance = distances_from(graph, f);
    EXPECT_EQ(distance[structure.antipode(FaceId(f)).index()], k);
    EXPECT_EQ(*std::max_element(distance.begin(), distance.end()), k);
  }
}

// An algorithm with weights by edge: crossing circle c costs c + 1.
TEST(DualGraph, WeightsByCircle) {
  const ArrangementStructure structure(test::simple_planes(8, 2));
  const DualGraph graph(structure);
  const auto weight = boost::make_function_property_map<DualEdge>([&](DualEdge e) {
    return structure.circle(ArrangementStructure::edge(e.halfedge())).index() + 1;
  });
  std::vector<std::size_t> distance(num_vertices(graph));
  boost::dijkstra_shortest_paths(
      graph, std::size_t{0},
      boost::weight_map(weight).distance_map(boost::make_iterator_property_map(
          distance.begin(), get(boost::vertex_index, graph))));
  const SlipState from = structure.signs(FaceId(0));
  for (std::size_t f = 0; f < structure.faces(); ++f) {
    const SlipState to = structure.signs(FaceId(f));
    std::size_t expected = 0;
    for (std::size_t p = 0; p < to.size(); ++p) expected += to[p] != from[p] ? p + 1 : 0;
    EXPECT_EQ(distance[f], expected);
  }
}

}  // namespace
}  // namespace stickslip
