// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "commands.hpp"
#include "completion_scripts.hpp"
#include "question_options.hpp"
#include "stickslip/core/file.hpp"

namespace stickslip {

void add_completion_command(CLI::App& app, int& exit_code) {
  struct Arguments {
    std::string shell;
    std::string output = "-";
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "completion", "Print a script that lets a shell complete stickslip's words");
  command->add_option("SHELL", arguments->shell, "The shell that is to complete")
      ->type_name("NAME")
      ->check(CLI::IsMember({"bash", "zsh", "fish"}))
      ->required();
  add_output_option(*command, arguments->output, "Script");
  command->footer(
      "cmake --install puts the scripts where these shells look; this command is for programs\n"
      "that are run from elsewhere. In .bashrc, or in .zshrc after compinit:\n"
      "  source <(stickslip completion bash)\n"
      "  source <(stickslip completion zsh)\n"
      "Example: stickslip completion fish -o stickslip.fish\n" +
      kExitCodes);
  command->callback([&app, arguments, &exit_code] {
    const CommandEntry tree = command_tree(app);
    const auto& script = arguments->shell == "bash"  ? bash_completion
                         : arguments->shell == "zsh" ? zsh_completion
                                                     : fish_completion;
    write_whole_file(arguments->output, script(tree));
    exit_code = kDone;
  });
}

}  // namespace stickslip
