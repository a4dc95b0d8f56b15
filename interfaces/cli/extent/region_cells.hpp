// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The answer of `region` in space, and if motions are bounded: a window of the plane, cell by
/// cell.
#pragma once

#include <string>

#include "cells.hpp"
#include "question_options.hpp"

namespace stickslip {

/// A question about a region, exact or not: the plane ORIGIN + s U + t V, as it was given, where
/// an empty text is the default; and how its cells are found.
struct RegionAsked {
  std::string origin;
  std::string torque;
  std::string u;
  std::string v;
  std::string within;
  CellsAsked cells;
  std::string time_limit;
  NumberOptions numbers;
};

/// Returns true if the region is not found exactly.
inline bool is_found_in_cells(const Question& question) {
  return question.box() != nullptr;
}

/// Answers the question. Returns the exit code.
int answer_region_in_cells(const Question& question, const RegionAsked& asked);
/// Draws the region into a file, or prints the picture. Returns the exit code.
int draw_region_in_cells(const Question& question, const RegionAsked& asked,
                         const std::string& output);

}  // namespace stickslip
