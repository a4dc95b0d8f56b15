// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/quality.hpp"

#include <iostream>
#include <memory>
#include <utility>

#include "box_numbers.hpp"
#include "cells.hpp"
#include "commands.hpp"
#include "long_work.hpp"
#include "question_options.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/engine/decide_in_time.hpp"
#include "stickslip/interfaces/quality_answer.hpp"
#include "stickslip/interfaces/quality_plot.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

struct QualityArguments {
  QuestionArguments question;
  QualityText quality;
  std::string certificates;
  std::size_t node_limit = 0;
  std::string time_limit;
  NumberOptions numbers;
  CellsAsked cells;  ///< the cells of a picture
  std::string output = "-";
};

/// Returns the radius as far as it is known, in words that follow "quality".
std::string radii_text(const Quality& quality, bool all_digits) {
  if (quality.scales && quality.refuted) {
    return "0: without load and preload, what is not resisted is not resisted however small";
  }
  if (quality.scales && !quality.proved.is_zero()) {
    return "without end: every load is resisted";
  }
  const std::string proved = rounded_text(quality.proved, Round::kDown, all_digits);
  if (quality.refuted) {
    return proved + " to " + rounded_text(*quality.refuted, Round::kUp, all_digits);
  }
  return proved + " or more: no load that is not resisted was found" +
         (quality.proved < quality.limit
              ? ""
              : ", and none farther than " + to_readable_string(quality.limit) + " sought");
}

/// Prints the rest about a load that is resisted.
void print_ball(const Quality& quality, NumberText& text, bool all_digits) {
  std::cout << "  quality   " << radii_text(quality, all_digits) << '\n';
  if (quality.radii.example) {
    std::cout << "  lost at   " << load_text(quality.radii.example->wrench, text) << '\n';
  }
  LoadBall ball = *quality.ball.ball;
  ball.radius = quality.proved;
  std::cout << "\nThe quality is the radius of the largest ball of loads around w that the "
               "grasp resists.\n";
  if (!quality.proved.is_zero()) {
    std::cout
        << "One proof is for every load that differs from w by a force and a torque with\n"
        << ball_text(ball, text) << ".\n";
  }
}

void print(const Question& question, const Quality& quality,
           const QualityArguments& arguments) {
  NumberText text(arguments.numbers);
  std::cout << heading(question) << verdict_name(quality.stable) << "\n\n  load w    "
            << load_text(quality.ball.wrench, text) << '\n';
  if (quality.stable == true) {
    print_ball(quality, text, arguments.numbers.exact);
  } else {
    std::cout << (quality.stable
                      ? "\nThe load w itself is not resisted: the grasp has no quality.\n"
                      : "\nThe load w is not decided, and so is nothing about others.\n");
  }
  if (!arguments.certificates.empty() && quality.stable) {
    std::cout << "Proofs: in " << arguments.certificates;
    if (!quality.proved.is_zero()) {
      LoadBall ball = *quality.ball.ball;
      ball.radius = quality.proved;
      std::cout << ". That of the ball is checked by\n  stickslip-check "
                << arguments.certificates << "/proved.json " << arguments.certificates
                << "/proved.certificate.json --uncertain wrench=" << to_string(ball);
    }
    std::cout << '\n';
  }
  std::cout << text.note() << conventions_text(question) << motions_text(question)
            << engine_text(box_engine(question), question.law);
}

/// A question and its answer.
struct QualityFound {
  Question question;
  Quality quality;
};

QualityFound find(const QualityArguments& arguments, LongWork& work) {
  const QualityAsked asked = quality_asked(arguments.quality);
  QualityOptions options = asked.options;
  options.radius.box.node_limit = arguments.node_limit;
  Question question = arguments.question.any_question();
  const LoadBall shape = shape_for(asked, question);
  const GraspBox grasp = grasp_for_ball(question, shape, arguments.question.name_of_file());
  Quality found;
  work.finishes([&] {
    found = find_quality(grasp, question.law, shape, options, [&](const Quality& so_far) {
      found = so_far;
      work.say("proved up to " + to_readable_string(so_far.proved) +
               (so_far.refuted ? ", refuted from " + to_readable_string(*so_far.refuted) : ""));
    });
  });
  return {std::move(question), std::move(found)};
}

int quality(const QualityArguments& arguments) {
  LongWork work("quality", time_limit_option(arguments.time_limit));
  const auto [question, found] = find(arguments, work);
  if (!arguments.certificates.empty()) {
    if (found.stable) {
      write_proved_files("--certificates", arguments.certificates,
                         proved_quality(question, found));
    } else {
      say_nothing_written("--certificates", "the load in the centre is not decided");
    }
  }
  if (arguments.numbers.json) {
    Json json = quality_json(question, found);
    work.add_ending(json);
    std::cout << finished(std::move(json), arguments.numbers.floats).dump(1) << '\n';
  } else {
    print(question, found, arguments);
    std::cout << work.ending();
  }
  return found.stable ? kDone : kUndecidedWithinLimit;
}

/// Returns the resisted part of one plane: exactly for one body in the plane, else cell by
/// cell.
ResistedSection resisted_in(LoadSection section, const QualityFound& found,
                            const CellsAsked& cells, const TimeLimit& limit) {
  const auto& [question, quality] = found;
  const auto& [s, t] = section.axes;
  LongWork work("a plane of loads", limit);
  if (question.box() == nullptr) {
    const WrenchPlane plane(question.loaded().wrench, wrench_of(s.along), wrench_of(t.along));
    ResistedSection resisted{section, std::vector<MapCell>{}};
    work.finishes([&] {
      auto region = resistible_set(problem_of(question), plane);
      resisted = {section, std::get<ResistibleSet>(std::move(region)).region};
    });
    return resisted;
  }
  auto proved = proved_cells(quality.ball.middle(), question.law, s, t, cells, work);
  return {std::move(section), std::move(proved)};
}

/// Returns the question about the load that is not resisted, if there is one.
Question question_to_draw(const QualityFound& found) {
  Question question = found.question;
  const auto& [stable, example] = std::pair(found.quality.stable, found.quality.radii.example);
  if (stable != true || !example) return question;
  if (LoadedGrasp* one = question.grasp.single()) {
    one->wrench = wrench_of(middle_of(example->wrench));
  } else {
    question.grasp.box()->wrench = example->wrench;
  }
  return question;
}

int draw_quality(const QualityArguments& arguments) {
  LongWork work("quality", time_limit_option(arguments.time_limit));
  const QualityFound found = find(arguments, work);
  CellsAsked cells = arguments.cells;
  cells.node_limit = arguments.node_limit;
  std::vector<ResistedSection> sections;
  if (found.quality.stable == true) {
    for (LoadSection& section : load_sections(found.quality)) {
      sections.push_back(resisted_in(std::move(section), found, cells, work.limit()));
    }
  }
  const Question drawn = question_to_draw(found);
  const Verdict verdict = decide_in_time(drawn, to_draw(), work.limit()).verdict;
  write_whole_file(arguments.output, plot_quality(drawn, verdict, found.quality, sections));
  return found.quality.stable ? kDone : kUndecidedWithinLimit;
}

/// Adds the options that the command and its picture share.
void add_quality_options(Command& command, QualityArguments& arguments) {
  arguments.question.add_with_enclosures_to(command);
  add_ball_options(command, arguments.quality);
  add_node_limit_option(command, arguments.node_limit);
  add_time_limit_option(command, arguments.time_limit);
}

}  // namespace

void add_quality_plot(Command& plot, int& exit_code) {
  auto arguments = std::make_shared<QualityArguments>();
  arguments->cells.depth = 5;
  Command* command = plot.add_subcommand(
      "quality",
      "The ball of loads that is resisted, in planes of loads, and the load that is not");
  add_quality_options(*command, *arguments);
  constexpr std::uint64_t kMostDepth = 12;
  add_count_option(*command, "--depth", arguments->cells.depth,
                   "In space and of several bodies: the finest cells are a 2^N-th of a plane",
                   kMostDepth);
  add_output_option(*command, arguments->output, "SVG file");
  command->footer(
      footer_text("", kExitCodesWithLimit,
                  "stickslip plot quality fig1.json --preload 1 --length 2 -o quality.svg"));
  command->callback([arguments, &exit_code] { exit_code = draw_quality(*arguments); });
}

void add_quality_command(Command& app, int& exit_code) {
  auto arguments = std::make_shared<QualityArguments>();
  Command* command = app.add_subcommand(
      "quality", "How large a ball of loads does the grasp resist? With proofs");
  add_quality_options(*command, *arguments);
  command
      ->add_option("--certificates", arguments->certificates,
                   "Write the ball that is resisted there, proved.json, and the load that is "
                   "not, refuted.json, each with its certificate for stickslip-check")
      ->type_name("DIR");
  arguments->numbers.add_to(*command);
  command->footer(footer_text(
      "A load w + z, z = (force, torque), is in the ball of radius R around the load w if\n"
      "|force|^2 + |torque/L|^2 <= R^2. The answer is two radii: of a ball that is resisted, "
      "by one\n"
      "proof for all of it, and of one with a load that is not (docs/quality.md). What is\n"
      "resisted is neither convex nor star-shaped, so that no number of loads would do.\n",
      kExitCodesWithLimit, "stickslip quality fig1.json --preload 1 --length 2"));
  command->callback([arguments, &exit_code] { exit_code = quality(*arguments); });
}

}  // namespace stickslip
