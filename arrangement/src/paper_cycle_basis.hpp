// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Minimum cycle bases of undirected graphs with unit weights.
///
/// The cycle space of a graph with c components is the GF(2) vector space, of dimension
/// N = E - V + c, of the edge sets in which every vertex has even degree. A minimum cycle basis
/// is a basis of simple cycles with the least total length.
///
/// J. C. de Pina, "Applications of shortest path methods", thesis, Universiteit van Amsterdam,
/// 1995; as stated by K. Mehlhorn and D. Michail, "Implementing minimum cycle basis
/// algorithms", J. Experimental Algorithmics 11, 2006 (WEA 2005):
///
///     fix a spanning forest with the other edges e_1 .. e_N;  S_i = {e_i}
///     for i = 1 .. N:
///       C_i = a shortest cycle that has an odd number of edges in S_i
///       for j = i + 1 .. N:  if C_i has an odd number of edges in S_j, then S_j = S_j + S_i
///
/// Why it is right: S_i has even intersection with C_1 .. C_{i-1} and odd with C_i, so the
/// cycles are independent. In any basis some cycle has odd intersection with S_i; exchanging
/// it for C_i makes nothing longer.
///
/// C_i is found in the graph with vertices (v, parity) in which an edge of S_i changes the
/// parity: the shortest of all paths from (v, 0) to (v, 1), for all v. The shortest such closed
/// walk repeats no vertex: else it splits in two, and the odd one is shorter.
///
/// N V breadth-first searches of O(V + E), and N^2 / 2 sums of N bits: O(V E^2 + E^3 / 64).
#pragma once

#include <boost/graph/adjacency_list.hpp>
#include <cstddef>
#include <vector>

namespace stickslip::arrangement_detail {

/// The graph. Its edges carry the indices 0 .. E - 1.
using DualPolyhedron =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                          boost::property<boost::edge_index_t, std::size_t>>;

struct CycleBasis {
  std::vector<std::vector<std::size_t>> cycles;  ///< edge indices, increasing
  std::size_t components = 0;
  std::size_t path_searches = 0;
  std::size_t edges_scanned = 0;
};

/// Returns a minimum cycle basis. Requires a graph without loops. Deterministic: the order of
/// vertices and edges decides between cycles of equal length. Throws ContractError if a cycle
/// found is not simple.
CycleBasis minimum_cycle_basis(const DualPolyhedron& graph);

}  // namespace stickslip::arrangement_detail
