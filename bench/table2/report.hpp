// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What table2 found, and its three forms.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "child.hpp"
#include "stickslip/arrangement/paper_enumerator.hpp"

namespace stickslip::bench {

/// A column of the paper's Table II.
struct Published {
  std::size_t cells;
  double seconds;
};

/// One m of Table II. Times are medians over the instances.
struct TableRow {
  std::size_t m = 0;
  std::optional<Published> published;  ///< the paper has m = 2 .. 9
  std::size_t cells = 0;
  std::size_t distinct_states = 0;
  std::size_t states_of_paper_steps = 0;  ///< distinct; without all-stick from m = 3
  double paper = 0;
  double paper_steps[3] = {0, 0, 0};
  double cgal = 0;
  double sweep = 0;
  PaperWork work;  ///< of the first instance; all but pivots and scans are the same for all
};

struct ScalingRow {
  std::size_t m = 0;
  std::size_t cells = 0;
  std::size_t distinct_states = 0;
  ChildMeasurement count;
  ChildMeasurement visit;
  ChildMeasurement structure;
  std::optional<ChildMeasurement> cgal;
};

struct Report {
  std::size_t instances = 0;
  std::vector<TableRow> table;
  std::vector<ScalingRow> scaling;
};

void print_table(const Report& report);
void print_scaling(const Report& report);
nlohmann::ordered_json to_json(const Report& report);
/// One number of seconds a line: section,m,enumerator,task,cells,distinct_states,seconds,
/// peak_bytes; empty where there is none.
void write_csv(const Report& report, std::ostream& out);

}  // namespace stickslip::bench
