// SPDX-License-Identifier: GPL-3.0-or-later
// How often the method in doubles (float_twin.hpp) is wrong, by family and tolerance, with
// exact truth: what `stickslip crosscheck` says of each of its answers. Prints a Markdown
// table, as in bench/README.md.
#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <string>

#include "arguments.hpp"
#include "families.hpp"
#include "float_twin.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/measures/claim.hpp"

namespace stickslip::bench {
namespace {

/// The double in 17 digits, which is how such claims are written by programs.
std::string spell(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// One line of a claims file.
std::string claim_line(const Question& question, const FloatAnswer& answer) {
  std::string grasp = write_grasp(question.loaded());
  grasp.pop_back();
  std::replace(grasp.begin(), grasp.end(), '\n', ' ');
  std::string line = "{\"grasp\": " + grasp + ", \"options\": {\"normal_law\": \"" +
                     to_string(question.law) + "\"}, \"claim\": {\"verdict\": ";
  if (!answer.stable) return line + "\"unstable\"}}";
  line += "\"stable\", \"twist\": [" + spell(answer.twist[0]) + ", " + spell(answer.twist[1]) +
          ", " + spell(answer.twist[2]) + "], \"force_vectors\": [";
  for (std::size_t i = 0; i < answer.forces.size(); ++i) {
    line += (i == 0 ? "[" : ", [") + spell(answer.forces[i].x()) + ", " +
            spell(answer.forces[i].y()) + "]";
  }
  return line + "]}}";
}

/// One row of the table.
struct Row {
  std::size_t stable = 0;  ///< exactly
  std::size_t false_stable = 0;
  std::size_t false_unstable = 0;
  std::size_t ties = 0;        ///< of the false ones
  std::size_t inaccurate = 0;  ///< right, but the solution is not one
  double worst_wrong = 0;      ///< largest relative distance to the threshold of a wrong answer

  void add(const Claim& claim, const ClaimReport& report) {
    const bool is_stable = std::holds_alternative<Stable>(report.answer.verdict);
    if (is_stable) ++stable;
    if (report.inaccurate) ++inaccurate;
    if (report.claim_class == ClaimClass::kRight) return;
    ++(claim.stable ? false_stable : false_unstable);
    if (report.claim_class == ClaimClass::kTie) ++ties;
    const auto distance = report.distance->smallest();
    if (distance && distance->high) {
      worst_wrong = std::max(worst_wrong, to_double(*distance->high));
    }
  }
};

int run(std::size_t instances, const std::string& claims_file) {
  std::ofstream claims;
  if (!claims_file.empty()) claims.open(claims_file);
  std::printf(
      "| family | tolerance | loads | stable | false stable | false unstable | of these ties | "
      "farthest | right, solution off |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (std::size_t f = 0; f < kFloatFamilies; ++f) {
    const auto family = static_cast<FloatFamily>(f);
    for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
      Row row;
      for (std::size_t index = 0; index < instances; ++index) {
        const Question question = float_question(family, index);
        const FloatAnswer answer = decide_in_doubles(to_float(question), tolerance);
        const std::string text = claim_line(question, answer);
        if (claims.is_open()) claims << text << '\n';
        // Judged as crosscheck would read it.
        const ClaimLine line = parse_claim_line(text, "");
        row.add(line.claim, judge_claim(line.question, line.claim));
      }
      std::printf("| %s | %.0e | %zu | %zu | %zu | %zu | %zu | %.1e | %zu |\n", name_of(family),
                  tolerance, instances, row.stable, row.false_stable, row.false_unstable,
                  row.ties, row.worst_wrong, row.inaccurate);
      std::fflush(stdout);
    }
  }
  if (claims.is_open() && !claims.flush()) {
    std::fprintf(stderr, "float_study: cannot write %s\n", claims_file.c_str());
    return 2;
  }
  return 0;
}

}  // namespace
}  // namespace stickslip::bench

int main(int argc, char** argv) {
  std::size_t instances = 240;
  bool quick = false;
  std::string claims_file;
  stickslip::bench::Arguments arguments("float_study",
                                        "How often the method in doubles is wrong");
  stickslip::Command& app = arguments.described();
  app.add_option("--instances", instances, "Loads in each family");
  app.add_flag("--quick", quick, "12 loads in each family: for tests");
  app.add_option("--claims", claims_file, "Write every answer for stickslip crosscheck")
      ->type_name("FILE");
  if (const auto code = arguments.read(argc, argv)) return *code;
  try {
    return stickslip::bench::run(quick ? 12 : instances, claims_file);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "float_study: %s\n", error.what());
    return 1;
  }
}
