// SPDX-License-Identifier: GPL-3.0-or-later
#include "report.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>

namespace stickslip::bench {
namespace {

/// Three digits, in s, ms or us.
std::string show_seconds(double seconds) {
  const char* unit = seconds >= 1 ? "s" : seconds >= 1e-3 ? "ms" : "us";
  const double value = seconds * (seconds >= 1 ? 1 : seconds >= 1e-3 ? 1e3 : 1e6);
  char text[32];
  std::snprintf(text, sizeof text, "%.*f %s",
                value >= 100  ? 0
                : value >= 10 ? 1
                              : 2,
                value, unit);
  return text;
}

std::string show_ratio(double ratio) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", ratio >= 10 ? 0 : 1, ratio);
  return text;
}

std::string show_megabytes(std::size_t bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", static_cast<double>(bytes) / 1e6);
  return text;
}

nlohmann::ordered_json to_json(const ChildMeasurement& measurement) {
  return {{"seconds", measurement.seconds}, {"peak_bytes", measurement.peak_bytes}};
}

void print_work(const Report& report) {
  std::printf("\nThe steps of `paper`: their times and what they did.\n");
  std::printf("%3s %9s %9s %9s  %6s %8s %8s %8s %10s\n", "m", "Step 1", "Step 2", "Step 3",
              "LPs", "pivots", "pairs", "searches", "edges seen");
  for (const TableRow& row : report.table) {
    std::printf(
        "%3zu %9s %9s %9s  %6zu %8zu %8zu %8zu %10zu\n", row.m,
        show_seconds(row.paper_steps[0]).c_str(), show_seconds(row.paper_steps[1]).c_str(),
        show_seconds(row.paper_steps[2]).c_str(), row.work.linear_programs, row.work.pivots,
        row.work.pairs_compared, row.work.path_searches, row.work.edges_scanned);
  }
}

}  // namespace

void print_table(const Report& report) {
  std::printf(
      "Table II: all slip states of m random contacts. Medians over %zu grasps for each m.\n"
      "`printed` is the time in the paper, of its own program on a 2.80 GHz Core i7 (2018).\n",
      report.instances);
  std::printf("%3s %6s %9s %6s  %9s %9s %9s %9s  %13s %13s %12s %11s\n", "m", "cells",
              "published", "states", "printed", "paper", "cgal", "sweep", "printed/paper",
              "printed/sweep", "paper/sweep", "cgal/sweep");
  for (const TableRow& row : report.table) {
    const bool is_published = row.published.has_value();
    std::printf(
        "%3zu %6zu %9s %6zu  %9s %9s %9s %9s  %13s %13s %12s %11s\n", row.m, row.cells,
        is_published ? std::to_string(row.published->cells).c_str() : "-", row.distinct_states,
        is_published ? show_seconds(row.published->seconds).c_str() : "-",
        show_seconds(row.paper).c_str(), show_seconds(row.cgal).c_str(),
        show_seconds(row.sweep).c_str(),
        is_published ? show_ratio(row.published->seconds / row.paper).c_str() : "-",
        is_published ? show_ratio(row.published->seconds / row.sweep).c_str() : "-",
        show_ratio(row.paper / row.sweep).c_str(), show_ratio(row.cgal / row.sweep).c_str());
  }
  std::printf(
      "States are distinct sign vectors, all-stick included; the steps of the paper do not "
      "give\n"
      "all-stick from m = 3, and count two equal ones at m = 2.\n");
  print_work(report);
}

void print_scaling(const Report& report) {
  std::printf(
      "\nScaling. Best time of one thread; peak memory in MB above that of the idle program,\n"
      "some 1.2 MB of it code. count: cells counted; visit: all cells with their signs, in a\n"
      "stream; structure: all cells and incidences; cgal: all cells, and all states in "
      "memory.\n");
  std::printf("%5s %10s  %9s %7s  %9s %7s  %9s %7s  %9s %7s\n", "m", "cells", "count", "MB",
              "visit", "MB", "structure", "MB", "cgal", "MB");
  for (const ScalingRow& row : report.scaling) {
    std::printf(
        "%5zu %10zu  %9s %7s  %9s %7s  %9s %7s  %9s %7s\n", row.m, row.cells,
        show_seconds(row.count.seconds).c_str(), show_megabytes(row.count.peak_bytes).c_str(),
        show_seconds(row.visit.seconds).c_str(), show_megabytes(row.visit.peak_bytes).c_str(),
        show_seconds(row.structure.seconds).c_str(),
        show_megabytes(row.structure.peak_bytes).c_str(),
        row.cgal ? show_seconds(row.cgal->seconds).c_str() : "-",
        row.cgal ? show_megabytes(row.cgal->peak_bytes).c_str() : "-");
  }
}

nlohmann::ordered_json to_json(const Report& report) {
  nlohmann::ordered_json json{{"format", "stickslip-table2/1"},
                              {"instances", report.instances},
                              {"table", nlohmann::ordered_json::array()},
                              {"scaling", nlohmann::ordered_json::array()}};
  for (const TableRow& row : report.table) {
    nlohmann::ordered_json seconds{{"paper", row.paper},
                                   {"paper_steps", row.paper_steps},
                                   {"cgal", row.cgal},
                                   {"sweep", row.sweep}};
    nlohmann::ordered_json entry{{"m", row.m},
                                 {"cells", row.cells},
                                 {"distinct_states", row.distinct_states},
                                 {"states_of_paper_steps", row.states_of_paper_steps}};
    if (row.published) {
      entry["cells_published"] = row.published->cells;
      seconds["printed"] = row.published->seconds;
    }
    entry["seconds"] = seconds;
    entry["paper_work"] = {{"linear_programs", row.work.linear_programs},
                           {"pivots", row.work.pivots},
                           {"pairs_compared", row.work.pairs_compared},
                           {"path_searches", row.work.path_searches},
                           {"edges_scanned", row.work.edges_scanned}};
    json["table"].push_back(entry);
  }
  for (const ScalingRow& row : report.scaling) {
    nlohmann::ordered_json entry{{"m", row.m},
                                 {"cells", row.cells},
                                 {"distinct_states", row.distinct_states},
                                 {"count", to_json(row.count)},
                                 {"visit", to_json(row.visit)},
                                 {"structure", to_json(row.structure)}};
    if (row.cgal) entry["cgal"] = to_json(*row.cgal);
    json["scaling"].push_back(entry);
  }
  return json;
}

void write_csv(const Report& report, std::ostream& out) {
  out << "section,m,enumerator,task,cells,distinct_states,seconds,peak_bytes\n";
  for (const TableRow& row : report.table) {
    const auto line = [&](const char* enumerator, const char* task, std::size_t states,
                          double seconds) {
      out << "table," << row.m << ',' << enumerator << ',' << task << ',' << row.cells << ','
          << states << ',' << seconds << ",\n";
    };
    if (row.published) {
      out << "table," << row.m << ",printed,enumerate," << row.published->cells << ",,"
          << row.published->seconds << ",\n";
    }
    line("paper", "enumerate", row.states_of_paper_steps, row.paper);
    line("cgal", "enumerate", row.distinct_states, row.cgal);
    line("sweep", "enumerate", row.distinct_states, row.sweep);
  }
  for (const ScalingRow& row : report.scaling) {
    const auto line = [&](const char* enumerator, const char* task,
                          const ChildMeasurement& what) {
      out << "scaling," << row.m << ',' << enumerator << ',' << task << ',' << what.result
          << ',' << row.distinct_states << ',' << what.seconds << ',' << what.peak_bytes
          << '\n';
    };
    line("sweep", "count", row.count);
    line("sweep", "visit", row.visit);
    line("sweep", "structure", row.structure);
    if (row.cgal) line("cgal", "enumerate", *row.cgal);
  }
}

}  // namespace stickslip::bench
