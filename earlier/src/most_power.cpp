// SPDX-License-Identifier: GPL-3.0-or-later
#include "most_power.hpp"

namespace stickslip::earlier_detail {
namespace {

NoPower coprime(const Rational& weight, const std::vector<Rational>& multipliers) {
  RationalRow numbers{weight};
  numbers.insert(numbers.end(), multipliers.begin(), multipliers.end());
  const Row scaled = primitive_multiple(numbers);
  return {Rational(scaled.front()), {scaled.begin() + 1, scaled.end()}};
}

}  // namespace

std::variant<std::vector<Rational>, NoPower> most_power(LinearProgram program,
                                                        const RationalRow& load) {
  RationalRow objective;
  for (const Rational& w : load) objective.push_back(-w);
  program.minimize(objective);
  const LpResult solved = solve(program);
  if (const auto* none = std::get_if<Infeasible>(&solved)) return coprime(0, none->farkas);
  if (const auto* optimal = std::get_if<Optimal>(&solved)) {
    // w = 0 leaves no objective: the empty sum proves it.
    if (optimal->value.sign() >= 0) return coprime(1, optimal->dual);
    return optimal->point;
  }
  // The point returned is far enough along the ray that w.a > 0.
  const auto& [start, ray] = std::get<Unbounded>(solved);
  const Rational step = 1 + abs(dot(load, start)) / dot(load, ray);
  std::vector<Rational> x = start;
  for (std::size_t v = 0; v < x.size(); ++v) x[v] += step * ray[v];
  return x;
}

}  // namespace stickslip::earlier_detail
