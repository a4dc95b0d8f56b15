// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What Haas-Heger et al. (RSS 2018) print about their examples, as they print it, and what is
/// to be said about the rows that are misprinted. Numbers are texts, "0.025", so that they can
/// be held against the page; the program reads them exactly.
///
/// Signs are the paper's tables': w is applied to the object, the contact forces sum to -w,
/// f_i = (f_n, f_t) with f_t along the normal turned by +90 degrees, d = (x, y, r).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "stickslip/core/grasp.hpp"

namespace stickslip {

/// A printed motion and printed forces; `forces` is empty where the paper prints dashes.
struct PrintedSolution {
  std::vector<std::string> forces;
  std::string twist;
};

/// What a row should say, where it says something else.
struct Correction {
  bool printed_is_solution = false;  ///< the row as printed is an equilibrium all the same
  std::string outside_cone;          ///< its forces outside the friction cone, "f1, f3"
  PrintedSolution intent;
  std::string remark;
};

/// A row of Table I or III.
struct ForceRow {
  std::string wrench;
  std::string preload;
  std::string stable;  ///< "Yes" or "No"
  PrintedSolution solution;
  std::optional<Correction> correction;
};

struct ForceTable {
  std::string title;
  std::string grasp_file;
  std::vector<ForceRow> rows;
};

/// A column of Table II. The paper counts cells of an arrangement; the number of distinct slip
/// states, all-stick included, is ours (stickslip/arrangement/slip_states.hpp).
struct CountColumn {
  std::size_t contacts;
  std::string cells;
  std::string distinct_states;
};

/// The counts that belong to one of the figures.
struct FigureCounts {
  std::string title;
  std::string grasp_file;
  CountColumn counts;
};

/// A verdict that follows from the paper. Without preload or wrench: those of the grasp file.
struct Claim {
  std::optional<std::string> preload;
  std::optional<std::string> wrench;
  bool stable;
};

struct ClaimGroup {
  std::string title;
  std::string grasp_file;
  NormalLaw law;
  std::vector<Claim> claims;
};

const ForceTable& table_1();
const std::vector<CountColumn>& table_2();
const ForceTable& table_3();

/// Rows of Table III as the literal Eqs. 2 and 4 have them.
const ClaimGroup& table_3_without_detachment();
const std::vector<FigureCounts>& figure_counts();
/// Figs. 3, 4 and 7 and Section VI.
const std::vector<ClaimGroup>& claims();

}  // namespace stickslip
