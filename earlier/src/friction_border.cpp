// SPDX-License-Identifier: GPL-3.0-or-later
#include "friction_border.hpp"

#include <algorithm>

#include "contact_forces.hpp"
#include "stickslip/core/box.hpp"
#include "stickslip/earlier/load_classes.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::earlier_detail {

Problem with_friction_times(const Problem& problem, const Rational& s) {
  std::vector<ContactRow> rows = problem.rows();
  for (ContactRow& row : rows) row.friction *= s;
  return Problem(std::move(rows), problem.wrench(), problem.law());
}

namespace {

/// A factor of friction; nothing means infinite friction.
using Factor = std::optional<Rational>;

/// Returns the least factor at which a contact force opposes the twist that none opposed
/// before.
Factor opposed_from(const Problem& problem, const Twist& y) {
  Factor least;
  for (const ContactRow& row : problem.rows()) {
    const Rational slip = row.friction * abs(power(row.tangent, y));
    if (slip.is_zero()) continue;
    const Rational from = power(row.normal, y) / slip;
    if (!least || from < *least) least = from;
  }
  return least;
}

/// Returns the least factor whose cones the forces are in.
Rational used_by(const Problem& problem, const std::vector<ContactForce>& forces) {
  Rational most = 0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (forces[i].tangential.is_zero()) continue;
    most = std::max(most, Rational(abs(forces[i].tangential) /
                                   (problem.rows()[i].friction * forces[i].normal)));
  }
  return most;
}

/// Adds N.y >= s mu |T.y| to a program whose first three variables are y.
void add_unopposed(LinearProgram& program, const ContactRow& row, const Factor& s) {
  for (const int side : {1, -1}) {
    const Wrench edge =
        s ? row.normal + Rational(side * *s * row.friction) * row.tangent : row.normal;
    program.add_row(row_of(edge), Relation::kGreaterEqual, 0);
  }
  if (!s && !row.friction.is_zero()) program.add_row(row_of(row.tangent), Relation::kEqual, 0);
}

/// Makes as many as possible of the sums of some variables positive, in a program whose points
/// are a cone, and says which. Nothing if the program has no point.
std::optional<std::vector<bool>> positive(LinearProgram program,
                                          const std::vector<std::vector<Rational>>& sums) {
  const std::size_t first = program.add_variables(sums.size(), VariableKind::kNonNegative);
  std::vector<Rational> objective(first + sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    std::vector<Rational> unit(first + i + 1);
    unit.back() = 1;
    program.add_row(unit, Relation::kLessEqual, 1);
    std::vector<Rational> row = sums[i];
    row.resize(first + i + 1);
    row.back() = -1;
    program.add_row(std::move(row), Relation::kGreaterEqual, 0);
    objective[first + i] = -1;
  }
  program.minimize(std::move(objective));
  const LpResult result = solve(program);
  const auto* optimal = std::get_if<Optimal>(&result);
  if (optimal == nullptr) return std::nullopt;
  std::vector<bool> found;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    found.push_back(optimal->point[first + i].sign() > 0);
  }
  return found;
}

bool is_feasible(const LinearProgram& program) {
  return !std::holds_alternative<Infeasible>(solve(program));
}

/// Returns true if no factor below r balances the load. This is so if some y with w.y >= 0 is
/// unopposed at r, and some d with w.d > 0 is unopposed at those contacts that have N.y = 0:
/// below r the other contacts leave y + e d room for some e > 0.
bool all_below_move(const Problem& problem, const Factor& r) {
  LinearProgram program;
  program.add_variables(3, VariableKind::kFree);
  program.add_row(row_of(problem.wrench()), Relation::kGreaterEqual, 0);
  std::vector<std::vector<Rational>> apart;
  for (const ContactRow& row : problem.rows()) {
    add_unopposed(program, row, r);
    apart.push_back(row_of(row.normal));
  }
  const auto parts = positive(program, apart);
  if (!parts) return false;
  LinearProgram second;
  second.add_variables(3, VariableKind::kFree);
  second.add_row(row_of(problem.wrench()), Relation::kEqual, 1);
  for (std::size_t i = 0; i < problem.size(); ++i) {
    if (!(*parts)[i]) add_unopposed(second, problem.rows()[i], r);
  }
  return is_feasible(second);
}

/// Returns true if all factors above r balance the load. This is so if some forces in the cones
/// of r balance one another, and others balance the load that are in these cones at contacts
/// where the first press nothing: above r enough of the first makes room for the second.
bool all_above_rest(const Problem& problem, const Rational& r) {
  const Problem at = with_friction_times(problem, r);
  const std::size_t m = problem.size();
  std::array<std::vector<Rational>, 3> columns;
  std::vector<std::vector<Rational>> pressed(m, std::vector<Rational>(2 * m));
  LinearProgram program;
  program.add_variables(2 * m, VariableKind::kNonNegative);
  for (std::size_t i = 0; i < m; ++i) {
    pressed[i][2 * i] = pressed[i][2 * i + 1] = 1;
    for (const int side : {1, -1}) {
      const Vector3 edge = coordinates(at.edge_wrench(ContactId(i), side));
      for (std::size_t j = 0; j < 3; ++j) columns[j].push_back(edge[j]);
    }
  }
  for (std::size_t j = 0; j < 3; ++j) program.add_row(columns[j], Relation::kEqual, 0);
  const auto presses = positive(program, pressed);
  if (!presses) return false;
  LinearProgram second;
  std::array<std::vector<Rational>, 3> balance;
  const auto add = [&](VariableKind kind, const Wrench& wrench) {
    second.add_variable(kind);
    for (std::size_t j = 0; j < 3; ++j) balance[j].push_back(coordinates(wrench)[j]);
  };
  for (std::size_t i = 0; i < m; ++i) {
    const ContactRow& row = problem.rows()[i];
    if ((*presses)[i] && !row.friction.is_zero()) {
      add(VariableKind::kFree, row.normal);
      add(VariableKind::kFree, row.tangent);
    } else {
      for (const int side : {1, -1}) {
        add(VariableKind::kNonNegative, at.edge_wrench(ContactId(i), side));
      }
    }
  }
  for (std::size_t j = 0; j < 3; ++j) {
    second.add_row(balance[j], Relation::kEqual, -coordinates(problem.wrench())[j]);
  }
  return is_feasible(second);
}

Integer whole_part(const Rational& value) {
  return numerator(value) / denominator(value);
}

/// Returns the fraction of the least denominator in low < x < high, 0 <= low.
Rational simplest_between(const Rational& low, const Rational& high) {
  const Rational whole = whole_part(low);
  if (whole + 1 < high) return whole + 1;
  const Rational inverse = 1 / (high - whole);
  const Rational rest = low - whole;
  if (rest.is_zero()) return whole + Rational(1) / (whole_part(inverse) + 1);
  return whole + 1 / simplest_between(inverse, 1 / rest);
}

}  // namespace

FrictionBorder friction_border(const Problem& problem) {
  FrictionBorder border;
  Rational low = 0;
  std::optional<Rational> high;
  // Moves `low` up or `high` down to the factor, or beyond.
  const auto ask = [&](const Rational& s) {
    const LoadClass found = weakly_stable_load(with_friction_times(problem, s));
    if (const auto* forces = std::get_if<RigidForces>(&found)) {
      high = std::min(s, used_by(problem, planar_forces(*forces)));
      return true;
    }
    const Factor until =
        opposed_from(problem, planar_motion(std::get<UnopposedMotion>(found).twist));
    if (!until) border.always_moves = true;
    low = std::max(s, until.value_or(s));
    return !until.has_value();
  };
  if (ask(0)) {
    if (!border.always_moves) border.rests = 0, border.rests_at = true;
    return border;
  }
  const Rational largest = 1 << 20;
  for (Rational s = 1; !high && s <= largest; s *= 2) {
    if (s > low && ask(s) && border.always_moves) return border;
  }
  border.moves = low;
  border.moves_at = true;
  if (!high) {
    border.always_moves = all_below_move(problem, std::nullopt);
    return border;
  }
  for (int round = 0;; ++round) {
    const bool opens = all_above_rest(problem, low);
    const bool closes = !opens && all_below_move(problem, *high);
    border.moves = closes ? *high : low;
    border.moves_at = !closes;
    border.rests = opens ? low : *high;
    border.rests_at = !opens;
    if (opens || closes || (*high - low) * (1 << 20) <= *high) return border;
    ask(round % 2 == 0 ? simplest_between(low, *high) : Rational((low + *high) / 2));
  }
}

}  // namespace stickslip::earlier_detail
