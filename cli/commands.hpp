// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The subcommands of `stickslip`. Each adds itself to the command line and returns nothing;
/// its work runs when its name was given, and sets `exit_code`.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace stickslip {

enum ExitCode : int {
  kDone = 0,
  kClaimsWrong = 1,  ///< crosscheck: some claim is wrong
  kBadInput = 2,
  kUndecidedWithinLimit = 3,
  kAnswerStable = 10,  ///< decide --exit-code, as SAT solvers answer
  kAnswerUnstable = 20,
  kInternalError = 70  ///< a broken promise of the program's own
};

/// The last line of most footers; those of other commands begin alike (see manual.hpp).
inline const std::string kExitCodes = "Exit codes: 0 done, 2 bad input or usage.";
inline const std::string kExitCodesWithLimit =
    "Exit codes: 0 done, 2 bad input or usage, 3 undecided within a limit.";

void add_decide_command(CLI::App& app, int& exit_code);
void add_states_command(CLI::App& app, int& exit_code);
void add_margin_command(CLI::App& app, int& exit_code);
void add_compare_command(CLI::App& app, int& exit_code);
void add_region_command(CLI::App& app, int& exit_code);
void add_batch_command(CLI::App& app, int& exit_code);
void add_crosscheck_command(CLI::App& app, int& exit_code);
void add_export_command(CLI::App& app, int& exit_code);
void add_plot_command(CLI::App& app, int& exit_code);
/// `plot region`, beside `region`.
void add_region_plot(CLI::App& plot, int& exit_code);
void add_help_command(CLI::App& app, int& exit_code);
void add_completion_command(CLI::App& app, int& exit_code);
/// Hidden: writes the manual's pages. The build calls it.
void add_manual_command(CLI::App& app, int& exit_code);

/// Of a command line that the parser did not take: throws InputError for the first word that
/// stands where a command or an option should, and is none; it says which may have been meant.
/// Of options only if `options_too`.
void refuse_unknown_words(const CLI::App& app, const std::vector<std::string>& words,
                          bool options_too);

}  // namespace stickslip
