// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The parts of the report. Each prints its table, adds to `json`, and counts in `failures`
/// what must never happen: a wrong verdict, a refused certificate, work that is not
/// reproducible.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

namespace stickslip::bench {

struct Report {
  bool quick = false;
  bool verbose = false;       ///< a line for each instance
  bool large_growth = false;  ///< one size more in report_growth
  std::size_t min_contacts = 0;
  std::size_t max_contacts = 10000;
  std::string folder;  ///< where report_targets leaves its grasps as files; none if empty
  nlohmann::json json = nlohmann::json::object();
  int failures = 0;
};

/// Medians over generated grasps of 10 to 10,000 contacts, with work counters.
void report_targets(Report& report);

/// The same grasps put to branch and bound, the reference engine, Z3, cvc5 and GLPK.
void report_side_by_side(Report& report);

/// The two engines on one to six contacts, with short numbers and with those of doubles.
void report_engines(Report& report);

/// Hard families: how the tree grows next to a threshold.
void report_growth(Report& report);

}  // namespace stickslip::bench
