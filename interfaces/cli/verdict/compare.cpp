// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>

#include "box_numbers.hpp"
#include "commands.hpp"
#include "long_work.hpp"
#include "question_options.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/engine/decide_in_time.hpp"
#include "stickslip/interfaces/comparison_answer.hpp"
#include "stickslip/interfaces/option_text.hpp"
#include "terminal.hpp"
#include "verdict/statics.hpp"

namespace stickslip {
namespace {

struct CompareArguments {
  QuestionArguments question;
  ComparisonText asked;
  std::string certificate;
  std::string time_limit;
  NumberOptions output;
};

/// Writes the certificate of a class. Returns false, and writes nothing, if the class is not
/// known.
bool writes_certificate(const std::string& file, const Question& question,
                        const Inertia& inertia, const RigidVerdict& verdict) {
  if (const auto* undecided = std::get_if<Undecided>(&verdict)) {
    std::cerr << "stickslip: the class is not known: " << in_words(*undecided) << '\n';
    return false;
  }
  write_whole_file(
      file, class_certificate_text(question, inertia, verdict, "stickslip " STICKSLIP_VERSION));
  return true;
}

std::string inertia_text(const Inertia& inertia, NumberText& text) {
  if (!inertia.in_space()) {
    return text(inertia.centre) + ", squared radius of gyration " +
           text(inertia.gyration[0][0]);
  }
  std::string result = text(inertia.centre) + ", tensor";
  for (const RationalRow& row : inertia.gyration) result += " " + text(row);
  return result;
}

void print_text(const Question& question, const CompareOptions& options, bool has_length,
                const Comparison& comparison, NumberText& text) {
  const std::string& name = question.description().name;
  if (!name.empty()) std::cout << name << '\n';
  RationalRow load;
  for (const Interval& w : question.grasp.wrench()) load.push_back(w.low);
  std::cout << "  load w    " << text(load) << '\n'
            << "  length L  " << text(options.length)
            << (has_length ? "" : ", half the spread of the contacts")
            << ", by which torques are divided (--length)\n"
            << "  inertia   centre " << inertia_text(options.inertia, text) << " (--inertia)\n";
  if (comparison.load_class) std::cout << "  class     " << *comparison.load_class << '\n';
  if (comparison.undecided) {
    std::cout << "  class     undecided: " << in_words(*comparison.undecided) << '\n';
  }
  std::cout << '\n';
  std::vector<std::vector<std::string>> table{{"method", "verdict", "agrees", "why"}};
  for (const MethodRow& row : comparison.methods) {
    table.push_back({row.method, row.verdict,
                     row.agrees           ? (*row.agrees ? "yes" : "no")
                     : row.about_the_load ? ""
                                          : "answers another question",
                     row.why});
  }
  std::cout << format_table(table, Align::kLeft) << "\nAll methods are exact."
            << " Normal law of the passive model: " << law_text(question.law) << ".\n"
            << (question.is_bounded()
                    ? "Passive equilibrium alone is about motions up to " +
                          bound_text(*question.box()) + "; the other methods know no bound.\n"
                    : "")
            << conventions_text(question) << text.note();
}

/// Answers whether several bodies may stand: nothing more is computed of their rigid contacts.
int compare_bodies(const Question& question, const CompareArguments& arguments) {
  const ComparisonText& given = arguments.asked;
  for (const auto& [is_given, option] :
       {std::pair(!given.methods.empty(), "--methods"),
        {!given.inertia.empty(), "--inertia"},
        {!given.length.empty(), "--length"},
        {given.max_force != ComparisonText().max_force, "--max-force"},
        {given.accuracy != ComparisonText().accuracy, "--accuracy"},
        {given.edges != 0, "--edges"}}) {
    if (!is_given) continue;
    throw InputError("", option, "the grasp is of several bodies",
                     "leave it out: of them the class alone is computed");
  }
  StaticsQuestion asked{question};
  asked.gives_wrench = arguments.question.gives_wrench();
  return answer_statics(std::move(asked), arguments.certificate,
                        arguments.question.name_of_argument(), arguments.output,
                        time_limit_option(arguments.time_limit));
}

int compare(const CompareArguments& arguments) {
  NumberText text(arguments.output);
  const ComparisonAsked comparison = comparison_asked(arguments.asked);
  const Question asked = arguments.question.any_question();
  // A certificate of a class is about a file of one body.
  const Question question = arguments.certificate.empty() ? as_one_body(asked) : asked;
  if (question.mechanism() != nullptr) return compare_bodies(question, arguments);
  CompareOptions options = options_for(comparison, question);
  const TimeLimit time = options.time = time_limit_option(arguments.time_limit);
  std::optional<RigidVerdict> verdict;
  Robustness robustness;
  const std::optional<RobustnessKind> kind = options.only_robustness();
  if (!arguments.certificate.empty() && kind) {
    LongWork work("robustness", time);
    if (!work.finishes([&] { robustness = robustness_to_prove(question, *kind, options); })) {
      say_nothing_written("--certificate", time.in_words() + " was over first");
      return kUndecidedWithinLimit;
    }
    options.robustness = &robustness;
    write_whole_file(arguments.certificate,
                     robustness_certificate_text(question, *kind, options.for_robustness(),
                                                 robustness, "stickslip " STICKSLIP_VERSION));
  } else if (!arguments.certificate.empty()) {
    const Question of_all = without_bound(question);  // classes are about all motions
    verdict = out_of_time(time);
    LongWork("class", time).finishes([&] { verdict = rigid_verdict(of_all, options.inertia); });
    if (!writes_certificate(arguments.certificate, of_all, options.inertia, *verdict)) {
      return kUndecidedWithinLimit;
    }
    options.verdict = &*verdict;
  }
  Comparison found;
  // Each method has an answer, if only that the time was over: the limit is theirs.
  LongWork("comparing").finishes([&] { found = compare_methods(question, options, text); });
  if (arguments.output.json) {
    const Json json = comparison_json(question, options.length, options.inertia, found);
    std::cout << finished(json, arguments.output.floats).dump(1) << '\n';
  } else {
    print_text(question, options, comparison.length.has_value(), found, text);
  }
  return kDone;
}

}  // namespace

void add_compare_command(Command& app, int& exit_code) {
  auto arguments = std::make_shared<CompareArguments>();
  Command* command = app.add_subcommand(
      "compare", "What earlier methods say of the same question, and why they differ");
  arguments->question.add_to(*command);
  arguments->question.add_max_motion_to(*command);
  add_method_options(*command, arguments->asked);
  command
      ->add_option("--length", arguments->asked.length,
                   "Characteristic length of the object, by which grasp wrench spaces divide "
                   "torques; else half the spread of the contacts")
      ->type_name("L");
  command
      ->add_option(
          "--inertia", arguments->asked.inertia,
          "Centre of mass and squared radius of gyration about it, which strong "
          "stability needs; default: 0,0 and the square of --length. In space "
          "X,Y,Z,XX,YY,ZZ[,XY,XZ,YZ]: the centre and the tensor of inertia about it, over "
          "the mass; default: 0,0,0 and that square, thrice")
      ->type_name("INERTIA");
  command
      ->add_option("--accuracy", arguments->asked.accuracy,
                   "How near the bounds of the two robustnesses are to be")
      ->type_name("A")
      ->capture_default_str();
  command
      ->add_option(
          "--certificate", arguments->certificate,
          "Write a proof of the class for stickslip-check --inertia; or, if one of the two "
          "robustnesses is the only method, of its bounds, for stickslip-check --robustness "
          "(certificate/FORMAT.md)")
      ->type_name("FILE");
  add_time_limit_option(*command, arguments->time_limit);
  arguments->output.add_to(*command,
                           "Print one JSON object with all evidence; rationals are strings");
  command->footer(footer_text(
      "The methods, all exact: passive equilibrium; form closure, which asks for no load;\n"
      "frictionless, strongly and weakly stable load (rigid contacts, no preload); grasp\n"
      "wrench space, L1, and grasp wrench space, Linf, with normal forces bounded in sum or\n"
      "each, closed if it holds a ball about 0; linear compliance, by springs along normals "
      "and\n"
      "tangents; three-state compliance, the same with each contact stuck, slipping without\n"
      "friction or detached; friction cones alone, the passive model without maximum\n"
      "dissipation; potential contact robustness (PCR) and potential grasp robustness\n"
      "(PGR), how far the best internal forces of a hand keep contacts from breaking a\n"
      "condition, between two bounds; the robustness of rigid motions, the best of the states\n"
      "that these allow; the least singular value of the grasp map; the volume of the wrench\n"
      "space; the least normal forces that hold the load, by their sum and by the largest; "
      "the\n"
      "margin of internal forces, how far the best are from breaking a condition; and the\n"
      "distance of the centroid of the contacts from the centre of mass. A method that would\n"
      "take too long is not computed.\n"
      "Motions are bounded of passive equilibrium alone.\n"
      "The class is what rigid contacts do: must move (the load is not weakly stable), must\n"
      "hold (it is strongly stable) or open (between). Accelerations are those of mass 1.\n"
      "In space cones are round: of the grasp wrench space, L1, there are bounds of the "
      "largest\n"
      "ball, and Linf, three-state compliance and the robustness of rigid motions are not\n"
      "done. Of several bodies only the class is: must move, or may stand (stickslip "
      "statics).\n",
      kExitCodesWithLimit,
      "stickslip compare fig1.json --wrench 0,1,0 --preload 1\n"
      "  $ stickslip compare fig1.json --methods weakly-stable-load,strongly-stable-load"));
  command->callback([arguments, &exit_code] {
    try {
      exit_code = compare(*arguments);
    } catch (const InputError& error) {
      const bool is_in_grasp = error.place().rfind("contacts", 0) == 0;
      throw in_options(error, is_in_grasp ? arguments->question.name_of_file() : error.file());
    }
  });
}

}  // namespace stickslip
