// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The description of a command line: commands, options and arguments, and the variables that
/// they set. CLI11 reads it, and command_line.cpp alone includes that library.
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
/// chain. A name that no option has, or that is taken, throws CLI11's errors, which are
/// std::exceptions.
class CommandOption {
 public:
  /// Returns the error in a value; an empty text if there is none.
  using Check = std::function<std::string(const std::string& value)>;
  /// Whether the help shows the values that may be chosen behind the name of the type.
  enum class InHelp { kShown, kHidden };

  CommandOption(const CommandOption&) = delete;
  CommandOption& operator=(const CommandOption&) = delete;

  CommandOption* description(const std::string& text);
  /// Sets the name that stands for the value in the help: "N", "FILE". A shell completes FILE
  /// and DIR.
  CommandOption* type_name(const std::string& name);
  CommandOption* required();
  /// Shows in the help the value that the variable has now.
  CommandOption* capture_default_str();
  /// \{ Values are checked in this order, after each change of transform().
  CommandOption* check(const Check& check);
  CommandOption* choices(const std::vector<std::string>& values, InHelp help = InHelp::kShown);
  CommandOption* transform(const std::function<std::string(std::string)>& change);
  /// \}
  /// Lets one word hold several values with this between them.
  CommandOption* delimiter(char between);
  /// Keeps the next word from ever being another value of it.
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
  /// Whether the command line that was read has it.
  bool is_given() const;
  bool is_argument() const;

 private:
  friend class Command;
  explicit CommandOption(CLI::Option* parsed) : parsed_(parsed) {}

  CLI::Option* parsed_;
};

/// A command, and all commands below it. It is given a reference to each variable that the
/// parser sets.
class Command {
 public:
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;
  ~Command();

  /// \{ Add an option by its names, as in "--output,-o", or an argument, whose name has no
  /// dash. The variable is set if it is given.
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
  CommandOption* add_option(const std::string& names, double& value,
                            const std::string& description);
  CommandOption* add_flag(const std::string& names, bool& value,
                          const std::string& description);
  /// \}
  Command* add_subcommand(const std::string& name, const std::string& description);
  /// Sets the text below the options in the help.
  void footer(const std::string& text);
  /// Sets the work of the command, which runs once the line is read.
  void callback(const std::function<void()>& work);
  /// Requires that one of its commands is given.
  void require_subcommand();
  /// Hides it from the help and from completions.
  Command* hide();

  const std::string& name() const;
  std::string description() const;
  bool is_hidden() const;
  /// Returns the help of the command where it is called so: "stickslip plot grasp".
  std::string help(const std::string& called) const;
  /// \{ The commands and options in the order in which they were added, after --help and
  /// --version; hidden ones included.
  std::vector<const Command*> subcommands() const;
  std::vector<const CommandOption*> options() const;
  /// \}
  /// Returns the option that is called so, dashes included; nullptr if there is none.
  const CommandOption* find_option(const std::string& name) const;
  /// Returns the option that is called so, which must be there.
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
    bool asked_for_help;  ///< whether help or the version was asked for
    std::string text;     ///< the text that was asked for, or the error
  };
  /// Reads a command line and runs the command's work. Throws what that work throws.
  std::optional<Stopped> run(int argc, const char* const* argv);

 private:
  std::unique_ptr<CLI::App> parsed_;
  std::unique_ptr<Command> program_;
};

}  // namespace stickslip
