// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The checkers of certificate/FORMAT.md, asked the same: the C++ checker through its library,
/// check.py in batches, many files to one Python process (tests/support/batch.py), and so
/// certificate/js/check.js in one process of node, and stickslip-proved.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "stickslip/engine/box_verdict.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/engine/verdict.hpp"
#include "stickslip/measures/margin.hpp"

namespace stickslip::test {

/// The directions of a plane of loads.
struct LoadDirections {
  Wrench u;
  Wrench v;
};

/// What a checker is given: the content of both files, any bytes, and the options.
struct CheckerInput {
  std::string grasp;
  std::string certificate;
  QuestionOptions options;
  std::optional<LoadDirections> plane = std::nullopt;
  std::vector<std::string> robustness{};  ///< the words that ask for one
};

struct CheckerAnswer {
  std::string result;  ///< "accepted", "rejected", "malformed", or what else went wrong
  std::string rule;    ///< if rejected
  std::optional<std::uint64_t> node;
  std::string path;  ///< of the node, or another place
  std::string found;

  /// Result, rule, node and path; a message's wording is each checker's own.
  bool agrees_with(const CheckerAnswer& other) const;
};

/// For failure messages.
std::string describe(const CheckerAnswer& answer);
std::string describe(const CheckerInput& input);

CheckerAnswer ask_cpp_checker(const CheckerInput& input);

/// Throws std::runtime_error when Python does not run or does not answer each.
std::vector<CheckerAnswer> ask_python_checker(const std::vector<CheckerInput>& inputs);

/// Fails the running test where check.js does not answer as the C++ checker, with these
/// answers: result, rule, node and path.
void expect_js_checker_agrees(const std::vector<CheckerInput>& inputs,
                              const std::vector<CheckerAnswer>& answers);

/// Fails the running test where stickslip-proved accepts, rejects or finds malformed what the
/// C++ checker, with these answers, does not; its rules may be coarser. Without
/// STICKSLIP_BUILD_PROVED does nothing.
void expect_proved_checker_agrees(const std::vector<CheckerInput>& inputs,
                                  const std::vector<CheckerAnswer>& answers);

/// The options as both programs, `stickslip decide` and `stickslip margin` take them on the
/// command line.
std::vector<std::string> command_line(const QuestionOptions& options);

/// The grasp file, certificate and options that state and prove a verdict.
CheckerInput input_of(const Question& question, const Verdict& verdict);
/// The same of a margin.
CheckerInput input_of(const Question& question, const Margin& margin);
/// The same of a box: of this grasp file, asked with these options.
CheckerInput input_of(const std::string& grasp, const QuestionOptions& options,
                      const BoxDecision& decision);

/// Fails the running test unless the C++ checker accepts, and leaves the files for check.py in
/// the folder named by the environment variable STICKSLIP_SPOOL, which the ctest
/// `check_py_spool` goes through when all tests that fill it are done
/// (stickslip_fills_spool in CMakeLists.txt).
void expect_accepted_by_both(const Question& question, const Verdict& verdict);
void expect_accepted_by_both(const Question& question, const Margin& margin);
void expect_accepted_by_both(const CheckerInput& input);

/// The same for a grasp and a normal law, with nothing replaced.
void expect_accepted_by_both(const LoadedGrasp& loaded, NormalLaw law, const Verdict& verdict);

}  // namespace stickslip::test
