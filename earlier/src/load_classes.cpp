// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/earlier/load_classes.hpp"

#include <algorithm>

#include "contact_forces.hpp"
#include "rigid_cells.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip {

using namespace earlier_detail;

namespace {

/// The forces a N + b T with |b| <= mu a, or with b = 0.
enum class Friction { kCone, kNone };

Wrench edge(const Problem& problem, std::size_t contact, int side, Friction friction) {
  return problem.edge_wrench(ContactId(contact), friction == Friction::kCone ? side : 0);
}

UnopposedMotion checked(const Problem& problem, Friction friction, const Twist& motion) {
  require(power(problem.wrench(), motion).sign() > 0, "the load does no work");
  for (std::size_t i = 0; i < problem.size(); ++i) {
    for (const int side : {1, -1}) {
      require(power(edge(problem, i, side, friction), motion).sign() >= 0,
              "a contact force opposes the motion");
    }
  }
  return {row_of(motion)};
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
    return checked(problem, friction, Twist{-y[0], -y[1], -y[2]});
  }
  const std::vector<Rational>& point = std::get<Optimal>(result).point;
  std::vector<ContactForce> found;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    found.push_back(force_of_edges(problem.rows()[i], point[2 * i], point[2 * i + 1]));
    if (friction == Friction::kNone) found.back().tangential = 0;
  }
  require(balances_in_cones(problem, found), "the forces do not balance the load");
  return rigid_forces(found);
}

}  // namespace

LoadClass weakly_stable_load(const Problem& problem) {
  return balance(problem, Friction::kCone);
}

LoadClass frictionless_stable_load(const Problem& problem) {
  return balance(problem, Friction::kNone);
}

namespace {

Acceleration checked(const Problem& problem, const Inertia& inertia,
                     const CellPoint& solution) {
  const Twist& a = solution.acceleration;
  require(!(a == Twist{}), "an acceleration is zero");
  require(row_of(resultant(problem, solution.forces)) == times_mass(inertia, row_of(a)),
          "an acceleration breaks Newton's law");
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    const ContactForce& f = solution.forces[i];
    const Rational apart = power(row.normal, a);
    const Rational slip = power(row.tangent, a);
    require(is_in_cone(row, f), "a force of an accelerating body leaves its friction cone");
    require(apart.sign() >= 0 && (f.normal * apart).is_zero(),
            "an acceleration breaks complementarity");
    require((row.friction * f.normal * abs(slip) + f.tangential * slip).is_zero(),
            "friction does not oppose the acceleration");
  }
  return {row_of(a), rigid_forces(solution.forces)};
}

}  // namespace

std::variant<StronglyStable, Acceleration, Undecided> strongly_stable_load(
    const Problem& problem, const Inertia& inertia, std::size_t most_programs) {
  require_planar(inertia);
  AccelerationSearch search = search_accelerations(problem, inertia, {}, most_programs);
  if (search.limited) {
    return Undecided{"it takes more than " + std::to_string(most_programs) +
                     " linear programs"};
  }
  if (search.found) return checked(problem, inertia, *search.found);
  LoadClass weak = weakly_stable_load(problem);
  auto* forces = std::get_if<RigidForces>(&weak);
  require(forces != nullptr, "the rigid-body model has no solution at all");
  return StronglyStable{std::move(*forces), std::move(search.tree)};
}

std::size_t StronglyStable::cases() const {
  return static_cast<std::size_t>(std::count_if(
      tree.begin(), tree.end(),
      [](const RigidNode& node) { return std::holds_alternative<RigidLeaf>(node); }));
}

RigidVerdict rigid_verdict(const Problem& problem, const Inertia& inertia,
                           std::size_t most_programs) {
  LoadClass weak = weakly_stable_load(problem);
  if (auto* motion = std::get_if<UnopposedMotion>(&weak)) return std::move(*motion);
  auto strong = strongly_stable_load(problem, inertia, most_programs);
  if (auto* motion = std::get_if<Acceleration>(&strong)) {
    return OpenLoad{std::move(std::get<RigidForces>(weak)), std::move(*motion)};
  }
  if (auto* undecided = std::get_if<Undecided>(&strong)) return std::move(*undecided);
  return std::get<StronglyStable>(std::move(strong));
}

RigidVerdict rigid_verdict(const Question& question, const Inertia& inertia) {
  if (question.in_space()) return rigid_verdict(point_in_space(question), inertia);
  return rigid_verdict(problem_of(question), inertia);
}

std::string name_of(const RigidVerdict& verdict) {
  constexpr const char* kNames[] = {"must move", "must hold", "open", "undecided"};
  return kNames[verdict.index()];
}

}  // namespace stickslip
