// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How `region` answers in space, and where motions are bounded: a window of the plane, cell by
/// cell.
#pragma once

#include <string>

#include "cells.hpp"
#include "question_options.hpp"

namespace stickslip {

/// The plane ORIGIN + s U + t V, as it was given; empty: by default.
struct RegionCellsArguments {
  std::string origin;
  std::string torque;
  std::string u;
  std::string v;
  std::string within;
  CellsAsked cells;
  NumberOptions numbers;
};

/// Whether the region is not found exactly.
inline bool is_found_in_cells(const Question& question) {
  return question.in_space() || question.is_bounded();
}

/// The exit code.
int answer_region_in_cells(const Question& question, const RegionCellsArguments& arguments);
/// Draws it into a file, or prints it.
int draw_region_in_cells(const Question& question, const RegionCellsArguments& arguments,
                         const std::string& output);

}  // namespace stickslip
