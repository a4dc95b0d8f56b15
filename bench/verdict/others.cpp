// SPDX-License-Identifier: GPL-3.0-or-later
#include "others.hpp"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "limited.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/engine/states_engine.hpp"

#ifdef STICKSLIP_HAVE_GLPK
#include "weakly_stable.hpp"
#endif

namespace stickslip::bench {
namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Timed inside the limited process: `work` returns the answer.
template <class Work>
OtherAnswer timed(double seconds, Work work) {
  const auto text = run_limited(seconds, [&] {
    const Clock::time_point start = Clock::now();
    const std::string answer = work();
    return std::to_string(ms_since(start)) + ' ' + answer;
  });
  if (!text) return {seconds * 1e3, ""};
  return {std::strtod(text->c_str(), nullptr), text->substr(text->find(' ') + 1)};
}

OtherAnswer by_states(const Question& question, double seconds) {
  return timed(seconds, [&] {
    return std::string(name_of(decide_by_states(Problem(question.loaded(), question.law))));
  });
}

/// The time is that of the program, reading the file included.
OtherAnswer by_smt_solver(const std::vector<std::string>& command, const Question& question,
                          double seconds) {
  std::string path = (std::filesystem::temp_directory_path() / "verdict_bench_XXXXXX").string();
  const int file = mkstemp(path.data());
  if (file < 0) return {0, ""};
  std::ofstream(path) << smtlib_text(question);
  std::vector<std::string> argv = command;
  argv.push_back(path);
  const ProgramRun run = run_program(seconds, argv);
  std::filesystem::remove(path);
  OtherAnswer answer{run.seconds * 1e3, ""};
  if (run.output && run.output->rfind("sat", 0) == 0) answer.answer = "stable";
  if (run.output && run.output->rfind("unsat", 0) == 0) answer.answer = "unstable";
  return answer;
}

OtherAnswer by_z3(const Question& question, double seconds) {
  return by_smt_solver({"z3", "-smt2"}, question, seconds);
}

OtherAnswer by_cvc5(const Question& question, double seconds) {
  return by_smt_solver({"cvc5", "--lang=smt2"}, question, seconds);
}

#ifdef STICKSLIP_HAVE_GLPK
OtherAnswer by_glpk(const Question& question, double seconds) {
  return timed(seconds,
               [&] { return std::string(is_weakly_stable(question) ? "stable" : "unstable"); });
}
#endif

bool is_there(const char* program) {
  const ProgramRun run = run_program(10, {program, "--version"});
  return run.output && !run.output->empty();
}

}  // namespace

std::vector<Competitor> competitors() {
  std::vector<Competitor> result;
  result.push_back({"states", "the reference engine", true, by_states});
  if (is_there("z3")) result.push_back({"Z3", "", true, by_z3});
  if (is_there("cvc5")) result.push_back({"cvc5", "", true, by_cvc5});
#ifdef STICKSLIP_HAVE_GLPK
  result.push_back({"GLPK", "weakly stable only, in doubles", false, by_glpk});
#endif
  return result;
}

std::vector<std::string> missing_competitors() {
  std::vector<std::string> result;
  if (!is_there("z3")) result.emplace_back("Z3: n/a (apt-get install z3)");
  if (!is_there("cvc5")) result.emplace_back("cvc5: n/a (apt-get install cvc5)");
#ifndef STICKSLIP_HAVE_GLPK
  result.emplace_back("GLPK: n/a (apt-get install libglpk-dev)");
#endif
  return result;
}

}  // namespace stickslip::bench
