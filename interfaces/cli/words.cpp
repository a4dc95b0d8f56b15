// SPDX-License-Identifier: GPL-3.0-or-later
// The words of a command line: which of them are unknown, what a word may become, and help.
#include <algorithm>
#include <iostream>
#include <memory>
#include <sstream>

#include "commands.hpp"
#include "question_options.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

bool takes_value(const CommandOption& option) {
  return option.takes_value();
}

/// A command, and the words by which it is reached.
struct NamedCommand {
  const Command* app;
  std::string name;  ///< as it is typed: "stickslip plot grasp"

  /// The commands below it, hidden ones included.
  std::vector<const Command*> subcommands() const { return app->subcommands(); }

  /// Goes down to the subcommand `word`. Returns false if there is none.
  bool enter(const std::string& word) {
    for (const Command* below : subcommands()) {
      if (below->name() != word) continue;
      *this = {below, name + " " + word};
      return true;
    }
    return false;
  }

  /// Returns the option that a word such as --option=value or -oFILE gives, or nullptr.
  const CommandOption* option(const std::string& word) const {
    const CommandOption* found = app->find_option(word.substr(0, word.find('=')));
    if (found != nullptr || word[1] == '-') return found;
    found = app->find_option(word.substr(0, 2));
    return found != nullptr && takes_value(*found) ? found : nullptr;
  }
};

/// Returns true if this is a word for an option, and not an argument such as - or -1.
bool is_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && (word[1] < '0' || word[1] > '9');
}

/// Returns true if the next word is the value of the option that `word` gives.
bool value_follows(const CommandOption& option, const std::string& word) {
  return takes_value(option) &&
         (word[1] == '-' ? word.find('=') == std::string::npos : word.size() == 2);
}

/// Goes down to the subcommand `word`, or throws.
void enter(NamedCommand& command, const std::string& word) {
  if (command.enter(word)) return;
  std::vector<std::string> known;
  for (const Command* below : command.subcommands()) {
    if (!below->is_hidden()) known.push_back(below->name());
  }
  throw InputError("", "", command.name + " has no command " + quote(word),
                   choice_of(word, known, "its commands are "));
}

[[noreturn]] void refuse_option(const NamedCommand& command, const std::string& word) {
  std::vector<std::string> known;
  for (const CommandOption* option : command.app->options()) {
    for (const std::string& each : option->long_names()) known.push_back("--" + each);
  }
  const std::string option = word.substr(0, word.find('='));
  throw InputError("", "", command.name + " has no option " + quote(option),
                   did_you_mean(option, known) + command.name + " --help lists its options");
}

/// Returns a line for a word that may stand in a place of the command line: the word, a tab and
/// its description. FILE or DIR alone is for names that the shell knows.
std::string line(const std::string& word, const std::string& description) {
  return word + "\t" +
         description.substr(0, std::min(description.find(". "), description.find("; "))) + "\n";
}

/// Returns the values of an option or argument, each behind `prefix`. The parser knows their
/// sort by a name, FILE or "NAME:{a,b}".
std::string values(const CommandOption& option, const std::string& prefix) {
  const std::string sort = option.type_name();
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

std::string options(const Command& command) {
  std::string lines;
  for (const CommandOption* option : command.options()) {
    for (const std::string& name : option->short_names()) {
      lines += line("-" + name, option->description());
    }
    for (const std::string& name : option->long_names()) {
      lines += line("--" + name, option->description());
    }
  }
  return lines;
}

/// Returns the words that `current`, the last word of a line that is being typed, may become.
std::string candidates(const Command& app, const std::vector<std::string>& before,
                       const std::string& current) {
  NamedCommand command{&app, app.name()};
  std::size_t given = 0;                   // the arguments given
  const CommandOption* waiting = nullptr;  // the option that waits for its value
  for (const std::string& word : before) {
    if (waiting != nullptr) {
      // An --option=value is three words in bash.
      if (word != "=") waiting = nullptr;
    } else if (is_option(word)) {
      const CommandOption* option = command.option(word);
      if (option != nullptr && value_follows(*option, word)) waiting = option;
    } else if (!command.enter(word)) {
      ++given;
    }
  }
  if (waiting != nullptr) return values(*waiting, "");
  if (!current.empty() && current[0] == '-') {
    const std::size_t equals = current.find('=');
    if (equals == std::string::npos) return options(*command.app);
    const CommandOption* option = command.option(current);
    return option == nullptr ? "" : values(*option, current.substr(0, equals + 1));
  }
  std::string lines;
  for (const Command* below : command.subcommands()) {
    if (!below->is_hidden()) lines += line(below->name(), below->description());
  }
  if (!lines.empty()) return lines;
  for (const CommandOption* option : command.app->options()) {
    if (option->is_argument() && given-- == 0) return values(*option, "");
  }
  return options(*command.app);
}

/// Returns those lines whose words begin with `start`, and those that leave it to the shell.
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

void refuse_unknown_words(const Command& app, const std::vector<std::string>& words,
                          bool options_too) {
  NamedCommand command{&app, app.name()};
  for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
    const std::string& word = words[i];
    if (!is_option(word)) {
      if (!command.subcommands().empty()) enter(command, word);
      continue;
    }
    const CommandOption* option = command.option(word);
    if (option == nullptr && options_too) refuse_option(command, word);
    if (option != nullptr && value_follows(*option, word)) ++i;
  }
}

void introduce(const Command& app) {
  std::vector<std::vector<std::string>> table;
  for (const Command* command : NamedCommand{&app, app.name()}.subcommands()) {
    if (!command->is_hidden()) {
      table.push_back({"  " + command->name(), command->description()});
    }
  }
  std::cout << app.description() << ".\n\nTry\n  $ stickslip example jaw | stickslip decide -\n"
            << "\nIt can\n"
            << format_table(table, Align::kLeft) << "\nstickslip COMMAND --help says more.\n";
}

void add_help_command(Command& app, int& exit_code) {
  auto words = std::make_shared<std::vector<std::string>>();
  Command* command =
      app.add_subcommand("help", "Show the help of a command, as the command's --help does");
  command
      ->add_option("COMMAND", *words,
                   "The command, in as many words as it has; without it, the program's help")
      ->type_name("WORD");
  command->footer(footer_text("", kExitCodes, "stickslip help plot grasp"));
  command->callback([&app, words, &exit_code] {
    NamedCommand about{&app, app.name()};
    for (const std::string& word : *words) {
      if (about.subcommands().empty()) break;
      enter(about, word);
    }
    std::cout << about.app->help(about.name);
    exit_code = kDone;
  });
}

void add_completion_command(Command& app, int& exit_code) {
  struct Arguments {
    std::string shell;
    std::string output = "-";
  };
  auto arguments = std::make_shared<Arguments>();
  Command* command = app.add_subcommand(
      "completion", "Print a script that lets a shell complete stickslip's words");
  command->add_option("SHELL", arguments->shell, "The shell that is to complete")
      ->type_name("NAME")
      ->choices({"bash", "zsh", "fish"})
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
  Command* complete =
      app.add_subcommand("complete", "For the scripts: what the last word may become")->hide();
  complete->add_option("WORD", *words, "The words behind the program's name");
  complete->callback([&app, words, &exit_code] {
    const std::string current = words->empty() ? "" : words->back();
    if (!words->empty()) words->pop_back();
    std::cout << matching(candidates(app, *words, current == "=" ? "" : current),
                          current == "=" ? "" : current);
    exit_code = kDone;
  });
}

}  // namespace stickslip
