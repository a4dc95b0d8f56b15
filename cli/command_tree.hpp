// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The commands of the program as a tree, and what the words of a command line are in it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace stickslip {

/// A command of the tree.
struct NamedCommand {
  const CLI::App* app;
  std::string name;  ///< as it is typed: "stickslip plot grasp"

  /// The commands below it, hidden ones included.
  std::vector<const CLI::App*> subcommands() const;

  /// Goes down to the subcommand `word`; false if there is none.
  bool enter(const std::string& word);

  /// The option that a word such as --option=value or -oFILE gives, or nullptr.
  const CLI::Option* option(const std::string& word) const;
};

/// Whether this is a word for an option, and not an argument such as - or -1.
bool is_option(const std::string& word);

/// Whether the value of the option that `word` gives is the next word.
bool value_follows(const CLI::Option& option, const std::string& word);

}  // namespace stickslip
