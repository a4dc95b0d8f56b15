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

/// What an axis of a map varies.
enum class AxisKind {
  kFriction,   ///< all coefficients by a factor, or one by its value
  kStiffness,  ///< likewise
  kPreload,    ///< likewise
  kWrench,     ///< a component, by its value
  kLoad,       ///< the whole wrench, by a factor
  kDirection,  ///< the force of the wrench, which keeps its size and turns: degrees from +x
  kAlong       ///< a multiple of a wrench, added
};

/// An axis of a map.
struct MapAxis {
  std::string name;                    ///< as it was given: "friction[2]"
  std::string place;                   ///< where: "--x", in errors
  AxisKind kind = AxisKind::kLoad;     ///< of what
  std::optional<std::size_t> index{};  ///< of a contact or a component; nothing: of all
  Interval range;                      ///< of the factor or value
  RationalRow along{};                 ///< of kAlong: the wrench
};

/// "NAME=A:B", such as "friction[2]=0:1", "load=0:2", "direction=0:360" or, for a multiple of a
/// wrench that is added, "0,1,0=-1:1", for this one grasp; directions are of a force in the
/// plane. Throws InputError with this place for what is no axis, or leaves the grasps that
/// there are.
MapAxis parse_axis(const GraspBox& grasp, std::string_view text, const std::string& place);

/// A cell of a map: a rectangle of the plane of its axes.
struct MapCell {
  Interval x;            ///< along the first axis
  Interval y;            ///< along the second axis
  BoxDecision decision;  ///< stable or unstable throughout, or undecided
};

/// The box of grasps in a rectangle, each with all that are as near as `uncertain` says. Where
/// all frictions (stiffnesses, preloads, components) change by one factor, or the load turns,
/// it has more grasps than the rectangle; so it has along wrenches of several components.
/// Throws InputError as GraspBox::widened().
GraspBox box_of_cell(const GraspBox& grasp, const MapAxis& x_axis, const MapAxis& y_axis,
                     const Interval& x, const Interval& y, const Tolerances& uncertain);

/// How finely to look.
struct MapOptions {
  unsigned depth = 6;      ///< the finest cells are a 2^depth-th of an axis
  SearchOptions box;       ///< of each proof
  Tolerances uncertain{};  ///< of the grasps of every cell
};

/// A quadtree: a cell without a proof is cut into four, down to the finest. `take` is called
/// with each cell in turn, the largest first, which tile the rectangle of the axes; `progress`
/// with the part of the rectangle that is done, from 0 to 1. Both are called by this thread,
/// while others prove. Throws InputError if both axes vary the same number, if one varies the
/// load of which there is a ball, and as box_of_cell().
void map_verdicts(const GraspBox& grasp, NormalLaw law, const MapAxis& x_axis,
                  const MapAxis& y_axis, const MapOptions& options,
                  const std::function<void(MapCell)>& take,
                  const std::function<void(double)>& progress = {});

}  // namespace stickslip
