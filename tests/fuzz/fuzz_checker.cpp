// SPDX-License-Identifier: GPL-3.0-or-later
// The C++ checker. An input is the options of its command line, separated by blanks, a line
// feed, a grasp file, a NUL byte and a certificate. The checker answers, whatever it is given;
// a refusal says why; what it prints is plain; and what is accepted of one body is true: the
// engines, which see no certificate, say the same; of a margin in space, about some of its
// multiples. (What is true of several bodies tests/certificate/cpp and tests/rules know, and of
// statics tests/rules and tests/certificate/python.)
//
// With the environment variable STICKSLIP_SPOOL, inputs are left in that folder for check.py
// together with the answer that it must give (tests/support/batch.py).
#include <algorithm>
#include <sstream>

#include "arguments.hpp"
#include "check.hpp"
#include "fuzz_target.hpp"
#include "print.hpp"
#include "spool.hpp"
#include "stickslip/engine/box_verdict.hpp"
#include "stickslip/engine/branch_and_bound.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/measures/margin.hpp"

namespace {

using stickslip::fuzz::broken;
using namespace stickslip_check;

struct Input {
  std::vector<std::string> words;
  std::string grasp;
  std::string certificate;
};

Input input_of(const std::string& bytes) {
  Input input;
  const std::size_t line = std::min(bytes.find('\n'), bytes.size());
  std::istringstream words(bytes.substr(0, line));
  for (std::string word; words >> word;) input.words.push_back(word);
  const std::size_t begin = std::min(line + 1, bytes.size());
  const std::size_t separator = std::min(bytes.find('\0', begin), bytes.size());
  input.grasp = bytes.substr(begin, separator - begin);
  input.certificate = bytes.substr(std::min(separator + 1, bytes.size()));
  return input;
}

void expect_well_said(const Answer& answer) {
  const auto* rejected = std::get_if<Rejected>(&answer);
  if (rejected != nullptr && rejected->found.empty()) broken("a rejection without a reason");
  const auto* malformed = std::get_if<Malformed>(&answer);
  if (malformed != nullptr && malformed->problem.empty()) broken("malformed without a reason");
  const auto* not_judged = std::get_if<NotJudged>(&answer);
  if (not_judged != nullptr && not_judged->why.empty()) broken("not judged without a reason");
  for (const std::string& text : {as_text(answer), as_json(answer)}) {
    const auto plain = [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); };
    if (!std::all_of(text.begin(), text.end(), plain)) broken("not plain: " + text);
  }
}

stickslip::Rational core_number(const Rational& number) {
  return stickslip::Rational(number.get_str());
}

stickslip::RationalRow core_wrench(const Vector& w) {
  return {core_number(w[0]), core_number(w[1]), core_number(w[2])};
}

/// What the engine finds, as the checker says it; empty if it would take long.
std::string truth(const Input& input, const Options& options) {
  if (options.plane) return {};  // tests/measures/resistance knows what is true of those
  stickslip::QuestionOptions asked;
  if (options.direction) asked.direction = core_wrench(*options.direction);
  if (const auto& growth = options.preload_direction) {
    asked.preload_direction = stickslip::PreloadDirection{growth->scale, {}};
    for (const Rational& rate : growth->values) {
      asked.preload_direction->preloads.push_back(core_number(rate));
    }
  }
  if (options.wrench) asked.wrench = core_wrench(*options.wrench);
  if (options.preload) asked.preload = core_number(*options.preload);
  if (options.bilateral) asked.law = stickslip::NormalLaw::kBilateral;
  const stickslip::Question question =
      stickslip::ask(stickslip::parse_grasp(input.grasp, "grasp"), asked);
  const stickslip::Problem problem = stickslip::problem_of(question);
  stickslip::SearchOptions limit;
  limit.node_limit = 300;
  if (!options.margin()) {
    const stickslip::Verdict verdict = stickslip::branch_and_bound(problem, limit);
    const bool decided = !std::holds_alternative<stickslip::Undecided>(verdict);
    return decided ? name_of(verdict) : "";
  }
  const auto found = stickslip::find_margin(problem, limit);
  const auto* margin = std::get_if<stickslip::Margin>(&found);
  if (margin == nullptr) return {};
  std::string text = "margin";
  for (const auto& [low, high] : margin->resisted) {
    text += " " + stickslip::to_string(low) + ".." + (high ? stickslip::to_string(*high) : "");
  }
  return text;
}

/// In space, at a multiple: what the engine finds, or nothing if it would take long.
std::string truth_in_space(const Input& input, const Question& question,
                           const Rational& multiple) {
  const auto at_multiple = [&](const Bounds& base, const Rational& growth) {
    const stickslip::Rational sum = core_number(base.low + multiple * growth);
    return stickslip::Interval{sum, sum};
  };
  stickslip::GraspBox grasp =
      stickslip::parse_any_grasp(input.grasp, "grasp").content.as_box();
  for (std::size_t j = 0; j < grasp.wrench.size(); ++j) {
    grasp.wrench[j] = at_multiple(question.wrench[j], question.growth[j]);
  }
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    grasp.contacts[i].preload = at_multiple(
        question.contacts[i].preload,
        question.preload_growth.size() == 0 ? Rational(0) : question.preload_growth[i]);
  }
  stickslip::QuestionOptions options;
  if (question.asked.bilateral) options.law = stickslip::NormalLaw::kBilateral;
  stickslip::SearchOptions limit;
  limit.node_limit = 300;
  const auto decision = stickslip::decide_box(grasp, options.law, limit);
  const bool decided = !std::holds_alternative<stickslip::Undecided>(decision.verdict);
  return decided ? name_of(decision.verdict) : "";
}

void expect_true_in_space(const Input& input, const Accepted& accepted) {
  const auto expect = [&](const Rational& multiple, const std::string& verdict) {
    const std::string found = truth_in_space(input, accepted.question, multiple);
    if (found.empty() || found == verdict) return;
    broken("accepted: " + verdict + " at " + multiple.get_str() + ", but true is: " + found);
  };
  if (accepted.verdict != "margin") expect(0, accepted.verdict);
  for (const auto& [low, high] : accepted.resisted) {
    expect(low, "stable");
    expect(high.value_or(low + 1), "stable");
  }
  for (const Range& range : accepted.refuted) {
    expect((range.low + range.high.value_or(range.low + 1)) / 2, "unstable");
    if (!range.open_low) expect(range.low, "unstable");
  }
}

std::string claim_of(const Accepted& accepted) {
  std::string text = accepted.verdict;
  for (const auto& [low, high] : accepted.resisted) {
    text += " " + low.get_str() + ".." + (high ? high->get_str() : "");
  }
  return text;
}

void leave_for_python(const Input& input, const Answer& answer) {
  static std::size_t count = 0;
  if (count++ % 16 != 0) return;                          // check.py takes its time
  if (std::holds_alternative<NotJudged>(answer)) return;  // each checker has its own limit
  const char* const results[] = {"accepted", "rejected", "malformed"};
  using stickslip::test::spool_line;
  const bool good = stickslip::test::append_to_spool(
      spool_line(input.grasp, input.certificate, input.words, results[answer.index()]));
  if (!good) broken("cannot write to the spool");
}

bool is_about_statics(const Input& input) {
  return std::any_of(input.words.begin(), input.words.end(),
                     [](const std::string& word) { return word.rfind("--statics", 0) == 0; });
}

void run(const Input& input) {
  std::vector<std::string> words = input.words;
  words.insert(words.end(), {"grasp", "certificate"});
  Arguments arguments;
  try {
    arguments = parse_arguments(words);
  } catch (const UsageError& error) {
    if (error.problem.empty()) broken("a refusal of options without a reason");
    return;
  }
  std::istringstream grasp(input.grasp);
  std::istringstream certificate(input.certificate);
  const Answer answer = check(grasp, certificate, arguments.options);
  expect_well_said(answer);
  if (!arguments.help && !arguments.json) leave_for_python(input, answer);
  const auto* accepted = std::get_if<Accepted>(&answer);
  if (accepted == nullptr || is_about_statics(input) ||
      accepted->question.contacts.size() > 6 || accepted->question.is_box ||
      accepted->question.several || accepted->question.asked.max_motion) {
    return;
  }
  if (accepted->question.in_space) {
    expect_true_in_space(input, *accepted);
    return;
  }
  const std::string found = truth(input, arguments.options);
  if (!found.empty() && found != claim_of(*accepted)) {
    broken("accepted: " + claim_of(*accepted) + ", but true is: " + found);
  }
}

/// "0,1,0": the numbers of a member, if the text has it, from these characters to those.
std::string vector_in(const std::string& text, const std::string& name,
                      const std::string& opening = "[", const std::string& closing = "]") {
  const std::string before = '"' + name + "\": " + opening;
  const std::size_t at = text.find(before);
  if (at == std::string::npos) return {};
  const std::size_t begin = at + before.size();
  std::string numbers = text.substr(begin, text.find_first_of(closing, begin) - begin);
  const auto is_mark = [](char c) { return c == '"' || c == ' '; };
  numbers.erase(std::remove_if(numbers.begin(), numbers.end(), is_mark), numbers.end());
  return numbers;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    run(input_of(std::string(data, data + size)));
  } catch (const std::exception& error) {
    broken(std::string("an exception: ") + error.what());
  }
  return 0;
}

std::vector<stickslip::fuzz::Seed> stickslip::fuzz::seeds(const std::filesystem::path& corpus) {
  const std::string ending = ".grasp.json";
  std::vector<Seed> files = files_below(corpus / "certificates");
  for (const char* folder : {"space", "bodies"}) {
    for (Seed& file : files_below(corpus / folder)) files.push_back(std::move(file));
  }
  std::vector<Seed> result;
  for (const Seed& grasp : files) {
    if (grasp.name.find(ending) == std::string::npos) continue;
    const std::string stem = grasp.name.substr(0, grasp.name.size() - ending.size());
    for (const Seed& certificate : files) {
      if (certificate.name != stem + ".certificate.json") continue;
      std::string words;
      if (stem.rfind("bilateral_", 0) == 0) words += " --normal-law bilateral";
      const std::string question =
          certificate.bytes.substr(0, certificate.bytes.find("\"verdict\""));
      const std::string direction = vector_in(question, "direction");
      const std::string wrench = vector_in(grasp.bytes, "wrench");
      if (!direction.empty()) {
        words += (wrench.empty() ? "" : " --wrench " + wrench) + " --direction " + direction;
      }
      const std::string growth = vector_in(question, "preload_direction");
      if (!growth.empty()) words += " --preload-direction " + growth;
      if (question.find("\"scale\"") != std::string::npos) {
        words += " --preload-direction scale";
      }
      const std::string first = vector_in(question, "plane", "[[");
      if (!first.empty()) {
        const std::string second = question.substr(question.find("], [") + 3);
        words += " --plane " + first + ',' + vector_in("\"v\": " + second, "v");
      }
      const std::string statics = vector_in(question, "statics", "", ",}");
      if (!statics.empty()) words += " --statics " + statics;
      result.push_back({stem, words + '\n' + grasp.bytes + '\0' + certificate.bytes});
    }
  }
  return result;
}
