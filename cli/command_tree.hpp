// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What the command line offers, read off the parser: the manual and the completion scripts are
/// written from this, so that they cannot say anything else than --help.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace stickslip {

struct OptionEntry {
  /// "-o", "--output"; of an argument the one name that --help gives it.
  std::vector<std::string> names;
  std::string value;  ///< what stands for the value: FILE, DIR, N, ...; empty: it takes none
  std::vector<std::string> choices;  ///< all possible values, if they are few
  std::string default_value;
  std::string description;
  bool required = false;
  /// Longest names of the options that it needs, and that it cannot be together with.
  std::vector<std::string> needs;
  std::vector<std::string> excludes;
};

/// A command and its subcommands. Only a command without subcommands has arguments and options
/// with values: a command's name is then the first words of the line that are not flags.
struct CommandEntry {
  std::string name;  ///< as it is typed: "stickslip plot grasp"
  std::string description;
  std::string footer;
  std::vector<OptionEntry> options;
  std::vector<OptionEntry> arguments;
  std::vector<CommandEntry> subcommands;
};

/// All that is not hidden.
CommandEntry command_tree(const CLI::App& app);

/// A command and all below it, each before its subcommands.
std::vector<const CommandEntry*> all_commands(const CommandEntry& command);

/// The last word of a command's name.
std::string last_word(const CommandEntry& command);

/// The words one after the other, with `separator` between them.
std::string joined(const std::vector<std::string>& words, const std::string& separator = " ");

/// The first clause of a description, for menus: up to a full stop or a semicolon.
std::string first_clause(const std::string& text);

}  // namespace stickslip
