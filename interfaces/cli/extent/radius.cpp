// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/radius.hpp"

#include <iostream>
#include <memory>

#include "box_numbers.hpp"
#include "commands.hpp"
#include "long_work.hpp"
#include "question_options.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/interfaces/radius_answer.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

struct RadiusArguments {
  QuestionArguments question;
  std::string accuracy = "1%";
  std::string certificates;
  std::size_t node_limit = 0;
  std::string time_limit;
  NumberOptions output;
};

/// A box, and the grasp in its middle.
struct RadiusQuestion {
  Question question;
  GraspBox box;
  GraspBox centre;
};

class Report {
 public:
  Report(const RadiusQuestion& asked, const Radius& radius, const NumberOptions& output)
      : asked_(asked), radius_(radius), exact_(output.exact), text_(output) {}

  void print();

 private:
  bool none_proved() const { return radius_.proved.is_zero(); }
  std::string factor(const Rational& factor, Round round) const {
    return rounded_text(factor, round, exact_);
  }
  std::string tolerances_table() const;
  std::string numbers_table();
  std::string meaning() const;

  const RadiusQuestion& asked_;
  const Radius& radius_;
  bool exact_;
  NumberText text_;
};

/// Returns a table of each tolerance of --uncertain times the factors.
std::string Report::tolerances_table() const {
  std::vector<std::vector<std::string>> rows{{""}, {"asked"}, {"proved"}, {"refuted"}};
  const auto add = [&](const std::string& name, const Tolerance& tolerance) {
    const Rational size = tolerance.spelled();
    const std::string unit = tolerance.relative ? " %" : "";
    rows[0].push_back(name);
    rows[1].push_back(factor(size, Round::kDown) + unit);
    rows[2].push_back(factor(radius_.proved * size, Round::kDown) + unit);
    rows[3].push_back(radius_.refuted ? factor(*radius_.refuted * size, Round::kUp) + unit
                                      : "-");
  };
  add("factor", {1, false});
  for (const auto& [kind, tolerance] : given(asked_.question.uncertain)) add(kind, tolerance);
  if (asked_.box.ball) add("ball of loads", {asked_.box.ball->radius, false});
  return short_table(rows);
}

/// Returns a table of the numbers of the counterexample.
std::string Report::numbers_table() {
  const std::vector<UncertainNumber> numbers = uncertain_numbers(asked_.box);
  const std::vector<Rational> centre = values_in(asked_.box, asked_.centre);
  const std::vector<Rational> found = values_in(asked_.box, *radius_.example);
  std::vector<std::vector<std::string>> rows{{"differs", "centre", "counterexample"}};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (centre[i] == found[i]) continue;
    rows.push_back({numbers[i].label(), text_(centre[i]), text_(found[i])});
  }
  return "\nThe counterexample:\n\n" + short_table(rows) + "\n";
}

std::string Report::meaning() const {
  const std::string holds = *radius_.stable ? "holds the load" : "does not hold the load";
  const std::string other = *radius_.stable ? "does not hold it" : "holds it";
  std::string text =
      none_proved() ? "The grasp in the centre " + holds + ", and no box about it is proved.\n"
                    : "Every grasp within the proved tolerances " + holds +
                          ": one proof for all of them.\n";
  if (radius_.is_on_threshold()) {
    return text + "Beside it, as near as anything was tried, one " + other +
           ": it is on a threshold, or next to one.\n";
  }
  if (radius_.refuted) {
    return text + "Within the refuted tolerances one " + other +
           ". Between the two nothing is known.\n";
  }
  return text + "No counterexample is known" +
         (radius_.limit < RadiusOptions().most
              ? ": at factor " + factor(radius_.limit, Round::kDown) +
                    " the box reaches numbers that no grasp has.\n"
              : "; no factor above " + to_string(radius_.limit) + " was tried.\n");
}

void Report::print() {
  std::cout << heading(asked_.question) << verdict_name(radius_.stable) << "\n\n"
            << "  load w    " << load_text(asked_.centre.wrench, text_) << "\n\n";
  if (radius_.stable) {
    std::cout << tolerances_table() << '\n' << meaning();
    if (radius_.example) std::cout << numbers_table();
  } else {
    std::cout << "The grasp in the centre is not decided, and so is nothing about it.\n";
  }
  std::cout << text_.note() << conventions_text(asked_.question)
            << motions_text(asked_.question)
            << engine_text(box_engine(asked_.question), asked_.question.law);
}

void write_certificates(const RadiusQuestion& asked, const Radius& radius,
                        const std::string& folder) {
  std::vector<ProvedFiles> proofs =
      proved_radius(asked.centre, asked.box, asked.question.law, radius,
                    "stickslip " STICKSLIP_VERSION ", radius");
  std::vector<std::pair<std::string, ProvedFiles>> files;
  for (const char* name : {"proved", "refuted"}) {
    if (files.size() < proofs.size()) files.emplace_back(name, proofs[files.size()]);
  }
  write_proved_files("--certificates", folder, files);
}

int radius(const RadiusArguments& arguments) {
  RadiusOptions options;
  options.accuracy = accuracy_option(arguments.accuracy);
  options.box.node_limit = arguments.node_limit;
  RadiusQuestion asked{arguments.question.any_question(), {}, {}};
  asked.box = asked.question.grasp.as_box();
  asked.centre = asked.box.middle();
  if (asked.box.is_point()) {
    throw InputError("", "--uncertain", "nothing is uncertain",
                     "say how far numbers may be off, as in --uncertain friction=10%");
  }
  LongWork work("radius", time_limit_option(arguments.time_limit));
  Radius found;
  work.finishes([&] {
    found = find_radius(
        asked.centre, asked.box, asked.question.law, options, [&](const Radius& so_far) {
          found = so_far;
          work.say(
              "proved up to factor " + to_readable_string(so_far.proved) +
              (so_far.refuted ? ", refuted from " + to_readable_string(*so_far.refuted) : ""));
        });
  });
  if (!arguments.certificates.empty()) {
    if (found.stable) {
      write_certificates(asked, found, arguments.certificates);
    } else {
      say_nothing_written("--certificates", "the grasp in the centre is not decided");
    }
  }
  if (arguments.output.json) {
    Json json = radius_json(asked.question, found);
    work.add_ending(json);
    std::cout << finished(json, arguments.output.floats).dump(1) << '\n';
  } else {
    Report(asked, found, arguments.output).print();
    std::cout << work.ending();
    if (!arguments.certificates.empty() && found.stable) {
      std::cout << "Proofs: in " << arguments.certificates << ".\n";
    }
  }
  return found.stable ? kDone : kUndecidedWithinLimit;
}

}  // namespace

void add_radius_command(Command& app, int& exit_code) {
  auto arguments = std::make_shared<RadiusArguments>();
  Command* command = app.add_subcommand(
      "radius", "How far may numbers be off before the verdict is another? With proofs");
  arguments->question.add_with_uncertain_to(*command);
  command
      ->add_option("--accuracy", arguments->accuracy,
                   "Stop when what is proved and what is refuted differ by this part of it")
      ->type_name("A")
      ->capture_default_str();
  command
      ->add_option("--certificates", arguments->certificates,
                   "Write the largest box that is proved there, proved.json, and the "
                   "counterexample, refuted.json, each with its certificate for "
                   "stickslip-check")
      ->type_name("DIR");
  add_node_limit_option(*command, arguments->node_limit);
  add_time_limit_option(*command, arguments->time_limit);
  arguments->output.add_to(*command);
  command->footer(footer_text(
      "The answer is two factors of the tolerances: the largest for which every grasp has the\n"
      "verdict of the one in the centre, proved, and the smallest for which one is known that\n"
      "has not (docs/uncertainty.md). A box of a file is scaled about its middle.\n",
      kExitCodesWithLimit,
      "stickslip radius fig1.json --preload 1 --uncertain friction=10%,wrench=5%"));
  command->callback([arguments, &exit_code] { exit_code = radius(*arguments); });
}

}  // namespace stickslip
