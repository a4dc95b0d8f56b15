// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_balance.hpp"

#include <vector>

#include "engine/large/decide_large.hpp"
#include "stickslip/engine/grasp_law.hpp"
#include "stickslip/lp/exact_system.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::warnings_detail {
namespace {

/// Returns wrenches of which those that the contact can exert are sums with multiples >= 0.
/// Friction is put into a box around it, and so may be more than it is.
std::vector<RationalRow> edges_of(const LawContact& contact) {
  const CornerRow& row = contact.corners.front();
  const std::size_t numbers = contact.directions.front().size();
  if (contact.friction.low.is_zero()) return {row.push_with(RationalRow(numbers))};
  std::vector<RationalRow> corners{RationalRow(numbers)};
  for (const RationalRow& direction : contact.directions) {
    constexpr unsigned kBits = 20;
    const Rational square = contact.friction.low * contact.friction.low *
                            contact.squared_length / contact.squared_force(direction);
    const Rational most = short_sqrt(square, kBits).upper;
    std::vector<RationalRow> farther;
    for (const RationalRow& corner : corners) {
      for (const int sign : {1, -1}) {
        farther.push_back(corner);
        add_multiple(farther.back(), sign * most, direction);
      }
    }
    corners = std::move(farther);
  }
  std::vector<RationalRow> edges;
  for (const RationalRow& corner : corners) edges.push_back(row.push_with(corner));
  return edges;
}

/// Returns a motion y that no wrench opposes, y.g >= 0 for all: a free one, y.g = 0, or else
/// one on which the load does the least negative work, none or some; nothing if there is no
/// free one and every other one has work below -1 over the sum of all y.g.
std::optional<RationalRow> least_opposed(const std::vector<RationalRow>& wrenches,
                                         const RationalRow& load) {
  const std::vector<RationalRow> free = null_space(matrix_of(wrenches, load.size()));
  if (!free.empty()) return free.front();
  // The largest s with sum (s + m_g) g = -load, m >= 0 and s <= 1: y is its dual.
  LinearProgram program;
  program.add_variables(wrenches.size(), VariableKind::kNonNegative);
  const std::size_t s = program.add_variable(VariableKind::kFree);
  for (std::size_t j = 0; j < load.size(); ++j) {
    RationalRow row(s + 1);
    for (std::size_t g = 0; g < wrenches.size(); ++g) {
      row[g] = wrenches[g][j];
      row[s] += wrenches[g][j];
    }
    program.add_row(std::move(row), Relation::kEqual, -load[j]);
  }
  RationalRow only_s(s + 1);
  only_s[s] = 1;
  program.add_row(only_s, Relation::kLessEqual, 1);
  only_s[s] = -1;
  program.minimize(only_s);
  const LpResult result = solve(program);
  const auto* optimal = std::get_if<Optimal>(&result);
  if (optimal == nullptr || optimal->value == -1) return std::nullopt;
  RationalRow y(optimal->dual.begin(), optimal->dual.end() - 1);
  for (Rational& entry : y) entry = -entry;
  return y;
}

}  // namespace

std::optional<std::string> balance_on_an_edge(const AnyGrasp& any) {
  // A crowd of contacts in the plane would take much memory as a box.
  const LoadedGrasp* crowd = any.single();
  if (crowd != nullptr && crowd->grasp.size() > kMostContactsInBalance) return {};
  const GraspBox grasp = any.as_box();
  if (!grasp.springs.empty() || grasp.contacts.size() > kMostContactsInBalance) return {};
  if (is_large(grasp)) return {};
  const GraspLaw law(grasp, NormalLaw::kUnilateral);
  RationalRow load;
  for (const Interval& w : law.wrench) load.push_back(w.low);
  const Rational length = law.short_length();
  const Rational size = law.squared_size(load, length);
  if (size.is_zero()) return {};
  std::vector<RationalRow> wrenches;
  for (const LawContact& contact : law.contacts) {
    for (RationalRow& edge : edges_of(contact)) wrenches.push_back(std::move(edge));
  }
  const auto y = least_opposed(wrenches, load);
  if (!y) return {};
  const Rational work = dot(*y, load);
  const Rational part = work * kRoundingPart;
  if (part * part > size * law.squared_size(*y, 1 / length)) return {};
  std::size_t largest = 0;
  const auto entry = [&](std::size_t j) {
    return law.rotates[j] != 0 ? Rational(abs((*y)[j]) * length) : Rational(abs((*y)[j]));
  };
  for (std::size_t j = 1; j < y->size(); ++j) {
    if (entry(j) > entry(largest)) largest = j;
  }
  constexpr const char* kInPlane[] = {"the force along x", "the force along y", "the torque"};
  constexpr const char* kInSpace[] = {"the force along x",  "the force along y",
                                      "the force along z",  "the torque about x",
                                      "the torque about y", "the torque about z"};
  const std::string name = grasp.mechanism    ? grasp.mechanism->coordinate_name(largest)
                           : grasp.in_space() ? kInSpace[largest]
                                              : kInPlane[largest];
  return "the load is balanced as on an edge: no contact opposes some motion on which it does "
         "no work, so that a load that is off by a billionth, as by " +
         name + ", may not be held";
}

}  // namespace stickslip::warnings_detail
