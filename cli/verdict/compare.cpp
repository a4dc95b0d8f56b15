// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "question_options.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/earlier/comparison.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

struct CompareArguments {
  QuestionArguments question;
  std::vector<std::string> methods;
  std::string length = "1";
  std::string inertia;
  std::string certificate;
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

/// Without --inertia the object has its mass about its origin, at the characteristic length.
CompareOptions compare_options(const CompareArguments& arguments) {
  CompareOptions options;
  options.methods = arguments.methods;
  options.length = positive_length(arguments.length);
  options.inertia = arguments.inertia.empty() ? Inertia{{}, options.length * options.length}
                                              : inertia_option("--inertia", arguments.inertia);
  return options;
}

void print_json(const Question& question, const CompareOptions& options,
                const Comparison& comparison, bool floats) {
  Json json{{"name", question.loaded().grasp.name()},
            {"normal_law", to_string(question.law)},
            {"wrench", number_json(coordinates(question.loaded().wrench))},
            {"length", number_json(options.length)},
            {"inertia", inertia_json(options.inertia)},
            {"class", comparison.load_class ? Json(*comparison.load_class) : Json(nullptr)}};
  add_units(json, question.loaded().grasp);
  Json& methods = json["methods"] = Json::array();
  for (const MethodRow& row : comparison.methods) {
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

void print_text(const Question& question, const CompareOptions& options,
                const Comparison& comparison, NumberText& text) {
  const std::string& name = question.loaded().grasp.name();
  if (!name.empty()) std::cout << name << '\n';
  std::cout << "  load w    " << text(coordinates(question.loaded().wrench)) << '\n'
            << "  length L  " << text(options.length)
            << ", by which torques are divided (--length)\n"
            << "  inertia   centre " << text(options.inertia.centre)
            << ", squared radius of gyration " << text(options.inertia.gyration_squared)
            << " (--inertia)\n";
  if (comparison.load_class) std::cout << "  class     " << *comparison.load_class << '\n';
  std::cout << '\n';
  std::vector<std::vector<std::string>> table{{"method", "verdict", "agrees", "why"}};
  for (const MethodRow& row : comparison.methods) {
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
  const CompareOptions options = compare_options(arguments);
  const Question question = arguments.question.question();
  if (!arguments.certificate.empty()) {
    const RigidVerdict verdict = rigid_verdict(problem_of(question), options.inertia);
    if (const auto* undecided = std::get_if<Undecided>(&verdict)) {
      std::cerr << "stickslip: the class is not known: " << in_words(*undecided) << '\n';
      return kUndecidedWithinLimit;
    }
    write_whole_file(arguments.certificate,
                     class_certificate_text(question, options.inertia, verdict,
                                            "stickslip " STICKSLIP_VERSION));
  }
  NumberText text(arguments.output);
  const Comparison comparison = compare_methods(problem_of(question), options, text);
  if (arguments.output.json) {
    print_json(question, options, comparison, arguments.output.floats);
  } else {
    print_text(question, options, comparison, text);
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
      ->add_option("--methods", arguments->methods,
                   "Ask these alone, by the names below with hyphens and without commas")
      ->type_name("NAME,NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(method_words()).description(""));
  command
      ->add_option("--length", arguments->length,
                   "Characteristic length of the object, by which grasp wrench spaces divide "
                   "torques")
      ->type_name("L")
      ->capture_default_str();
  command
      ->add_option("--inertia", arguments->inertia,
                   "Centre of mass and squared radius of gyration about it, which strong "
                   "stability needs; default: 0,0 and the square of --length")
      ->type_name("X,Y,G2");
  command
      ->add_option(
          "--certificate", arguments->certificate,
          "Write a proof of the class for stickslip-check --inertia, whichever methods "
          "are asked (certificate/FORMAT.md)")
      ->type_name("FILE");
  arguments->output.add_to(*command,
                           "Print one JSON object with all evidence; rationals are strings");
  command->footer(footer_text(
      "The methods, all exact: passive equilibrium; form closure, which asks for no load;\n"
      "frictionless, strongly and weakly stable load (rigid contacts, no preload); grasp\n"
      "wrench space, L1, and grasp wrench space, Linf, with normal forces bounded in sum or\n"
      "each, closed if it holds a ball about 0; linear compliance, by springs along normals "
      "and\n"
      "tangents; three-state compliance, the same with each contact stuck, slipping without\n"
      "friction or detached; and friction cones alone, the passive model without maximum\n"
      "dissipation. A method that would take too long is not computed.\n"
      "The class is what rigid contacts do: must move (the load is not weakly stable), must\n"
      "hold (it is strongly stable) or open (between). Accelerations are those of mass 1.\n",
      kExitCodesWithLimit,
      "stickslip compare fig1.json --wrench 0,1,0 --preload 1\n"
      "  $ stickslip compare fig1.json --methods weakly-stable-load,strongly-stable-load"));
  command->callback([arguments, &exit_code] { exit_code = compare(*arguments); });
}

}  // namespace stickslip
