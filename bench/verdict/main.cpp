// SPDX-License-Identifier: GPL-3.0-or-later
// The times of branch and bound and its work against the project's targets, side by side with
// other ways to ask the same question, and on families meant to be hard. Prints Markdown
// tables, as in bench/README.md. Exit code 1 if a verdict, a certificate or a counter is wrong;
// never for a time.
#include <cstdio>
#include <fstream>
#include <string>

#include "arguments.hpp"
#include "report.hpp"

int main(int argc, char** argv) {
  stickslip::bench::Report report;
  std::string json_file;
  std::string part = "all";
  stickslip::bench::Arguments arguments("verdict_bench", "Times and work of verdicts");
  stickslip::Command& app = arguments.described();
  app.add_flag("--quick", report.quick, "Small sizes, no other solvers: for tests");
  app.add_flag("--verbose", report.verbose, "A line for each instance of the first table");
  app.add_option("--min-m", report.min_contacts, "The least contacts of the first table");
  app.add_option("--max-m", report.max_contacts, "The most contacts");
  app.add_option("--save", report.folder,
                 "Write each grasp of the first table to a file of this folder");
  app.add_option("--json", json_file, "Write every instance to a file");
  app.add_option("--part", part, "targets, side-by-side, engines, growth or all")
      ->choices({"targets", "side-by-side", "engines", "growth", "all"});
  if (const auto code = arguments.read(argc, argv)) return *code;
  const bool all = part == "all";
  report.large_growth = !all;
  try {
    if (all || part == "targets") report_targets(report);
    if (!report.quick && (all || part == "side-by-side")) report_side_by_side(report);
    if (!report.quick && (all || part == "engines")) report_engines(report);
    if (!report.quick && (all || part == "growth")) report_growth(report);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "verdict_bench: %s\n", error.what());
    return 1;
  }
  if (!json_file.empty()) {
    std::ofstream out(json_file);
    out << report.json.dump(1) << '\n';
    if (!out) {
      std::fprintf(stderr, "verdict_bench: cannot write %s\n", json_file.c_str());
      return 2;
    }
  }
  if (report.failures > 0) std::printf("%d failures\n", report.failures);
  return report.failures > 0 ? 1 : 0;
}
