// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>

#include "command_tree.hpp"
#include "commands.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/spelling.hpp"
#include "table.hpp"

namespace stickslip {
namespace {

/// Goes down to the subcommand `word`.
void enter(NamedCommand& command, const std::string& word) {
  if (command.enter(word)) return;
  std::vector<std::string> known;
  for (const CLI::App* below : command.subcommands()) {
    if (!below->get_group().empty()) known.push_back(below->get_name());
  }
  throw InputError("", "", command.name + " has no command " + quote(word),
                   choice_of(word, known, "its commands are "));
}

[[noreturn]] void refuse_option(const NamedCommand& command, const std::string& word) {
  std::vector<std::string> known;
  for (const CLI::Option* option : command.app->get_options()) {
    for (const std::string& each : option->get_lnames()) known.push_back("--" + each);
  }
  const std::string option = word.substr(0, word.find('='));
  throw InputError("", "", command.name + " has no option " + quote(option),
                   did_you_mean(option, known) + command.name + " --help lists its options");
}

}  // namespace

void refuse_unknown_words(const CLI::App& app, const std::vector<std::string>& words,
                          bool options_too) {
  NamedCommand command{&app, app.get_name()};
  for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
    const std::string& word = words[i];
    if (!is_option(word)) {
      if (!command.subcommands().empty()) enter(command, word);
      continue;
    }
    const CLI::Option* option = command.option(word);
    if (option == nullptr && options_too) refuse_option(command, word);
    if (option != nullptr && value_follows(*option, word)) ++i;
  }
}

void introduce(const CLI::App& app) {
  std::vector<std::vector<std::string>> table;
  for (const CLI::App* command : NamedCommand{&app, app.get_name()}.subcommands()) {
    if (!command->get_group().empty()) {
      table.push_back({"  " + command->get_name(), command->get_description()});
    }
  }
  std::cout << app.get_description()
            << ".\n\nTry\n  $ stickslip example jaw | stickslip decide -\n"
            << "\nIt can\n"
            << format_table(table, Align::kLeft) << "\nstickslip COMMAND --help says more.\n";
}

void add_help_command(CLI::App& app, int& exit_code) {
  auto words = std::make_shared<std::vector<std::string>>();
  CLI::App* command =
      app.add_subcommand("help", "Show the help of a command, as the command's --help does");
  command
      ->add_option("COMMAND", *words,
                   "The command, in as many words as it has; without it, the program's help")
      ->type_name("WORD");
  command->footer(footer_text("", kExitCodes, "stickslip help plot grasp"));
  command->callback([&app, words, &exit_code] {
    NamedCommand about{&app, app.get_name()};
    for (const std::string& word : *words) {
      if (about.subcommands().empty()) break;
      enter(about, word);
    }
    std::cout << about.app->get_formatter()->make_help(about.app, about.name,
                                                       CLI::AppFormatMode::Normal);
    exit_code = kDone;
  });
}

}  // namespace stickslip
