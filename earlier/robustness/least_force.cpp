// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "earlier/robustness/robustness_search.hpp"
#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/earlier/force_measures.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip {

using namespace robustness_detail;

namespace {

constexpr int kMostRounds = 24;
constexpr std::size_t kMostDirections = 48;
/// The search ends where the bounds differ by no more than this part.
constexpr long kInverseAccuracy = 1000000;

/// Seeks the least forces with more and more directions of friction.
class LeastForceSearch {
 public:
  LeastForceSearch(const ForceModel& model, ForceBound bound)
      : model_(model), bound_(bound), directions_(model, kMostDirections) {}

  LeastForce run() {
    for (int round = 0; round < kMostRounds; ++round) {
      throw_if_cancelled();
      const RationalRow twist = solve_program();
      if (!take(twist) || are_near() || !add_directions(twist)) break;
    }
    return std::move(result_);
  }

 private:
  /// A force of normal part 1.
  struct Share {
    std::size_t contact;
    RationalRow force;  ///< the normal force and the tangential ones
  };

  /// Solves the program of the present directions, and keeps better forces. Returns the twist
  /// that shows its bound, or that it has no solution.
  RationalRow solve_program() {
    const bool is_sum = bound_ == ForceBound::kL1;
    const std::size_t size = model_.coordinates;
    const std::size_t first = is_sum ? 0 : 1;  // of the shares; the largest force is before
    std::vector<Share> shares;
    std::vector<RationalRow> balance(size, RationalRow(first));
    std::vector<RationalRow> limits;
    for (std::size_t i = 0; i < model_.contacts.size(); ++i) {
      const ForceContact& contact = model_.contacts[i];
      RationalRow& limit = limits.emplace_back(first + shares.size());
      if (!is_sum) limit[0] = -1;
      const std::size_t count = contact.can_stick() ? directions_.of(i).size() : 1;
      for (std::size_t k = 0; k < count; ++k) {
        RationalRow force(1 + contact.tangents.size());
        force[0] = 1;
        RationalRow column = contact.normal.row();
        for (std::size_t t = 0; t < contact.tangents.size() && contact.can_stick(); ++t) {
          force[1 + t] = contact.friction * directions_.of(i)[k].along[t];
          add_multiple(column, force[1 + t], contact.tangents[t].row());
        }
        for (std::size_t j = 0; j < size; ++j) balance[j].push_back(column[j]);
        limit.emplace_back(1);
        shares.push_back({i, std::move(force)});
      }
    }
    LinearProgram program;
    program.add_variables(first + shares.size(), VariableKind::kNonNegative);
    program.minimize(is_sum ? RationalRow(shares.size(), 1) : RationalRow{1});
    for (std::size_t j = 0; j < size; ++j) {
      program.add_row(balance[j], Relation::kEqual, -model_.load[j]);
    }
    if (!is_sum) {
      for (const RationalRow& limit : limits) program.add_row(limit, Relation::kLessEqual, 0);
    }
    const LpResult solved = solve(program);
    const auto* best = std::get_if<Optimal>(&solved);
    const auto* none = std::get_if<Infeasible>(&solved);
    require(best != nullptr || none != nullptr, "forces have no value below 0");
    RationalRow twist;
    for (std::size_t j = 0; j < size; ++j) {
      twist.push_back(best != nullptr ? -best->dual[j] : -none->farkas[j]);
    }
    if (best == nullptr || (result_.upper && best->value >= *result_.upper)) return twist;
    result_.upper = best->value;
    result_.forces.clear();
    for (const ForceContact& contact : model_.contacts) {
      result_.forces.emplace_back(contact.n.size());
    }
    for (std::size_t k = 0; k < shares.size(); ++k) {
      const auto& [i, force] = shares[k];
      const Rational& much = best->point[first + k];
      add_multiple(result_.forces[i], much * force[0], model_.contacts[i].n);
      for (std::size_t t = 0; t < model_.contacts[i].t.size(); ++t) {
        add_multiple(result_.forces[i], much * force[1 + t], model_.contacts[i].t[t]);
      }
    }
    return twist;
  }

  /// Raises the lower bound by a twist. Returns false if it shows that no forces balance.
  bool take(const RationalRow& twist) {
    const Rational work = dot(twist, model_.load);
    if (work.sign() <= 0) return true;
    Rational against = 0;
    for (const ForceContact& contact : model_.contacts) {
      RationalRow across;
      for (const ScaledRow& t : contact.tangents) across.push_back(dot(twist, t.row()));
      const Rational here = most_against(contact, dot(twist, contact.normal.row()), across);
      against = bound_ == ForceBound::kL1 ? std::max(against, here) : Rational(against + here);
    }
    if (against.is_zero()) {
      require(!result_.upper, "forces that a twist refutes");
      result_.balances = false;
      result_.twist = twist;
      return false;
    }
    const Rational least = work / against;
    if (least <= result_.lower) return true;
    result_.lower = least;
    result_.twist = twist;
    return true;
  }

  bool are_near() const {
    if (!result_.upper) return false;
    const Rational apart = *result_.upper - result_.lower;
    require(apart.sign() >= 0, "the bounds of the least forces contradict each other");
    return apart * Rational(kInverseAccuracy) <= result_.lower;
  }

  bool add_directions(const RationalRow& twist) {
    bool is_new = false;
    for (std::size_t i = 0; i < model_.contacts.size(); ++i) {
      if (!model_.contacts[i].can_stick()) continue;
      is_new = directions_.add_against(i, doubles_of(twist)) || is_new;
    }
    return is_new;
  }

  const ForceModel& model_;
  ForceBound bound_;
  Directions directions_;
  LeastForce result_;
};

}  // namespace

LeastForce least_force(const GraspBox& grasp, ForceBound bound, std::size_t edges) {
  RobustnessOptions options;
  options.edges = edges;
  const ForceModel model(grasp, options);
  return LeastForceSearch(model, bound).run();
}

InternalMargin internal_margin(const GraspBox& grasp, const RobustnessOptions& options) {
  const ForceModel model(grasp, options);
  BestDistance found = best_distance(model, first_combination(model));
  InternalMargin result;
  result.balances = found.most.sign() >= 0;
  result.twist = std::move(found.twist);
  if (!result.balances) return result;
  result.upper = std::move(found.most);
  if (found.forces.distance.sign() < 0) return result;
  result.lower = found.forces.distance;
  result.forces = forces_on_object(model, found.forces);
  return result;
}

}  // namespace stickslip
