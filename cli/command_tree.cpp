// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_tree.hpp"

namespace stickslip {
namespace {

bool takes_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

}  // namespace

std::vector<const CLI::App*> NamedCommand::subcommands() const {
  return app->get_subcommands([](const CLI::App*) { return true; });
}

bool NamedCommand::enter(const std::string& word) {
  for (const CLI::App* below : subcommands()) {
    if (below->get_name() != word) continue;
    *this = {below, name + " " + word};
    return true;
  }
  return false;
}

const CLI::Option* NamedCommand::option(const std::string& word) const {
  const CLI::Option* found = app->get_option_no_throw(word.substr(0, word.find('=')));
  if (found != nullptr || word[1] == '-') return found;
  found = app->get_option_no_throw(word.substr(0, 2));
  return found != nullptr && takes_value(*found) ? found : nullptr;
}

bool is_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && (word[1] < '0' || word[1] > '9');
}

bool value_follows(const CLI::Option& option, const std::string& word) {
  return takes_value(option) &&
         (word[1] == '-' ? word.find('=') == std::string::npos : word.size() == 2);
}

}  // namespace stickslip
