// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.hpp"

#include <CLI/CLI.hpp>
#include <sstream>

namespace stickslip {
namespace {

/// Returns the command that was called, of those below `app`.
const CLI::App& called(const CLI::App& app) {
  const std::vector<CLI::App*> below = app.get_subcommands();
  return below.empty() ? app : called(*below.front());
}

/// Returns its name in full.
std::string full_name(const CLI::App& command) {
  const CLI::App* const above = command.get_parent();
  return (above == nullptr ? "" : full_name(*above) + " ") + command.get_name();
}

/// Returns what is wrong with the words of a command, and what would be right. The parser's own
/// sentences name two options with one of these verbs between them.
std::string in_words(const CLI::App& app, const CLI::ParseError& error) {
  const std::string said = error.what();
  const std::string name = full_name(called(app));
  const std::string help = name + " --help";
  const auto around = [&](const std::string& verb, const std::string& between,
                          const std::string& after) {
    const std::size_t at = said.find(verb);
    return at == std::string::npos
               ? said + "; see " + help
               : said.substr(0, at) + between + said.substr(at + verb.size()) + after;
  };
  if (dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr) {
    return around(" excludes ", " and ", " do not go together; leave one of them out");
  }
  if (dynamic_cast<const CLI::RequiresError*>(&error) != nullptr) {
    return around(" requires ", " needs ", ", too; see " + help);
  }
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    return around(" is required", " is missing", "; " + help + " says what it is");
  }
  const std::vector<std::string> rest = app.remaining(true);
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !rest.empty()) {
    return "\"" + rest.front() + "\" is more than " + name + " takes; leave it out, or see " +
           help;
  }
  return said + "; see " + help;
}

}  // namespace

CommandOption* CommandOption::description(const std::string& text) {
  parsed_->description(text);
  return this;
}

CommandOption* CommandOption::type_name(const std::string& name) {
  parsed_->type_name(name);
  return this;
}

CommandOption* CommandOption::required() {
  parsed_->required();
  return this;
}

CommandOption* CommandOption::capture_default_str() {
  parsed_->capture_default_str();
  return this;
}

CommandOption* CommandOption::check(const Check& check) {
  parsed_->check(CLI::Validator([check](std::string& value) { return check(value); }, ""));
  return this;
}

CommandOption* CommandOption::choices(const std::vector<std::string>& values, InHelp help) {
  CLI::IsMember member(values);
  if (help == InHelp::kHidden) member.description("");
  parsed_->check(member);
  return this;
}

CommandOption* CommandOption::transform(const std::function<std::string(std::string)>& change) {
  parsed_->transform(change);
  return this;
}

CommandOption* CommandOption::delimiter(char between) {
  parsed_->delimiter(between);
  return this;
}

CommandOption* CommandOption::takes_one_word() {
  parsed_->allow_extra_args(false);
  return this;
}

CommandOption* CommandOption::excludes(CommandOption* other) {
  parsed_->excludes(other->parsed_);
  return this;
}

CommandOption* CommandOption::needs(CommandOption* other) {
  parsed_->needs(other->parsed_);
  return this;
}

const std::vector<std::string>& CommandOption::long_names() const {
  return parsed_->get_lnames();
}

const std::vector<std::string>& CommandOption::short_names() const {
  return parsed_->get_snames();
}

const std::string& CommandOption::description() const {
  return parsed_->get_description();
}

std::string CommandOption::type_name() const {
  return parsed_->get_type_name();
}

bool CommandOption::takes_value() const {
  return parsed_->get_items_expected_max() > 0;
}

bool CommandOption::is_given() const {
  return parsed_->count() > 0;
}

bool CommandOption::is_argument() const {
  return parsed_->get_positional();
}

Command::Command(CLI::App* parsed) : parsed_(parsed) {
  for (CLI::Option* option : parsed_->get_options()) keep(option);  // --help
}

Command::~Command() = default;

CommandOption* Command::keep(CLI::Option* parsed) {
  options_.emplace_back(new CommandOption(parsed));
  return options_.back().get();
}

CommandOption* Command::add_option(const std::string& names, std::string& value,
                                   const std::string& description) {
  return keep(parsed_->add_option(names, value, description));
}

CommandOption* Command::add_option(const std::string& names, std::vector<std::string>& values,
                                   const std::string& description) {
  return keep(parsed_->add_option(names, values, description));
}

CommandOption* Command::add_option(const std::string& names, unsigned long& value,
                                   const std::string& description) {
  return keep(parsed_->add_option(names, value, description));
}

CommandOption* Command::add_option(const std::string& names, unsigned& value,
                                   const std::string& description) {
  return keep(parsed_->add_option(names, value, description));
}

CommandOption* Command::add_option(const std::string& names, int& value,
                                   const std::string& description) {
  return keep(parsed_->add_option(names, value, description));
}

CommandOption* Command::add_option(const std::string& names, double& value,
                                   const std::string& description) {
  return keep(parsed_->add_option(names, value, description));
}

CommandOption* Command::add_flag(const std::string& names, bool& value,
                                 const std::string& description) {
  return keep(parsed_->add_flag(names, value, description));
}

Command* Command::add_subcommand(const std::string& name, const std::string& description) {
  subcommands_.emplace_back(new Command(parsed_->add_subcommand(name, description)));
  return subcommands_.back().get();
}

void Command::footer(const std::string& text) {
  parsed_->footer(text);
}

void Command::callback(const std::function<void()>& work) {
  parsed_->callback(work);
}

void Command::require_subcommand() {
  parsed_->require_subcommand(1);
}

Command* Command::hide() {
  parsed_->group("");
  return this;
}

const std::string& Command::name() const {
  return parsed_->get_name();
}

std::string Command::description() const {
  return parsed_->get_description();
}

bool Command::is_hidden() const {
  return parsed_->get_group().empty();
}

std::string Command::help(const std::string& called) const {
  return parsed_->get_formatter()->make_help(parsed_, called, CLI::AppFormatMode::Normal);
}

std::vector<const Command*> Command::subcommands() const {
  std::vector<const Command*> result;
  for (const auto& below : subcommands_) result.push_back(below.get());
  return result;
}

std::vector<const CommandOption*> Command::options() const {
  std::vector<const CommandOption*> result;
  for (const auto& option : options_) result.push_back(option.get());
  return result;
}

const CommandOption* Command::find_option(const std::string& name) const {
  const CLI::Option* const found = parsed_->get_option_no_throw(name);
  for (const auto& option : options_) {
    if (option->parsed_ == found) return option.get();
  }
  return nullptr;
}

CommandOption* Command::get_option(const std::string& name) {
  const CLI::Option* const found = parsed_->get_option(name);
  for (const auto& option : options_) {
    if (option->parsed_ == found) return option.get();
  }
  throw CLI::OptionNotFound(name);
}

CommandLine::CommandLine(const std::string& name, const std::string& description,
                         const std::string& version)
    : parsed_(std::make_unique<CLI::App>(description, name)) {
  constexpr std::size_t kColumns = 34;  // the columns of the help for names
  parsed_->set_version_flag("--version", version);
  parsed_->get_formatter()->column_width(kColumns);
  program_.reset(new Command(parsed_.get()));
}

CommandLine::~CommandLine() = default;

std::optional<CommandLine::Stopped> CommandLine::run(int argc, const char* const* argv) {
  try {
    parsed_->parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) return Stopped{false, in_words(*parsed_, error)};
    std::ostringstream text;
    parsed_->exit(error, text, text);
    return Stopped{true, text.str()};
  }
}

}  // namespace stickslip
