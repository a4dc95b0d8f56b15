// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>

#include "box_numbers.hpp"
#include "commands.hpp"
#include "long_work.hpp"
#include "question_options.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/certificate/proved_files.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/engine/decide_in_time.hpp"
#include "terminal.hpp"
#include "verdict_text.hpp"
#include "warnings.hpp"

namespace stickslip {
namespace {

void print_json(const Json& json, const NumberOptions& output) {
  std::cout << finished(json, output.floats).dump(1) << '\n';
}

/// \{ The limits of options.
constexpr std::size_t kMostSamples = 1000000;
constexpr std::uint64_t kMostSeed = 1000000000;
/// \}

struct WarnedAnswer {
  Answer answer;
  Warnings warnings;
};

void print_cases_json(const std::vector<WarnedAnswer>& answers, const NumberOptions& output) {
  const std::string name = answers.front().answer.question.description().name;
  Json json{{"name", name}, {"cases", Json::array()}};
  for (const auto& [answer, warnings] : answers) {
    json["cases"].push_back(to_json(answer, warnings));
  }
  print_json(json, output);
}

/// Prints a line for each case, and each warning once, with the cases that it is about.
void print_cases_text(const std::vector<WarnedAnswer>& answers, const NumberOptions& output) {
  NumberText text(output);
  std::vector<std::vector<std::string>> rows{{"case", "verdict", "load w"}};
  const bool has_second =
      std::any_of(answers.begin(), answers.end(),
                  [](const WarnedAnswer& a) { return a.answer.within != nullptr; });
  if (has_second) rows.front().insert(rows.front().begin() + 2, "but for rounding");
  std::vector<std::pair<std::string, std::string>> warnings;  // each warning with its cases
  for (const auto& [answer, found] : answers) {
    const std::string& name = answer.question.case_name;
    rows.push_back(
        {name, name_of(answer.verdict), load_text(answer.question.grasp.wrench(), text)});
    if (has_second) {
      rows.back().insert(rows.back().begin() + 2,
                         answer.within ? name_of(answer.within->verdict) : "");
    }
    for (const ModelWarning& warning : found.value_or(std::vector<ModelWarning>{})) {
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
  // The engine named is that of one grasp in the plane, if there is any; --case tells the
  // engine of others.
  const auto exact = std::find_if(answers.begin(), answers.end(), [](const WarnedAnswer& a) {
    return a.answer.problem.has_value();
  });
  const Answer& answer = exact == answers.end() ? answers.front().answer : exact->answer;
  const std::string& grasp = answer.question.description().name;
  const std::size_t n = answers.size();
  std::cout << (grasp.empty() ? "" : grasp + ": ") << n << (n == 1 ? " case" : " cases")
            << "\n\n"
            << format_table(rows, Align::kLeft)
            << "\nForces and motions, or why there are none: --case NAME.\n"
            << text.note() << conventions_text(answer.question)
            << engine_text(answer.engine(), answer.question.law);
  for (const auto& [warning, names] : warnings) {
    std::cout << "Warning, " << names << ": " << warning << ".\n";
  }
}

struct DecideArguments {
  QuestionArguments question;
  std::string engine = "auto";
  std::string certificate;
  std::string examples;
  SearchOptions search;
  NumberOptions output;
  bool no_warnings = false;
  bool answer_by_exit_code = false;
  std::string time_limit;
  std::size_t samples = 0;
  std::uint64_t seed = 1;
};

WarnedAnswer answered(Question question, const DecideArguments& arguments, LongWork& work) {
  const auto refuse = [](const std::string& problem, const std::string& remedy) {
    throw InputError("", "--engine", problem, remedy);
  };
  if (question.box() != nullptr && arguments.engine != "auto") {
    if (question.in_space() || question.mechanism() != nullptr) {
      refuse(question.in_space() ? "the grasp is in space, for which there is one engine"
                                 : "there are several bodies, for which there is one engine",
             "leave the option out");
    }
    if (question.box()->is_point()) {
      refuse("a preloaded contact has a normal of irrational length",
             "leave the option out, or ask about the file that stickslip snap writes");
    }
    refuse("the question is a box, about all grasps in it at once",
           "leave the option out: there is one engine for boxes");
  }
  SearchOptions search = arguments.search;
  if (arguments.engine == "states") search.engine = Engine::kStates;
  if (arguments.engine == "branch-and-bound") search.engine = Engine::kBranchAndBound;
  Warnings warnings;
  const auto warn = [&](const Answer& answer) {
    if (!arguments.no_warnings) warnings = model_warnings(answer);
  };
  Answer answer = decide_in_time(std::move(question), search, work.limit(), warn,
                                 [&](const auto& all) { return work.finishes(all); });
  return {std::move(answer), std::move(warnings)};
}

/// Writes the certificate if the verdict has one, or says on standard error why it has none.
void write_certificate(const Answer& answer, const std::string& file) {
  if (file.empty()) return;
  if (const auto certificate = certificate_of(answer)) {
    write_whole_file(file, *certificate);
  } else if (std::holds_alternative<Fragile>(answer.verdict)) {
    say_nothing_written("--certificate",
                        "what proves that a box is fragile is two grasps, each with a "
                        "certificate; --examples DIR writes them");
  } else {
    say_nothing_written("--certificate",
                        "the verdict is undecided, so there is no proof of one");
  }
}

/// Draws the samples that were asked for from a box without one verdict. Says on standard error
/// if it has one.
std::optional<Samples> drawn(Answer& answer, const DecideArguments& arguments, LongWork& work) {
  if (arguments.samples == 0) return std::nullopt;
  const bool has_one = is_stable(answer.verdict).has_value();
  if (has_one) {
    std::cerr << "stickslip: --samples drew nothing: the verdict is proved for every grasp in "
                 "the box\n";
    return std::nullopt;
  }
  Samples samples{arguments.seed};
  work.finishes([&] {
    decide_samples(answer.question, arguments.samples, arguments.search, samples, [&] {
      work.say("samples: " + std::to_string(samples.stable) + " stable, " +
               std::to_string(samples.unstable) + " unstable of " +
               std::to_string(arguments.samples));
    });
  });
  add_samples(answer.verdict, samples);
  return samples;
}

/// Writes the two grasps of a fragile box and the samples that are unstable, each with the
/// certificate of its verdict. Says on standard error if there are none.
void write_examples(const Answer& answer, const Samples* samples, const std::string& folder) {
  if (folder.empty()) return;
  const auto* fragile = std::get_if<Fragile>(&answer.verdict);
  const bool has_failures = samples != nullptr && !samples->failures.empty();
  if (fragile == nullptr && !has_failures) {
    const GraspBox* box = answer.question.box();
    const bool is_box = box != nullptr && !box->is_point();
    say_nothing_written(
        "--examples", (is_box ? "the box is " : "the question is about one grasp, which is ") +
                          std::string(name_of(answer.verdict)) +
                          (is_box ? ", and only one that is fragile has two examples" : ""));
    return;
  }
  const NormalLaw law = answer.question.law;
  const std::string producer = producer_of(answer.engine());
  std::vector<std::pair<std::string, ProvedFiles>> files;
  if (fragile != nullptr) {
    files = {{"stable", proved_grasp(fragile->stable, law, true, producer)},
             {"unstable", proved_grasp(fragile->unstable, law, false, producer)}};
  }
  if (has_failures) {
    for (const auto& [number, failure] : samples->failures) {
      files.emplace_back("sample" + std::to_string(number), failure);
    }
  }
  write_proved_files("--examples", folder, files);
}

/// Returns the exit code of the worst answer: unstable, then fragile, then undecided, then
/// stable.
int exit_code(const std::vector<WarnedAnswer>& answers, bool answer_by_exit_code) {
  const auto any = [&](const std::string& verdict) {
    return std::any_of(answers.begin(), answers.end(), [&](const WarnedAnswer& a) {
      return name_of(a.answer.verdict) == verdict;
    });
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
  const GraspBox* box = questions.front().box();
  if (arguments.samples != 0 && (by_case || box == nullptr || box->is_point())) {
    throw InputError("", "--samples",
                     by_case ? "the grasp has cases, and samples are of one box"
                             : "the question is about one grasp, of which there are no samples",
                     by_case ? "choose the case with --case NAME"
                             : "say with --uncertain how far numbers may be off");
  }
  LongWork work("deciding", time_limit_option(arguments.time_limit));
  std::vector<WarnedAnswer> answers;
  for (Question& question : questions) {
    if (by_case) work.say(question.case_name);
    answers.push_back(answered(std::move(question), arguments, work));
  }
  const bool json = arguments.output.json;
  if (by_case) {
    (json ? print_cases_json : print_cases_text)(answers, arguments.output);
  } else {
    auto& [answer, warnings] = answers.front();
    const std::optional<Samples> samples = drawn(answer, arguments, work);
    const Samples* some = samples ? &*samples : nullptr;
    write_certificate(answer, arguments.certificate);
    write_examples(answer, some, arguments.examples);
    if (json) {
      Json result = to_json(answer, warnings);
      if (samples) result["samples"] = samples_json(*samples);
      print_json(result, arguments.output);
    } else {
      print_text(answer, warnings, arguments.output, arguments.examples, some);
    }
  }
  return exit_code(answers, arguments.answer_by_exit_code);
}

}  // namespace

void add_decide_command(Command& app, int& exit_code) {
  auto arguments = std::make_shared<DecideArguments>();
  Command* command = app.add_subcommand(
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
      ->transform([](const std::string& name) {  // its old name
        return name == "cone" ? std::string("branch-and-bound") : name;
      })
      ->choices({"auto", "states", "branch-and-bound"})
      ->capture_default_str();
  command
      ->add_option("--certificate", arguments->certificate,
                   "Write a proof of the verdict for stickslip-check (certificate/FORMAT.md)")
      ->type_name("FILE");
  command
      ->add_option("--examples", arguments->examples,
                   "If the box is fragile, write two of its grasps there, stable.json and "
                   "unstable.json, each with its certificate; and samples that are unstable")
      ->type_name("DIR");
  add_count_option(*command, "--samples", arguments->samples,
                   "If the box is fragile or undecided, decide so many of its grasps, drawn at "
                   "random, and say which share holds; --examples DIR keeps those that do not",
                   kMostSamples);
  add_count_option(*command, "--seed", arguments->seed, "The seed of --samples", kMostSeed);
  add_node_limit_option(*command, arguments->search.node_limit);
  add_time_limit_option(*command, arguments->time_limit);
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
