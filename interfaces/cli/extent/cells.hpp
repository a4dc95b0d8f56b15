// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Cells of a plane that are proved one by one, for `map`, and for `region` in space or within
/// a bound on motions.
#pragma once

#include <string>
#include <vector>

#include "long_work.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/measures/map.hpp"

namespace stickslip {

/// How finely to look, and the folder for proofs.
struct CellsAsked {
  unsigned depth = MapOptions().depth;
  std::size_t node_limit = 0;
  std::string certificates{};  ///< a folder, or empty
  Tolerances uncertain{};      ///< the tolerances of the grasps of every cell
};

/// Returns the cells, with those undecided that the work does not come to in its time. Proofs
/// are written, and not kept.
std::vector<MapCell> proved_cells(const GraspBox& grasp, NormalLaw law, const MapAxis& x,
                                  const MapAxis& y, const CellsAsked& asked, LongWork& work);

/// Returns a table: which part of the area is stable, unstable and neither.
std::string shares_text(const std::vector<MapCell>& cells, const MapAxis& x, const MapAxis& y);

}  // namespace stickslip
