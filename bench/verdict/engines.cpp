// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <cmath>
#include <cstdio>

#include "loads.hpp"
#include "report.hpp"
#include "statistics.hpp"
#include "stickslip/core/snap.hpp"
#include "stickslip/engine/decide_problem.hpp"

namespace stickslip::bench {
namespace {

constexpr std::size_t kGrasps = 12;
const double kPi = std::acos(-1.0);

/// Positions and unit normals as a program in doubles has them, all digits of them; preload 1
/// with the normals snapped, as a preload asks for, or none.
Instance doubles(std::size_t contacts, std::size_t k) {
  const auto exact = [](double x, double y) {
    return Vector2{rational_from_double(x), rational_from_double(y)};
  };
  GraspFile file;
  std::vector<Contact> list;
  const bool preloaded = k % 2 == 0;
  for (std::size_t i = 0; i < contacts; ++i) {
    const double angle = 2 * kPi * (static_cast<double>(i) + 0.1 * static_cast<double>(k)) /
                         static_cast<double>(contacts);
    const double tilt = angle + kPi + 0.2 * std::sin(static_cast<double>(3 * i + k));
    list.push_back({exact(0.05 * std::cos(angle), 0.05 * std::sin(angle)),
                    exact(std::cos(tilt), std::sin(tilt)), rational_from_double(0.4), 1,
                    preloaded ? 1 : 0});
  }
  const double pull = 0.3 * static_cast<double>(k);
  Grasp grasp(std::move(list));
  if (preloaded) grasp = snap_normals(grasp, Rational(1, 1000000)).grasp;
  file.content =
      LoadedGrasp{std::move(grasp),
                  {rational_from_double(std::cos(pull)), rational_from_double(std::sin(pull)),
                   rational_from_double(0.001 * static_cast<double>(k % 3))}};
  return {"doubles", ask(file, {}), Expected::kUnknown};
}

Instance short_numbers(std::size_t contacts, std::size_t k) {
  return make_stable(k % kStableFamilies, contacts, 1 + k);
}

/// Milliseconds of the fastest of three, and the verdict.
std::pair<double, std::string> timed(const Problem& problem, Engine engine) {
  double best = INFINITY;
  std::string verdict;
  for (int run = 0; run < 3; ++run) {
    const auto start = std::chrono::steady_clock::now();
    verdict = name_of(decide(problem, by(engine)).verdict);
    const std::chrono::duration<double, std::milli> took =
        std::chrono::steady_clock::now() - start;
    best = std::min(best, took.count());
  }
  return {best, verdict};
}

}  // namespace

void report_engines(Report& report) {
  std::printf(
      "| m | short numbers: `branch-and-bound` | `states` | unit normals in doubles: "
      "`branch-and-bound` | `states` |\n"
      "|--:|--:|--:|--:|--:|\n");
  for (std::size_t contacts = 1; contacts <= 6; ++contacts) {
    std::printf("| %zu |", contacts);
    for (const auto make : {short_numbers, doubles}) {
      std::vector<double> cone;
      std::vector<double> states;
      for (std::size_t k = 0; k < kGrasps; ++k) {
        const Question question = make(contacts, k).question;
        const Problem problem(question.loaded(), question.law);
        const auto by_cones = timed(problem, Engine::kBranchAndBound);
        const auto by_states = timed(problem, Engine::kStates);
        if (by_cones.second != by_states.second) ++report.failures;
        cone.push_back(by_cones.first);
        states.push_back(by_states.first);
        report.json["engines"].push_back({{"contacts", contacts},
                                          {"family", make == doubles ? "doubles" : "short"},
                                          {"verdict", by_cones.second},
                                          {"cone_ms", by_cones.first},
                                          {"states_ms", by_states.first}});
      }
      std::printf(" %.2f | %.2f |", median(cone), median(states));
    }
    std::printf("\n");
    std::fflush(stdout);
  }
}

}  // namespace stickslip::bench
