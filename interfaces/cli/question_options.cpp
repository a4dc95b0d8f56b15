// SPDX-License-Identifier: GPL-3.0-or-later
#include "question_options.hpp"

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"

namespace stickslip {

void write_proved_files(const std::string& option, const std::string& folder,
                        const std::vector<std::pair<std::string, ProvedFiles>>& files) {
  make_folder(option, folder);
  const FileWrite all;
  for (const auto& [name, proved] : files) {
    write_whole_file(folder + "/" + name + ".json", proved.grasp);
    write_whole_file(folder + "/" + name + ".certificate.json", proved.certificate);
  }
}

std::string heading(const Question& question) {
  const std::string& name = question.description().name;
  const std::string& of_case = question.case_name;
  const std::string both = name + (name.empty() || of_case.empty() ? "" : ", ") + of_case;
  return both.empty() ? both : both + ": ";
}

std::string conventions_text(const Question& question) {
  const GraspDescription& about = question.description();
  std::string text;
  if (const std::optional<Units>& units = about.units) {
    text += "Units: force " + units->force + ", length " + units->length + ", torque " +
            units->torque() + ".\n";
  }
  if (!about.gravity.empty()) {
    text +=
        "Gravity, by which masses became forces: " + NumberText(false)(about.gravity) + ".\n";
  }
  if (about.rounded_normals.empty()) return text;
  constexpr std::size_t kMostNamed = 4;
  std::string names;
  for (std::size_t i = 0; i < std::min(about.rounded_normals.size(), kMostNamed); ++i) {
    const RoundedNormal& one = about.rounded_normals[i];
    names += (names.empty() ? "contacts[" : ", contacts[") +
             std::to_string(one.contact.index()) + "] at " + to_readable_string(one.degrees) +
             " degrees";
  }
  if (about.rounded_normals.size() > kMostNamed) names += ", ...";
  return text +
         "Normals at irrational directions are rounded to rational unit vectors, by less than "
         "1e-9: " +
         names + ".\n";
}

std::string law_text(NormalLaw law) {
  return to_string(law) + std::string(law == NormalLaw::kUnilateral
                                          ? " (contacts may detach)"
                                          : " (contacts may not detach)");
}

std::string undecided_text(const Undecided& undecided, bool is_box) {
  return "Not decided: " + undecided.limit + ".\nNothing is known about the verdict" +
         (is_box ? ", which need not be the same for all grasps in the box" : "") +
         (undecided.remedy.empty() ? "" : ";\n" + undecided.remedy) + ".\n";
}

std::string engine_text(const std::string& engine, NormalLaw law) {
  return "Engine: " + engine + "; normal law: " + law_text(law) + ".\n";
}

Question read_contacts(const std::string& file) {
  return contacts_alone(read_any_grasp_file(file, Intervals::kRefused));
}

void add_grasp_argument(Command& command, std::string& file) {
  command.add_option("GRASP", file, "Grasp file (docs/grasp_file.md); - is standard input")
      ->type_name("FILE")
      ->required();
}

CommandOption* add_output_option(Command& command, std::string& output,
                                 const std::string& sort) {
  return command.add_option("--output,-o", output, sort + " to write; - is standard output")
      ->type_name("FILE")
      ->capture_default_str();
}

CommandOption::Check whole_number(std::uint64_t most) {
  const auto problem = [most](const std::string& value) {
    std::uint64_t number = 0;
    const char* end = value.data() + value.size();
    const auto [stop, error] = std::from_chars(value.data(), end, number);
    if (error == std::errc::invalid_argument || stop != end) {
      return quote(value) + " is not a whole number; give one in digits, 0 or more";
    }
    const bool above = error != std::errc() || number > most;
    return above ? value + " is too large; give at most " + std::to_string(most)
                 : std::string();
  };
  return problem;
}

void add_uncertain_option(Command& command, std::string& uncertain,
                          const std::string& description) {
  command.add_option("--uncertain", uncertain, description)->type_name("KIND=T,...");
}

std::vector<CommandOption*> add_ball_options(Command& command, QualityText& text) {
  return {
      command
          .add_option("--length", text.length,
                      "Characteristic length of the object, by which torques are divided; "
                      "else half the spread of the contacts")
          ->type_name("L"),
      command
          .add_option("--about", text.about,
                      "The point about which torques are, in space of three coordinates; else "
                      "the origin")
          ->type_name("X,Y"),
      command
          .add_option("--body", text.body, "Of several bodies the one that the loads are on")
          ->type_name("NAME"),
      command
          .add_option("--at-most", text.at_most,
                      "No larger ball is of interest; else 64 times a typical force")
          ->type_name("R"),
      command
          .add_option("--accuracy", text.accuracy,
                      "Stop when what is proved and what is refuted differ by this part of it")
          ->type_name("A")
          ->capture_default_str()};
}

std::vector<CommandOption*> add_method_options(Command& command, ComparisonText& text) {
  return {
      command
          .add_option("--methods", text.methods,
                      "Ask these alone, by the names that compare prints with hyphens and "
                      "without commas, or PCR, PGR")
          ->type_name("NAME,NAME,...")
          ->delimiter(',')
          ->takes_one_word()
          ->choices(method_words(), CommandOption::InHelp::kHidden),
      command
          .add_option("--max-force", text.max_force,
                      "The largest normal force, of the robustnesses and the margin of "
                      "internal forces: one for all contacts, or one for each")
          ->type_name("F,...")
          ->capture_default_str(),
      command
          .add_option("--edges", text.edges,
                      "In space, of the robustnesses, the volume, the least forces and the "
                      "margin: pyramids with so many edges in place of round cones; 0 is round")
          ->type_name("N")
          ->capture_default_str()};
}

CommandOption* add_modes_option(Command& command, std::string& modes) {
  return command
      .add_option(
          "--modes", modes,
          "Which states. slip: the signs of slip, as if no contact opened. full: and the "
          "signs of N.d. closed: slip while all contacts stay closed. cs: which contacts "
          "open. ss: contact modes, which open and how the others slip")
      ->type_name("MODES")
      ->choices({"slip", "full", "closed", "cs", "ss"})
      ->capture_default_str();
}

std::vector<CommandOption*> add_state_set_options(Command& command, StateSetArguments& set) {
  return {
      add_modes_option(command, set.modes),
      command
          .add_option("--lines", set.lines,
                      "Lines of slip of each contact in space; 0 is 2, across the normal and "
                      "each other")
          ->type_name("K")
          ->check(whole_number(kMostSlipLines))
          ->capture_default_str(),
      command.add_flag("--snap", set.snap,
                       "Take rational directions near those of --lines that are irrational"),
      add_count_option(command, "--limit", set.limit,
                       "End after so many states of a grasp; 0 is no end")};
}

void add_node_limit_option(Command& command, std::size_t& node_limit) {
  add_count_option(
      command, "--node-limit", node_limit,
      "Give up, undecided, after N nodes of a search; 0 is the program's own limit, or none");
}

void QuestionArguments::add_to(Command& command) {
  add_grasp_argument(command, file_);
  add_options_to(command);
}

void QuestionArguments::add_with_uncertain_to(Command& command) {
  add_with_enclosures_to(command);
  add_uncertain_option(
      command, text_.uncertain,
      "How far numbers may be off: friction, stiffness, preload, position, normal "
      "or wrench, by a number or of all but normals by a percentage; a normal turns "
      "by a slope; loads may be a ball, wrench=ball:R. Asks about all grasps in the box "
      "(docs/uncertainty.md)");
}

void QuestionArguments::add_with_enclosures_to(Command& command) {
  add_to(command);
  add_max_motion_to(command);
  takes_boxes_ = true;
}

void QuestionArguments::add_max_motion_to(Command& command) {
  takes_bounds_ = true;
  command
      .add_option(
          "--max-motion", text_.max_motion,
          "Only equilibria with motions up to this count: a length and an angle in radians, a "
          "number for each coordinate, or as 1000x a factor of what the load would press the "
          "softest contact; none replaces that of the file (docs/model.md)")
      ->type_name("LENGTH,ANGLE");
}

void QuestionArguments::add_options_to(Command& command) {
  CommandOption* wrench =
      command
          .add_option(
              "--wrench", text_.wrench,
              "Wrench applied to the object: force x, force y and torque about the origin "
              "(replaces the file's); of a grasp in space, force x, y, z and torque x, y, z")
          ->type_name("WX,WY,T");
  add_case_to(command, "The case of the file whose load is applied")->excludes(wrench);
  add_model_options_to(command);
}

CommandOption* QuestionArguments::add_case_to(Command& command,
                                              const std::string& description) {
  return command.add_option("--case", text_.case_name, description)->type_name("NAME");
}

void QuestionArguments::add_without_wrench_to(Command& command) {
  add_grasp_argument(command, file_);
  add_model_options_to(command);
  has_no_wrench_ = true;
}

void QuestionArguments::add_model_options_to(Command& command) {
  command
      .add_option(
          "--preload", text_.preload,
          "Preload of every contact, its normal force before the load (replaces the file's)")
      ->type_name("P");
  command
      .add_option(
          "--normal-law", text_.normal_law,
          "Normal force of a contact with preload P and stiffness k that is displaced by "
          "N.d along its normal. unilateral: contacts may open, c_n = max(0, P - k N.d). "
          "bilateral: the paper's Eq. 4 literally, c_n = P - k N.d >= 0")
      ->type_name("LAW")
      ->choices({"unilateral", "bilateral"})
      ->capture_default_str();
}

void QuestionArguments::add_with_directions_to(Command& command) {
  add_to(command);
  command.get_option("--wrench")
      ->description(
          "Wrench w to start from: force x, force y and torque about the origin. If neither it "
          "nor a case is given, it is 0,0,0 with --direction, and the file's without");
  command.get_option("--case")->description("The case of the file whose load is w");
  command
      .add_option("--direction", text_.direction,
                  "Wrench u: which multiples l >= 0 are resisted under the wrench w + l u?")
      ->type_name("WX,WY,T");
  command
      .add_option(
          "--preload-direction", text_.preload_direction,
          "How preloads grow. scale: all in proportion, l times what they are. Numbers of "
          "0 or more, one for each contact: by l times these, from what they are")
      ->type_name("P0,P1,...|scale");
}

QuestionOptions QuestionArguments::options() const {
  QuestionOptions options = question_options(text_);
  options.takes_limits = takes_limits_;
  if (has_no_wrench_ && !chooses_case()) options.wrench = RationalRow(3);
  return options;
}

Intervals QuestionArguments::intervals() const {
  return takes_boxes_    ? Intervals::kAllowed
         : takes_bounds_ ? Intervals::kOnlyBounds
                         : Intervals::kRefused;
}

GraspFile QuestionArguments::read() const {
  return read_grasp_file(file_, intervals());
}

Question QuestionArguments::ask_about(GraspFile file, const QuestionOptions& options) const {
  return ask_with_options(std::move(file), options, name_of_file(), takes_boxes_);
}

Question QuestionArguments::question() const {
  return ask_about(read(), options());
}

std::vector<Question> QuestionArguments::questions() const {
  return questions_about(read());
}

std::vector<Question> QuestionArguments::any_questions() const {
  return questions_about(read_any_grasp_file(file_));
}

Question QuestionArguments::any_question() const {
  GraspFile file = read_any_grasp_file(file_, intervals());
  QuestionOptions asked = options();
  if (has_no_wrench_ && asked.wrench) asked.wrench->resize(file.content.wrench().size());
  return ask_about(std::move(file), asked);
}

std::vector<Question> QuestionArguments::questions_about(GraspFile file) const {
  QuestionOptions asked = options();
  std::vector<Question> questions;
  if (file.cases.empty() || asked.case_name || asked.wrench) {
    questions.push_back(ask_about(std::move(file), asked));
    return questions;
  }
  for (const NamedLoad& load : file.cases) {
    asked.case_name = load.name;
    questions.push_back(ask_about(file, asked));
  }
  return questions;
}

void NumberOptions::add_to(Command& command, const std::string& json_description) {
  CommandOption* json_option = command.add_flag("--json", json, json_description);
  command
      .add_flag("--floats", floats,
                "With --json: beside each member X of exact numbers a member X_float, the "
                "nearest doubles")
      ->needs(json_option);
  command.add_flag("--exact", exact, "Print all digits of every number in text");
}

}  // namespace stickslip
