// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "commands.hpp"
#include "interruption.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"

namespace {

struct NamedAddition {
  const char* name;
  void (*add)(stickslip::Command&, int&);
};

/// The commands in the order of the help.
constexpr NamedAddition kCommands[] = {
    {"decide", stickslip::add_decide_command},
    {"states", stickslip::add_states_command},
    {"margin", stickslip::add_margin_command},
    {"radius", stickslip::add_radius_command},
    {"quality", stickslip::add_quality_command},
    {"preload", stickslip::add_preload_command},
    {"map", stickslip::add_map_command},
    {"statics", stickslip::add_statics_command},
    {"compare", stickslip::add_compare_command},
    {"region", stickslip::add_region_command},
    {"batch", stickslip::add_batch_command},
    {"crosscheck", stickslip::add_crosscheck_command},
    {"snap", stickslip::add_snap_command},
    {"example", stickslip::add_example_command},
    {"export", stickslip::add_export_command},
    {"plot", stickslip::add_plot_command},
    {"page", stickslip::add_page_command},
    {"serve", stickslip::add_serve_command},
    {"help", stickslip::add_help_command},
    {"completion", stickslip::add_completion_command},
};

/// Adds the command that `words` begin with, or all where one has to know of others: describing
/// all of them takes longer than a small verdict.
void add_commands(stickslip::Command& app, const std::vector<std::string>& words,
                  int& exit_code) {
  const auto named = [&](const NamedAddition& command) {
    return std::find(words.begin(), words.end(), command.name) != words.end();
  };
  const auto* first = std::find_if(std::begin(kCommands), std::end(kCommands), named);
  const bool is_alone = first != std::end(kCommands) && words.front() == first->name &&
                        words.front() != "help" && words.front() != "completion" &&
                        std::none_of(first + 1, std::end(kCommands), named);
  if (is_alone) return first->add(app, exit_code);
  for (const NamedAddition& command : kCommands) command.add(app, exit_code);
}

}  // namespace

int main(int argc, char** argv) {
  stickslip::finish_files_when_interrupted();
  stickslip::protect_inputs();
  stickslip::CommandLine line(
      "stickslip",
      "Exact passive stability of frictional grasps, in the plane and in space, with proofs",
      "stickslip " STICKSLIP_VERSION);
  stickslip::Command& app = line.program();
  app.require_subcommand();
  app.footer(stickslip::footer_text(
      "Each subcommand explains itself: stickslip decide --help.\n"
      "\n"
      "A grasp file is JSON (docs/grasp_file.md): contacts (position, normal into the object,\n"
      "friction, stiffness, preload) and the wrench applied to the object. Numbers are read\n"
      "exactly, \"3/5\" and 0.1 alike. Where stickslip is installed, docs/ is\n"
      "share/doc/stickslip, and certificate/FORMAT.md is share/stickslip/FORMAT.md.\n",
      stickslip::kExitCodesWithLimit +
          ", 70 internal error;\n"
          "decide --exit-code, crosscheck, margin --least and preload have others of their own",
      "stickslip decide grasp.json --certificate proof.json\n"
      "  $ stickslip-check grasp.json proof.json"));
  int exit_code = stickslip::kDone;
  add_commands(app, {argv + 1, argv + argc}, exit_code);
  try {
    if (argc == 1) {
      stickslip::introduce(app);
      return stickslip::kDone;
    }
    if (const auto stopped = line.run(argc, argv)) {
      stickslip::refuse_unknown_words(app, {argv + 1, argv + argc}, !stopped->asked_for_help);
      if (!stopped->asked_for_help) {
        std::cerr << "stickslip: " << stopped->text << '\n';
        return stickslip::kBadInput;
      }
      std::cout << stopped->text;
      exit_code = stickslip::kDone;
    }
  } catch (const stickslip::InputError& error) {
    std::cerr << "stickslip: " << error.what() << '\n';
    return stickslip::kBadInput;
  } catch (const std::exception& error) {
    std::cerr << "stickslip: internal error: " << error.what()
              << "; please report it with the command and its input\n";
    return stickslip::kInternalError;
  }
  std::cout.flush();
  if (!std::cout) {
    errno = 0;  // the reason may be long forgotten: another write meets the same
    [[maybe_unused]] const ssize_t again = ::write(STDOUT_FILENO, "\n", 1);
    std::cerr << "stickslip: " << stickslip::cannot_write("<stdout>", errno).what() << '\n';
    return stickslip::kBadInput;
  }
  return exit_code;
}
