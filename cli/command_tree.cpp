// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_tree.hpp"

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

namespace stickslip {
namespace {

std::string longest_name(const CLI::Option& option) {
  return option.get_lnames().empty() ? option.get_name() : "--" + option.get_lnames().front();
}

OptionEntry entry_of(const CLI::Option& option) {
  OptionEntry entry;
  if (option.get_positional()) {
    entry.names = {option.get_name(true)};
  } else {
    for (const std::string& name : option.get_snames()) entry.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) entry.names.push_back("--" + name);
  }
  if (option.get_type_size() != 0) {
    // "NAME" or, of a CLI::IsMember, "NAME:{a,b}".
    const std::string type = option.get_type_name();
    const std::size_t colon = type.find(':');
    entry.value = type.substr(0, colon);
    const std::size_t open = type.find('{');
    const std::size_t close = type.find('}');
    if (open != std::string::npos && close != std::string::npos) {
      std::istringstream list(type.substr(open + 1, close - open - 1));
      for (std::string choice; std::getline(list, choice, ',');)
        entry.choices.push_back(choice);
    }
  }
  entry.default_value = option.get_default_str();
  entry.description = option.get_description();
  entry.required = option.get_required();
  const auto add_names = [](const std::set<CLI::Option*>& options,
                            std::vector<std::string>& names) {
    for (const CLI::Option* other : options) names.push_back(longest_name(*other));
    std::sort(names.begin(), names.end());  // the set is in the order of addresses
  };
  add_names(option.get_needs(), entry.needs);
  add_names(option.get_excludes(), entry.excludes);
  return entry;
}

CommandEntry entry_of(const CLI::App& app, const std::string& before) {
  CommandEntry command;
  command.name = before + app.get_name();
  command.description = app.get_description();
  command.footer = app.get_footer();
  for (const CLI::Option* option : app.get_options()) {
    (option->get_positional() ? command.arguments : command.options)
        .push_back(entry_of(*option));
  }
  for (const CLI::App* subcommand : app.get_subcommands(
           [](const CLI::App* candidate) { return !candidate->get_group().empty(); })) {
    command.subcommands.push_back(entry_of(*subcommand, command.name + " "));
  }
  const bool takes_values =
      !command.arguments.empty() ||
      std::any_of(command.options.begin(), command.options.end(),
                  [](const OptionEntry& option) { return !option.value.empty(); });
  if (takes_values && !command.subcommands.empty()) {
    throw std::logic_error(command.name + " has subcommands, and takes values");
  }
  return command;
}

}  // namespace

CommandEntry command_tree(const CLI::App& app) {
  return entry_of(app, "");
}

std::vector<const CommandEntry*> all_commands(const CommandEntry& command) {
  std::vector<const CommandEntry*> all{&command};
  for (const CommandEntry& subcommand : command.subcommands) {
    const auto below = all_commands(subcommand);
    all.insert(all.end(), below.begin(), below.end());
  }
  return all;
}

std::string last_word(const CommandEntry& command) {
  return command.name.substr(command.name.rfind(' ') + 1);
}

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

std::string first_clause(const std::string& text) {
  return text.substr(0, std::min({text.find(". "), text.find("; "), text.size()}));
}

}  // namespace stickslip
