// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/preload.hpp"

#include <iostream>
#include <memory>
#include <utility>

#include "box_numbers.hpp"
#include "commands.hpp"
#include "long_work.hpp"
#include "margin_text.hpp"
#include "question_options.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/interfaces/preload_answer.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"
#include "terminal.hpp"
#include "warnings.hpp"

namespace stickslip {
namespace {

struct PreloadArguments {
  QuestionArguments question;
  bool hold = false;
  bool balanced = false;
  std::string equal = "normals";
  std::string budget;
  std::string length;
  std::string about;
  std::string body;
  std::string accuracy = "5%";
  std::string certificates;
  std::size_t boxes = 0;
  std::size_t node_limit = 0;
  std::string time_limit;
  NumberOptions output;

  PreloadOptions options(const GraspBox& grasp) const {
    PreloadOptions options;
    options.alike = alike_from(equal, grasp);
    options.box.node_limit = node_limit;
    options.balanced = balanced;
    options.accuracy = accuracy_option(accuracy);
    options.most_boxes = boxes;
    return options;
  }
};

std::string preloads_table(const RationalRow& preloads, NumberText& text) {
  std::vector<std::vector<std::string>> rows{{"contact", "preload"}};
  for (std::size_t i = 0; i < preloads.size(); ++i) {
    rows.push_back({std::to_string(i), text(preloads[i])});
  }
  return short_table(rows) + "\n";
}

/// Returns "[1, 5/4] and from 2".
std::string range_text(const PreloadRange& range, NumberText& text) {
  std::vector<std::string> parts;
  for (const auto& [low, high] : range.multiples) {
    parts.push_back(multiples_text(low, high, text));
  }
  return parts.empty() ? "not known" : joined(parts);
}

std::string range_meaning(const PreloadRange& range, const char* what) {
  if (range.boxes.empty() && range.margins.empty()) return "";
  return std::string("These multiples of the preloads hold ") + what +
         (range.boxes.empty() ? ", all in proportion.\n"
                              : "; between them each may be what it is for itself.\n");
}

std::string boxes_text(const std::vector<ProvedPreloads>& boxes) {
  return std::to_string(boxes.size()) + (boxes.size() == 1 ? " box" : " boxes") +
         " of preloads, which together cover them";
}

/// Returns why no more boxes were looked at.
std::string end_text(std::size_t looked, std::size_t most) {
  return std::to_string(looked) + (looked == 1 ? " box was" : " boxes were") + " looked at" +
         (looked >= most ? ", as many as --boxes allows" : "") + ".\n";
}

/// Returns which contacts press alike.
std::string alike_text(const ContactGroups& alike) {
  if (alike.empty()) return "";
  std::string groups;
  for (const std::vector<std::size_t>& group : alike) {
    std::string contacts;
    for (const std::size_t i : group)
      contacts += (contacts.empty() ? "" : ", ") + std::to_string(i);
    groups += (groups.empty() ? "" : "; ") + contacts;
  }
  return "Contacts that press alike: " + groups +
         " (--equal); multiples of the file's own preloads were tried, too.\n";
}

/// Prints the last lines about proofs, if they were written.
void print_folder(const std::string& folder, const RationalRow& preloads,
                  const PreloadRange& range, NumberText& text) {
  if (folder.empty()) return;
  std::cout << "Proofs: in " << folder << ".";
  if (!range.margins.empty()) {
    std::cout << " Those of multiples are checked with\n  --preload-direction ";
    const char* comma = "";
    for (const Rational& preload : preloads) {
      std::cout << std::exchange(comma, ",") << to_string(preload);
    }
  }
  std::cout << '\n' << text.note();
}

class LeastText {
 public:
  LeastText(const std::vector<Question>& questions, const LeastPreload& least,
            const PreloadArguments& arguments, const PreloadOptions& options)
      : questions_(questions),
        least_(least),
        arguments_(arguments),
        options_(options),
        text_(arguments.output),
        loads_(questions.size() == 1 ? "the load" : "all loads") {
    if (questions.front().uncertain.ball) {
      loads_ = questions.size() == 1 ? "all loads of the ball" : "all loads of all balls";
    }
  }

  void print() {
    const Question& question = questions_.front();
    const std::string& name = question.description().name;
    std::cout << name << (name.empty() ? "" : ": ")
              << (least_.preloads ? "held" : "no preloads found") << "\n\n"
              << loads();
    if (least_.preloads) {
      std::cout << preloads_table(*least_.preloads, text_) << "  sum        "
                << text_(sum_of(*least_.preloads)) << '\n';
    }
    std::cout << "  bound      " << rounded_text(least_.bound, Round::kDown, exact()) << '\n';
    if (least_.preloads)
      std::cout << "  multiples  " << range_text(least_.range, text_) << '\n';
    std::cout << '\n' << meaning();
    if (least_.preloads) {
      print_folder(arguments_.certificates, *least_.preloads, least_.range, text_);
    }
    if (arguments_.certificates.empty()) std::cout << text_.note();
    std::cout << conventions_text(question) << engine_text(box_engine(question), question.law);
    if (least_.preloads) stickslip::print(unbalanced(least_.held.front().box, question.law));
  }

 private:
  bool exact() const { return arguments_.output.exact; }

  std::string loads() {
    std::string lines;
    for (const Question& question : questions_) {
      lines += "  load w     " + load_text(question.grasp.wrench(), text_) +
               (question.case_name.empty() ? "" : "  " + question.case_name) + '\n';
    }
    if (const auto& ball = questions_.front().uncertain.ball) {
      lines += "  and what differs from it by a force and a torque with\n  " +
               ball_text(*ball, text_) + '\n';
    }
    std::string before;  // cases may have bounds of their own
    for (const Question& question : questions_) {
      const std::string bound = motions_text(question);
      if (bound != before) lines += "  " + bound;
      before = bound;
    }
    return lines + '\n';
  }

  std::string meaning() {
    std::string words;
    if (least_.preloads && sum_of(*least_.preloads).is_zero()) {
      words = "No preload is needed.\n";
    } else if (least_.bound.is_zero()) {
      words = "No bound of the sum is proved.\n";
    } else {
      words = "No preloads whose sum is below the bound hold " + loads_ +
              (arguments_.balanced ? ", balanced or not" : "") + ": proved for\n" +
              boxes_text(least_.refused) + ".\n";
    }
    words += alike_text(options_.alike);
    if (least_.looked > 0) words += end_text(least_.looked, options_.most_boxes_of_sum());
    if (least_.preloads) return words + range_meaning(least_.range, loads_.c_str());
    return words + "No preloads were sought of a sum above " + text_(least_.limit) + ".\n";
  }

  const std::vector<Question>& questions_;
  const LeastPreload& least_;
  const PreloadArguments& arguments_;
  const PreloadOptions& options_;
  NumberText text_;
  std::string loads_;
};

int hold(const PreloadArguments& arguments) {
  const std::vector<Question> questions = arguments.question.any_questions();
  const std::vector<GraspBox> loads = loads_of(questions, arguments.question.name_of_file());
  const PreloadOptions options = arguments.options(loads.front());
  LongWork work("preload", time_limit_option(arguments.time_limit));
  LeastPreload least;
  const bool is_done = work.finishes([&] {
    least = find_least_preload(
        loads, questions.front().law, options, [&](const LeastPreload& so_far) {
          least = so_far;
          work.say((so_far.preloads ? "held by " + to_readable_string(sum_of(*so_far.preloads))
                                    : std::string("nothing held")) +
                   ", bound " + to_readable_string(so_far.bound) + " by " +
                   std::to_string(so_far.refused.size()) + " boxes of preloads");
        });
  });
  if (!arguments.certificates.empty()) {
    write_proved_files("--certificates", arguments.certificates,
                       proved_preload(questions.front().law, least));
  }
  if (arguments.output.json) {
    Json json = preload_json(questions, least, options.alike);
    work.add_ending(json);
    std::cout << finished(std::move(json), arguments.output.floats).dump(1) << '\n';
  } else {
    LeastText(questions, least, arguments, options).print();
    std::cout << work.ending();
  }
  if (least.preloads) return kDone;
  return is_done && least.bound >= least.limit ? kAnswerUnstable : kUndecidedWithinLimit;
}

void print_ball(const Question& question, const Rational& budget, const BallPreload& found,
                const PreloadArguments& arguments, const PreloadOptions& options) {
  const Quality& quality = found.quality;
  const bool exact = arguments.output.exact;
  NumberText text(arguments.output);
  const bool holds = quality.stable == true;
  std::cout << heading(question) << (holds ? "held" : "no preloads found") << "\n\n"
            << "  load w     " << load_text(quality.ball.wrench, text) << "\n\n"
            << motions_text(question);
  if (holds) {
    std::cout << preloads_table(found.preloads, text) << "  radius     "
              << rounded_text(quality.proved, Round::kDown, exact);
    if (quality.refuted) {
      std::cout << "; not " << rounded_text(*quality.refuted, Round::kUp, exact);
    }
    std::cout << '\n';
  }
  std::cout << "  bound      "
            << (found.bound ? rounded_text(*found.bound, Round::kUp, exact) : "not known")
            << '\n';
  if (holds) std::cout << "  multiples  " << range_text(found.range, text) << '\n';
  LoadBall ball = *quality.ball.ball;
  ball.radius = quality.proved;
  std::cout << '\n';
  if (!quality.proved.is_zero()) {
    std::cout
        << "With these preloads every load is resisted that differs from w by a force and "
           "a\ntorque with "
        << ball_text(ball, text) << ".\n";
  }
  if (found.bound) {
    std::cout << "No preloads of a sum of at most " << text(budget)
              << " resist a larger ball than the bound: proved\nfor "
              << boxes_text(found.refused) << ".\n";
  }
  std::cout << alike_text(options.alike)
            << end_text(found.looked, options.most_boxes_of_ball());
  if (holds) {
    std::cout << range_meaning(found.range, "the ball");
    print_folder(arguments.certificates, found.preloads, found.range, text);
  }
  if (!holds || arguments.certificates.empty()) std::cout << text.note();
  std::cout << conventions_text(question) << engine_text(box_engine(question), question.law);
  if (holds) print(unbalanced(quality.ball, question.law));
}

int ball(const PreloadArguments& arguments) {
  const Rational budget = rational_at("--budget", arguments.budget);
  if (budget.sign() <= 0) {
    throw InputError("", "--budget", "the value is " + arguments.budget,
                     "it is the sum of preloads: give a number above 0");
  }
  QualityText text;
  text.length = arguments.length;
  text.about = arguments.about;
  text.body = arguments.body;
  const Question question = arguments.question.any_question();
  const LoadBall shape = shape_for(quality_asked(text), question);
  if (question.uncertain.any()) {
    throw InputError("", "--uncertain", "the ball is what is sought with --budget",
                     "leave it out, or ask --hold");
  }
  const GraspBox grasp = loads_of({question}, arguments.question.name_of_file()).front();
  const PreloadOptions options = arguments.options(grasp);
  LongWork work("preload", time_limit_option(arguments.time_limit));
  BallPreload found;
  work.finishes([&] {
    found = find_ball_preload(
        grasp, question.law, shape, budget, options, [&](const BallPreload& so_far) {
          found = so_far;
          work.say("proved up to " + to_readable_string(so_far.quality.proved) +
                   (so_far.bound ? ", bound " + to_readable_string(*so_far.bound) : ""));
        });
  });
  if (!arguments.certificates.empty()) {
    write_proved_files("--certificates", arguments.certificates,
                       proved_preload(question, found));
  }
  if (arguments.output.json) {
    Json json = preload_json(question, budget, found, options.alike);
    work.add_ending(json);
    std::cout << finished(std::move(json), arguments.output.floats).dump(1) << '\n';
  } else {
    print_ball(question, budget, found, arguments, options);
    std::cout << work.ending();
  }
  return found.quality.stable == true            ? kDone
         : found.bound && found.bound->is_zero() ? kAnswerUnstable
                                                 : kUndecidedWithinLimit;
}

}  // namespace

void add_preload_command(Command& app, int& exit_code) {
  auto arguments = std::make_shared<PreloadArguments>();
  Command* command = app.add_subcommand(
      "preload",
      "Which preloads are best: of the least sum, or for the largest ball of loads?");
  arguments->question.add_with_uncertain_to(*command);
  CommandOption* hold_option = command->add_flag(
      "--hold", arguments->hold,
      "Seek preloads of the least sum that hold the load, all cases of the file, or with "
      "--uncertain wrench=ball:R all loads around them");
  CommandOption* budget = command
                              ->add_option("--budget", arguments->budget,
                                           "Seek preloads of at most this sum that resist the "
                                           "largest ball of loads around the load")
                              ->type_name("B")
                              ->excludes(hold_option);
  for (auto& [option, value, type, words] :
       {std::tuple{
            "--length", &arguments->length, "L",
            "With --budget, as of quality: characteristic length of the object, by which "
            "torques are divided; else half the spread of the contacts"},
        std::tuple{"--about", &arguments->about, "X,Y",
                   "With --budget: the point about which torques are; else the origin"},
        std::tuple{"--body", &arguments->body, "NAME",
                   "With --budget: of several bodies the one that the loads are on"}}) {
    command->add_option(option, *value, words)->type_name(type)->needs(budget);
  }
  command->add_flag(
      "--balanced", arguments->balanced,
      "Seek preloads that friction balances before the load comes, of one body in "
      "the plane; the bound is about all preloads even so");
  command
      ->add_option(
          "--equal", arguments->equal,
          "Which contacts press alike, unless all preloads are a multiple of the file's: "
          "normals for those whose normals have one direction, as those of a jaw; none; "
          "or groups of contacts, as in 0,1:2,3. The bound is about all preloads even so")
      ->type_name("GROUPS")
      ->capture_default_str();
  command
      ->add_option("--accuracy", arguments->accuracy,
                   "Stop when what is found and the bound differ by this part")
      ->type_name("A")
      ->capture_default_str();
  add_count_option(*command, "--boxes", arguments->boxes,
                   "Look at so many boxes of preloads for the bound; 0 is 1000 with --hold and "
                   "200 with --budget");
  command
      ->add_option(
          "--certificates", arguments->certificates,
          "Write all proofs there, as grasp files and certificates for stickslip-check: "
          "what is held, which multiples hold, and the boxes of the bound")
      ->type_name("DIR");
  add_node_limit_option(*command, arguments->node_limit);
  add_time_limit_option(*command, arguments->time_limit);
  arguments->output.add_to(*command);
  command->footer(footer_text(
      "Preloads P_i >= 0 of contacts, in place of the file's, which are tried as well. The\n"
      "search is a local one, and what it finds is proved; the bound says how much better\n"
      "others might be, and is proved, too (docs/preload.md). More preload can break a grasp:\n"
      "the answer says which multiples hold. The more contacts, the farther the bound.\n",
      kExitCodesWithLimit + ";\n20 if no preloads up to a limit hold",
      "stickslip preload fig1.json --wrench 0,1/2,0 --hold\n"
      "  $ stickslip preload fig1.json --wrench 0,1/2,0 --hold --uncertain wrench=ball:1/8 "
      "--accuracy 10%\n"
      "  $ stickslip preload fig1.json --wrench 0,1/2,0 --budget 3 --length 2"));
  command->callback([arguments, &exit_code] {
    if (!arguments->hold && arguments->budget.empty()) {
      throw InputError(
          "", "", "it is not said which preloads are best",
          "ask for those of least sum with --hold, or give a sum, as in --budget 20");
    }
    try {
      exit_code = arguments->hold ? hold(*arguments) : ball(*arguments);
    } catch (const InputError& error) {
      if (error.place() == "equal") {
        throw InputError("", "--equal", error.problem(), error.remedy());
      }
      if (error.place() != "balanced") throw;
      throw in_options(error, arguments->question.name_of_file());
    }
  });
}

}  // namespace stickslip
