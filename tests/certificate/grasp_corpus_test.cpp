// SPDX-License-Identifier: GPL-3.0-or-later
// Three readers of grasp files (core, the C++ checker, check.py) take and refuse the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "both_checkers.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/engine/decide.hpp"

namespace stickslip {
namespace {

using test::CheckerAnswer;
using test::CheckerInput;

/// A certificate about another number of contacts than any file of the corpus has: rejected by
/// question-contacts if the grasp file can be read.
const char* const kCertificate =
    R"({"format": "stickslip-certificate/2",
 "question": {"contacts": 123456, "wrench": [0, 0, 0], "normal_law": "unilateral"},
 "verdict": "unstable", "tree": []})";

std::string in_core(const std::string& text) {
  try {
    parse_any_grasp(text, "grasp", Intervals::kAllowed);
    return "read";
  } catch (const InputError&) {
    return "malformed";
  }
}

std::string in_checker(const CheckerAnswer& answer) {
  return answer.rule == "question-contacts" ? "read" : answer.result;
}

TEST(GraspCorpus, ReadAlike) {
  std::vector<std::string> names;
  std::vector<CheckerInput> inputs;
  for (const char* folder : {"good", "bad"}) {
    for (const auto& entry : std::filesystem::directory_iterator(
             std::string(STICKSLIP_CORPUS "/grasps/") + folder)) {
      std::ifstream in(entry.path(), std::ios::binary);
      inputs.push_back({{std::istreambuf_iterator<char>(in), {}}, kCertificate, {}});
      inputs.back().options.wrench = RationalRow(3);  // no case need be chosen
      names.push_back(std::string(folder) + "/" + entry.path().filename().string());
    }
  }
  // Those of several bodies have mostly five coordinates, and those of space six; a body in
  // space has no meaning to checkers, but all refuse the same.
  const auto add = [&](const std::string& name, const std::string& text) {
    const bool is_several = text.find("\"bodies\"") != std::string::npos;
    const bool is_in_space = text.find("[0, 0, 0, 0, 0, 0]") != std::string::npos;
    std::string certificate = kCertificate;
    certificate.replace(certificate.find("[0, 0, 0]"), 9,
                        is_several    ? "[0, 0, 0, 0, 0]"
                        : is_in_space ? "[0, 0, 0, 0, 0, 0]"
                                      : "[0, 0, 0]");
    names.push_back(name);
    inputs.push_back({text, certificate, {}});
  };
  std::ifstream refused(STICKSLIP_CORPUS "/grasps/refused.txt");
  for (std::string line; std::getline(refused, line);) {
    if (line[0] != '#') add("bad: " + line, line.substr(0, line.find(" |")));
  }
  for (const char* faces : {"[[0, 1, 0]]", R"([[0, 1, "2/2", 1.0], [1e0, -0, 0]])"}) {
    add(std::string("good: ") + faces,
        R"({"format": "stickslip-grasp/2", "contacts": [], "wrench": [0, 0, 0, 0, 0, 0],)"
        R"( "body": {"vertices": [[0, 0, 0], ["1/3", 1e-3, -2]], "faces": )" +
            std::string(faces) + "}}");
  }
  EXPECT_GE(names.size(), 200u);
  const std::vector<CheckerAnswer> python = test::ask_python_checker(inputs);
  std::vector<CheckerAnswer> answers;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string expected = names[i].rfind("good", 0) == 0 ? "read" : "malformed";
    EXPECT_EQ(in_core(inputs[i].grasp), expected) << names[i];
    const CheckerAnswer cpp = answers.emplace_back(ask_cpp_checker(inputs[i]));
    EXPECT_EQ(in_checker(cpp), expected) << names[i] << ": " << describe(cpp);
    EXPECT_EQ(in_checker(python[i]), expected) << names[i] << ": " << describe(python[i]);
  }
  test::expect_js_checker_agrees(inputs, answers);
  test::expect_proved_checker_agrees(inputs, answers);
}

// A proof about a plain file is one about the file with masses, frictions by name and angles.
// (The proved checker reads the plain files alone, and refuses the others.)
TEST(GraspCorpus, NotationMeansTheSame) {
  const std::string separator = " || ";
  std::vector<CheckerInput> inputs;
  std::vector<CheckerInput> plain;
  std::ifstream pairs(STICKSLIP_CORPUS "/grasps/notation.txt");
  for (std::string line; std::getline(pairs, line);) {
    if (line[0] == '#') continue;
    const std::size_t at = line.find(separator);
    const Answer answer = decide(ask(parse_any_grasp(line.substr(at + separator.size()), "")));
    const std::optional<std::string> certificate = certificate_of(answer);
    ASSERT_TRUE(certificate) << line;
    inputs.push_back({line.substr(0, at), *certificate, {}});
    plain.push_back({line.substr(at + separator.size()), *certificate, {}});
  }
  const std::vector<CheckerAnswer> python = test::ask_python_checker(inputs);
  std::vector<CheckerAnswer> answers;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    answers.push_back(ask_cpp_checker(inputs[i]));
    EXPECT_EQ(answers[i].result, "accepted") << describe(answers[i]) << describe(inputs[i]);
    EXPECT_EQ(python[i].result, "accepted") << describe(python[i]) << describe(inputs[i]);
  }
  test::expect_js_checker_agrees(inputs, answers);
  test::expect_proved_checker_agrees(plain, answers);
}

// The numbers of the files mean the same to each: the wrench is what the checkers compare.
TEST(GraspCorpus, NumbersMeanTheSame) {
  std::vector<CheckerInput> inputs;
  for (const char* spelling : {"0.1", "-0", "1e-3", "12.5E+1", "123456789012345678901234567890",
                               "\"-6/4\"", "\"+010\"", "\"2.50E+01\"", "\"1e-4096\"", "1e4096",
                               "0.000000000000000000001", "18446744073709551616"}) {
    const std::string text =
        std::string(R"({"format": "stickslip-grasp/1", "contacts": [], "wrench": [0, )") +
        spelling + ", 0]}";
    const Rational value = parse_grasp(text, "grasp").loaded().wrench.y;
    std::string certificate = kCertificate;
    certificate.replace(certificate.find("123456"), 6, "0");
    certificate.replace(certificate.find("0, 0, 0"), 7, "0, \"" + to_string(value) + "\", 0");
    inputs.push_back({text, certificate, {}});
  }
  const std::vector<CheckerAnswer> python = test::ask_python_checker(inputs);
  std::vector<CheckerAnswer> answers;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    answers.push_back(ask_cpp_checker(inputs[i]));
    EXPECT_EQ(answers[i].rule, "tree-short") << inputs[i].grasp;
    EXPECT_EQ(python[i].rule, "tree-short") << inputs[i].grasp;
  }
  test::expect_js_checker_agrees(inputs, answers);
  test::expect_proved_checker_agrees(inputs, answers);
}

}  // namespace
}  // namespace stickslip
