// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A command line described: commands, options and arguments, and what they write to. CLI11
/// reads it, and command_line.cpp alone includes that library.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace stickslip {

/// An option or an argument of a command. Functions that describe it return it, so that they
/// chain. A name given where there is none, or twice, throws CLI11's errors, which are
/// std::exceptions.
class CommandOption {
 public:
  /// Says what is wrong with a value; an empty text if nothing is.
  using Check = std::function<std::string(const std::string& value)>;
  /// Whether the help shows the values that may be chosen behind the name of the type.
  enum class InHelp { kShown, kHidden };

  CommandOption(const CommandOption&) = delete;
  CommandOption& operator=(const CommandOption&) = delete;

  CommandOption* description(const std::string& text);
  /// The name stands for the value in the help: "N", "FILE". A shell completes FILE and DIR.
  CommandOption* type_name(const std::string& name);
  CommandOption* required();
  /// The help shows the value that the variable has now.
  CommandOption* capture_default_str();
  /// \{ Values are checked in this order, after each change of transform().
  CommandOption* check(const Check& check);
  CommandOption* choices(const std::vector<std::string>& values, InHelp help = InHelp::kShown);
  CommandOption* transform(const std::function<std::string(std::string)>& change);
  /// \}
  /// One word may hold several values with this between them.
  CommandOption* delimiter(char between);
  /// The next word is never another value of it.
  CommandOption* takes_one_word();
  CommandOption* excludes(CommandOption* other);
  CommandOption* needs(CommandOption* other);

  /// Its names without dashes.
  const std::vector<std::string>& long_names() const;
  const std::vector<std::string>& short_names() const;
  const std::string& description() const;
  /// The name of the type as the help shows it: "FILE", "ENGINE:{auto,states}".
  std::string type_name() const;
  bool takes_value() const;
  bool is_argument() const;

 private:
  friend class Command;
  explicit CommandOption(CLI::Option* parsed) : parsed_(parsed) {}

  CLI::Option* parsed_;
};

/// A command, and all that stands below it. It is given a reference to each variable that the
/// parser sets.
class Command {
 public:
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;
  ~Command();

  /// \{ An option by its names, as in "--output,-o", or an argument, whose name has no dash.
  /// The variable is set if it is given.
  CommandOption* add_option(const std::string& names, std::string& value,
                            const std::string& description);
  CommandOption* add_option(const std::string& names, std::vector<std::string>& values,
                            const std::string& description);
  CommandOption* add_option(const std::string& names, unsigned long& value,
                            const std::string& description);
  CommandOption* add_option(const std::string& names, unsigned& value,
                            const std::string& description);
  CommandOption* add_option(const std::string& names, int& value,
                            const std::string& description);
  CommandOption* add_flag(const std::string& names, bool& value,
                          const std::string& description);
  /// \}
  Command* add_subcommand(const std::string& name, const std::string& description);
  /// The text stands below the options in the help.
  void footer(const std::string& text);
  /// `work` is what the command does, once the line is read.
  void callback(const std::function<void()>& work);
  /// One of its commands has to be given.
  void require_subcommand();
  /// Neither the help nor a completion shows it.
  Command* hide();

  const std::string& name() const;
  std::string description() const;
  bool is_hidden() const;
  /// The help of the command where it is called so: "stickslip plot grasp".
  std::string help(const std::string& called) const;
  /// \{ These stand in the order in which they were added, after --help and --version; those
  /// hidden included.
  std::vector<const Command*> subcommands() const;
  std::vector<const CommandOption*> options() const;
  /// \}
  /// The option that is called so, dashes included; nullptr if there is none.
  const CommandOption* find_option(const std::string& name) const;
  /// The option that is called so, which is there.
  CommandOption* get_option(const std::string& name);

 private:
  friend class CommandLine;
  explicit Command(CLI::App* parsed);
  CommandOption* keep(CLI::Option* parsed);

  CLI::App* parsed_;
  std::vector<std::unique_ptr<CommandOption>> options_;
  std::vector<std::unique_ptr<Command>> subcommands_;
};

/// The command line of a program.
class CommandLine {
 public:
  CommandLine(const std::string& name, const std::string& description,
              const std::string& version);
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;
  ~CommandLine();

  /// The program itself, below which the commands stand.
  Command& program() { return *program_; }

  /// The reason why a command line was not carried out.
  struct Stopped {
    bool asked_for_help;  ///< or for the version
    std::string text;     ///< what was asked for, or what is wrong
  };
  /// Reads a command line and calls what the command does; what that throws is passed on.
  std::optional<Stopped> run(int argc, const char* const* argv);

 private:
  std::unique_ptr<CLI::App> parsed_;
  std::unique_ptr<Command> program_;
};

}  // namespace stickslip
