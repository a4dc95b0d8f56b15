// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibria_by_states.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "engine/motion/dense.hpp"

namespace stickslip {
namespace {

constexpr Eigen::Index kMotions = 3;
constexpr double kRoundingError = 1e-9;  // relative to what is typical

/// The sign of the slip of each contact with friction, by contact; 0 sticks.
using State = std::vector<int>;

struct Found {
  NearEquilibrium at;
  bool turns_back;  ///< whether forces turn small motions back
};

/// Returns the states that are consistent with some motion: those around the vertices of the
/// arrangement of the great circles S_i d = 0.
std::set<State> consistent_states(const RoundedGrasp& grasp,
                                  const std::vector<std::size_t>& rubbing) {
  const auto row = [&](std::size_t i) -> Eigen::Vector3d {
    return grasp.contacts[i].slip.row(0).transpose();
  };
  std::set<State> states;
  for (const std::size_t i : rubbing) {
    for (const std::size_t j : rubbing) {
      if (j == i) break;
      const Eigen::Vector3d vertex = row(i).cross(row(j));
      for (const int side : {1, -1}) {
        State state(grasp.contacts.size(), 0);
        for (const std::size_t k : rubbing) state[k] = side * vertex.dot(row(k)) < 0 ? -1 : 1;
        for (const int slip_i : {0, 1, -1}) {
          for (const int slip_j : {0, 1, -1}) {
            state[i] = slip_i;
            state[j] = slip_j;
            states.insert(state);
          }
        }
      }
    }
  }
  return states;
}

/// Solves for the motion and the friction of contacts that stick, while these contacts act.
class StateEquations {
 public:
  StateEquations(const RoundedGrasp& grasp, const State& state,
                 const std::vector<std::size_t>& sticking, const std::vector<char>& acts) {
    const Eigen::Index count = kMotions + static_cast<Eigen::Index>(sticking.size());
    matrix_.setZero(count, count);
    right_.setZero(count);
    right_.head(kMotions) = -grasp.load;
    for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
      if (acts[i] == 0) continue;
      const RoundedContact& c = grasp.contacts[i];
      Reals wrench = c.normal;
      if (state[i] != 0) wrench -= state[i] * c.slope * c.slip.row(0).transpose();
      right_.head(kMotions) -= c.preload * wrench;
      matrix_.topLeftCorner(kMotions, kMotions) -= c.stiffness * wrench * c.normal.transpose();
    }
    for (Eigen::Index k = kMotions; k < count; ++k) {
      const auto& slip = grasp.contacts[sticking[static_cast<std::size_t>(k - kMotions)]].slip;
      matrix_.col(k).head(kMotions) = slip.transpose();
      matrix_.row(k).head(kMotions) = slip;
    }
  }

  /// Returns the unknowns, or nothing if the equations do not determine them.
  std::optional<Eigen::VectorXd> unknowns() const {
    Eigen::VectorXd x = solution(matrix_, right_);
    const double off = (matrix_ * x - right_).norm();
    if (!(off <= kRoundingError * right_.norm())) return std::nullopt;  // or no number
    return x;
  }
  /// Returns whether forces turn back what moves a little, as springs do: this sign does not
  /// change where a contact begins to slip, but where two equilibria meet.
  bool turn_back() const { return determinant(matrix_) < 0; }

 private:
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd right_;
};

/// Returns whether this is an equilibrium of the state: slips are as it says, and contacts that
/// stick press enough.
bool is_lawful(const NearEquilibrium& at, const State& state, const RoundedGrasp& grasp) {
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const RoundedContact& c = grasp.contacts[i];
    if (at.sticks[i] != 0) {
      const double most = c.slope * at.normal[i];
      if (std::fabs(at.friction[i][0]) > most + kRoundingError * grasp.force) return false;
    } else if (state[i] != 0 && at.normal[i] > 0) {
      const double slip = c.slip.row(0).dot(at.motion);
      if (state[i] * slip < -kRoundingError * grasp.reach) return false;
    }
  }
  return true;
}

/// Returns an equilibrium in this state, if there is one where Newton's method ends that begins
/// with all contacts pressing.
std::optional<Found> equilibrium_in(const State& state, const RoundedGrasp& grasp,
                                    const std::vector<std::size_t>& rubbing) {
  const std::size_t m = grasp.contacts.size();
  std::vector<std::size_t> sticking;
  for (const std::size_t i : rubbing) {
    if (state[i] == 0) sticking.push_back(i);
  }
  std::vector<char> acts(m, 1);
  constexpr int kSteps = 10;
  for (int step = 0; step < kSteps; ++step) {
    const StateEquations equations(grasp, state, sticking, acts);
    const auto x = equations.unknowns();
    if (!x) return std::nullopt;
    NearEquilibrium at{x->head(kMotions), {}, {}, std::vector<char>(m, 0)};
    const std::vector<char> acted = acts;
    for (std::size_t i = 0; i < m; ++i) {
      const RoundedContact& c = grasp.contacts[i];
      acts[i] = c.acts(c.separation(at.motion)) ? 1 : 0;
      at.normal.push_back(c.force(at.motion));
      at.friction.push_back({-state[i] * c.slope * at.normal[i], 0, 0});
    }
    if (acts != acted) continue;
    for (std::size_t k = 0; k < sticking.size(); ++k) {
      at.friction[sticking[k]][0] = (*x)[kMotions + static_cast<Eigen::Index>(k)];
      at.sticks[sticking[k]] = 1;
    }
    if (!is_lawful(at, state, grasp)) return std::nullopt;
    return Found{std::move(at), equations.turn_back()};
  }
  return std::nullopt;
}

}  // namespace

std::vector<NearEquilibrium> equilibria_by_states(const RoundedGrasp& grasp) {
  if (grasp.motions() != kMotions) return {};
  std::vector<std::size_t> rubbing;
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const RoundedContact& c = grasp.contacts[i];
    if (c.slip.rows() != 1 || !(c.slope > 0)) continue;
    rubbing.push_back(i);
  }
  if (rubbing.size() > kMostContactsOfStates) return {};
  std::vector<Found> found;
  for (const State& state : consistent_states(grasp, rubbing)) {
    auto one = equilibrium_in(state, grasp, rubbing);
    // (Which way a contact that is open would slip makes no difference.)
    const bool is_new =
        one && std::none_of(found.begin(), found.end(), [&](const Found& other) {
          return (other.at.motion - one->at.motion).norm() <= kRoundingError * grasp.reach;
        });
    if (is_new) found.push_back(std::move(*one));
  }
  std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
    if (a.turns_back != b.turns_back) return a.turns_back;
    return a.at.motion.norm() < b.at.motion.norm();
  });
  std::vector<NearEquilibrium> result;
  for (Found& one : found) result.push_back(std::move(one.at));
  return result;
}

}  // namespace stickslip
