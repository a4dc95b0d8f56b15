// SPDX-License-Identifier: GPL-3.0-or-later
#include "completion_scripts.hpp"

#include <sstream>

namespace stickslip {
namespace {

/// `text` with `before` put before each character of `special`.
std::string escaped(const std::string& text, const std::string& special,
                    const std::string& before = "\\") {
  std::string result;
  for (const char c : text) {
    if (special.find(c) != std::string::npos) result += before;
    result += c;
  }
  return result;
}

/// A word of bash or zsh that is `text`, whatever is in it.
std::string shell_word(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
  return result + "'";
}

/// The same for fish.
std::string fish_word(const std::string& text) {
  return "'" + escaped(text, "\\'") + "'";
}

/// "stickslip plot grasp" as a part of a function's name.
std::string identifier(std::string name) {
  for (char& c : name) c = c == ' ' || c == '-' ? '_' : c;
  return name;
}

/// The value of an option, in the words of the bash script: choices, FILE, DIR or ANY.
std::string bash_value(const OptionEntry& option) {
  if (!option.choices.empty()) return joined(option.choices);
  return option.value == "FILE" || option.value == "DIR" ? option.value : "ANY";
}

constexpr const char* kBashFunction = R"(
_stickslip() {
  local current=${COMP_WORDS[COMP_CWORD]} command=stickslip option='' prefix='' word i given=0
  local subcommands options arguments value
  _stickslip_command "$command"
  for ((i = 1; i < COMP_CWORD; ++i)); do
    word=${COMP_WORDS[i]}
    if [[ $option && $word != = ]]; then  # readline splits --option=value into three words
      option=''
    elif [[ $word == -?* ]]; then
      _stickslip_value "$command" "$word"
      [[ $value ]] && option=$word
    elif [[ " $subcommands " == *" $word "* ]]; then
      command+=" $word"
      _stickslip_command "$command"
    elif [[ ! $option ]]; then
      ((++given))
    fi
  done
  if [[ $option && $current == = ]]; then
    current=''
  elif [[ ! $option && $current == --*=* ]]; then  # unless = is no longer in COMP_WORDBREAKS
    option=${current%%=*}
    prefix=$option=
    current=${current#*=}
  fi
  if [[ $option ]]; then
    _stickslip_value "$command" "$option"
  elif [[ $current == -* ]]; then
    value=$options
  else
    value=${subcommands:-${arguments[given]-$options}}
  fi
  COMPREPLY=()
  case $value in
    FILE) compopt -o default ;;
    DIR) compopt -o dirnames ;;
    '' | ANY) ;;
    *) mapfile -t COMPREPLY < <(compgen -P "$prefix" -W "$value" -- "$current") ;;
  esac
}
complete -F _stickslip stickslip
)";

/// Commands are looked up in a list, so that "states" as a value of an option is not taken for
/// the command of that name.
constexpr const char* kFishFunction = R"(
# Are the words before the cursor those of this command, and of none below it?
function __stickslip_at
    set -l words (commandline -opc)
    set -l command stickslip
    for word in $words[2..-1]
        if contains -- "$command $word" $__stickslip_commands
            set command "$command $word"
        end
    end
    test "$command" = "$argv"
end

complete -c stickslip -f
)";

std::string zsh_action(const OptionEntry& entry) {
  if (!entry.choices.empty()) return "(" + joined(entry.choices) + ")";
  if (entry.value == "FILE") return "_files";
  if (entry.value == "DIR") return "_path_files -/";
  return " ";  // says what to type
}

std::string zsh_text(const std::string& text) {
  return escaped(text, "\\[]:");
}

/// The options of _arguments, one a line.
void write_zsh_arguments(std::ostream& out, const CommandEntry& command) {
  for (const OptionEntry& option : command.options) {
    std::vector<std::string> no_more = option.names;
    no_more.insert(no_more.end(), option.excludes.begin(), option.excludes.end());
    for (const std::string& name : option.names) {
      std::string spec = (no_more.size() > 1 ? "(" + joined(no_more) + ")" : "") + name;
      if (!option.value.empty()) spec += name.size() > 2 ? "=" : "+";
      spec += "[" + zsh_text(first_clause(option.description)) + "]";
      if (!option.value.empty())
        spec += ":" + zsh_text(option.value) + ":" + zsh_action(option);
      out << " \\\n    " << shell_word(spec);
    }
  }
  for (std::size_t i = 0; i < command.arguments.size(); ++i) {
    const OptionEntry& argument = command.arguments[i];
    out << " \\\n    "
        << shell_word(std::to_string(i + 1) + ":" + zsh_text(argument.names.front()) + ":" +
                      zsh_action(argument));
  }
}

void write_zsh_function(std::ostream& out, const CommandEntry& command) {
  const std::string function = "_" + identifier(command.name);
  out << '\n' << function << "() {\n";
  if (command.subcommands.empty()) {
    out << "  _arguments";
    write_zsh_arguments(out, command);
    out << "\n}\n";
    return;
  }
  out << "  local curcontext=$curcontext state\n  local -a line\n  local -A opt_args\n  "
         "_arguments -C";
  write_zsh_arguments(out, command);
  out << " \\\n    '1:command:->command' \\\n    '*::argument:->argument'\n"
      << "  case $state in\n    command)\n      local -a commands=(\n";
  for (const CommandEntry& subcommand : command.subcommands) {
    out << "        "
        << shell_word(last_word(subcommand) + ":" + escaped(subcommand.description, "\\"))
        << '\n';
  }
  out << "      )\n      _describe -t commands command commands\n      ;;\n"
      << "    argument)\n      case $line[1] in\n";
  for (const CommandEntry& subcommand : command.subcommands) {
    out << "        " << last_word(subcommand) << ") _" << identifier(subcommand.name)
        << " ;;\n";
  }
  out << "      esac\n      ;;\n  esac\n}\n";
}

}  // namespace

std::string bash_completion(const CommandEntry& tree) {
  std::ostringstream out;
  std::ostringstream values;
  out << "# bash completion for stickslip " STICKSLIP_VERSION
         ", written by: stickslip completion bash\n\n"
      << "# Sets what the command $1 takes.\n_stickslip_command() {\n"
      << "  subcommands='' options='' arguments=()\n  case $1 in\n";
  for (const CommandEntry* command : all_commands(tree)) {
    std::vector<std::string> subcommands;
    for (const CommandEntry& subcommand : command->subcommands) {
      subcommands.push_back(last_word(subcommand));
    }
    std::vector<std::string> options;
    for (const OptionEntry& option : command->options) {
      options.insert(options.end(), option.names.begin(), option.names.end());
      if (option.value.empty()) continue;
      std::string patterns;
      for (const std::string& name : option.names) {
        patterns += (patterns.empty() ? "" : " | ") + shell_word(command->name + " " + name);
      }
      values << "    " << patterns << ") value=" << shell_word(bash_value(option)) << " ;;\n";
    }
    out << "    " << shell_word(command->name)
        << ")\n      options=" << shell_word(joined(options)) << '\n';
    if (!subcommands.empty())
      out << "      subcommands=" << shell_word(joined(subcommands)) << '\n';
    for (const OptionEntry& argument : command->arguments) {
      out << "      arguments+=(" << shell_word(bash_value(argument)) << ")\n";
    }
    out << "      ;;\n";
  }
  out << "  esac\n}\n\n"
      << "# Sets what the value of option $2 of command $1 is: words to choose from, FILE, "
         "DIR\n"
      << "# or ANY; nothing if it takes none.\n_stickslip_value() {\n  case \"$1 $2\" in\n"
      << values.str() << "    *) value='' ;;\n  esac\n}\n"
      << kBashFunction;
  return out.str();
}

std::string zsh_completion(const CommandEntry& tree) {
  std::ostringstream out;
  out << "#compdef stickslip\n# zsh completion for stickslip " STICKSLIP_VERSION
         ", written by: stickslip completion zsh\n";
  for (const CommandEntry* command : all_commands(tree)) write_zsh_function(out, *command);
  out << "\n# Found in $fpath, this file is the body of the function; sourced, it defines it.\n"
      << "if [[ ${funcstack[1]} == _stickslip ]]; then\n  _stickslip \"$@\"\nelse\n"
      << "  compdef _stickslip stickslip\nfi\n";
  return out.str();
}

std::string fish_completion(const CommandEntry& tree) {
  std::ostringstream out;
  const auto commands = all_commands(tree);
  out << "# fish completion for stickslip " STICKSLIP_VERSION
         ", written by: stickslip completion fish\n\n"
      << "set -g __stickslip_commands";
  for (const CommandEntry* command : commands) out << " \\\n    " << fish_word(command->name);
  out << '\n' << kFishFunction;
  for (const CommandEntry* command : commands) {
    out << '\n';
    const std::string start =
        "complete -c stickslip -n " + fish_word("__stickslip_at " + command->name);
    const auto value = [](const OptionEntry& entry) -> std::string {
      if (!entry.choices.empty()) return " -x -a " + fish_word(joined(entry.choices));
      if (entry.value == "FILE") return " -r -F";
      if (entry.value == "DIR") return " -x -a '(__fish_complete_directories)'";
      return entry.value.empty() ? "" : " -x";
    };
    for (const CommandEntry& subcommand : command->subcommands) {
      out << start << " -a " << last_word(subcommand) << " -d "
          << fish_word(subcommand.description) << '\n';
    }
    for (const OptionEntry& argument : command->arguments) {
      out << start
          << (argument.value == "FILE" ? " -F" : " -a " + fish_word(joined(argument.choices)))
          << '\n';
    }
    for (const OptionEntry& option : command->options) {
      out << start;
      for (const std::string& name : option.names) {
        out << (name.size() > 2 ? " -l " + name.substr(2) : " -s " + name.substr(1));
      }
      out << value(option) << " -d " << fish_word(first_clause(option.description)) << '\n';
    }
  }
  return out.str();
}

}  // namespace stickslip
