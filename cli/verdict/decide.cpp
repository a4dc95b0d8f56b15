// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/planar/decide.hpp"

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "box_answer.hpp"
#include "box_numbers.hpp"
#include "commands.hpp"
#include "fragile_answer.hpp"
#include "question_options.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/core/sign.hpp"
#include "stickslip/equilibrium/contact_mode.hpp"
#include "terminal.hpp"
#include "warnings.hpp"

namespace stickslip {
namespace {

void print_json(const Json& json, const NumberOptions& output) {
  std::cout << finished(json, output.floats).dump(1) << '\n';
}

void explain(const RefutationSummary& summary, NumberText& text) {
  // On a leaf's own twist the load does negative work: the way that the contacts lose is back.
  const std::string twist = text.direction(negated(summary.largest_leaf_twist));
  if (summary.leaves == 0) {
    std::cout << "\nThe normal law allows no motion at all.\n";
    return;
  }
  if (summary.largest_leaf.empty()) {
    std::cout << "\nWhatever the contacts do: along the virtual twist " << twist
              << "\nthe load does more work than they can take up.\n";
    return;
  }
  std::cout
      << "\nNo motion and forces satisfy all conditions. Proved by a tree of " << summary.leaves
      << (summary.leaves == 1 ? " leaf" : " leaves")
      << ", which\ntogether cover all motions: in each, along some virtual twist, the load "
         "does more\nwork than the contacts can take up. The largest leaf:\n";
  for (const std::string& condition : summary.largest_leaf)
    std::cout << "  " << condition << '\n';
  std::cout << "  twist " << twist << "\n\n";
}

std::string engine_text(const CaseAnswer& answer) {
  return engine_text(answer.decision.engine(), answer.question.law);
}

void print_text(const CaseAnswer& answer, const NumberOptions& output) {
  const auto& [question, problem, decision, warnings] = answer;
  NumberText text(output);
  const Verdict& verdict = answer.verdict();
  const Wrench& w = problem.wrench();
  std::cout << heading(question) << name_of(verdict) << "\n\n"
            << "  load w    " << text(coordinates(w)) << '\n';
  if (const auto* stable = std::get_if<Stable>(&verdict)) {
    const Twist& d = stable->witness.twist;
    std::vector<std::vector<std::string>> rows{
        {"contact", "normal", "tangential", "force", "slip", ""}};
    std::size_t index = 0;
    for (const ContactReport& c : report_contacts(answer, stable->witness)) {
      rows.push_back({std::to_string(index++), text.root(c.force.normal, c.length_squared),
                      text.root(c.force.tangential, c.length_squared), text(c.vector),
                      std::string(1, to_char(c.mode.slip)), c.mode.closed ? "closed" : "open"});
    }
    std::cout
        << "  motion d  " << text(d) << "\n\n"
        << format_table(rows) << '\n'
        << "These forces balance the load, lie in their friction cones and oppose slip; "
           "checked exactly.\n"
           "Load: force x, y, torque. Motion: x, y, rotation in radians. Slip: + is along "
           "the normal turned\nby +90 degrees, - against it, 0 sticks. An open contact is "
           "detached.\n";
  } else if (const auto* unstable = std::get_if<Unstable>(&verdict)) {
    explain(summarize(unstable->refutation, &problem), text);
  } else {
    std::cout << '\n' << undecided_text(std::get<Undecided>(verdict), false);
  }
  std::cout << text.note() << units_text(question) << engine_text(answer);
  print(warnings);
}

const Question& question_of(const Answer& answer) {
  return std::visit([](const auto& a) -> const Question& { return a.question; }, answer);
}

std::string load_text(const CaseAnswer& answer, NumberText& text) {
  return text(coordinates(answer.problem.wrench()));
}

std::string load_text(const BoxAnswer& answer, NumberText& text) {
  return load_text(answer.question.box()->wrench, text);
}

std::vector<ModelWarning> warnings_of(const Answer& answer) {
  return std::visit([](const auto& a) { return a.warnings; }, answer)
      .value_or(std::vector<ModelWarning>{});
}

void print_cases_json(const std::vector<Answer>& answers, const NumberOptions& output) {
  const std::string name = question_of(answers.front()).description().name;
  Json json{{"name", name}, {"cases", Json::array()}};
  for (const Answer& answer : answers) {
    json["cases"].push_back(to_json(answer));
  }
  print_json(json, output);
}

/// A line each; and each warning once, with the cases that it is about.
void print_cases_text(const std::vector<Answer>& answers, const NumberOptions& output) {
  NumberText text(output);
  std::vector<std::vector<std::string>> rows{{"case", "verdict", "load w"}};
  std::vector<std::pair<std::string, std::string>> warnings;  // and their cases
  std::string engine;
  for (const Answer& each : answers) {
    const std::string name = question_of(each).case_name;
    rows.push_back({name, name_of(each),
                    std::visit([&](const auto& a) { return load_text(a, text); }, each)});
    const auto* answer = std::get_if<CaseAnswer>(&each);
    if (answer != nullptr && engine.empty()) engine = engine_text(*answer);
    for (const ModelWarning& warning : warnings_of(each)) {
      const auto known = std::find_if(warnings.begin(), warnings.end(), [&](const auto& other) {
        return other.first == warning.text;
      });
      if (known == warnings.end()) {
        warnings.emplace_back(warning.text, name);
      } else {
        known->second += ", " + name;
      }
    }
  }
  const Question& question = question_of(answers.front());
  const bool all_boxes = engine.empty() && !question.in_space();
  if (engine.empty()) engine = engine_text(box_engine(question), question.law);
  const std::string& grasp = question.description().name;
  const std::size_t n = answers.size();
  std::cout << (grasp.empty() ? "" : grasp + ": ") << n << (n == 1 ? " case" : " cases")
            << "\n\n"
            << format_table(rows, Align::kLeft)
            << (all_boxes ? "\nWhat is uncertain, and what the verdict means: --case NAME.\n"
                          : "\nForces and motions, or why there are none: --case NAME.\n")
            << text.note() << units_text(question) << engine;
  for (const auto& [warning, names] : warnings) {
    std::cout << "Warning, " << names << ": " << warning << ".\n";
  }
}

struct DecideArguments {
  QuestionArguments question;
  std::string engine = "auto";
  std::string certificate;
  std::string examples;
  std::size_t node_limit = 0;
  NumberOptions output;
  bool no_warnings = false;
  bool answer_by_exit_code = false;
};

AnswerOptions options_of(const DecideArguments& arguments) {
  const Engine engine = arguments.engine == "states"             ? Engine::kStates
                        : arguments.engine == "branch-and-bound" ? Engine::kBranchAndBound
                                                                 : Engine::kAuto;
  return {engine, arguments.node_limit, !arguments.no_warnings};
}

Answer answered(Question question, const DecideArguments& arguments) {
  const auto refuse = [](const std::string& problem, const std::string& remedy) {
    throw InputError("", "--engine", problem, remedy);
  };
  if (question.box() != nullptr && arguments.engine != "auto") {
    if (question.in_space()) {
      refuse("the grasp is in space, for which there is one engine", "leave the option out");
    }
    if (question.box()->is_point()) {
      refuse("a preloaded contact has a normal of irrational length",
             "leave the option out, or ask about the file that stickslip snap writes");
    }
    refuse("the question is a box, about all grasps in it at once",
           "leave the option out: there is one engine for boxes");
  }
  return answer_to(std::move(question), options_of(arguments));
}

void write_certificate(const CaseAnswer& answer, const std::string& file) {
  if (file.empty()) return;
  if (const auto certificate = certificate_of(answer)) write_whole_file(file, *certificate);
}

void write_examples(const CaseAnswer& answer, const std::string& /*folder*/) {
  say_no_examples(false, stickslip::name_of(answer.verdict()));
}

void print_text(const CaseAnswer& answer, const NumberOptions& output,
                const std::string& /*examples*/) {
  print_text(answer, output);
}

/// That of the worst answer: unstable, then fragile, then undecided, then stable.
int exit_code(const std::vector<Answer>& answers, bool answer_by_exit_code) {
  const auto any = [&](const std::string& verdict) {
    return std::any_of(answers.begin(), answers.end(),
                       [&](const Answer& a) { return name_of(a) == verdict; });
  };
  if (answer_by_exit_code && any("unstable")) return kAnswerUnstable;
  if (answer_by_exit_code && any("fragile")) return kAnswerFragile;
  if (any("undecided")) return kUndecidedWithinLimit;
  return answer_by_exit_code ? kAnswerStable : kDone;
}

int decide(const DecideArguments& arguments) {
  std::vector<Question> questions = arguments.question.any_questions();
  const bool by_case =
      !questions.front().case_name.empty() && !arguments.question.chooses_case();
  for (const auto& [option, value] : {std::pair{"--certificate", &arguments.certificate},
                                      std::pair{"--examples", &arguments.examples}}) {
    if (!by_case || value->empty()) continue;
    throw InputError("", option, "the grasp has cases, and this is about the proof of one",
                     "choose the case with --case NAME");
  }
  std::vector<Answer> answers;
  for (Question& question : questions) {
    answers.push_back(answered(std::move(question), arguments));
  }
  const bool json = arguments.output.json;
  if (by_case) {
    (json ? print_cases_json : print_cases_text)(answers, arguments.output);
  } else {
    std::visit(
        [&](const auto& answer) {
          write_certificate(answer, arguments.certificate);
          if (!arguments.examples.empty()) write_examples(answer, arguments.examples);
          json ? print_json(to_json(answer), arguments.output)
               : print_text(answer, arguments.output, arguments.examples);
        },
        answers.front());
  }
  return exit_code(answers, arguments.answer_by_exit_code);
}

}  // namespace

void add_decide_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<DecideArguments>();
  CLI::App* command = app.add_subcommand(
      "decide", "Will the grasp hold its load passively? An exact verdict, with evidence");
  arguments->question.add_with_uncertain_to(*command);
  command
      ->add_option(
          "--engine", arguments->engine,
          "How to decide about one grasp in the plane; all engines are exact. states: the "
          "systems of all slip states, in groups, the method of the paper. branch-and-bound: "
          "splits sets of motions. auto: branch-and-bound, which is faster, but without forces "
          "where these would be long")
      ->type_name("ENGINE")
      ->transform([](const std::string& name) {  // its name of old
        return name == "cone" ? std::string("branch-and-bound") : name;
      })
      ->check(CLI::IsMember({"auto", "states", "branch-and-bound"}))
      ->capture_default_str();
  command
      ->add_option("--certificate", arguments->certificate,
                   "Write a proof of the verdict for stickslip-check (certificate/FORMAT.md)")
      ->type_name("FILE");
  command
      ->add_option("--examples", arguments->examples,
                   "If the box is fragile, write two of its grasps there, stable.json and "
                   "unstable.json, each with its certificate")
      ->type_name("DIR");
  add_node_limit_option(*command, arguments->node_limit);
  arguments->output.add_to(*command);
  add_no_warnings_option(*command, arguments->no_warnings);
  command->add_flag(
      "--exit-code", arguments->answer_by_exit_code,
      "Exit with 10 if stable, 20 if unstable, 30 if fragile, instead of 0; of "
      "cases, if one is unstable 20, if one is fragile 30, if one is undecided 3, "
      "else 10");
  command->footer(footer_text(
      "What the model says and does not say, and its warnings: docs/model.md. A grasp\n"
      "file with cases is answered with a table, unless --case or --wrench is given.\n"
      "If numbers are uncertain, by --uncertain or in the file, the verdict is about every\n"
      "grasp in the box: stable or unstable throughout, or fragile, some one and some the "
      "other.\n",
      "0 done (with --exit-code 10 stable, 20 unstable, 30 fragile),\n"
      "2 bad input or usage, 3 undecided within a limit",
      "stickslip decide fig1.json --wrench 0,-11/10,0 --preload 0"));
  command->callback([arguments, &exit_code] { exit_code = decide(*arguments); });
}

}  // namespace stickslip
