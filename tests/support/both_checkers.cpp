// SPDX-License-Identifier: GPL-3.0-or-later
#include "both_checkers.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "arguments.hpp"
#include "check.hpp"
#include "spool.hpp"
#include "stickslip/certificate/certificate.hpp"

namespace stickslip::test {
namespace {

using Json = nlohmann::json;

stickslip_check::Rational checker_number(const Rational& value) {
  return stickslip_check::Rational(to_string(value));
}

stickslip_check::Vector checker_vector(const Wrench& w) {
  return {checker_number(w.x), checker_number(w.y), checker_number(w.torque)};
}

stickslip_check::Vector checker_vector(const std::vector<Rational>& values) {
  stickslip_check::Vector result;
  for (const Rational& value : values) result.push_back(checker_number(value));
  return result;
}

std::string with_commas(const std::vector<Rational>& values) {
  std::string text;
  for (const Rational& value : values) text += (text.empty() ? "" : ",") + to_string(value);
  return text;
}

std::string with_commas(const Wrench& w) {
  return with_commas(std::vector<Rational>{w.x, w.y, w.torque});
}

std::string json_line(const CheckerInput& input, const std::string& expected) {
  std::vector<std::string> words = command_line(input.options);
  if (input.plane) {
    const auto& [u, v] = *input.plane;
    words.insert(words.end(), {"--plane", with_commas(u) + "," + with_commas(v)});
  }
  words.insert(words.end(), input.robustness.begin(), input.robustness.end());
  return spool_line(input.grasp, input.certificate, words, expected);
}

std::string text_or_empty(const Json& value) {
  return value.is_string() ? value.get<std::string>() : std::string();
}

/// A file that is gone at the end of the scope.
class TemporaryFile {
 public:
  explicit TemporaryFile(const char* suffix)
      : path_(::testing::TempDir() + "stickslip_" + std::to_string(getpid()) + suffix) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { std::remove(path_.c_str()); }

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Answers of a program whose command reads questions from a file and writes replies to one; it
/// is given both names, quoted.
template <typename MakeCommand>
std::vector<CheckerAnswer> ask_in_a_batch(const std::vector<CheckerInput>& inputs,
                                          MakeCommand make_command) {
  const TemporaryFile questions("_questions.jsonl");
  const TemporaryFile replies("_replies.jsonl");
  {
    std::ofstream file(questions.path(), std::ios::binary);
    for (const CheckerInput& input : inputs) file << json_line(input, "");
    if (!file.flush()) throw std::runtime_error("cannot write " + questions.path());
  }
  const std::string command =
      make_command("'" + questions.path() + "'", "'" + replies.path() + "'");
  if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
  std::vector<CheckerAnswer> answers;
  std::ifstream file(replies.path());
  for (std::string line; std::getline(file, line);) {
    const Json json = Json::parse(line);
    CheckerAnswer answer{json["result"].get<std::string>(),
                         text_or_empty(json["rule"]),
                         {},
                         "",
                         text_or_empty(json["found"])};
    if (answer.result == "rejected") answer.path = text_or_empty(json["path"]);
    if (json["node"].is_number()) answer.node = json["node"].get<std::uint64_t>();
    answers.push_back(std::move(answer));
  }
  if (answers.size() != inputs.size()) {
    throw std::runtime_error(std::to_string(answers.size()) + " answers to " +
                             std::to_string(inputs.size()) + " questions: " + command);
  }
  return answers;
}

}  // namespace

bool CheckerAnswer::agrees_with(const CheckerAnswer& other) const {
  return result == other.result && rule == other.rule && node == other.node &&
         path == other.path;
}

std::string describe(const CheckerAnswer& answer) {
  std::string text = answer.result;
  if (!answer.rule.empty()) text += " " + answer.rule;
  if (answer.node) text += " at node " + std::to_string(*answer.node);
  if (!answer.path.empty()) text += " (" + answer.path + ")";
  return text + (answer.found.empty() ? "" : ": " + answer.found);
}

std::string describe(const CheckerInput& input) {
  constexpr std::size_t kMost = 4000;
  std::string text;
  for (const std::string& word : command_line(input.options)) text += word + " ";
  return text + "\n" + input.grasp.substr(0, kMost) + "\n" + input.certificate.substr(0, kMost);
}

CheckerAnswer ask_cpp_checker(const CheckerInput& input) {
  stickslip_check::Options options;
  if (!input.robustness.empty()) {
    std::vector<std::string> words{"grasp", "certificate"};
    words.insert(words.end(), input.robustness.begin(), input.robustness.end());
    options = stickslip_check::parse_arguments(words).options;
  }
  if (input.options.wrench) options.wrench = checker_vector(*input.options.wrench);
  if (input.options.direction) options.direction = checker_vector(*input.options.direction);
  if (const auto& growth = input.options.preload_direction) {
    options.preload_direction =
        stickslip_check::PreloadDirection{growth->scale, checker_vector(growth->preloads)};
  }
  if (input.options.preload) options.preload = checker_number(*input.options.preload);
  if (input.options.max_motion) {
    options.max_motion = checker_vector(input.options.max_motion->numbers);
  }
  if (input.plane) {
    options.plane.emplace({checker_vector(input.plane->u), checker_vector(input.plane->v)});
  }
  options.bilateral = input.options.law == NormalLaw::kBilateral;
  for (const auto& [kind, tolerance] : given(input.options.uncertain)) {
    options.uncertain[kind] = {checker_number(tolerance.spelled()), tolerance.relative};
  }
  std::istringstream grasp(input.grasp);
  std::istringstream certificate(input.certificate);
  const stickslip_check::Answer answer = stickslip_check::check(grasp, certificate, options);
  if (const auto* rejected = std::get_if<stickslip_check::Rejected>(&answer)) {
    return {"rejected", rejected->rule, rejected->node, rejected->path, rejected->found};
  }
  if (const auto* malformed = std::get_if<stickslip_check::Malformed>(&answer)) {
    return {"malformed",
            "",
            {},
            "",
            malformed->file + ": " + malformed->place + ": " + malformed->problem};
  }
  if (const auto* not_judged = std::get_if<stickslip_check::NotJudged>(&answer)) {
    return {"not judged", "", {}, "", not_judged->why};
  }
  return {"accepted", "", {}, "", ""};
}

std::vector<CheckerAnswer> ask_python_checker(const std::vector<CheckerInput>& inputs) {
  return ask_in_a_batch(inputs, [](const std::string& questions, const std::string& replies) {
    return "'" STICKSLIP_PYTHON "' -B '" STICKSLIP_BATCH "' " + questions + " " + replies;
  });
}

void expect_js_checker_agrees(const std::vector<CheckerInput>& inputs,
                              const std::vector<CheckerAnswer>& answers) {
  const std::vector<CheckerAnswer> js =
      ask_in_a_batch(inputs, [](const std::string& questions, const std::string& replies) {
        return "'" STICKSLIP_NODE "' '" STICKSLIP_CHECK_NODE "' --batch <" + questions + " >" +
               replies;
      });
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    EXPECT_TRUE(js[i].agrees_with(answers[i]))
        << "C++: " << describe(answers[i]) << "\nJavaScript: " << describe(js[i]) << "\n"
        << describe(inputs[i]);
  }
}

void expect_proved_checker_agrees([[maybe_unused]] const std::vector<CheckerInput>& inputs,
                                  [[maybe_unused]] const std::vector<CheckerAnswer>& answers) {
#ifdef STICKSLIP_PROVED
  const std::vector<CheckerAnswer> proved =
      ask_in_a_batch(inputs, [](const std::string& questions, const std::string& replies) {
        return "'" STICKSLIP_PROVED "' --batch <" + questions + " >" + replies;
      });
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const std::string seen = "C++: " + describe(answers[i]) +
                             "\nproved: " + describe(proved[i]) + "\n" + describe(inputs[i]);
    EXPECT_EQ(proved[i].result, answers[i].result) << seen;
  }
#endif
}

std::vector<std::string> command_line(const QuestionOptions& options) {
  std::vector<std::string> words;
  if (options.wrench) {
    words.insert(words.end(), {"--wrench", with_commas(*options.wrench)});
  }
  if (options.preload) words.insert(words.end(), {"--preload", to_string(*options.preload)});
  words.insert(words.end(), {"--normal-law", to_string(options.law)});
  if (options.direction) {
    words.insert(words.end(), {"--direction", with_commas(*options.direction)});
  }
  if (const auto& growth = options.preload_direction) {
    words.insert(words.end(),
                 {"--preload-direction", growth->scale ? "scale" : with_commas(growth->preloads)});
  }
  std::string uncertain;
  for (const auto& [kind, tolerance] : given(options.uncertain)) {
    uncertain += std::string(uncertain.empty() ? "" : ",") + kind + "=" +
                 to_string(tolerance.spelled()) + (tolerance.relative ? "%" : "");
  }
  if (!uncertain.empty()) words.insert(words.end(), {"--uncertain", uncertain});
  return words;
}

namespace {

CheckerInput input_of(const Question& question) {
  CheckerInput input;
  input.options.law = question.law;
  input.options.preload = question.preload;
  LoadedGrasp file = question.loaded();
  if (question.preload_direction && question.preload_direction->scale) {
    file.grasp = file.grasp.with_preloads(question.preload_growth);
  }
  input.grasp = write_grasp(file);
  return input;
}

}  // namespace

void expect_accepted_by_both(const CheckerInput& input) {
  const CheckerAnswer answer = ask_cpp_checker(input);
  EXPECT_EQ(answer.result, "accepted") << describe(answer) << "\n" << describe(input);
  EXPECT_TRUE(append_to_spool(json_line(input, "accepted"))) << "cannot write to the spool";
}

CheckerInput input_of(const Question& question, const Verdict& verdict) {
  CheckerInput input = input_of(question);
  input.certificate = certificate_text(question, verdict, "tests");
  return input;
}

CheckerInput input_of(const Question& question, const Margin& margin) {
  CheckerInput input = input_of(question);
  input.options.wrench = row_of(question.loaded().wrench);
  input.options.direction = question.direction;
  input.options.preload_direction = question.preload_direction;
  input.certificate = margin_certificate_text(question, margin, "tests");
  return input;
}

CheckerInput input_of(const std::string& grasp, const QuestionOptions& options,
                      const BoxDecision& decision) {
  const Question question = ask(parse_any_grasp(grasp, "grasp"), options);
  return {grasp, certificate_text(question, decision.verdict, "tests", decision.bits), options};
}

void expect_accepted_by_both(const Question& question, const Margin& margin) {
  expect_accepted_by_both(input_of(question, margin));
}

void expect_accepted_by_both(const Question& question, const Verdict& verdict) {
  expect_accepted_by_both(input_of(question, verdict));
}

void expect_accepted_by_both(const LoadedGrasp& loaded, NormalLaw law, const Verdict& verdict) {
  expect_accepted_by_both(Question{loaded, law, std::nullopt}, verdict);
}

}  // namespace stickslip::test
