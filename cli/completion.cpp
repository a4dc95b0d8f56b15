// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>
#include <memory>
#include <sstream>

#include "command_tree.hpp"
#include "commands.hpp"
#include "question_options.hpp"
#include "stickslip/core/file.hpp"

namespace stickslip {
namespace {

/// What may stand in a place of the command line: a word and a tab and its description on each
/// line; or FILE or DIR alone, for what the shell knows.
std::string line(const std::string& word, const std::string& description) {
  return word + "\t" +
         description.substr(0, std::min(description.find(". "), description.find("; "))) + "\n";
}

/// The values of an option or argument, each behind `prefix`. The parser knows their sort by a
/// name, FILE or "NAME:{a,b}".
std::string values(const CLI::Option& option, const std::string& prefix) {
  const std::string sort = option.get_type_name();
  if (sort == "FILE" || sort == "DIR") return sort + "\n";
  const std::size_t open = sort.find('{');
  if (open == std::string::npos) return "";
  std::istringstream choices(sort.substr(open + 1, sort.find('}') - open - 1));
  std::string lines;
  for (std::string choice; std::getline(choices, choice, ',');) {
    lines += line(prefix + choice, "");
  }
  return lines;
}

std::string options(const CLI::App& command) {
  std::string lines;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_snames()) {
      lines += line("-" + name, option->get_description());
    }
    for (const std::string& name : option->get_lnames()) {
      lines += line("--" + name, option->get_description());
    }
  }
  return lines;
}

/// What `current`, the last word of a line that is being typed, may become.
std::string candidates(const CLI::App& app, const std::vector<std::string>& before,
                       const std::string& current) {
  NamedCommand command{&app, app.get_name()};
  std::size_t given = 0;                 // arguments
  const CLI::Option* waiting = nullptr;  // for its value
  for (const std::string& word : before) {
    if (waiting != nullptr) {
      // In bash, --option=value is three words.
      if (word != "=") waiting = nullptr;
    } else if (is_option(word)) {
      const CLI::Option* option = command.option(word);
      if (option != nullptr && value_follows(*option, word)) waiting = option;
    } else if (!command.enter(word)) {
      ++given;
    }
  }
  if (waiting != nullptr) return values(*waiting, "");
  if (!current.empty() && current[0] == '-') {
    const std::size_t equals = current.find('=');
    if (equals == std::string::npos) return options(*command.app);
    const CLI::Option* option = command.option(current);
    return option == nullptr ? "" : values(*option, current.substr(0, equals + 1));
  }
  std::string lines;
  for (const CLI::App* below : command.subcommands()) {
    if (!below->get_group().empty()) lines += line(below->get_name(), below->get_description());
  }
  if (!lines.empty()) return lines;
  for (const CLI::Option* option : command.app->get_options()) {
    if (option->get_positional() && given-- == 0) return values(*option, "");
  }
  return options(*command.app);
}

/// Of the lines those for words that begin with `start`, unless it is for the shell to say.
std::string matching(const std::string& lines, const std::string& start) {
  std::istringstream all(lines);
  std::string result;
  for (std::string each; std::getline(all, each);) {
    const bool is_word = each.find('\t') != std::string::npos;
    if (!is_word || each.rfind(start, 0) == 0) result += each + "\n";
  }
  return result;
}

constexpr const char* kBash = R"(# bash completion for stickslip
_stickslip() {
  mapfile -t COMPREPLY < <("$1" complete -- "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
  case ${COMPREPLY[0]-} in
    FILE) COMPREPLY=(); compopt -o default ;;
    DIR) COMPREPLY=(); compopt -o dirnames ;;
    *) COMPREPLY=("${COMPREPLY[@]%%$'\t'*}") ;;
  esac
}
complete -F _stickslip stickslip
)";

constexpr const char* kZsh = R"(#compdef stickslip
_stickslip() {
  local -a found
  found=("${(@f)$("$words[1]" complete -- "${(@)words[2,CURRENT]}" 2>/dev/null)}")
  case $found[1] in
    FILE) compset -P '-*='; _files ;;
    DIR) compset -P '-*='; _path_files -/ ;;
    ?*) found=(${found//:/\\:}); found=(${found/$'\t'/:}); _describe stickslip found ;;
  esac
}
# Found in $fpath, this file is the body of the function; sourced, it defines it.
if [[ ${funcstack[1]} == _stickslip ]]; then _stickslip "$@"; else compdef _stickslip stickslip; fi
)";

constexpr const char* kFish = R"(# fish completion for stickslip
function __stickslip
    set -l words (commandline -opc) (commandline -ct)
    $words[1] complete -- $words[2..-1] 2>/dev/null
end
complete -c stickslip -f -n 'not contains -- (__stickslip)[1] FILE DIR' -a '(__stickslip)'
complete -c stickslip -F -n 'contains -- (__stickslip)[1] FILE'
complete -c stickslip -f -n 'contains -- (__stickslip)[1] DIR' -a '(__fish_complete_directories)'
)";

}  // namespace

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
  command->footer(footer_text(
      "cmake --install puts the scripts where these shells look; this command is for programs\n"
      "that are run from elsewhere. In .bashrc, or in .zshrc after compinit:\n"
      "  source <(stickslip completion bash)\n"
      "  source <(stickslip completion zsh)\n",
      kExitCodes, "stickslip completion fish -o stickslip.fish"));
  command->callback([arguments, &exit_code] {
    write_whole_file(arguments->output, arguments->shell == "bash"  ? kBash
                                        : arguments->shell == "zsh" ? kZsh
                                                                    : kFish);
    exit_code = kDone;
  });

  auto words = std::make_shared<std::vector<std::string>>();
  app.add_subcommand("complete", "For the scripts: what the last word may become")
      ->group("")
      ->add_option("WORD", *words, "The words behind the program's name");
  app.get_subcommand("complete")->callback([&app, words, &exit_code] {
    const std::string current = words->empty() ? "" : words->back();
    if (!words->empty()) words->pop_back();
    std::cout << matching(candidates(app, *words, current == "=" ? "" : current),
                          current == "=" ? "" : current);
    exit_code = kDone;
  });
}

}  // namespace stickslip
