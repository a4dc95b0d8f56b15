// SPDX-License-Identifier: GPL-3.0-or-later
#include "witness_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

#include "engine/equilibrium/long_rationals.hpp"
#include "engine/motion/dense.hpp"
#include "few_shares.hpp"
#include "smooth_balance.hpp"
#include "stickslip/engine/newton_equilibria.hpp"
#include "stickslip/lp/exact_system.hpp"

namespace stickslip {

namespace {

/// Returns whether a contact sticks with all the friction there can be: that is known, and so
/// is its slip.
bool rests_on_edge(const ModeGuess& guess) {
  return guess.closed && guess.sticks && guess.keeps_share && abs(guess.share) == 1;
}

/// Balance and no slip at the sticking contacts as linear equations, with the shares of
/// friction as guessed but at a few *basic* contacts. The unknowns are d, then the friction b
/// of these.
class ModeSystem {
 public:
  /// `keeps_shares` gives all but the basic contacts the friction guessed. Otherwise those that
  /// stick have none: the basic ones, whose T span its T, can do what it could.
  ModeSystem(const Problem& problem, const std::vector<ModeGuess>& guesses, bool keeps_shares)
      : problem_(problem), guesses_(guesses), shares_(guesses.size()) {
    choose_basic();
    for (std::size_t i = 0; i < guesses.size(); ++i) {
      if (guesses[i].closed && !is_basic(i) && (keeps_shares || !guesses[i].sticks)) {
        shares_[i] = guesses[i].share;
      }
    }
  }

  /// Returns whether nothing moves: then alone three independent slips are 0.
  bool is_at_rest() const { return basic_.size() == 3; }
  /// Returns whether all contacts that stick and can have friction are basic.
  bool all_are_basic() const { return all_are_basic_; }

  /// Returns the solution; nothing if there is none, or several. With `near` several will do:
  /// what they leave open stays as it is there.
  std::optional<Witness> solve(const Witness* near) const {
    auto [a, b] = equations();
    RationalRow start(a.columns());
    if (near != nullptr) {
      for (std::size_t j = 0; j < 3; ++j) start[j] = coordinates(near->twist)[j];
      for (std::size_t k = 0; k < basic_.size(); ++k) {
        start[column(k)] = near->forces[basic_[k]].tangential;
      }
      add_multiple(b, -1, a * start);
    }
    const std::optional<RationalRow> change = solve_exactly(a, b, near == nullptr);
    if (!change) return std::nullopt;
    add_multiple(start, 1, *change);
    return witness_at(start);
  }

 private:
  static std::size_t column(std::size_t k) { return 3 + k; }
  bool is_basic(std::size_t i) const {
    return std::find(basic_.begin(), basic_.end(), i) != basic_.end();
  }

  /// Chooses at most three sticking contacts with linearly independent T, those with the most
  /// room in the friction cone first.
  void choose_basic() {
    std::vector<std::pair<double, std::size_t>> candidates;
    for (std::size_t i = 0; i < guesses_.size(); ++i) {
      // Friction at an open or frictionless contact is 0 and cannot be an unknown.
      if (guesses_[i].sticks && guesses_[i].closed && !rests_on_edge(guesses_[i]) &&
          !problem_.rows()[i].friction.is_zero()) {
        candidates.emplace_back(std::fabs(to_double(guesses_[i].share)), i);
      }
    }
    std::sort(candidates.begin(), candidates.end());
    std::vector<Vector3> tangents;
    for (const auto& [share, i] : candidates) {
      const Vector3 t = coordinates(problem_.rows()[i].tangent);
      const Vector3 zero{};
      if (tangents.empty()       ? t == zero
          : tangents.size() == 1 ? cross(tangents[0], t) == zero
                                 : dot(cross(tangents[0], tangents[1]), t).is_zero()) {
        all_are_basic_ = false;
        continue;
      }
      tangents.push_back(t);
      basic_.push_back(i);
      if (basic_.size() == 3) break;
    }
  }

  /// Returns the equations: balance, no slip at the basic contacts, and what keeps others on
  /// the border of their mode.
  std::pair<RationalMatrix, RationalRow> equations() const {
    std::vector<std::size_t> on_border;
    for (std::size_t i = 0; i < guesses_.size(); ++i) {
      if (rests_on_edge(guesses_[i]) || guesses_[i].touches) on_border.push_back(i);
    }
    const std::size_t n = column(basic_.size());
    RationalMatrix a(n + on_border.size(), n);
    RationalRow b(n + on_border.size());
    add_balance(a, b);
    for (std::size_t k = 0; k < basic_.size(); ++k) {
      const Vector3 t = coordinates(problem_.rows()[basic_[k]].tangent);
      for (std::size_t j = 0; j < 3; ++j) a(j, column(k)) = a(column(k), j) = t[j];
    }
    std::size_t row = n;
    for (const std::size_t i : on_border) {
      const Vector3 t = coordinates(problem_.rows()[i].tangent);
      const Vector5& v = problem_.separation(ContactId(i));
      for (std::size_t j = 0; j < 3; ++j) a(row, j) = guesses_[i].touches ? v[j] : t[j];
      if (guesses_[i].touches) b[row] = -v[3];
      ++row;
    }
    return {std::move(a), std::move(b)};
  }

  /// Fills the first three rows: the load, and of each closed contact (N + share mu T) (x) v.
  void add_balance(RationalMatrix& a, RationalRow& b) const {
    std::array<std::array<std::vector<Rational>, 4>, 3> terms;
    for (std::size_t i = 0; i < guesses_.size(); ++i) {
      if (!guesses_[i].closed) continue;
      const ContactRow& row = problem_.rows()[i];
      const Vector3 wrench =
          coordinates(row.normal + (shares_[i] * row.friction) * row.tangent);
      const Vector5& v = problem_.separation(ContactId(i));
      for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 4; ++c) terms[r][c].push_back(wrench[r] * v[c]);
      }
    }
    const Vector3 load = coordinates(problem_.wrench());
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) a(r, c) = sum_in_pairs(std::move(terms[r][c]));
      b[r] = -load[r] - sum_in_pairs(std::move(terms[r][3]));
    }
  }

  Witness witness_at(const RationalRow& x) const {
    Witness witness{{x[0], x[1], x[2]}, {}};
    const ScaledTwist scaled(witness.twist);
    for (std::size_t i = 0; i < guesses_.size(); ++i) {
      const ContactRow& row = problem_.rows()[i];
      ContactForce force{0, 0};
      if (guesses_[i].closed) {
        force.normal = scaled.normal_coefficient(row) / scaled.scale;
        force.tangential = shares_[i] * row.friction * force.normal;
      }
      witness.forces.push_back(std::move(force));
    }
    for (std::size_t k = 0; k < basic_.size(); ++k) {
      witness.forces[basic_[k]].tangential = x[column(k)];
    }
    return witness;
  }

  const Problem& problem_;
  const std::vector<ModeGuess>& guesses_;
  std::vector<std::size_t> basic_;
  bool all_are_basic_ = true;  ///< not set at rest, where it does not matter
  std::vector<Rational> shares_;
};

}  // namespace

/// The steps are fine enough that the errors of many contacts together leave room at the basic
/// ones.
Rational rounded_share(double share) {
  constexpr double kSteps = 4294967296.0;
  const double clamped = std::clamp(share, -1.0, 1.0);
  return Rational(std::lround(clamped * kSteps), static_cast<long>(kSteps));
}

std::optional<Witness> complete_exactly(const Problem& problem,
                                        const std::vector<ModeGuess>& guesses,
                                        const Witness* near) {
  const ModeSystem system(problem, guesses, near != nullptr);
  std::optional<Witness> witness;
  if (near == nullptr && system.is_at_rest()) {
    witness = find_forces(problem, {});
  } else {
    witness = system.solve(near);
    // The motion does not depend on the friction of the sticking contacts that are not basic.
    if (near == nullptr && witness && !system.all_are_basic()) {
      witness = find_forces(problem, witness->twist);
    }
  }
  if (witness && find_violation(problem, *witness)) return std::nullopt;
  return witness;
}

namespace {

constexpr double kConverged = 1e-13;  // relative to the force

/// Applies Newton's method until nothing is left that can be told.
double settle(const SmoothBalance& balance, const DoubleModel& model, Eigen::Vector3d& d,
              int steps) {
  return balance.solve(d, steps, kConverged * model.force);
}

std::vector<ModeGuess> guesses(const SmoothBalance& balance, const DoubleModel& model,
                               const Eigen::Vector3d& d) {
  std::vector<ModeGuess> result;
  result.reserve(model.contacts.size());
  const Double5 x = balance.point(d);
  for (const ContactDoubles& c : model.contacts) {
    const double slip = dot(c.slip, x);
    result.push_back({dot(c.separation, x) > 0, std::fabs(slip) < balance.epsilon(),
                      rounded_share(balance.friction_ratio(slip))});
  }
  return result;
}

/// Returns whether contacts open at d and must not: SmoothBalance lets them, and to find that
/// out exactly may take minutes.
bool opens_unlawfully(const Problem& problem, const SmoothBalance& balance,
                      const Eigen::Vector3d& d) {
  return problem.law() == NormalLaw::kBilateral && balance.opens(d);
}

/// Returns an equilibrium in the mode at d.
std::optional<Witness> complete(const Problem& problem, const SmoothBalance& balance,
                                const DoubleModel& model, const Eigen::Vector3d& d) {
  if (opens_unlawfully(problem, balance, d)) return std::nullopt;
  return complete_exactly(problem, guesses(balance, model, d));
}

NearEquilibrium near(const SmoothBalance& balance, const DoubleModel& model,
                     const Eigen::Vector3d& d, double length) {
  NearEquilibrium result{Eigen::Vector3d(d[0], d[1], d[2] * length), {}, {}, {}};
  const Double5 x = balance.point(d);
  for (const ContactDoubles& c : model.contacts) {
    const double normal = std::max(0.0, dot(c.separation, x));
    const double slip = dot(c.slip, x);
    // The length of N is the translation's alone, and so is that of T.
    const double size = std::hypot(c.normal[0], c.normal[1]);
    const double most = normal * std::hypot(c.friction[0], c.friction[1]) / size;
    const bool rubs = normal > 0 && !c.frictionless;
    result.normal.push_back(normal);
    result.friction.push_back({balance.friction_ratio(slip) * most, 0, 0});
    result.sticks.push_back(rubs && std::fabs(slip) < balance.epsilon() ? 1 : 0);
  }
  return result;
}

/// Returns a balance that is found from rest, with friction as little smooth as it was found.
/// Epsilon falls from the size of all motion to nothing, in shorter steps where it goes too
/// fast; the last one that balanced stays set. `last_move` gets the last change. Returns
/// nothing if no balance was found, or nothing resists.
std::optional<Eigen::Vector3d> relax_from_rest(const DoubleModel& model, SmoothBalance& balance,
                                               Eigen::Vector3d& last_move) {
  if (!(model.stiffness > 0)) return std::nullopt;
  constexpr int kStages = 20;  // 14, and some shorter steps
  constexpr int kSteps = 12;
  constexpr double kFinest = 5e-14;
  constexpr double kShortest = 0.75;  // after 0.1 and three square roots
  const double coarsest =
      model.force / model.stiffness * static_cast<double>(model.contacts.size());
  Eigen::Vector3d d = Eigen::Vector3d::Zero();
  double balanced = 0;  // the last epsilon with a balance
  double epsilon = coarsest;
  double step = 0.1;
  for (int stage = 0; stage < kStages && epsilon >= kFinest * coarsest; ++stage) {
    balance.set_epsilon(epsilon);
    Eigen::Vector3d next = d;
    constexpr double kBalanced = 1e-6;
    if (settle(balance, model, next, kSteps) <= kBalanced * model.force) {
      last_move = next - d;
      d = next;
      balanced = epsilon;
    } else if (balanced == 0) {
      d = next;  // the first stages may only come near
    } else {
      step = std::sqrt(step);
      if (step > kShortest) break;
    }
    epsilon = (balanced > 0 ? balanced : epsilon) * step;
  }
  if (!(balanced > 0)) return std::nullopt;
  balance.set_epsilon(balanced);
  return d;
}

/// Returns the same from contacts that press much harder (`squeezed`), or from where springs
/// would give, so that the contacts that will press are closed; pressure and epsilon then fall.
/// Returns nothing if it does not balance in the end.
std::optional<Eigen::Vector3d> relax_from_squeeze(const DoubleModel& model,
                                                  SmoothBalance& balance, bool squeezed) {
  if (!(model.stiffness > 0)) return std::nullopt;
  Eigen::Vector3d d = Eigen::Vector3d::Zero();
  constexpr int kSteps = 12;
  const double travel =
      model.force / model.stiffness * static_cast<double>(model.contacts.size());
  balance.set_epsilon(1e-2 * travel);
  if (squeezed) {
    for (double squeeze = 4 * model.force; squeeze > 1e-6 * model.force; squeeze *= 0.5) {
      balance.set_squeeze(squeeze);
      settle(balance, model, d, kSteps);
    }
    balance.set_squeeze(0);
  } else {
    d = least_squares(spring_stiffness(model), Eigen::Vector3d(model.load.data()));
    if (!d.allFinite()) return std::nullopt;
    for (double shrink = 1e4; shrink > 1e-2; shrink *= 0.3) {
      balance.set_epsilon(shrink * travel);
      settle(balance, model, d, kSteps);
    }
  }
  double size = HUGE_VAL;
  for (double shrink = 1e-2; shrink > 1e-13; shrink *= 0.1) {
    balance.set_epsilon(shrink * travel);
    Eigen::Vector3d next = d;
    const double there = settle(balance, model, next, kSteps);
    if (!(there <= 1e-9 * model.force) && size <= 1e-9 * model.force) {
      balance.set_epsilon(10 * shrink * travel);
      break;
    }
    d = next;
    size = there;
  }
  if (!(size <= 1e-6 * model.force)) return std::nullopt;
  return d;
}

/// Searches from motions at random, always the same; `found` gets those where the method
/// balances.
template <class Found>
void relax_around(const DoubleModel& model, std::size_t starts, SmoothBalance& balance,
                  const Found& found) {
  if (!(model.stiffness > 0)) return;
  const double travel =
      model.force / model.stiffness * static_cast<double>(model.contacts.size());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> within(-1, 1);
  for (std::size_t start = 0; start < starts; ++start) {
    const double reach = travel * std::pow(10.0, 1.5 * within(random));
    Eigen::Vector3d d(reach * within(random), reach * within(random),
                      reach * within(random) / model.length);
    constexpr int kSteps = 30;
    double size = HUGE_VAL;
    for (const double shrink : {1e-1, 1e-3, 1e-5, 1e-7, 1e-9}) {
      balance.set_epsilon(shrink * travel);
      size = settle(balance, model, d, kSteps);
    }
    if (size <= 1e-6 * model.force) found(d);
  }
}

}  // namespace

std::optional<Witness> find_witness_from_rest(const Problem& problem, const DoubleModel& model,
                                              std::optional<MotionBox>& otherwise) {
  if (!(model.stiffness > 0)) return complete_exactly(problem, {});  // nothing resists
  SmoothBalance balance(model);
  Eigen::Vector3d move = Eigen::Vector3d::Zero();
  const std::optional<Eigen::Vector3d> d = relax_from_rest(model, balance, move);
  if (!d || opens_unlawfully(problem, balance, *d)) return std::nullopt;
  if (auto witness = complete_exactly(problem, guesses(balance, model, *d))) return witness;
  // The reach is farther than the last step, as the next ones, which did not balance, would
  // have gone on.
  constexpr double kFarther = 16;
  move[2] *= model.length;
  const double reach = kFarther * move.norm();
  const double turn = reach / model.length;
  if (std::isfinite(reach) && std::isfinite(turn)) {
    otherwise = MotionBox{{(*d)[0], (*d)[1], (*d)[2]}, {reach, reach, turn}};
  }
  return std::nullopt;
}

std::optional<Witness> find_witness_near(const Problem& problem, const DoubleModel& model,
                                         Double3 start, std::vector<ModeGuess>* failed) {
  double travel = 0;
  for (const ContactDoubles& c : model.contacts) {
    travel = std::max(travel, std::fabs(dot(c.slip, {start[0], start[1], start[2], 1, 0})));
  }
  if (!(travel > 0)) return std::nullopt;
  SmoothBalance balance(model);
  Eigen::Vector3d d(start[0], start[1], start[2]);
  constexpr int kSteps = 8;
  // A start that is near converges at once; one that is not is left to the search.
  for (const double shrink : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    balance.set_epsilon(shrink * travel);
    if (!(settle(balance, model, d, kSteps) <= 1e-3 * model.force)) return std::nullopt;
  }
  if (!(settle(balance, model, d, kSteps) <= 1e-6 * model.force)) return std::nullopt;
  if (opens_unlawfully(problem, balance, d)) return std::nullopt;
  std::vector<ModeGuess> modes = guesses(balance, model, d);
  // The share of friction where contacts stick is not what fails.
  const auto are_one = [](const ModeGuess& a, const ModeGuess& b) {
    return a.closed == b.closed && a.sticks == b.sticks && (a.sticks || a.share == b.share);
  };
  if (failed != nullptr &&
      std::equal(modes.begin(), modes.end(), failed->begin(), failed->end(), are_one)) {
    return std::nullopt;
  }
  auto witness = complete_exactly(problem, modes);
  if (failed != nullptr) *failed = std::move(modes);
  return witness;
}

std::vector<Witness> find_witnesses_around(const Problem& problem, const DoubleModel& model,
                                           std::size_t starts) {
  std::vector<Witness> found;
  SmoothBalance balance(model);
  relax_around(model, starts, balance, [&](const Eigen::Vector3d& d) {
    auto witness = complete(problem, balance, model, d);
    if (!witness) return;
    const bool is_new = std::none_of(found.begin(), found.end(), [&](const Witness& other) {
      return other.twist == witness->twist;
    });
    if (is_new) found.push_back(std::move(*witness));
  });
  return found;
}

std::vector<NearEquilibrium> newton_equilibria(const DoubleModel& model, std::size_t starts,
                                               double length) {
  SmoothBalance balance(model);
  std::vector<NearEquilibrium> found;
  std::vector<Eigen::Vector3d> motions;
  const auto add = [&](const Eigen::Vector3d& d) {
    const bool is_known = std::any_of(motions.begin(), motions.end(), [&](const auto& other) {
      constexpr double kSame = 1e-6;
      return (other - d).norm() <= kSame * (other.norm() + d.norm());
    });
    if (is_known) return;
    motions.push_back(d);
    found.push_back(near(balance, model, d, length));
  };
  Eigen::Vector3d move;
  if (const auto d = relax_from_rest(model, balance, move)) add(*d);
  if (starts == 0) return found;
  for (const bool squeezed : {false, true}) {
    if (const auto d = relax_from_squeeze(model, balance, squeezed)) add(*d);
  }
  relax_around(model, starts, balance, add);
  return found;
}

NearEquilibrium rounded_equilibrium(const Problem& problem, const Witness& witness,
                                    double length) {
  const Twist& d = witness.twist;
  NearEquilibrium result{
      Eigen::Vector3d(to_double(d.x), to_double(d.y), to_double(d.r) * length), {}, {}, {}};
  const ScaledTwist scaled(d);
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactForce& force = witness.forces[i];
    const ContactRow& row = problem.rows()[i];
    const bool rubs = force.normal.sign() > 0 && !row.friction.is_zero();
    result.normal.push_back(to_double(force.normal));
    result.friction.push_back({to_double(force.tangential), 0, 0});
    result.sticks.push_back(rubs && power(row.tangent, scaled.twist).is_zero() ? 1 : 0);
  }
  return result;
}

std::vector<NearEquilibrium> newton_equilibria(const Problem& problem, std::size_t starts,
                                               double length) {
  return newton_equilibria(DoubleModel(problem), starts, length);
}

bool has_long_equilibria(const Problem& problem, std::size_t bits) {
  Integer common = 1;
  const auto add = [&](const Rational& value) {
    const Integer d = denominator(value);
    if (d == 1 || (common % d).is_zero()) return;
    common = lcm(common, d);
  };
  for (const ContactRow& row : problem.rows()) {
    for (const Wrench* w : {&row.normal, &row.tangent}) {
      for (const Rational& entry : coordinates(*w)) add(entry);
    }
    add(row.friction);
    add(row.stiffness);
    add(row.preload);
    if (msb(common) >= bits) return true;
  }
  return false;
}

}  // namespace stickslip
