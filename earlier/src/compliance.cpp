// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/earlier/compliance.hpp"

#include <algorithm>
#include <array>

#include "contact_forces.hpp"
#include "spatial_cells.hpp"
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

/// A spring along a row of motions; `rest` is its force along the row at rest.
struct RowSpring {
  RationalRow row;
  Rational stiffness;
  Rational rest;
};

/// Returns the program K d = w + sum rest r, in the free variables d.
LinearProgram balance(const std::vector<RowSpring>& springs, const RationalRow& load) {
  std::vector<RationalRow> stiffness(load.size(), RationalRow(load.size()));
  RationalRow right = load;
  for (const auto& [row, k, rest] : springs) {
    for (std::size_t i = 0; i < load.size(); ++i) {
      right[i] += rest * row[i];
      if (row[i].is_zero()) continue;
      for (std::size_t j = 0; j < load.size(); ++j) stiffness[i][j] += k * row[i] * row[j];
    }
  }
  LinearProgram program;
  program.add_variables(load.size(), VariableKind::kFree);
  for (std::size_t j = 0; j < load.size(); ++j) {
    program.add_row(std::move(stiffness[j]), Relation::kEqual, std::move(right[j]));
  }
  return program;
}

/// Returns a motion y that stretches no spring, along which the load does work. It is the
/// multipliers of an infeasible balance. K y = 0 proves it, since y.K y = sum k (r.y)^2.
UnresistedMotion unresisted(const std::vector<RowSpring>& springs, const RationalRow& load,
                            const RationalRow& multipliers) {
  require(!dot(load, multipliers).is_zero(), "the load does no work");
  for (const RowSpring& spring : springs) {
    require(dot(spring.row, multipliers).is_zero(), "a spring resists the motion");
  }
  return {primitive_multiple(multipliers)};
}

std::vector<RowSpring> springs_of(const Problem& problem, const States& states) {
  std::vector<RowSpring> springs;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    if (states[i] == SpringState::kDetached) continue;
    const ContactRow& row = problem.rows()[i];
    springs.push_back({row_of(row.normal), row.stiffness, row.preload});
    if (states[i] == SpringState::kStick) {
      springs.push_back({row_of(row.tangent), row.stiffness, 0});
    }
  }
  return springs;
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

/// Adds the conditions that v = P - k N.d and the tangential force allow the contact's state.
void add_conditions(const ContactRow& row, SpringState state, LinearProgram& program) {
  // The row is -k N.d >= -P, or <= for a released spring.
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
  LinearProgram program = balance(springs_of(problem, states), row_of(problem.wrench()));
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

/// Goes to the next combination, the last contact varying fastest. Returns false after the last
/// one.
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

/// Returns the springs of contacts in space along x, y and z.
std::vector<RowSpring> springs_of(const GraspBox& grasp,
                                  const std::vector<FrictionDisc>& discs) {
  std::vector<RowSpring> springs;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const UncertainContact& c = grasp.contacts[i];
    const Rational preload = preload_over_length(c, i);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Vector3 unit{};
      unit[axis] = 1;
      const Vector6 row = discs[i].wrench(unit);
      springs.push_back({{row.begin(), row.end()}, c.stiffness.low, preload * c.normal[axis]});
    }
  }
  return springs;
}

/// Returns how far a force is outside of its cone, if it is; pulling counts more than any
/// friction.
std::optional<std::pair<bool, Rational>> outside(const FrictionDisc& disc,
                                                 const Vector3& force) {
  const Vector3& n = disc.normal();
  const Rational a = dot(force, n) / dot(n, n);
  const Vector3 friction = plus(force, -a, n);
  const Rational square = dot(friction, friction);
  const Rational most = disc.square() * a * a;
  if (a.sign() < 0) return std::pair(true, Rational(a * a * dot(n, n)));
  if (square <= most) return std::nullopt;
  if (most.is_zero()) return std::pair(true, square);
  return std::pair(false, Rational(square / most));
}

}  // namespace

std::variant<SpringBalance, UnresistedMotion> linear_compliance(const Problem& problem) {
  const States all_stick(problem.size(), SpringState::kStick);
  const std::vector<RowSpring> springs = springs_of(problem, all_stick);
  const RationalRow load = row_of(problem.wrench());
  const LpResult result = solve(balance(springs, load));
  if (const auto* infeasible = std::get_if<Infeasible>(&result)) {
    return unresisted(springs, load, infeasible->farkas);
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

std::variant<SpatialSpringBalance, UnresistedMotion> linear_compliance(const GraspBox& grasp) {
  const std::vector<FrictionDisc> discs = discs_of(grasp);
  const Vector6 w = load_of(grasp);
  const RationalRow load(w.begin(), w.end());
  const std::vector<RowSpring> springs = springs_of(grasp, discs);
  const LpResult result = solve(balance(springs, load));
  if (const auto* infeasible = std::get_if<Infeasible>(&result)) {
    return unresisted(springs, load, infeasible->farkas);
  }
  SpatialSpringBalance found{std::get<Optimal>(result).point, {}, {}};
  Vector6 sum = w;
  std::pair<bool, Rational> furthest{false, 0};
  for (std::size_t i = 0; i < discs.size(); ++i) {
    Vector3& force = found.forces.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& [row, k, rest] = springs[3 * i + axis];
      force[axis] = rest - k * dot(row, found.motion);
    }
    sum = plus(sum, 1, discs[i].wrench(force));
    const auto off = outside(discs[i], force);
    if (off && *off > furthest) {
      furthest = *off;
      found.outside = ContactId(i);
    }
  }
  require(sum == Vector6{}, "springs do not balance the load");
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
