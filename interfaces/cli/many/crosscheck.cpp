// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "crosscheck_report.hpp"
#include "question_options.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/core/json.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

struct CrosscheckArguments {
  std::string file;
  std::string tie = "1e-9";
  std::string residual_tolerance = "1e-6";
  std::string save;
  std::size_t node_limit = 0;
  bool distances = false;
  NumberOptions output;
};

Rational nonnegative_option(const std::string& option, const std::string& value) {
  Rational number = rational_at(option, value);
  if (number.sign() < 0) {
    throw InputError("", option, "the value is " + to_string(number), "it must be 0 or more");
  }
  return number;
}

/// Saves a disagreeing line as a question of its own: the grasp with all options applied, and
/// the certificate of its verdict. Both files are written or none.
std::vector<std::string> save(const std::string& folder, std::size_t number, Answer answer) {
  answer.question = {answer.question.grasp, answer.question.law};
  const std::string stem = folder + "/line-" + std::to_string(number);
  const std::string grasp = stem + ".grasp.json";
  const std::string certificate = stem + ".certificate.json";
  const std::string grasp_text = write_grasp(answer.question.grasp);
  const std::string proof = certificate_of(answer).value();
  const FileWrite both;
  write_whole_file(certificate, proof);
  try {
    write_whole_file(grasp, grasp_text);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(certificate, ignored);
    throw;
  }
  return {grasp, certificate};
}

/// Makes the folder, and refuses one with files that an earlier run saved: a claim that is not
/// read yet may be about one of these grasps, and nobody could tell them apart in the folder.
void make_save_folder(const std::string& folder) {
  make_folder("--save", folder);
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!is_numbered(name, "line-", ".grasp.json") &&
        !is_numbered(name, "line-", ".certificate.json")) {
      continue;
    }
    throw InputError(entry.path().string(), "--save", "an earlier run saved this",
                     "name another folder, or remove what is saved in this one");
  }
}

ClaimCounts judge_all(std::istream& in, const std::string& folder,
                      const CrosscheckArguments& arguments, const ClaimOptions& options,
                      NumberText& number) {
  const NumberOptions& printed = arguments.output;
  ClaimCounts counts;
  Progress progress;
  TextLines lines(in);
  std::string text;
  const auto show = [&] {
    progress.show(std::to_string(counts.claims()) + " claims, " +
                  std::to_string(counts.of(ClaimClass::kWrong)) + " wrong");
  };
  for (bool more = true; more; show()) {
    std::string output;
    std::optional<JudgedLine> judged;
    try {
      more = lines.next(text);
      if (!more) break;
      ClaimLine line = parse_claim_line(text, folder);
      ClaimReport report = judge_claim(line.question, line.claim, options);
      judged = JudgedLine{lines.number(), std::move(line), std::move(report), {}};
    } catch (const InputError& error) {
      ++counts.unreadable;
      output = printed.json ? to_json_line(lines.number(), error) + "\n"
                            : to_text(lines.number(), error);
    }
    if (judged) {
      counts.add(judged->report);
      const ClaimClass c = judged->report.claim_class;
      if (!arguments.save.empty() && (c == ClaimClass::kTie || c == ClaimClass::kWrong)) {
        judged->saved = save(arguments.save, judged->number, judged->report.answer);
      }
      output = printed.json ? to_json_line(*judged, printed.floats) + "\n"
                            : to_text(*judged, options, number);
    }
    std::cout << output;
  }
  return counts;
}

int crosscheck(const CrosscheckArguments& arguments) {
  ClaimOptions options;
  options.tie_distance = nonnegative_option("--tie", arguments.tie);
  options.residual_tolerance =
      nonnegative_option("--residual-tolerance", arguments.residual_tolerance);
  options.node_limit = arguments.node_limit;
  options.all_distances = arguments.distances;

  InputFile file(arguments.file, "a claims file");
  const std::string folder =
      arguments.file == "-" ? "" : std::filesystem::path(arguments.file).parent_path().string();
  if (!arguments.save.empty()) make_save_folder(arguments.save);
  NumberText number(arguments.output);
  const ClaimCounts counts = judge_all(file.stream(), folder, arguments, options, number);
  if (counts.claims() == 0) {
    throw InputError(file.name(), "", "the file is empty, there is no claim in it",
                     "write one a line, see docs/crosscheck.md");
  }
  std::cout << (arguments.output.json ? to_json_line(counts) + "\n"
                                      : number.note() + to_text(counts));
  return counts.exit_code();
}

}  // namespace

void add_crosscheck_command(Command& app, int& exit_code) {
  auto arguments = std::make_shared<CrosscheckArguments>();
  Command* command = app.add_subcommand(
      "crosscheck",
      "Judge another program's answers: right, wrong, or a tie that only exact "
      "arithmetic can see");
  command
      ->add_option("CLAIMS", arguments->file,
                   "Claims file, JSON Lines (docs/crosscheck.md); - is standard input")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("--tie", arguments->tie,
                   "A wrong verdict counts as a tie if a change of the load by at most this "
                   "fraction of itself would make it right")
      ->type_name("EPS")
      ->capture_default_str();
  command
      ->add_option("--residual-tolerance", arguments->residual_tolerance,
                   "Report a claimed solution that misses a condition by more than this "
                   "fraction of the forces and motions at hand (docs/crosscheck.md)")
      ->type_name("EPS")
      ->capture_default_str();
  command->add_flag("--distances", arguments->distances,
                    "Compute the distance to the threshold for right claims as well");
  command
      ->add_option("--save", arguments->save,
                   "Write each disagreeing line into this folder as a grasp file and a "
                   "certificate for stickslip-check, line-N.grasp.json and "
                   "line-N.certificate.json")
      ->type_name("DIR");
  add_node_limit_option(*command, arguments->node_limit);
  arguments->output.add_to(
      *command, "Print one JSON object a line, and a summary; rationals are strings");
  command->footer(footer_text(
      "Right claims are counted, all others shown. A node limit holds for each verdict and "
      "each\n"
      "distance to a threshold. In space a twist has six numbers, and forces are given as\n"
      "\"force_vectors\": [fx, fy, fz] for each contact.\n",
      "0 all right or ties, 1 some wrong, 2 unreadable lines or bad usage,\n"
      "3 undecided within a limit; the first of 1, 2, 3 that applies",
      "stickslip crosscheck claims.jsonl\n"
      "where a line of claims.jsonl may be (broken here for reading)\n"
      "  {\"grasp\": \"fig1.json\", \"options\": {\"wrench\": [0, 1, 0], \"preload\": 1},\n"
      "   \"claim\": {\"verdict\": \"stable\", \"twist\": [0, 1, 0],\n"
      "             \"forces\": [[1, -0.5], [0, 0], [1, 0.5]]}}"));
  command->callback([arguments, &exit_code] { exit_code = crosscheck(*arguments); });
}

}  // namespace stickslip
