// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/load_classes.hpp"

#include "contact_forces.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip {
namespace {

/// The forces a N + b T with |b| <= mu a, or with b = 0.
enum class Friction { kCone, kNone };

Wrench edge(const Problem& problem, std::size_t contact, int side, Friction friction) {
  return problem.edge_wrench(ContactId(contact), friction == Friction::kCone ? side : 0);
}

UnopposedMotion checked(const Problem& problem, Friction friction, UnopposedMotion motion) {
  require(power(problem.wrench(), motion.twist).sign() > 0, "the load does no work");
  for (std::size_t i = 0; i < problem.size(); ++i) {
    for (const int side : {1, -1}) {
      require(power(edge(problem, i, side, friction), motion.twist).sign() >= 0,
              "a contact force opposes the motion");
    }
  }
  return motion;
}

LoadClass balance(const Problem& problem, Friction friction) {
  LinearProgram program;
  program.add_variables(2 * problem.size(), VariableKind::kNonNegative);
  for (std::size_t j = 0; j < 3; ++j) {
    std::vector<Rational> coefficients;
    for (std::size_t i = 0; i < problem.size(); ++i) {
      for (const int side : {1, -1}) {
        coefficients.push_back(coordinates(edge(problem, i, side, friction))[j]);
      }
    }
    program.add_row(std::move(coefficients), Relation::kEqual,
                    -coordinates(problem.wrench())[j]);
  }
  const LpResult result = solve(program);
  if (const auto* infeasible = std::get_if<Infeasible>(&result)) {
    const std::vector<Rational>& y = infeasible->farkas;
    return checked(problem, friction, {{-y[0], -y[1], -y[2]}});
  }
  const std::vector<Rational>& point = std::get<Optimal>(result).point;
  BalancingForces found;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    found.forces.push_back(force_of_edges(problem.rows()[i], point[2 * i], point[2 * i + 1]));
    if (friction == Friction::kNone) found.forces.back().tangential = 0;
  }
  require(balances_in_cones(problem, found.forces), "the forces do not balance the load");
  return found;
}

}  // namespace

LoadClass weakly_stable_load(const Problem& problem) {
  return balance(problem, Friction::kCone);
}

LoadClass frictionless_stable_load(const Problem& problem) {
  return balance(problem, Friction::kNone);
}

}  // namespace stickslip
