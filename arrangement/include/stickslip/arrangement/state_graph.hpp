// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Which slip states border on each other: the cells of an arrangement, joined by facets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "stickslip/arrangement/contact_states.hpp"

namespace stickslip {

/// States whose motions have the largest dimension, *cells*, and those of one dimension less,
/// *facets*. A motion that leaves a cell meets a facet first, but for special ones, and each
/// facet is between two cells.
struct StateGraph {
  /// A facet between two cells.
  struct Facet {
    std::string state;       ///< as StatePlanes::text
    std::size_t first = 0;   ///< the number of one cell beside it
    std::size_t second = 0;  ///< the number of the other one, which is larger
  };
  int dimension = 0;               ///< that of cells
  std::vector<std::string> cells;  ///< as StatePlanes::text, in the order of visit_faces()
  std::vector<Facet> facets;       ///< all facets, in the same order
  bool complete = true;  ///< whether nobody ended the walk; if false there is no facet
};

/// Returns the graph of a set of states. `go_on` is as in FaceOptions. Throws InputError with
/// the place "graph" for the sets kOpening and kContact: their motions are in one cell, where
/// all contacts open.
StateGraph state_graph(const StatePlanes& planes,
                       const std::function<bool(std::uint64_t)>& go_on = {});

}  // namespace stickslip
