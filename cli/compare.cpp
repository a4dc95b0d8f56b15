// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "question_options.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/earlier/comparison.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

struct CompareArguments {
  QuestionArguments question;
  std::string length = "1";
  NumberOptions output;
};

Rational positive_length(const std::string& text) {
  Rational length = number_option("--length", text);
  if (length.sign() <= 0) {
    throw InputError("", "--length", "the value is " + to_string(length),
                     "a characteristic length must be above 0");
  }
  return length;
}

void print_json(const Question& question, const Rational& length,
                const std::vector<MethodRow>& rows, bool floats) {
  Json json{{"name", question.loaded().grasp.name()},
            {"normal_law", to_string(question.law)},
            {"wrench", number_json(coordinates(question.loaded().wrench))},
            {"length", number_json(length)}};
  add_units(json, question.loaded().grasp);
  Json& methods = json["methods"] = Json::array();
  for (const MethodRow& row : rows) {
    methods.push_back({{"method", row.method},
                       {"source", row.source},
                       {"about", row.about_the_load ? "load" : "grasp"},
                       {"verdict", row.verdict},
                       {"agrees", row.agrees ? Json(*row.agrees) : Json(nullptr)},
                       {"why", row.why},
                       {"evidence", row.evidence}});
  }
  std::cout << finished(json, floats).dump(1) << '\n';
}

void print_text(const Question& question, const Rational& length,
                const std::vector<MethodRow>& rows, NumberText& text) {
  const std::string& name = question.loaded().grasp.name();
  if (!name.empty()) std::cout << name << '\n';
  std::cout << "  load w    " << text(coordinates(question.loaded().wrench)) << '\n'
            << "  length L  " << text(length)
            << ", by which torques are divided (--length)\n\n";
  std::vector<std::vector<std::string>> table{{"method", "verdict", "agrees", "why"}};
  for (const MethodRow& row : rows) {
    table.push_back({row.method, row.verdict,
                     row.agrees           ? (*row.agrees ? "yes" : "no")
                     : row.about_the_load ? ""
                                          : "answers another question",
                     row.why});
  }
  std::cout << format_table(table, Align::kLeft)
            << "\nAll methods are exact. Normal law of the passive model: "
            << law_text(question.law) << ".\n"
            << units_text(question) << text.note();
}

int compare(const CompareArguments& arguments) {
  const Rational length = positive_length(arguments.length);
  const Question question = arguments.question.question();
  NumberText text(arguments.output);
  const std::vector<MethodRow> rows = compare_methods(problem_of(question), length, text);
  if (arguments.output.json) {
    print_json(question, length, rows, arguments.output.floats);
  } else {
    print_text(question, length, rows, text);
  }
  return kDone;
}

}  // namespace

void add_compare_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = app.add_subcommand(
      "compare", "What earlier methods say of the same question, and why they differ");
  arguments->question.add_to(*command);
  command
      ->add_option("--length", arguments->length,
                   "Characteristic length of the object, by which grasp wrench spaces divide "
                   "torques; also its radius of gyration about the origin of the object frame, "
                   "which strong stability needs")
      ->type_name("L")
      ->capture_default_str();
  arguments->output.add_to(*command,
                           "Print one JSON object with all evidence; rationals are strings");
  command->footer(footer_text(
      "The methods, all exact: form closure, which asks for no load; loads that are stable\n"
      "without friction, strongly or weakly (rigid contacts, no preload); the grasp wrench\n"
      "space with normal forces bounded in sum (L1) or each (Linf), closed if it holds a ball\n"
      "about 0; linear springs along normals and tangents; the same with each contact stuck,\n"
      "slipping without friction or detached; and the passive model without maximum\n"
      "dissipation. A method that would take too long is not computed.\n",
      kExitCodes, "stickslip compare fig1.json --wrench 0,1,0 --preload 1"));
  command->callback([arguments, &exit_code] { exit_code = compare(*arguments); });
}

}  // namespace stickslip
