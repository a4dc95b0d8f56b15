// SPDX-License-Identifier: GPL-3.0-or-later
// Table II of the paper, and beyond it: cells, distinct states and times of the three
// enumerators on the same random grasps, in one run.
//
//     table2 [--max-paper-m 9] [--max-m 3000] [--json FILE] [--csv FILE] [--quick]
//
// All enumerators of the table do the same task: every slip state in memory. Times are
// processor time of one thread; those of the table are medians over grasps of the best of
// three rounds each. Exit code 1 if any count is not what it must be.
#include <algorithm>
#include <array>
#include <exception>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "arguments.hpp"
#include "random_planes.hpp"
#include "report.hpp"
#include "statistics.hpp"
#include "stickslip/arrangement/arrangement_structure.hpp"
#include "stickslip/arrangement/sweep.hpp"

namespace stickslip::bench {
namespace {

struct Sizes {
  std::size_t max_paper_m = 9;
  std::size_t max_m = 3000;
  std::string json;
  std::string csv;
  bool quick = false;
};

struct CountError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

void check(bool holds, const std::string& what, std::size_t m) {
  if (!holds) throw CountError("m = " + std::to_string(m) + ": wrong " + what);
}

std::optional<Published> published(std::size_t m) {
  constexpr std::array<Published, 8> kTable = {{{10, 0.006},
                                                {26, 0.02},
                                                {50, 0.09},
                                                {82, 0.42},
                                                {122, 1.5},
                                                {170, 4.8},
                                                {226, 13.8},
                                                {290, 35.7}}};
  if (m < 2 || m - 2 >= kTable.size()) return std::nullopt;
  return kTable[m - 2];
}

/// Distinct states of a simple arrangement of m >= 2 planes (slip_states.hpp).
std::size_t states_of_simple(std::size_t m) {
  return m == 2 ? cells_of_simple(m) - 1 : cells_of_simple(m) + 1;
}

/// Checks every enumerator's counts on one grasp, and fills those of the row.
void count_states(const std::vector<Vector3>& planes, bool is_first, TableRow& row) {
  const std::size_t m = row.m;
  const PaperEnumeration paper = enumerate_slip_states_paper(planes);
  const SlipStates cgal = enumerate_slip_states_cgal(planes);
  const SlipStates sweep = enumerate_slip_states_sweep(planes);
  for (const std::size_t cells : {paper.cells(), cgal.counts.cells(), sweep.counts.cells()}) {
    check(cells == cells_of_simple(m), "number of cells", m);
    check(!row.published || cells == row.published->cells, "published number", m);
  }
  check(cgal.states == sweep.states, "states", m);
  check(cgal.states.size() == states_of_simple(m), "number of states", m);
  // All-stick sorts last.
  std::vector<SlipState> expected = cgal.states;
  if (m >= 3) expected.pop_back();
  check(paper.states == expected, "states of the paper's steps", m);
  row.cells = cgal.counts.cells();
  row.distinct_states = cgal.states.size();
  row.states_of_paper_steps = paper.states.size();
  if (is_first) row.work = paper.work;
}

TableRow measure_table_row(std::size_t m, std::size_t instances, bool quick) {
  TableRow row;
  row.m = m;
  row.published = published(m);
  std::vector<double> paper;
  std::array<std::vector<double>, 3> steps;
  std::vector<double> cgal;
  std::vector<double> sweep;
  const auto time = [quick](std::vector<double>& into, const auto& work) {
    into.push_back(seconds_per_call(work, quick ? 1 : 3, quick ? 0 : 0.002));
  };
  for (std::size_t i = 0; i < instances; ++i) {
    const std::vector<Vector3> planes = random_simple_planes(m, i);
    count_states(planes, i == 0, row);
    const std::vector<SlipState> regions = paper_regions(planes);
    const std::vector<PaperFacet> facets = paper_facets(regions);
    time(paper, [&] { enumerate_slip_states_paper(planes); });
    time(steps[0], [&] { paper_regions(planes); });
    time(steps[1], [&] { paper_facets(regions); });
    time(steps[2], [&] { paper_lines(regions, facets); });
    time(cgal, [&] { enumerate_slip_states_cgal(planes); });
    time(sweep, [&] { enumerate_slip_states_sweep(planes); });
  }
  row.paper = median(paper);
  for (std::size_t s = 0; s < steps.size(); ++s) row.paper_steps[s] = median(steps[s]);
  row.cgal = median(cgal);
  row.sweep = median(sweep);
  return row;
}

ScalingRow measure_scaling_row(std::size_t m) {
  constexpr std::size_t kLargestForCgal = 200;
  const std::vector<Vector3> planes = random_simple_planes(m, 0);
  const int rounds = m <= 1000 ? 3 : 1;
  ScalingRow row;
  row.m = m;
  row.count = measure_in_child([&] { return count_cells(planes).cells(); }, 3);
  row.visit = measure_in_child(
      [&] {
        std::size_t cells = 0;
        visit_cells(planes, [&](CellKind, const PackedSigns&) { ++cells; });
        return cells;
      },
      rounds);
  row.structure =
      measure_in_child([&] { return ArrangementStructure(planes).counts().cells(); }, rounds);
  if (m <= kLargestForCgal) {
    row.cgal = measure_in_child(
        [&] { return enumerate_slip_states_cgal(planes).counts.cells(); }, rounds);
    check(row.cgal->result == cells_of_simple(m), "number of cells (cgal)", m);
  }
  row.cells = row.count.result;
  row.distinct_states = count_cells(planes).distinct_states;
  for (const ChildMeasurement* measured : {&row.count, &row.visit, &row.structure}) {
    check(measured->result == cells_of_simple(m), "number of cells (sweep)", m);
  }
  check(row.distinct_states == states_of_simple(m), "number of states (sweep)", m);
  return row;
}

void write_files(const Sizes& arguments, const Report& report) {
  const auto write = [](const std::string& name, const auto& writer) {
    if (name.empty()) return;
    std::ofstream out(name);
    writer(out);
    if (!out) throw std::runtime_error(name + ": cannot be written");
  };
  write(arguments.json, [&](std::ostream& out) { out << to_json(report).dump(1) << '\n'; });
  write(arguments.csv, [&](std::ostream& out) { write_csv(report, out); });
}

void run(const Sizes& arguments) {
  Report report;
  report.instances = arguments.quick ? 2 : 15;
  const std::size_t max_paper_m =
      arguments.quick ? std::min<std::size_t>(arguments.max_paper_m, 9) : arguments.max_paper_m;
  const std::size_t max_m =
      arguments.quick ? std::min<std::size_t>(arguments.max_m, 60) : arguments.max_m;
  for (std::size_t m = 2; m <= max_paper_m; ++m) {
    report.table.push_back(measure_table_row(m, report.instances, arguments.quick));
  }
  print_table(report);
  for (const std::size_t m : {10U, 20U, 50U, 100U, 200U, 500U, 1000U, 2000U, 3000U}) {
    if (m <= max_m) report.scaling.push_back(measure_scaling_row(m));
  }
  print_scaling(report);
  write_files(arguments, report);
}

}  // namespace
}  // namespace stickslip::bench

int main(int argc, char** argv) {
  stickslip::bench::Sizes arguments;
  stickslip::bench::Arguments line(
      "table2", "Table II of the paper: slip states of m random contacts, counted and timed");
  stickslip::Command& app = line.described();
  app.add_option("--max-paper-m", arguments.max_paper_m,
                 "Largest m of the table, where all three enumerators run")
      ->capture_default_str();
  app.add_option("--max-m", arguments.max_m, "Largest m of the scaling section")
      ->capture_default_str();
  app.add_option("--json", arguments.json, "Also write the numbers to this file as JSON");
  app.add_option("--csv", arguments.csv, "Also write the numbers to this file as CSV");
  app.add_flag("--quick", arguments.quick,
               "Two grasps for each m, one call each, at most 60 contacts: for the counts");
  if (const auto code = line.read(argc, argv)) return *code;
  try {
    stickslip::bench::run(arguments);
  } catch (const std::exception& error) {
    std::cerr << "table2: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
