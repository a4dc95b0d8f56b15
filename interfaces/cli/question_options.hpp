// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Options that several subcommands have: the question about a grasp file, and how numbers are
/// printed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "command_line.hpp"
#include "stickslip/certificate/proved_files.hpp"
#include "stickslip/core/number_text.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/interfaces/comparison_answer.hpp"
#include "stickslip/interfaces/option_text.hpp"
#include "stickslip/interfaces/quality_answer.hpp"
#include "stickslip/interfaces/question_text.hpp"
#include "stickslip/interfaces/states_answer.hpp"

namespace stickslip {

class QuestionArguments {
 public:
  /// Adds GRASP, --wrench, --case, --preload and --normal-law.
  void add_to(Command& command);
  /// Does what add_to does, and adds --uncertain, for a command that answers questions that are
  /// boxes. Without it question() and questions() refuse boxes.
  void add_with_uncertain_to(Command& command);
  /// Does what add_to does, for a command that answers about one grasp even if lengths of
  /// normals are enclosed.
  void add_with_enclosures_to(Command& command);
  /// Does what add_to does, and adds --direction and --preload-direction, for a command that
  /// asks about a margin.
  void add_with_directions_to(Command& command);
  /// Lets questions be about forces with limits.
  void take_limits() { takes_limits_ = true; }
  /// Adds --max-motion.
  void add_max_motion_to(Command& command);
  /// Adds the options of add_to without GRASP, for commands that read many.
  void add_options_to(Command& command);
  /// Adds the same without --wrench and --case, for an answer that does not depend on a load:
  /// the load is then 0.
  void add_without_wrench_to(Command& command);
  /// Adds --case alone, whose load replaces that 0.
  CommandOption* add_case_to(Command& command, const std::string& description);

  /// Returns the options of the question. Throws InputError naming the option.
  QuestionOptions options() const;
  /// Reads the file and replaces what the options say. Throws InputError naming the file or
  /// option.
  Question question() const;
  /// Returns the same; of a file with cases, if no load is chosen, the question of each.
  std::vector<Question> questions() const;
  /// \{ Return the same for a grasp in the plane or in space.
  Question any_question() const;
  std::vector<Question> any_questions() const;
  /// \}
  /// The file itself, and the options as they are spelled.
  GraspFile file() const { return read_any_grasp_file(file_); }
  const QuestionText& text() const { return text_; }
  const std::string& name_of_argument() const { return file_; }  ///< GRASP as it was given
  /// Returns the name of the file in errors.
  std::string name_of_file() const { return file_ == "-" ? "<stdin>" : file_; }
  /// Returns true if --case is given.
  bool chooses_case() const { return !text_.case_name.empty(); }
  /// Returns true if --wrench is given.
  bool gives_wrench() const { return !text_.wrench.empty(); }
  /// Returns true if --wrench or --case is given.
  bool chooses_load() const { return chooses_case() || gives_wrench(); }

 private:
  void add_model_options_to(Command& command);
  Intervals intervals() const;
  GraspFile read() const;
  std::vector<Question> questions_about(GraspFile file) const;
  Question ask_about(GraspFile file, const QuestionOptions& options) const;

  std::string file_;
  QuestionText text_;
  bool has_no_wrench_ = false;
  bool takes_boxes_ = false;
  bool takes_bounds_ = false;  ///< whether it takes bounds on motions
  bool takes_limits_ = false;
};

/// The options --json, --floats and --exact, of every subcommand that answers in numbers.
struct NumberOptions {
  bool json = false;
  bool floats = false;
  bool exact = false;

  void add_to(Command& command, const std::string& json_description =
                                    "Print one JSON object; rationals are strings");
  operator NumberText() const { return NumberText(exact, "; --exact prints all digits"); }
};

/// Returns the words "name, case: ", or a part of them, for people.
std::string heading(const Question& question);

/// Returns lines for people on what the numbers of the grasp mean: "Units: force N, length mm,
/// torque N mm.", by which gravity masses became forces, and which normals were rounded, as far
/// as there is any of it.
std::string conventions_text(const Question& question);

/// Returns "unilateral (contacts may detach)", for people.
std::string law_text(NormalLaw law);

/// Returns three lines for people: why there is no verdict, and what may help.
std::string undecided_text(const Undecided& undecided, bool is_box);

/// Returns a line for people: which engine answered under which law.
std::string engine_text(const std::string& engine, NormalLaw law);

/// Reads a grasp of which only the contacts matter, under no load; a file of one body alone
/// becomes that of the body. Throws InputError as read_any_grasp_file() does, and for
/// intervals.
Question read_contacts(const std::string& file);

/// Adds the GRASP argument alone.
void add_grasp_argument(Command& command, std::string& file);

/// Adds -o for a command that writes one file of this sort.
CommandOption* add_output_option(Command& command, std::string& output,
                                 const std::string& sort);

/// Accepts the whole numbers from 0 to `most`, spelled in digits.
CommandOption::Check whole_number(std::uint64_t most);

/// Adds an option whose value is a number of things, 0 or more; the help shows its default.
template <class Count>
CommandOption* add_count_option(Command& command, const std::string& option, Count& count,
                                const std::string& description,
                                std::uint64_t most = std::numeric_limits<std::size_t>::max()) {
  return command.add_option(option, count, description)
      ->type_name("N")
      ->check(whole_number(most))
      ->capture_default_str();
}

/// Adds --uncertain.
void add_uncertain_option(Command& command, std::string& uncertain,
                          const std::string& description);

/// Adds --length, --about, --body, --at-most and --accuracy, for a question about a quality.
std::vector<CommandOption*> add_ball_options(Command& command, QualityText& text);

/// Adds --methods, --max-force and --edges, for a command that asks the methods of compare.
std::vector<CommandOption*> add_method_options(Command& command, ComparisonText& text);

/// The values of --modes, --lines, --snap and --limit.
struct StateSetArguments {
  std::string modes = "slip";
  std::size_t lines = 0;
  bool snap = false;
  std::size_t limit = 0;

  StatesAsked asked() const { return {state_set_named(modes), {lines, snap, {}}, limit}; }
};

/// Adds --modes.
CommandOption* add_modes_option(Command& command, std::string& modes);

/// Adds these options, for a command that counts states.
std::vector<CommandOption*> add_state_set_options(Command& command, StateSetArguments& set);

/// Adds --node-limit, for a command that searches by cones.
void add_node_limit_option(Command& command, std::size_t& node_limit);

/// Writes NAME.json and NAME.certificate.json for each name into that folder.
void write_proved_files(const std::string& option, const std::string& folder,
                        const std::vector<std::pair<std::string, ProvedFiles>>& files);

/// Adds --threads, 0 to 1024.
template <class Count>
void add_threads_option(Command& command, Count& threads, const std::string& description) {
  constexpr std::uint64_t kMostThreads = 1024;
  add_count_option(command, "--threads", threads, description, kMostThreads);
}

}  // namespace stickslip
