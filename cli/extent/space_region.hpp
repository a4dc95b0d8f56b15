// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How `region` answers about a grasp in space: a window of the plane, cell by cell.
#pragma once

#include <string>

#include "cells.hpp"
#include "question_options.hpp"

namespace stickslip {

/// The plane ORIGIN + s U + t V, as it was given; empty: by default.
struct SpaceRegionArguments {
  std::string origin;
  std::string u;
  std::string v;
  std::string within;
  CellsAsked cells;
  NumberOptions numbers;
};

/// The exit code.
int answer_region_in_space(const Question& question, const SpaceRegionArguments& arguments);
/// Draws it into a file, or prints it.
int draw_region_in_space(const Question& question, const SpaceRegionArguments& arguments,
                         const std::string& output);

}  // namespace stickslip
