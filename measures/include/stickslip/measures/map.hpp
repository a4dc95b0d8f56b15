// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Maps of verdicts over two numbers, proved cell by cell.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stickslip/engine/box_verdict.hpp"

namespace stickslip {

/// The number that an axis of a map varies.
enum class AxisKind {
  kFriction,   ///< all coefficients by a factor, or one by its value
  kStiffness,  ///< all stiffnesses by a factor, or one by its value
  kPreload,    ///< all preloads by a factor, or one by its value
  kWrench,     ///< a component, by its value
  kLoad,       ///< the whole wrench, by a factor
  kDirection,  ///< the force of the wrench, which keeps its size and turns: degrees from +x
  kAlong       ///< a multiple of a wrench, added
};

/// An axis of a map.
struct MapAxis {
  std::string name;                    ///< the name as it was given: "friction[2]"
  std::string place;                   ///< the option it came from, for errors: "--x"
  AxisKind kind = AxisKind::kLoad;     ///< the sort of number that varies
  std::optional<std::size_t> index{};  ///< the contact or the component that varies; nothing:
                                       ///< all do
  Interval range;                      ///< the range of the factor or value
  RationalRow along{};                 ///< the wrench of kAlong
};

/// Reads "NAME=A:B" for this one grasp: "friction[2]=0:1", "load=0:2", "direction=0:360" (of a
/// force in the plane) or, for a multiple of a wrench that is added, "0,1,0=-1:1". Throws
/// InputError with this place if the text is no axis, or if the range leaves the valid grasps.
MapAxis parse_axis(const GraspBox& grasp, std::string_view text, const std::string& place);

/// Returns whether two axes, each along a wrench that is added, span no plane.
bool are_parallel(const MapAxis& a, const MapAxis& b);

/// A cell of a map: a rectangle of the plane of its axes.
struct MapCell {
  Interval x;            ///< along the first axis
  Interval y;            ///< along the second axis
  BoxDecision decision;  ///< stable or unstable throughout, or undecided
};

/// Returns the box of grasps in a rectangle, each with all grasps within the tolerances
/// `uncertain` of it. The box has more grasps than the rectangle if all frictions (stiffnesses,
/// preloads, components) change by one factor, if the load turns, or if an axis is along a
/// wrench of several components. Throws InputError as GraspBox::widened() does.
GraspBox box_of_cell(const GraspBox& grasp, const MapAxis& x_axis, const MapAxis& y_axis,
                     const Interval& x, const Interval& y, const Tolerances& uncertain);

/// How finely to look.
struct MapOptions {
  unsigned depth = 6;      ///< the finest cells are a 2^depth-th of an axis
  SearchOptions box;       ///< the options of each proof
  Tolerances uncertain{};  ///< the tolerances of the grasps of every cell
};

/// Maps the rectangle of the axes by a quadtree: a cell without a proof is cut into four, down
/// to the finest. Calls `take` with each cell, the largest first; the cells tile the rectangle.
/// Calls `progress` with the part of the rectangle that is done, from 0 to 1. This thread makes
/// both calls, while others prove. Throws InputError if both axes vary the same number, if one
/// varies the load of a box that has a ball of loads, and as box_of_cell() does.
void map_verdicts(const GraspBox& grasp, NormalLaw law, const MapAxis& x_axis,
                  const MapAxis& y_axis, const MapOptions& options,
                  const std::function<void(MapCell)>& take,
                  const std::function<void(double)>& progress = {});

}  // namespace stickslip
