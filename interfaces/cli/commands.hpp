// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The subcommands of `stickslip`. Each adds itself to the command line and returns nothing;
/// its work runs when its name was given, and sets `exit_code`.
#pragma once

#include <string>
#include <vector>

#include "command_line.hpp"

namespace stickslip {

enum ExitCode : int {
  kDone = 0,
  kClaimsWrong = 1,  ///< crosscheck: some claim is wrong
  kBadInput = 2,
  kUndecidedWithinLimit = 3,
  kAnswerStable = 10,  ///< decide --exit-code, as SAT solvers answer
  kAnswerUnstable = 20,
  kAnswerFragile = 30,
  kInternalError = 70  ///< a broken promise of the program's own
};

inline const std::string kExitCodes = "0 done, 2 bad input or usage";
inline const std::string kExitCodesWithLimit = kExitCodes + ", 3 undecided within a limit";

/// Returns the text of --help below the options, in the form that help2man reads: notes and the
/// exit codes, and a last section of examples, one command a line.
inline std::string footer_text(const std::string& notes, const std::string& exit_codes,
                               const std::string& example) {
  return notes + (notes.empty() ? "" : "\n") + "Exit codes: " + exit_codes +
         ".\n\nExamples:\n  $ " + example;
}

void add_decide_command(Command& app, int& exit_code);
void add_states_command(Command& app, int& exit_code);
void add_margin_command(Command& app, int& exit_code);
void add_radius_command(Command& app, int& exit_code);
void add_quality_command(Command& app, int& exit_code);
void add_preload_command(Command& app, int& exit_code);
void add_map_command(Command& app, int& exit_code);
void add_statics_command(Command& app, int& exit_code);
void add_compare_command(Command& app, int& exit_code);
void add_region_command(Command& app, int& exit_code);
void add_batch_command(Command& app, int& exit_code);
void add_crosscheck_command(Command& app, int& exit_code);
void add_snap_command(Command& app, int& exit_code);
void add_example_command(Command& app, int& exit_code);
void add_export_command(Command& app, int& exit_code);
void add_plot_command(Command& app, int& exit_code);
/// \{ Add `plot region` and `plot quality`, which are beside `region` and `quality`.
void add_region_plot(Command& plot, int& exit_code);
void add_quality_plot(Command& plot, int& exit_code);
/// \}
void add_page_command(Command& app, int& exit_code);
void add_serve_command(Command& app, int& exit_code);
void add_help_command(Command& app, int& exit_code);
/// Adds `completion`, which prints the scripts, and the hidden `complete`, which they call.
void add_completion_command(Command& app, int& exit_code);

/// Prints the introduction of a program that is given nothing to do.
void introduce(const Command& app);

/// Throws InputError for the first unknown word where a command or an option should stand, in a
/// command line that the parser did not take; it says which word may have been meant. Looks at
/// options only if `options_too`.
void refuse_unknown_words(const Command& app, const std::vector<std::string>& words,
                          bool options_too);

}  // namespace stickslip
