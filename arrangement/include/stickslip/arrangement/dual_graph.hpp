// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The dual graph of an arrangement, for the algorithms of Boost.Graph: its vertices are the
/// faces of the arrangement, its edges join the two faces beside an edge of the arrangement.
///
/// It is the edge graph of the zonotope sum of segments [-n_c, n_c], and the tope graph of the
/// arrangement: two faces are as far apart as the number of circles that separate them. So
/// for every k it is connected, simple, planar, bipartite, and a partial cube: the signs of
/// the faces embed it isometrically in the graph of the k-cube. With k distinct circles:
///
///     k = 0   one vertex
///     k = 1   two vertices and one edge
///     pencil  a cycle of 2k vertices
///     rank 3  a 3-connected graph, that of a polyhedron (Steinitz)
///
/// It never has parallel edges or loops: faces beside one edge differ in the sign of exactly
/// that edge's circle, and a face is convex, so it has one edge at most on each circle. (The
/// vertices and edges of the arrangement itself do form a graph with parallel edges when they
/// are a pencil.)
///
/// Models VertexListGraph, EdgeListGraph, IncidenceGraph, BidirectionalGraph and
/// AdjacencyGraph, undirected and read-only, with boost::vertex_index and boost::edge_index.
/// Include this file before the algorithms. out_degree takes time in proportion to the degree;
/// everything else is O(1). The structure must outlive the graph.
#pragma once

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/property_map/property_map.hpp>
#include <cstddef>
#include <utility>

#include "stickslip/arrangement/arrangement_structure.hpp"

namespace stickslip {

/// An edge as it is seen from the face to the left of a halfedge. Both halfedges of an edge are
/// equal, as the two descriptors of an edge of an undirected graph are.
class DualEdge {
 public:
  /// Of halfedge 0; Boost.Graph asks that descriptors can be made from nothing.
  DualEdge() = default;
  /// Out of the face to the left of the halfedge.
  explicit DualEdge(HalfedgeId halfedge) : halfedge_(halfedge.index()) {}

  /// The one with the source to its left.
  HalfedgeId halfedge() const { return HalfedgeId(halfedge_); }
  /// Of the arrangement's edge that is crossed.
  std::size_t index() const { return halfedge_ / 2; }

  /// \{ By index.
  friend bool operator==(DualEdge a, DualEdge b) { return a.index() == b.index(); }
  friend bool operator!=(DualEdge a, DualEdge b) { return !(a == b); }
  friend bool operator<(DualEdge a, DualEdge b) { return a.index() < b.index(); }
  /// \}

 private:
  std::size_t halfedge_ = 0;
};

/// The faces of an arrangement as the vertices of a graph. A view: copying is cheap.
class DualGraph {
 public:
  /// Of `structure`, which must outlive the graph.
  explicit DualGraph(const ArrangementStructure& structure) : structure_(&structure) {}
  const ArrangementStructure& structure() const { return *structure_; }  ///< what it is dual to

  /// \{ What boost::graph_traits asks for. A vertex is the index of a FaceId.
  using vertex_descriptor = std::size_t;
  using edge_descriptor = DualEdge;
  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::disallow_parallel_edge_tag;
  /// \}
  /// The concepts that this graph models.
  struct traversal_category : boost::vertex_list_graph_tag,
                              boost::edge_list_graph_tag,
                              boost::bidirectional_graph_tag,
                              boost::adjacency_graph_tag {};
  /// \{ Counts, as boost::graph_traits asks for.
  using vertices_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using degree_size_type = std::size_t;
  /// \}

  /// All vertices, in increasing order.
  using vertex_iterator = boost::counting_iterator<std::size_t>;

  /// Goes once around a face.
  class out_edge_iterator
      : public boost::iterator_facade<out_edge_iterator, DualEdge, boost::forward_traversal_tag,
                                      DualEdge> {
   public:
    /// Of no structure: equal to others of that kind, and not to be moved.
    out_edge_iterator() = default;
    /// At `start`, before the first step or, with `is_end`, after the last.
    out_edge_iterator(const ArrangementStructure& structure, HalfedgeId start, bool is_end)
        : structure_(&structure), halfedge_(start.index()), start_(start.index()) {
      is_past_start_ = is_end;
    }

   private:
    friend class boost::iterator_core_access;
    DualEdge dereference() const { return DualEdge(HalfedgeId(halfedge_)); }
    bool equal(const out_edge_iterator& other) const {
      return halfedge_ == other.halfedge_ && is_past_start_ == other.is_past_start_;
    }
    void increment() {
      halfedge_ = structure_->next(HalfedgeId(halfedge_)).index();
      is_past_start_ = halfedge_ == start_;
    }

    const ArrangementStructure* structure_ = nullptr;
    std::size_t halfedge_ = 0;
    std::size_t start_ = 0;
    bool is_past_start_ = false;  ///< all the way round
  };

  /// The same edges, seen from the other side.
  struct Reversed {
    /// As its twin.
    DualEdge operator()(DualEdge e) const {
      return DualEdge(ArrangementStructure::twin(e.halfedge()));
    }
  };
  /// The edges around a face, as seen from outside of it.
  using in_edge_iterator = boost::transform_iterator<Reversed, out_edge_iterator, DualEdge>;

  /// The face on the other side of an edge.
  struct Target {
    const ArrangementStructure* structure = nullptr;  ///< not owned
    /// Its index.
    std::size_t operator()(DualEdge e) const {
      return structure->face(ArrangementStructure::twin(e.halfedge())).index();
    }
  };
  /// The faces across the edges of a face.
  using adjacency_iterator = boost::transform_iterator<Target, out_edge_iterator, std::size_t>;

  /// The edge of an index.
  struct FromIndex {
    /// As its first halfedge.
    DualEdge operator()(std::size_t edge) const {
      return DualEdge(ArrangementStructure::first_halfedge(EdgeId(edge)));
    }
  };
  /// All edges, in increasing order of index.
  using edge_iterator =
      boost::transform_iterator<FromIndex, boost::counting_iterator<std::size_t>, DualEdge>;

  /// No vertex of any graph.
  static vertex_descriptor null_vertex() { return static_cast<std::size_t>(-1); }

  /// \{ As the concepts of Boost.Graph define it. A vertex is the index of a FaceId.
  friend std::size_t num_vertices(const DualGraph& g) { return g.structure_->faces(); }
  friend std::size_t num_edges(const DualGraph& g) { return g.structure_->edges(); }

  friend std::pair<vertex_iterator, vertex_iterator> vertices(const DualGraph& g) {
    return {vertex_iterator(0), vertex_iterator(num_vertices(g))};
  }
  friend std::pair<edge_iterator, edge_iterator> edges(const DualGraph& g) {
    return {edge_iterator(boost::counting_iterator<std::size_t>(0), FromIndex{}),
            edge_iterator(boost::counting_iterator<std::size_t>(num_edges(g)), FromIndex{})};
  }
  friend std::size_t source(DualEdge e, const DualGraph& g) {
    return g.structure_->face(e.halfedge()).index();
  }
  friend std::size_t target(DualEdge e, const DualGraph& g) { return Target{g.structure_}(e); }

  friend std::pair<out_edge_iterator, out_edge_iterator> out_edges(std::size_t v,
                                                                   const DualGraph& g) {
    const std::optional<HalfedgeId> start = g.structure_->boundary(FaceId(v));
    if (!start) return {};
    return {out_edge_iterator(*g.structure_, *start, false),
            out_edge_iterator(*g.structure_, *start, true)};
  }
  friend std::pair<in_edge_iterator, in_edge_iterator> in_edges(std::size_t v,
                                                                const DualGraph& g) {
    const auto range = out_edges(v, g);
    return {in_edge_iterator(range.first, Reversed{}),
            in_edge_iterator(range.second, Reversed{})};
  }
  friend std::pair<adjacency_iterator, adjacency_iterator> adjacent_vertices(
      std::size_t v, const DualGraph& g) {
    const auto range = out_edges(v, g);
    return {adjacency_iterator(range.first, Target{g.structure_}),
            adjacency_iterator(range.second, Target{g.structure_})};
  }
  friend std::size_t out_degree(std::size_t v, const DualGraph& g) {
    std::size_t count = 0;
    for (auto [here, end] = out_edges(v, g); here != end; ++here) ++count;
    return count;
  }
  friend std::size_t in_degree(std::size_t v, const DualGraph& g) { return out_degree(v, g); }
  friend std::size_t degree(std::size_t v, const DualGraph& g) { return out_degree(v, g); }
  /// \}

  /// boost::edge_index: edges count from 0, as in the arrangement.
  struct EdgeIndexMap {
    /// \{ What boost::property_traits asks for.
    using key_type = DualEdge;
    using value_type = std::size_t;
    using reference = std::size_t;
    using category = boost::readable_property_map_tag;
    /// \}
    /// \{ The index of the edge.
    friend std::size_t get(EdgeIndexMap, DualEdge e) { return e.index(); }
    std::size_t operator[](DualEdge e) const { return e.index(); }
    /// \}
  };
  /// \{ The indices of vertices and edges, from 0, as property maps and one by one.
  friend boost::identity_property_map get(boost::vertex_index_t, const DualGraph&) {
    return {};
  }
  friend std::size_t get(boost::vertex_index_t, const DualGraph&, std::size_t v) { return v; }
  friend EdgeIndexMap get(boost::edge_index_t, const DualGraph&) { return {}; }
  friend std::size_t get(boost::edge_index_t, const DualGraph&, DualEdge e) {
    return e.index();
  }
  /// \}

 private:
  const ArrangementStructure* structure_;
};

}  // namespace stickslip

namespace boost {

/// The indices of a DualGraph's vertices: each is its own.
template <>
struct property_map<stickslip::DualGraph, vertex_index_t> {
  /// \{ The map, for graphs that may change and for those that may not.
  using type = identity_property_map;
  using const_type = identity_property_map;
  /// \}
};
/// The indices of a DualGraph's edges.
template <>
struct property_map<stickslip::DualGraph, edge_index_t> {
  /// \{ The map, for graphs that may change and for those that may not.
  using type = stickslip::DualGraph::EdgeIndexMap;
  using const_type = stickslip::DualGraph::EdgeIndexMap;
  /// \}
};

}  // namespace boost
