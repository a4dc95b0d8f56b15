// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/spelling.hpp"

namespace stickslip {
namespace {

bool takes_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

struct NamedCommand {
  const CLI::App* app;
  std::string name;  ///< as it is typed: "stickslip plot grasp"

  /// Goes down to the subcommand `word`.
  void enter(const std::string& word) {
    std::vector<std::string> known;
    for (const CLI::App* below : app->get_subcommands([](const CLI::App*) { return true; })) {
      if (below->get_name() == word) {
        *this = {below, name + " " + word};
        return;
      }
      if (!below->get_group().empty()) known.push_back(below->get_name());
    }
    throw InputError("", "", name + " has no command " + quote(word),
                     choice_of(word, known, "its commands are "));
  }

  bool has_subcommands() const {
    return !app->get_subcommands([](const CLI::App*) { return true; }).empty();
  }

  /// The option that a word such as --option=value or -oFILE gives, or nullptr.
  const CLI::Option* option(const std::string& word) const {
    const CLI::Option* found = app->get_option_no_throw(word.substr(0, word.find('=')));
    if (found != nullptr || word[1] == '-') return found;
    found = app->get_option_no_throw(word.substr(0, 2));
    return found != nullptr && takes_value(*found) ? found : nullptr;
  }

  [[noreturn]] void refuse_option(const std::string& word) const {
    std::vector<std::string> known;
    for (const CLI::Option* option : app->get_options()) {
      for (const std::string& each : option->get_lnames()) known.push_back("--" + each);
    }
    const std::string option = word.substr(0, word.find('='));
    throw InputError("", "", name + " has no option " + quote(option),
                     did_you_mean(option, known) + name + " --help lists its options");
  }
};

}  // namespace

void refuse_unknown_words(const CLI::App& app, const std::vector<std::string>& words,
                          bool options_too) {
  NamedCommand command{&app, app.get_name()};
  for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
    const std::string& word = words[i];
    const bool is_option =
        word.size() > 1 && word[0] == '-' && (word[1] < '0' || word[1] > '9');
    if (!is_option) {
      if (command.has_subcommands()) command.enter(word);
      continue;
    }
    const CLI::Option* option = command.option(word);
    if (option == nullptr && options_too) command.refuse_option(word);
    const bool value_follows =
        option != nullptr && takes_value(*option) &&
        (word[1] == '-' ? word.find('=') == std::string::npos : word.size() == 2);
    if (value_follows) ++i;
  }
}

void add_help_command(CLI::App& app, int& exit_code) {
  auto words = std::make_shared<std::vector<std::string>>();
  CLI::App* command =
      app.add_subcommand("help", "Show the help of a command, as the command's --help does");
  command
      ->add_option("COMMAND", *words,
                   "The command, in as many words as it has; without it, the program's help")
      ->type_name("WORD");
  command->footer("Example: stickslip help plot grasp\n" + kExitCodes);
  command->callback([&app, words, &exit_code] {
    NamedCommand about{&app, app.get_name()};
    for (const std::string& word : *words) {
      if (!about.has_subcommands()) break;
      about.enter(word);
    }
    std::cout << about.app->get_formatter()->make_help(about.app, about.name,
                                                       CLI::AppFormatMode::Normal);
    exit_code = kDone;
  });
}

}  // namespace stickslip
