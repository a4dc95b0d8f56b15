// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>

#include "class_margin.hpp"
#include "commands.hpp"
#include "long_work.hpp"
#include "margin_text.hpp"
#include "question_options.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/engine/decide_in_time.hpp"
#include "stickslip/interfaces/margin_answer.hpp"
#include "terminal.hpp"
#include "verdict/statics.hpp"
#include "warnings.hpp"

namespace stickslip {
namespace {

struct MarginArguments {
  QuestionArguments question;
  std::string certificate;
  std::string accuracy = "1/1000";
  std::size_t node_limit = 0;
  std::string time_limit;
  NumberOptions output;
  bool least = false;
  bool asks_class = false;
  bool friction = false;
  std::string inertia = "0,0,1";
  bool no_warnings = false;
};

Rational accuracy_of(const MarginArguments& arguments) {
  return positive_option("--accuracy", arguments.accuracy);
}

/// Requires one grasp whose lengths are rational, and no bound on motions: classes know no
/// others.
void require_exact(const Question& question, const std::string& file) {
  if (!question.has_claims()) return;
  try {
    problem_of(question);
  } catch (const InputError& error) {
    throw in_options(error, file);
  }
}

/// Writes the certificate of a margin, and its answer as JSON or in words. `json` takes the
/// warnings, and `print_words` prints what print_text() does.
template <class Found, class JsonOf, class PrintWords>
void write_answer(const Question& question, const Found& found, const std::string& producer,
                  const MarginArguments& arguments, LongWork& work, const JsonOf& json,
                  const PrintWords& print_words) {
  if (!arguments.certificate.empty()) {
    write_whole_file(arguments.certificate, margin_certificate_text(question, found, producer));
  }
  Warnings warnings;
  if (!arguments.no_warnings) {
    work.finishes([&] { warnings = model_warnings(question, found); });
  }
  if (arguments.output.json) {
    std::cout << finished(json(warnings), arguments.output.floats).dump(1) << '\n';
    return;
  }
  NumberText text(arguments.output);
  if (arguments.least) {
    print_least(found, text);
  } else {
    print_words(text);
  }
  print(warnings);
}

int margin_by_claims(const Question& question, const MarginArguments& arguments) {
  SpatialMarginOptions search;
  search.accuracy = accuracy_of(arguments);
  search.search.node_limit = arguments.node_limit;
  LongWork work("margin", time_limit_option(arguments.time_limit));
  const auto show = [&](const SpatialMargin& so_far) {
    work.say(std::to_string(so_far.claims.size()) + " steps proved, " +
             std::to_string(so_far.work.nodes) + " nodes");
  };
  SpatialMargin margin;
  std::optional<SecondMargin> within;
  work.finishes([&] {
    margin = find_spatial_margin(question, search, [&](const SpatialMargin& so_far) {
      if (work.limit().seconds()) margin = so_far;
      show(so_far);
    });
    within = margin_within(question, margin, search, show);
  });
  write_answer(
      question, margin, producer_of(box_engine(question)), arguments, work,
      [&](const Warnings& warnings) {
        Json json = margin_json(question, margin, warnings);
        if (within) add_within(json, *within);
        work.add_ending(json);
        return json;
      },
      [&](NumberText& text) {
        print_text(question, margin, within, text);
        std::cout << work.ending();
      });
  if (margin.claims.empty()) return kUndecidedWithinLimit;
  return arguments.least && margin.resisted().empty() ? kAnswerUnstable : kDone;
}

int exact_margin(const Question& question, const MarginArguments& arguments) {
  SearchOptions options;
  options.node_limit = arguments.node_limit;
  MarginWork margin_work;
  LongWork work("margin", time_limit_option(arguments.time_limit));
  std::variant<Margin, Undecided> result = out_of_time(work.limit());
  work.finishes([&] {
    const auto show = [&](const MarginWork& so_far) {
      work.say("searching range " + std::to_string(so_far.ranges) + ", contact mode " +
               std::to_string(so_far.modes));
    };
    result = find_margin(problem_of(question), options, &margin_work, show);
  });
  if (const auto* undecided = std::get_if<Undecided>(&result)) {
    std::cerr << "stickslip: the margin is not known: " << in_words(*undecided) << '\n';
    return kUndecidedWithinLimit;
  }
  const auto& margin = std::get<Margin>(result);
  write_answer(
      question, margin, "stickslip " STICKSLIP_VERSION, arguments, work,
      [&](const Warnings& warnings) {
        return margin_json(question, margin, margin_work, warnings);
      },
      [&](NumberText& text) { print_text(question, margin, text); });
  return arguments.least && margin.resisted.empty() ? kAnswerUnstable : kDone;
}

/// In space and of several bodies rigid contacts tell whether they may stand.
int margin_of_statics(const Question& question, const MarginArguments& arguments) {
  if (question.preload_direction) {
    throw InputError("", "--class", "rigid contacts know no preloads",
                     "leave out --preload-direction");
  }
  if (arguments.friction == question.direction.has_value()) {
    throw InputError(
        "", arguments.friction ? "--friction" : "--class",
        arguments.friction ? "friction changes, and the load as well" : "nothing grows",
        arguments.friction ? "leave out --direction"
                           : "say which load does, as in --direction, or ask with "
                             "--friction for the least factor of friction");
  }
  StaticsQuestion asked{question};
  asked.least_friction = arguments.friction;
  if (question.direction) asked.asked.directions = {*question.direction};
  asked.question.direction.reset();
  asked.gives_wrench = arguments.question.gives_wrench();
  if (!arguments.friction || arguments.accuracy != MarginArguments().accuracy) {
    asked.accuracy = accuracy_of(arguments);
  }
  return answer_statics(std::move(asked), "", arguments.question.name_of_argument(),
                        arguments.output, time_limit_option(arguments.time_limit));
}

int margin(const MarginArguments& arguments) {
  const Question asked = arguments.question.any_question();
  // A certificate of a margin is about the bodies of the file; classes have none here.
  const Question question = arguments.asks_class ? as_one_body(asked) : asked;
  if (arguments.asks_class) {
    if (question.mechanism() != nullptr || question.in_space()) {
      return margin_of_statics(question, arguments);
    }
    require_exact(question, arguments.question.name_of_file());
    return answer_class_margin(question,
                               {arguments.inertia, arguments.friction, accuracy_of(arguments),
                                time_limit_option(arguments.time_limit)},
                               arguments.output);
  }
  if (!question.is_margin()) {
    throw InputError(
        "", "", "no direction is given",
        "say what grows: the load, as in --direction 0,1,0, or the preloads, as in "
        "--preload-direction scale");
  }
  return question.has_claims() ? margin_by_claims(question, arguments)
                               : exact_margin(question, arguments);
}

}  // namespace

void add_margin_command(Command& app, int& exit_code) {
  auto arguments = std::make_shared<MarginArguments>();
  Command* command = app.add_subcommand(
      "margin",
      "How much of a load is resisted, or with how much preload? The exact set, with a proof");
  arguments->question.add_with_directions_to(*command);
  arguments->question.add_max_motion_to(*command);
  CommandOption* least = command->add_flag(
      "--least", arguments->least,
      "Print the least multiple that is resisted, such as of the preloads that "
      "hold a load");
  CommandOption* certificate =
      command
          ->add_option("--certificate", arguments->certificate,
                       "Write a proof for stickslip-check with the same directions "
                       "(certificate/FORMAT.md)")
          ->type_name("FILE");
  CommandOption* asks_class =
      command
          ->add_flag(
              "--class", arguments->asks_class,
              "Ask which multiples of the load must move, must hold or are open under "
              "rigid contacts, as compare does; in space and of several bodies which may "
              "stand, as statics does")
          ->excludes(least)
          ->excludes(certificate);
  command
      ->add_flag(
          "--friction", arguments->friction,
          "With --class, and without directions: ask which factors of all friction are of "
          "which class")
      ->needs(asks_class);
  command
      ->add_option("--inertia", arguments->inertia,
                   "Of the object, for --class: the centre of mass and the squared radius of "
                   "gyration about it")
      ->type_name("X,Y,G2")
      ->capture_default_str()
      ->needs(asks_class);
  command
      ->add_option("--accuracy", arguments->accuracy,
                   "Where ends are not exact: which part of a multiple may stay undecided at "
                   "one. With --friction: which part of a factor, where what must hold ends")
      ->type_name("PART")
      ->capture_default_str();
  add_node_limit_option(*command, arguments->node_limit);
  add_time_limit_option(*command, arguments->time_limit);
  arguments->output.add_to(*command);
  add_no_warnings_option(*command, arguments->no_warnings);
  command->footer(footer_text(
      "With --direction the load grows, with --preload-direction the preloads do, with both "
      "both.\n"
      "The answer is a list of closed intervals of l; one without an upper end ends in null "
      "in\n"
      "JSON. More preload can break a grasp: there may be gaps (docs/loads.md).\n"
      "In space, of several bodies, within a bound of motions, and where a preloaded contact "
      "has a normal\n"
      "of irrational length, ends are known to a part of 1/1000 (--accuracy), and what is "
      "refuted is listed\n"
      "as well (docs/space.md).\n",
      kExitCodesWithLimit + ";\nwith --least 20 if no multiple is resisted",
      "stickslip margin fig1.json --preload 1 --direction 0,1,0\n"
      "  $ stickslip margin fig1.json --preload 1 --wrench 0,1/2,0 --preload-direction scale "
      "--least"));
  command->callback([arguments, &exit_code] { exit_code = margin(*arguments); });
}

}  // namespace stickslip
