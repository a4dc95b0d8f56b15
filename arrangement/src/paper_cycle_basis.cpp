// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper_cycle_basis.hpp"

#include <algorithm>
#include <boost/dynamic_bitset.hpp>
#include <boost/pending/disjoint_sets.hpp>
#include <limits>
#include <utility>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using Bits = boost::dynamic_bitset<>;

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// Numbers the edges outside a spanning forest.
struct SpanningForest {
  explicit SpanningForest(const DualPolyhedron& graph)
      : components(boost::num_vertices(graph)), cotree(boost::num_edges(graph), kNone) {
    boost::disjoint_sets_with_storage<> trees(boost::num_vertices(graph));
    for (auto [v, end] = boost::vertices(graph); v != end; ++v) trees.make_set(*v);
    for (auto [e, end] = boost::edges(graph); e != end; ++e) {
      const std::size_t a = trees.find_set(boost::source(*e, graph));
      const std::size_t b = trees.find_set(boost::target(*e, graph));
      require(boost::source(*e, graph) != boost::target(*e, graph),
              "minimum_cycle_basis: the graph has a loop");
      if (a == b) {
        cotree[boost::get(boost::edge_index, graph, *e)] = cotree_size++;
      } else {
        trees.link(a, b);
        --components;
      }
    }
  }

  std::size_t components;
  std::size_t cotree_size = 0;
  std::vector<std::size_t> cotree;  ///< by edge: its number, or kNone for a forest edge
};

/// Shortest paths from (v, 0) to (v, 1); node 2v + parity.
class ParitySearch {
 public:
  explicit ParitySearch(const DualPolyhedron& graph)
      : graph_(graph), entered_by_(2 * boost::num_vertices(graph)) {
    queue_.reserve(entered_by_.size());
  }

  /// By edge index, whether it changes the parity.
  void set_witness(std::vector<bool> changes_parity) {
    changes_parity_ = std::move(changes_parity);
  }

  /// The number of edges of the path; kNone if there is none.
  std::size_t run(std::size_t vertex, std::size_t& edges_scanned) {
    std::fill(entered_by_.begin(), entered_by_.end(), Entry{});
    queue_.assign(1, 2 * vertex);
    entered_by_[2 * vertex] = {2 * vertex, kNone, 0};
    for (std::size_t head = 0; head < queue_.size(); ++head) {
      const std::size_t node = queue_[head];
      if (node == 2 * vertex + 1) return entered_by_[node].distance;
      for (auto [e, end] = boost::out_edges(node / 2, graph_); e != end; ++e) {
        ++edges_scanned;
        const std::size_t index = boost::get(boost::edge_index, graph_, *e);
        const std::size_t parity = node % 2 ^ (changes_parity_[index] ? 1U : 0U);
        const std::size_t next = 2 * boost::target(*e, graph_) + parity;
        if (entered_by_[next].from != kNone) continue;
        entered_by_[next] = {node, index, entered_by_[node].distance + 1};
        queue_.push_back(next);
      }
    }
    return kNone;
  }

  /// Of the path that run(vertex) found. Checks that no vertex is repeated.
  std::vector<std::size_t> edges_of_path(std::size_t vertex) const {
    std::vector<std::size_t> edges;
    std::vector<bool> is_met(boost::num_vertices(graph_), false);
    for (std::size_t node = 2 * vertex + 1; node != 2 * vertex; node = entered_by_[node].from) {
      require(!is_met[node / 2], "minimum_cycle_basis: a cycle meets a vertex twice");
      is_met[node / 2] = true;
      edges.push_back(entered_by_[node].edge);
    }
    std::sort(edges.begin(), edges.end());
    return edges;
  }

 private:
  struct Entry {
    std::size_t from = kNone;
    std::size_t edge = kNone;
    std::size_t distance = 0;
  };

  const DualPolyhedron& graph_;
  std::vector<bool> changes_parity_;
  std::vector<Entry> entered_by_;
  std::vector<std::size_t> queue_;
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
  // Again, for its path: only of the shortest walk is it known that it is a cycle.
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

  ParitySearch search(graph);
  for (std::size_t i = 0; i < witnesses.size(); ++i) {
    std::vector<bool> changes_parity(boost::num_edges(graph), false);
    for (std::size_t e = 0; e < changes_parity.size(); ++e) {
      changes_parity[e] = forest.cotree[e] != kNone && witnesses[i].test(forest.cotree[e]);
    }
    search.set_witness(std::move(changes_parity));
    result.cycles.push_back(shortest_odd_cycle(search, boost::num_vertices(graph), result));

    for (std::size_t j = i + 1; j < witnesses.size(); ++j) {
      bool is_odd = false;
      for (const std::size_t e : result.cycles.back()) {
        if (forest.cotree[e] != kNone && witnesses[j].test(forest.cotree[e])) is_odd = !is_odd;
      }
      if (is_odd) witnesses[j] ^= witnesses[i];
    }
  }
  return result;
}

}  // namespace stickslip
