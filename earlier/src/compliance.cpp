// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/earlier/compliance.hpp"

#include <algorithm>
#include <array>

#include "contact_forces.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip {

using namespace earlier_detail;

namespace {

using States = std::vector<SpringState>;

std::vector<Rational> scaled(const Rational& factor, const Wrench& row) {
  const Vector3 entries = coordinates(factor * row);
  return {entries.begin(), entries.end()};
}

/// K d = w + sum P N, in the free variables d.
LinearProgram balance(const Problem& problem, const States& states) {
  std::array<std::vector<Rational>, 3> stiffness;
  stiffness.fill(std::vector<Rational>(3));
  Wrench right = problem.wrench();
  const auto add_spring = [&](const Rational& k, const Wrench& row) {
    const Vector3 r = coordinates(row);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) stiffness[i][j] += k * r[i] * r[j];
    }
  };
  for (std::size_t i = 0; i < problem.size(); ++i) {
    if (states[i] == SpringState::kDetached) continue;
    const ContactRow& row = problem.rows()[i];
    right += row.preload * row.normal;
    add_spring(row.stiffness, row.normal);
    if (states[i] == SpringState::kStick) add_spring(row.stiffness, row.tangent);
  }
  LinearProgram program;
  program.add_variables(3, VariableKind::kFree);
  for (std::size_t j = 0; j < 3; ++j) {
    program.add_row(std::move(stiffness[j]), Relation::kEqual, coordinates(right)[j]);
  }
  return program;
}

ContactForce spring_force(const ContactRow& row, SpringState state, const Twist& d) {
  if (state == SpringState::kDetached) return {0, 0};
  return {row.normal_coefficient(d), state == SpringState::kStick
                                         ? Rational(-row.stiffness * power(row.tangent, d))
                                         : Rational(0)};
}

Witness springs_at(const Problem& problem, const States& states,
                   const std::vector<Rational>& d) {
  Witness springs{{d[0], d[1], d[2]}, {}};
  for (std::size_t i = 0; i < problem.size(); ++i) {
    springs.forces.push_back(spring_force(problem.rows()[i], states[i], springs.twist));
  }
  require(resultant(problem, springs.forces) == Wrench{}, "springs do not balance the load");
  return springs;
}

/// v = P - k N.d and the tangential force must allow the contact's state.
void add_conditions(const ContactRow& row, SpringState state, LinearProgram& program) {
  // -k N.d >= -P, or <= for a released spring.
  program.add_row(
      scaled(-row.stiffness, row.normal),
      state == SpringState::kDetached ? Relation::kLessEqual : Relation::kGreaterEqual,
      -row.preload);
  if (state != SpringState::kStick) return;
  // mu (P - k N.d) -+ k T.d >= 0.
  for (const int side : {1, -1}) {
    program.add_row(
        scaled(-row.stiffness, row.friction * row.normal + Rational(side) * row.tangent),
        Relation::kGreaterEqual, -row.friction * row.preload);
  }
}

std::optional<Witness> solve_states(const Problem& problem, const States& states) {
  LinearProgram program = balance(problem, states);
  for (std::size_t i = 0; i < problem.size(); ++i) {
    add_conditions(problem.rows()[i], states[i], program);
  }
  const LpResult result = solve(program);
  const auto* optimal = std::get_if<Optimal>(&result);
  if (optimal == nullptr) return std::nullopt;
  Witness springs = springs_at(problem, states, optimal->point);
  require(balances_in_cones(problem, springs.forces), "a spring's force leaves its cone");
  for (std::size_t i = 0; i < problem.size(); ++i) {
    require(states[i] != SpringState::kDetached ||
                problem.rows()[i].normal_coefficient(springs.twist).sign() <= 0,
            "a detached contact is compressed");
  }
  return springs;
}

/// The next combination, the last contact varying fastest; false after the last one.
bool advance(States& states) {
  for (auto state = states.rbegin(); state != states.rend(); ++state) {
    if (*state == SpringState::kStick) {
      *state = SpringState::kSlip;
      return true;
    }
    if (*state == SpringState::kSlip) {
      *state = SpringState::kDetached;
      return true;
    }
    *state = SpringState::kStick;
  }
  return false;
}

}  // namespace

std::variant<SpringBalance, UnresistedMotion> linear_compliance(const Problem& problem) {
  const States all_stick(problem.size(), SpringState::kStick);
  const LpResult result = solve(balance(problem, all_stick));
  if (const auto* infeasible = std::get_if<Infeasible>(&result)) {
    const std::vector<Rational>& y = infeasible->farkas;
    const UnresistedMotion motion{{y[0], y[1], y[2]}};
    require(!power(problem.wrench(), motion.twist).is_zero(), "the load does no work");
    for (const ContactRow& row : problem.rows()) {
      require(power(row.normal, motion.twist).is_zero() &&
                  power(row.tangent, motion.twist).is_zero(),
              "a spring resists the motion");
    }
    return motion;
  }
  SpringBalance found{springs_at(problem, all_stick, std::get<Optimal>(result).point), {}};
  Rational furthest = 0;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    const ContactForce& f = found.springs.forces[i];
    const Rational distance =
        std::max(Rational(abs(f.tangential) - row.friction * f.normal), Rational(-f.normal));
    if (distance > furthest) {
      furthest = distance;
      found.outside = ContactId(i);
    }
  }
  return found;
}

std::variant<SpringStates, NoSpringStates, Undecided> three_state_compliance(
    const Problem& problem, std::size_t most_contacts) {
  if (problem.size() > most_contacts) {
    return Undecided{"there are 3^" + std::to_string(problem.size()) +
                     " combinations, and at most 3^" + std::to_string(most_contacts) +
                     " are tried"};
  }
  States states(problem.size(), SpringState::kStick);
  NoSpringStates none;
  do {
    if (std::optional<Witness> springs = solve_states(problem, states)) {
      return SpringStates{std::move(states), std::move(*springs)};
    }
    ++none.combinations;
  } while (advance(states));
  return none;
}

}  // namespace stickslip
