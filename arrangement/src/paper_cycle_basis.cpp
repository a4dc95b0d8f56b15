// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper_cycle_basis.hpp"

#include <algorithm>
#include <boost/dynamic_bitset.hpp>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/incremental_components.hpp>
#include <boost/pending/disjoint_sets.hpp>
#include <boost/pending/queue.hpp>
#include <limits>

#include "stickslip/core/error.hpp"

namespace stickslip::arrangement_detail {
namespace {

using Bits = boost::dynamic_bitset<>;

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// A spanning forest, and numbers for the edges outside it.
struct SpanningForest {
  explicit SpanningForest(const DualPolyhedron& graph)
      : components(boost::num_vertices(graph)), cotree(boost::num_edges(graph), kNone) {
    boost::disjoint_sets_with_storage<> trees(boost::num_vertices(graph));
    for (auto [e, end] = boost::edges(graph); e != end; ++e) {
      const std::size_t a = boost::source(*e, graph);
      const std::size_t b = boost::target(*e, graph);
      require(a != b, "minimum_cycle_basis: the graph has a loop");
      if (boost::same_component(a, b, trees)) {
        cotree[boost::get(boost::edge_index, graph, *e)] = cotree_size++;
      } else {
        trees.union_set(a, b);
        --components;
      }
    }
  }

  bool is_odd(std::size_t edge, const Bits& witness) const {
    return cotree[edge] != kNone && witness.test(cotree[edge]);
  }

  std::size_t components;
  std::size_t cotree_size = 0;
  std::vector<std::size_t> cotree;  ///< the number of an edge, or kNone for a forest edge
};

using Edge = boost::graph_traits<DualPolyhedron>::edge_descriptor;

/// Searches shortest paths from (v, 0) to (v, 1) in the graph of nodes 2v + parity.
class ParitySearch {
 public:
  /// Makes a search in which the edges of `witness` change the parity.
  ParitySearch(const DualPolyhedron& graph, const SpanningForest& forest, const Bits& witness)
      : graph_(2 * boost::num_vertices(graph)),
        colors_(boost::num_vertices(graph_)),
        distance_(colors_.size()),
        entered_by_(colors_.size()) {
    for (auto [e, end] = boost::edges(graph); e != end; ++e) {
      const std::size_t index = boost::get(boost::edge_index, graph, *e);
      const std::size_t a = 2 * boost::source(*e, graph);
      const std::size_t b = 2 * boost::target(*e, graph);
      const std::size_t change = forest.is_odd(index, witness) ? 1 : 0;
      boost::add_edge(a, b + change, index, graph_);
      boost::add_edge(a + 1, b + 1 - change, index, graph_);
    }
  }

  /// Returns the number of edges of the path; kNone if there is none.
  std::size_t run(std::size_t vertex, std::size_t& edges_scanned) {
    const std::size_t goal = 2 * vertex + 1;
    std::fill(colors_.begin(), colors_.end(), boost::white_color);
    distance_[2 * vertex] = 0;
    QueueUpTo queue(goal);
    boost::breadth_first_visit(graph_, 2 * vertex, queue, Recorder(*this, edges_scanned),
                               colors_.data());
    return colors_[goal] == boost::white_color ? kNone : distance_[goal];
  }

  /// Returns the edges of the path that run(vertex) found. Checks that no vertex is repeated.
  std::vector<std::size_t> edges_of_path(std::size_t vertex) const {
    std::vector<std::size_t> edges;
    std::vector<bool> is_met(colors_.size() / 2, false);
    for (std::size_t node = 2 * vertex + 1; node != 2 * vertex;) {
      require(!is_met[node / 2], "minimum_cycle_basis: a cycle meets a vertex twice");
      is_met[node / 2] = true;
      edges.push_back(boost::get(boost::edge_index, graph_, entered_by_[node]));
      node = boost::source(entered_by_[node], graph_);
    }
    std::sort(edges.begin(), edges.end());
    return edges;
  }

 private:
  /// A queue that seems empty once the goal is the next to be taken out, so that the search
  /// ends there.
  class QueueUpTo : public boost::queue<std::size_t> {
   public:
    explicit QueueUpTo(std::size_t goal) : goal_(goal) {}
    bool empty() const { return boost::queue<std::size_t>::empty() || top() == goal_; }

   private:
    std::size_t goal_;
  };

  class Recorder : public boost::default_bfs_visitor {
   public:
    Recorder(ParitySearch& search, std::size_t& edges_scanned)
        : search_(search), edges_scanned_(edges_scanned) {}
    void examine_edge(Edge, const DualPolyhedron&) { ++edges_scanned_; }
    void tree_edge(Edge e, const DualPolyhedron& graph) {
      const std::size_t to = boost::target(e, graph);
      search_.distance_[to] = search_.distance_[boost::source(e, graph)] + 1;
      search_.entered_by_[to] = e;
    }

   private:
    ParitySearch& search_;
    std::size_t& edges_scanned_;
  };

  DualPolyhedron graph_;
  std::vector<boost::default_color_type> colors_;
  std::vector<std::size_t> distance_;
  std::vector<Edge> entered_by_;
};

std::vector<std::size_t> shortest_odd_cycle(ParitySearch& search, std::size_t vertices,
                                            CycleBasis& result) {
  std::size_t shortest = kNone;
  std::size_t start = 0;
  for (std::size_t v = 0; v < vertices; ++v) {
    ++result.path_searches;
    const std::size_t length = search.run(v, result.edges_scanned);
    if (length < shortest) {
      shortest = length;
      start = v;
    }
  }
  require(shortest != kNone, "minimum_cycle_basis: no cycle has an odd part in the witness");
  // The search runs again for its path: only the shortest walk is known to be a cycle.
  ++result.path_searches;
  search.run(start, result.edges_scanned);
  return search.edges_of_path(start);
}

}  // namespace

CycleBasis minimum_cycle_basis(const DualPolyhedron& graph) {
  CycleBasis result;
  const SpanningForest forest(graph);
  result.components = forest.components;

  std::vector<Bits> witnesses(forest.cotree_size, Bits(forest.cotree_size));
  for (std::size_t i = 0; i < witnesses.size(); ++i) witnesses[i].set(i);

  for (std::size_t i = 0; i < witnesses.size(); ++i) {
    ParitySearch search(graph, forest, witnesses[i]);
    result.cycles.push_back(shortest_odd_cycle(search, boost::num_vertices(graph), result));
    const std::vector<std::size_t>& cycle = result.cycles.back();
    for (std::size_t j = i + 1; j < witnesses.size(); ++j) {
      const auto odd = std::count_if(cycle.begin(), cycle.end(), [&](std::size_t e) {
        return forest.is_odd(e, witnesses[j]);
      });
      if (odd % 2 == 1) witnesses[j] ^= witnesses[i];
    }
  }
  return result;
}

}  // namespace stickslip::arrangement_detail
