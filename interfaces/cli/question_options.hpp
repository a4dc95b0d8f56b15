// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Options that several subcommands have: what is asked about a grasp file, and how numbers are
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
#include "stickslip/engine/option_text.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/interfaces/quality_answer.hpp"
#include "stickslip/interfaces/question_text.hpp"

namespace stickslip {

class QuestionArguments {
 public:
  /// Adds GRASP, --wrench, --case, --preload and --normal-law.
  void add_to(Command& command);
  /// As add_to, and --uncertain, for a command that answers questions that are boxes: of
  /// others, question() and questions() refuse them.
  void add_with_uncertain_to(Command& command);
  /// As add_to, for a command that answers about one grasp also where lengths of normals are
  /// enclosed.
  void add_with_enclosures_to(Command& command);
  /// As add_to, and --direction and --preload-direction, for a command that asks about a
  /// margin.
  void add_with_directions_to(Command& command);
  /// Adds --max-motion.
  void add_max_motion_to(Command& command);
  /// Adds the options of add_to without GRASP, for commands that read many.
  void add_options_to(Command& command);
  /// The same but --wrench and --case, for what does not depend on a load: it is then 0.
  void add_without_wrench_to(Command& command);
  /// --case alone, whose load replaces that 0.
  CommandOption* add_case_to(Command& command, const std::string& description);

  /// What to replace. Throws InputError naming the option.
  QuestionOptions options() const;
  /// Reads the file and replaces what was asked. Throws InputError naming the file or option.
  Question question() const;
  /// The same; but of a file with cases, if no load is chosen, the question of each.
  std::vector<Question> questions() const;
  /// \{ The same, of a grasp in the plane or in space.
  Question any_question() const;
  std::vector<Question> any_questions() const;
  /// \}
  /// The file itself, and what is to be replaced, as it is spelled.
  GraspFile file() const { return read_any_grasp_file(file_); }
  const QuestionText& text() const { return text_; }
  const std::string& name_of_argument() const { return file_; }  ///< GRASP as it was given
  /// Of the file, in errors.
  std::string name_of_file() const { return file_ == "-" ? "<stdin>" : file_; }
  /// Whether --case is given.
  bool chooses_case() const { return !text_.case_name.empty(); }

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
  bool takes_bounds_ = false;  ///< of motions
};

/// --json, --floats and --exact, of every subcommand that answers in numbers.
struct NumberOptions {
  bool json = false;
  bool floats = false;
  bool exact = false;

  void add_to(Command& command, const std::string& json_description =
                                    "Print one JSON object; rationals are strings");
  operator NumberText() const { return NumberText(exact, "; --exact prints all digits"); }
};

/// For people: "name, case: ", or what there is of it.
std::string heading(const Question& question);

/// For people, a line: "Units: force N, length mm, torque N mm."; nothing if nobody gave them.
std::string units_text(const Question& question);

/// For people: "unilateral (contacts may detach)".
std::string law_text(NormalLaw law);

/// For people, three lines: why there is no verdict, and what may help.
std::string undecided_text(const Undecided& undecided, bool is_box);

/// For people, a line: which engine answered under which law.
std::string engine_text(const std::string& engine, NormalLaw law);

/// The GRASP argument alone.
void add_grasp_argument(Command& command, std::string& file);

/// -o of a command that writes one file of this sort.
CommandOption* add_output_option(Command& command, std::string& output,
                                 const std::string& sort);

/// Accepts the whole numbers from 0 to `most`, spelled in digits.
CommandOption::Check whole_number(std::uint64_t most);

/// An option whose value is a number of things, 0 or more; the help shows its default.
template <class Count>
void add_count_option(Command& command, const std::string& option, Count& count,
                      const std::string& description,
                      std::uint64_t most = std::numeric_limits<std::size_t>::max()) {
  command.add_option(option, count, description)
      ->type_name("N")
      ->check(whole_number(most))
      ->capture_default_str();
}

/// --uncertain.
void add_uncertain_option(Command& command, std::string& uncertain,
                          const std::string& description);

/// --length, --about, --body, --at-most and --accuracy, of what asks about a quality.
std::vector<CommandOption*> add_ball_options(Command& command, QualityText& text);

/// --node-limit, of every command that searches by cones.
void add_node_limit_option(Command& command, std::size_t& node_limit);

/// --time-limit, in seconds.
void add_time_limit_option(Command& command, unsigned& seconds, const std::string& description);

/// Writes NAME.json and NAME.certificate.json for each name into that folder.
void write_proved_files(const std::string& option, const std::string& folder,
                        const std::vector<std::pair<std::string, ProvedFiles>>& files);

/// --threads, 0 to 1024.
template <class Count>
void add_threads_option(Command& command, Count& threads, const std::string& description) {
  constexpr std::uint64_t kMostThreads = 1024;
  add_count_option(command, "--threads", threads, description, kMostThreads);
}

}  // namespace stickslip
