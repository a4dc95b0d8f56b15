// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Regenerates the tables of Haas-Heger et al. (RSS 2018) from grasp files and compares each
/// number with the printed one, exactly.
#include <algorithm>
#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "paper_rows.hpp"
#include "simple_grasp.hpp"
#include "stickslip/arrangement/slip_states.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/engine/states_engine.hpp"

namespace stickslip {
namespace {

constexpr int kAllAgree = 0;
constexpr int kDisagreement = 1;
constexpr int kBadInput = 2;
constexpr int kInternalError = 3;

constexpr const char* kSolution = "a solution";

constexpr const char* kUsage =
    "usage: paper_tables [DIRECTORY]\n"
    "Compares the tables of Haas-Heger et al. (RSS 2018) with exact verdicts on the grasps\n"
    "fig1.json, fig3.json and fig4.json in DIRECTORY (paper_examples/grasps unless given).\n"
    "Exit codes: 0 everything agrees, 1 something does not, 2 bad input or usage.\n";

/// "(0, -1, 0.5)", as the paper prints vectors.
std::vector<Rational> parse_tuple(const std::string& text) {
  require(text.size() > 2 && text.front() == '(' && text.back() == ')', "a printed vector");
  std::vector<Rational> values;
  for (std::size_t begin = 1; begin < text.size();) {
    const std::size_t end = text.find_first_of(",)", begin);
    values.push_back(parse_rational(text.substr(begin, end - begin)));
    begin = text.find_first_not_of(' ', end + 1);
  }
  return values;
}

template <class T>
T parse_triple(const std::string& text) {
  const std::vector<Rational> values = parse_tuple(text);
  require(values.size() == 3, "a printed wrench or motion has three entries");
  return {values[0], values[1], values[2]};
}

Witness parse_witness(const PrintedSolution& printed) {
  Witness witness{parse_triple<Twist>(printed.twist), {}};
  for (const std::string& force : printed.forces) {
    const std::vector<Rational> values = parse_tuple(force);
    require(values.size() == 2, "a printed force has two entries");
    witness.forces.push_back({values[0], values[1]});
  }
  return witness;
}

std::string tuple(const std::vector<Rational>& values) {
  std::string text;
  for (const Rational& value : values) text += (text.empty() ? "(" : ", ") + to_string(value);
  return text + ")";
}

PrintedSolution print(const Witness& witness) {
  PrintedSolution printed;
  printed.twist = tuple({witness.twist.x, witness.twist.y, witness.twist.r});
  for (const ContactForce& force : witness.forces) {
    printed.forces.push_back(tuple({force.normal, force.tangential}));
  }
  return printed;
}

/// The forces that the friction cone forbids, "f1, f3", numbered as in the paper.
std::string outside_cone(const Problem& problem, const Witness& witness) {
  std::string text;
  for (std::size_t i = 0; i < problem.size() && i < witness.forces.size(); ++i) {
    const auto& [normal, tangential] = witness.forces[i];
    if (abs(tangential) <= problem.rows()[i].friction * normal) continue;
    text += (text.empty() ? "f" : ", f") + std::to_string(i + 1);
  }
  return text;
}

const char* stable_or_not(bool stable) {
  return stable ? "stable" : "unstable";
}

/// Every comparison with the paper goes through here.
class Comparison {
 public:
  /// "agrees", or that it does not and what was expected.
  std::string check(const std::string& ours, const std::string& expected) {
    ++made_;
    if (ours == expected) return "agrees";
    ++failed_;
    return "DISAGREES: " + ours + " instead of " + expected;
  }

  std::size_t failed() const { return failed_; }

  /// Prints "N of N comparisons agree".
  int finish() const {
    std::cout << made_ - failed_ << " of " << made_ << " comparisons agree\n";
    return failed_ == 0 ? kAllAgree : kDisagreement;
  }

 private:
  std::size_t made_ = 0;
  std::size_t failed_ = 0;
};

class Report {
 public:
  explicit Report(std::filesystem::path directory) : directory_(std::move(directory)) {}

  void force_table(const ForceTable& table) {
    std::cout << table.title << '\n';
    PrintedSolution headings{{}, "d"};
    for (std::size_t i = 1; i <= table.rows.front().solution.forces.size(); ++i) {
      headings.forces.push_back("f" + std::to_string(i));
    }
    solution_line("", "", headings);
    for (const ForceRow& row : table.rows) force_row(table.grasp_file, row);
    std::cout << '\n';
  }

  void count_table(const std::vector<CountColumn>& columns) {
    std::cout
        << "Table II: slip states of random grasps with m contacts\n"
           "The paper's #(S) counts cells, V + E + F. Positions and normals here are drawn\n"
           "by std::mt19937 from its default seed, rational, stick planes in general\n"
           "position. A state is a sign vector, all-stick (d = 0) included.\n"
           "   m     V     E     F   cells   paper  states\n";
    for (const CountColumn& column : columns) {
      const std::size_t m = column.contacts;
      const ArrangementCounts counts = count(random_simple_grasp(m));
      std::cout << std::setw(4) << m << std::setw(6) << counts.vertices << std::setw(6)
                << counts.edges << std::setw(6) << counts.faces << std::setw(8)
                << counts.cells() << std::setw(8) << column.cells << std::setw(8)
                << counts.distinct_states << "   ";
      // Every two circles meet in two points, and no third passes through them.
      std::cout << check_numbers({{"V", counts.vertices, std::to_string(m * (m - 1))},
                                  {"E", counts.edges, std::to_string(2 * m * (m - 1))},
                                  {"F", counts.faces, std::to_string(m * (m - 1) + 2)},
                                  {"cells", counts.cells(), column.cells},
                                  {"states", counts.distinct_states, column.distinct_states}})
                << '\n';
    }
    for (const FigureCounts& figure : figure_counts()) {
      const ArrangementCounts counts =
          count(read_grasp_file(path_of(figure.grasp_file)).loaded().grasp);
      std::cout << figure.title << ": " << counts.cells() << " cells, "
                << counts.distinct_states << " states: "
                << check_numbers(
                       {{"cells", counts.cells(), figure.counts.cells},
                        {"states", counts.distinct_states, figure.counts.distinct_states}})
                << '\n';
    }
    std::cout << '\n';
  }

  void claim_group(const ClaimGroup& group) {
    std::cout << group.title << '\n';
    for (const Claim& claim : group.claims) {
      const Problem problem =
          problem_of(group.grasp_file, claim.wrench, claim.preload, group.law);
      const std::string verdict = name_of(decide_by_states(problem));
      const Wrench& w = problem.wrench();
      const std::string wrench =
          claim.wrench ? *claim.wrench : tuple({w.x, w.y, w.torque}) + " as in the file";
      const std::string load =
          "w = " + wrench + (claim.preload ? ", P = " + *claim.preload : "");
      std::cout << "  " << std::left << std::setw(42) << load << std::setw(10) << verdict
                << std::right << comparison_.check(verdict, stable_or_not(claim.stable))
                << '\n';
    }
    std::cout << '\n';
  }

  int finish() const { return comparison_.finish(); }

 private:
  /// The load as printed, or the file's where nothing is.
  Problem problem_of(const std::string& grasp_file, const std::optional<std::string>& wrench,
                     const std::optional<std::string>& preload, NormalLaw law) const {
    const std::string path = path_of(grasp_file);
    QuestionOptions options;
    if (wrench) options.wrench = row_of(parse_triple<Wrench>(*wrench));
    if (preload) options.preload = parse_rational(*preload);
    options.law = law;
    const GraspFile file = read_grasp_file(path);
    try {
      return Problem(ask(file, options).loaded(), law);
    } catch (const InputError& error) {
      throw error.in_file(path);
    }
  }

  std::string path_of(const std::string& grasp_file) const {
    return (directory_ / grasp_file).string();
  }

  static ArrangementCounts count(const Grasp& grasp) {
    return enumerate_slip_states_cgal(stick_planes(grasp)).counts;
  }

  struct NumberCheck {
    const char* name;
    std::size_t ours;
    std::string expected;
  };

  /// "agree", or those that do not.
  std::string check_numbers(const std::vector<NumberCheck>& numbers) {
    std::string failed;
    for (const NumberCheck& number : numbers) {
      const std::size_t failed_before = comparison_.failed();
      const std::string result =
          comparison_.check(std::to_string(number.ours), number.expected);
      if (comparison_.failed() == failed_before) continue;
      failed += (failed.empty() ? "" : "; ") + std::string(number.name) + ' ' + result;
    }
    return failed.empty() ? "agree" : failed;
  }

  static void solution_line(const std::string& label, const std::string& verdict,
                            const PrintedSolution& solution) {
    std::string line = "  " + label;
    const auto add = [&line](std::size_t column, const std::string& text) {
      line.resize(std::max(column, line.size() + 1), ' ');
      line += text;
    };
    if (!verdict.empty()) add(8, verdict);
    add(17, solution.twist);
    for (std::size_t i = 0; i < solution.forces.size(); ++i) {
      add(35 + 15 * i, solution.forces[i]);
    }
    std::cout << line << '\n';
  }

  /// "a solution", or the first condition that it breaks.
  static std::string judge(const Problem& problem, const PrintedSolution& solution) {
    return find_violation(problem, parse_witness(solution)).value_or(kSolution);
  }

  void force_row(const std::string& grasp_file, const ForceRow& row) {
    const Problem problem =
        problem_of(grasp_file, row.wrench, row.preload, NormalLaw::kUnilateral);
    const Verdict verdict = decide_by_states(problem);
    std::cout << "w = " << row.wrench << ", P = " << row.preload << ": verdict "
              << comparison_.check(name_of(verdict), stable_or_not(row.stable == "Yes"));
    const bool has_solution = !row.solution.forces.empty();
    const bool is_solution = !row.correction || row.correction->printed_is_solution;
    if (has_solution && is_solution) {
      std::cout << "; printed d and f solve it: "
                << comparison_.check(judge(problem, row.solution), kSolution);
    }
    std::cout << '\n';
    if (const auto* stable = std::get_if<Stable>(&verdict)) {
      solution_line("exact", "stable", print(stable->witness()));
    } else if (const auto* unstable = std::get_if<Unstable>(&verdict)) {
      solution_line(
          "exact", "unstable",
          {{}, "(refuted by a tree of " + std::to_string(unstable->tree.size()) + " nodes)"});
    }
    solution_line("paper", row.stable, has_solution ? row.solution : PrintedSolution{{}, "-"});
    if (row.correction) correction(problem, row.solution, *row.correction);
  }

  void correction(const Problem& problem, const PrintedSolution& printed,
                  const Correction& correction) {
    solution_line("intent", "", correction.intent);
    std::cout << "        " << correction.remark << '\n';
    if (!correction.printed_is_solution) {
      const bool solves = judge(problem, printed) == kSolution;
      const std::string outside = outside_cone(problem, parse_witness(printed));
      std::cout << "        printed d and f do not solve it: "
                << comparison_.check(solves ? kSolution : "no solution", "no solution")
                << "\n        since |f_t| > mu f_n at " << outside << ": "
                << comparison_.check(outside, correction.outside_cone) << '\n';
    }
    std::cout << "        intended d and f solve it: "
              << comparison_.check(judge(problem, correction.intent), kSolution) << '\n';
  }

  std::filesystem::path directory_;
  Comparison comparison_;
};

int run(const std::string& directory) {
  Report report(directory);
  report.force_table(table_1());
  report.count_table(table_2());
  report.force_table(table_3());
  report.claim_group(table_3_without_detachment());
  for (const ClaimGroup& group : claims()) report.claim_group(group);
  return report.finish();
}

}  // namespace
}  // namespace stickslip

int main(int argc, char** argv) {
  using namespace stickslip;
  const std::string argument = argc > 1 ? argv[1] : "paper_examples/grasps";
  if (argument == "--help" || argument == "-h") {
    std::cout << kUsage;
    return kAllAgree;
  }
  if (argc > 2 || argument.empty() || argument.front() == '-') {
    std::cerr << kUsage;
    return kBadInput;
  }
  try {
    const int exit_code = run(argument);
    std::cout.flush();
    if (std::cout) return exit_code;
    std::cerr << "paper_tables: standard output could not be written\n";
    return kBadInput;
  } catch (const InputError& error) {
    std::cerr << "paper_tables: " << error.what() << '\n';
    return kBadInput;
  } catch (const std::exception& error) {
    std::cerr << "paper_tables: internal error: " << error.what() << '\n';
    return kInternalError;
  }
}
