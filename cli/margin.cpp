// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/margin.hpp"

#include <iostream>
#include <memory>

#include "commands.hpp"
#include "question_options.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/equilibrium/decide.hpp"

namespace stickslip {
namespace {

struct MarginArguments {
  QuestionArguments question;
  std::string direction;
  std::string certificate;
  std::size_t node_limit = 0;
  NumberOptions output;
};

void print_json(const Question& question, const Margin& margin, const MarginWork& work,
                bool floats) {
  Json json;
  json["name"] = question.loaded.grasp.name();
  json["normal_law"] = to_string(question.law);
  json["wrench"] = number_json(coordinates(question.loaded.wrench));
  json["direction"] = number_json(coordinates(margin.direction));
  json["resisted"] = Json::array();
  for (const LoadInterval& interval : margin.resisted) {
    Json high;  // null
    if (interval.high) high = number_json(*interval.high);
    json["resisted"].push_back({number_json(interval.low), high});
  }
  json["unbounded"] = !margin.resisted.empty() && !margin.resisted.back().high;
  Json& stats = json["stats"] = Json::object();
  stats["ranges"] = work.ranges;
  stats["mode_programs"] = work.modes;
  for (const auto& [name, value] : counters(work.cone)) stats[name] = value;
  std::cout << finished(json, floats).dump(1) << '\n';
}

std::string interval_text(const LoadInterval& interval, NumberText& text) {
  return "[" + text(interval.low) + ", " + (interval.high ? text(*interval.high) + "]" : "oo)");
}

void print_text(const Question& question, const Margin& margin, NumberText text) {
  const std::string& name = question.loaded.grasp.name();
  std::cout << (name.empty() ? "" : name + ": ") << "loads w + l u with l >= 0\n\n"
            << "  wrench w     " << text(coordinates(question.loaded.wrench)) << '\n'
            << "  direction u  " << text(coordinates(margin.direction)) << "\n\n";
  if (margin.resisted.empty()) std::cout << "No l is resisted.\n";
  for (const LoadInterval& interval : margin.resisted) {
    std::cout << "Resisted: l in " << interval_text(interval, text) << '\n';
  }
  std::size_t nodes = 0;
  for (const Refutation& gap : margin.gaps) nodes += gap.size();
  const auto count = [](std::size_t n, const char* what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
  };
  std::cout << "\nProved by equilibria in " << count(margin.segments.size(), "contact mode")
            << (margin.gaps.empty() ? ", with nothing left to refute"
                                    : ", and by case trees of " + count(nodes, "node") +
                                          " that nothing else is resisted")
            << ".\nNormal law: " << law_text(question.law) << ".\n"
            << text.note();
}

int margin(const MarginArguments& arguments) {
  const Question question = arguments.question.question();
  const Wrench direction = wrench_option("--direction", arguments.direction);
  if (direction == Wrench{}) {
    throw InputError("", "--direction", "the direction is 0",
                     "give the wrench whose multiples are asked for, as in --direction 0,1,0");
  }
  const Problem problem(question.loaded, question.law);
  ConeOptions options;
  options.node_limit = arguments.node_limit;
  MarginWork work;
  const auto result = find_margin(problem, direction, options, &work);
  if (const auto* undecided = std::get_if<Undecided>(&result)) {
    std::cerr << "stickslip: given up at " << undecided->limit << "; the margin is not known\n";
    return kUndecidedWithinLimit;
  }
  const auto& found = std::get<Margin>(result);
  if (!arguments.certificate.empty()) {
    write_whole_file(arguments.certificate,
                     margin_certificate_text(question, found, "stickslip " STICKSLIP_VERSION));
  }
  if (arguments.output.json) {
    print_json(question, found, work, arguments.output.floats);
  } else {
    print_text(question, found, NumberText(arguments.output));
  }
  return kDone;
}

}  // namespace

void add_margin_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<MarginArguments>();
  CLI::App* command = app.add_subcommand(
      "margin", "How much of a load is resisted? The exact set of its multiples, with a proof");
  arguments->question.add_with_base_wrench_to(*command);
  command
      ->add_option("--direction", arguments->direction,
                   "Wrench u: which multiples l >= 0 are resisted under the load w + l u?")
      ->type_name("WX,WY,T")
      ->required();
  command
      ->add_option("--certificate", arguments->certificate,
                   "Write a proof for stickslip-check --direction (certificate/FORMAT.md)")
      ->type_name("FILE");
  add_node_limit_option(*command, arguments->node_limit);
  arguments->output.add_to(*command);
  command->footer(footer_text(
      "The answer is a list of closed intervals; one without an upper end is printed as\n"
      "[a, oo), and ends in null in JSON.\n",
      kExitCodesWithLimit, "stickslip margin fig1.json --preload 1 --direction 0,1,0"));
  command->callback([arguments, &exit_code] { exit_code = margin(*arguments); });
}

}  // namespace stickslip
