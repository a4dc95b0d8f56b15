// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/arrangement/state_graph.hpp"

#include <algorithm>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "distinct_planes.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

/// The signs of a face on all planes, one after the other. All of them count.
std::string signs_of(const Face& face, std::size_t planes) {
  std::string signs;
  for (std::size_t i = 0; i < planes; ++i) signs += to_char(*face.sign(i));
  return signs;
}

char opposite_sign(char sign) {
  return sign == '+' ? '-' : sign == '-' ? '+' : sign;
}

}  // namespace

StateGraph state_graph(const StatePlanes& planes,
                       const std::function<bool(std::uint64_t)>& go_on) {
  if (planes.set == StateSet::kOpening || planes.set == StateSet::kContact) {
    throw InputError("", "graph", "all motions that press nothing together are in one cell",
                     "ask for the modes slip, full or closed");
  }
  StateGraph graph;
  std::vector<Row> closed;
  for (const FacePlane& plane : planes.planes) {
    if (plane.side == AllowedSigns::kZero) closed.push_back(plane.row);
  }
  graph.dimension =
      static_cast<int>(planes.coordinates) - arrangement_detail::rank_of(closed);
  FaceOptions options;
  options.go_on = go_on;
  options.least_dimension = std::max(0, graph.dimension - 1);
  std::unordered_map<std::string, std::size_t> cells;
  std::string first_cell;
  std::vector<std::string> signs_of_facets;
  const FaceVisitor visitor = [&](const Face& face) {
    std::string signs = signs_of(face, planes.planes.size());
    if (face.dimension() < graph.dimension) {
      signs_of_facets.push_back(std::move(signs));
      graph.facets.push_back({planes.text(face), 0, 0});
    } else {
      if (cells.empty()) first_cell = signs;
      cells.emplace(std::move(signs), graph.cells.size());
      graph.cells.push_back(planes.text(face));
    }
    return true;
  };
  graph.complete = visit_faces(planes.coordinates, planes.planes, visitor, options).complete;
  if (!graph.complete) {
    graph.facets.clear();
    return graph;
  }
  // Rows that are 0 on a facet, and not everywhere, are multiples of one. So the cells beside
  // it have the signs there that any cell has, or the opposite ones.
  for (std::size_t i = 0; i < graph.facets.size(); ++i) {
    std::string one = signs_of_facets[i];
    std::string other = one;
    for (std::size_t j = 0; j < one.size(); ++j) {
      if (one[j] != '0') continue;
      one[j] = first_cell[j];
      other[j] = opposite_sign(first_cell[j]);
    }
    const auto a = cells.find(one);
    const auto b = cells.find(other);
    require(a != cells.end() && b != cells.end() && a != b, "a facet is between two cells");
    std::tie(graph.facets[i].first, graph.facets[i].second) = std::minmax(a->second, b->second);
  }
  return graph;
}

}  // namespace stickslip
