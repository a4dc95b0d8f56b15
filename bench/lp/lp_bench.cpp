// SPDX-License-Identifier: GPL-3.0-or-later
// Microseconds per exact LP, against CGAL's QP_solver on the same programs in the same run,
// with the work that was done. Feasibility of random systems, some feasible, some not.
//
//     lp_bench [programs per size, default 200]
//
// The clock is the process's CPU time over all programs of a size, best of 5 rounds for us and
// of 2 for QP_solver; building the programs (ours and CGAL's) is not timed.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <random>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "qp_solver.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::bench {
namespace {

enum class Data { kIntegers, kFractions, kDecimals, kNearMiss };

struct Size {
  const char* name;
  std::size_t variables;
  std::size_t rows;
  bool equations;  // rows =, variables >= 0; otherwise rows <=, variables free
  Data data;
  bool objective;
};

Rational random_number(std::mt19937& random, Data data) {
  const auto in = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  switch (data) {
    case Data::kIntegers:
    case Data::kNearMiss:
      return in(-9, 9);
    case Data::kFractions:
      return Rational(in(-9, 9), in(1, 9));
    case Data::kDecimals:
      return Rational(in(-99999, 99999), 1000);
  }
  return 0;
}

/// Half are made feasible by a known point; the others take their right-hand sides at random.
LinearProgram random_program(std::mt19937& random, const Size& size) {
  LinearProgram program;
  program.add_variables(size.variables,
                        size.equations ? VariableKind::kNonNegative : VariableKind::kFree);
  const bool is_made_feasible = random() % 2 == 0;
  std::vector<Rational> point(size.variables);
  for (Rational& x : point) {
    x = random_number(random, Data::kIntegers);
    if (size.equations) x = abs(x);
  }
  for (std::size_t i = 0; i < size.rows; ++i) {
    std::vector<Rational> row(size.variables);
    Rational rhs = random_number(random, size.data);
    if (is_made_feasible) rhs = size.equations ? Rational(0) : Rational(abs(rhs));
    for (std::size_t j = 0; j < size.variables; ++j) {
      row[j] = random_number(random, size.data);
      if (is_made_feasible) rhs += row[j] * point[j];
    }
    program.add_row(std::move(row), size.equations ? Relation::kEqual : Relation::kLessEqual,
                    std::move(rhs));
  }
  if (size.data == Data::kNearMiss) {
    // Through one point with -(sum of the rows), which contradicts them by 1e-18.
    LinearProgram closed;
    closed.add_variables(size.variables, VariableKind::kFree);
    std::vector<Rational> last(size.variables);
    Rational last_rhs = -parse_rational("1e-18");
    for (std::size_t i = 0; i + 1 < size.rows; ++i) {
      const std::vector<Rational>& row = program.row(i).coefficients;
      Rational rhs = 0;
      for (std::size_t j = 0; j < size.variables; ++j) {
        last[j] -= row[j];
        rhs += row[j] * point[j];
      }
      last_rhs -= rhs;
      closed.add_row(row, Relation::kLessEqual, rhs);
    }
    closed.add_row(std::move(last), Relation::kLessEqual, std::move(last_rhs));
    return closed;
  }
  if (size.objective) {
    std::vector<Rational> objective(size.variables);
    for (Rational& value : objective) value = random_number(random, Data::kIntegers);
    program.minimize(std::move(objective));
  }
  return program;
}

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Best of `rounds` rounds, in microseconds per call.
template <class Work>
double measure(int rounds, std::size_t calls, Work work) {
  double best = 1e300;
  for (int round = 0; round < rounds; ++round) {
    const double start = cpu_seconds();
    for (std::size_t k = 0; k < calls; ++k) work(k);
    best = std::min(best, cpu_seconds() - start);
  }
  return best * 1e6 / static_cast<double>(calls);
}

void run(const Size& size, std::size_t count) {
  std::mt19937 random(20180612);
  std::vector<LinearProgram> programs;
  std::vector<QpSolver> oracles;
  for (std::size_t k = 0; k < count; ++k) {
    programs.push_back(random_program(random, size));
    oracles.emplace_back(programs.back());
  }
  std::vector<char> ours(count);
  std::vector<char> theirs(count);
  const double our_time = measure(5, count, [&](std::size_t k) {
    ours[k] = std::holds_alternative<Infeasible>(solve(programs[k])) ? 0 : 1;
  });
  const double their_time =
      measure(2, count, [&](std::size_t k) { theirs[k] = oracles[k].is_feasible() ? 1 : 0; });

  const double calls = static_cast<double>(count);
  long double_pivots = 0;
  long exact_pivots = 0;
  long confirmed = 0;
  long tiers[3] = {0, 0, 0};
  long bits = 0;
  for (const LinearProgram& program : programs) {
    LpWork work;
    solve(program, &work);
    double_pivots += work.double_pivots;
    exact_pivots += work.exact_pivots;
    confirmed += work.basis_confirmed ? 1 : 0;
    ++tiers[static_cast<int>(work.tier)];
    bits = std::max(bits, work.largest_bits);
  }
  std::printf(
      "%-22s %3zu x %-3zu %9.2f %10.1f %7.1f   %5.1f %5.2f %6.1f%% %4ld/%ld/%ld %5ld  "
      "%3.0f%%%s\n",
      size.name, size.variables, size.rows, our_time, their_time, their_time / our_time,
      static_cast<double>(double_pivots) / calls, static_cast<double>(exact_pivots) / calls,
      100 * static_cast<double>(confirmed) / calls, tiers[0], tiers[1], tiers[2], bits,
      100 * static_cast<double>(std::count(ours.begin(), ours.end(), 1)) / calls,
      ours == theirs ? "" : "   VERDICTS DIFFER");
  if (ours != theirs) std::exit(1);
}

}  // namespace
}  // namespace stickslip::bench

int main(int argc, char** argv) {
  using stickslip::bench::Data;
  stickslip::bench::Arguments arguments(
      "lp_bench", "Microseconds per exact linear program, against CGAL's QP_solver.");
  stickslip::Command& app = arguments.described();
  std::size_t count = 200;
  app.add_option("PROGRAMS", count, "Programs of each size")->capture_default_str();
  if (const auto code = arguments.read(argc, argv)) return *code;
  std::printf(
      "%-22s %9s %9s %10s %7s   %5s %5s %7s %10s %5s  feasible\n"
      "%-22s %9s %9s %10s %7s   %5s %5s %7s %10s %5s\n",
      "data", "vars rows", "us/LP", "QP_solver", "ratio", "double", "exact", "conf.",
      "64/128/GMP", "bits", "", "", "", "us/LP", "", "pivots", "", "", "", "max");
  const stickslip::bench::Size sizes[] = {
      {"integers", 3, 24, false, Data::kIntegers, false},
      {"integers", 5, 20, false, Data::kIntegers, false},
      {"integers", 10, 30, false, Data::kIntegers, false},
      {"fractions", 3, 24, false, Data::kFractions, false},
      {"fractions", 5, 20, false, Data::kFractions, false},
      {"fractions", 10, 30, false, Data::kFractions, false},
      {"decimals", 3, 24, false, Data::kDecimals, false},
      {"decimals", 5, 20, false, Data::kDecimals, false},
      {"decimals", 10, 30, false, Data::kDecimals, false},
      {"integers, minimize", 5, 20, false, Data::kIntegers, true},
      {"integers, minimize", 10, 30, false, Data::kIntegers, true},
      {"integers, many rows", 4, 200, false, Data::kIntegers, false},
      {"infeasible by 1e-18", 3, 12, false, Data::kNearMiss, false},
      {"infeasible by 1e-18", 5, 20, false, Data::kNearMiss, false},
      {"equations, x >= 0", 20, 6, true, Data::kIntegers, false},
      {"equations, x >= 0", 60, 20, true, Data::kIntegers, false},
  };
  for (const auto& size : sizes) stickslip::bench::run(size, count);
}
