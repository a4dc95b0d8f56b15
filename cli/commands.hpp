// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The subcommands of `stickslip`. Each adds itself to the command line and returns nothing;
/// its work runs when its name was given, and sets `exit_code`.
#pragma once

#include <CLI/CLI.hpp>

namespace stickslip {

enum ExitCode : int {
  kDone = 0,
  kClaimsWrong = 1,  ///< crosscheck: some claim is wrong
  kBadInput = 2,
  kUndecidedWithinLimit = 3,
  kAnswerStable = 10,  ///< decide --exit-code, as SAT solvers answer
  kAnswerUnstable = 20
};

void add_decide_command(CLI::App& app, int& exit_code);
void add_states_command(CLI::App& app, int& exit_code);
void add_margin_command(CLI::App& app, int& exit_code);
void add_compare_command(CLI::App& app, int& exit_code);
void add_region_command(CLI::App& app, int& exit_code);
void add_crosscheck_command(CLI::App& app, int& exit_code);
void add_export_command(CLI::App& app, int& exit_code);
void add_plot_command(CLI::App& app, int& exit_code);
/// `plot region`, beside `region`.
void add_region_plot(CLI::App& plot, int& exit_code);
/// -o of the pictures.
void add_output_option(CLI::App& command, std::string& output);

}  // namespace stickslip
