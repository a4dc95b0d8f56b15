// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/model_traps.hpp"

#include <algorithm>
#include <cstdio>
#include <tuple>

#include "engine/motion/nearest_wrench.hpp"

namespace stickslip {
namespace {

std::string in_three_digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string root(const Rational& square) {
  return in_three_digits(std::sqrt(to_double(square)));
}

}  // namespace

const char* to_string(ModelTrap trap) {
  constexpr const char* kNames[] = {"large-motion",      "unbalanced-preload", "lost-preload",
                                    "assumed-stiffness", "reversed-contact",   "edge-balance"};
  return kNames[static_cast<std::size_t>(trap)];
}

void ModelWarnings::add(ModelTrap trap, std::optional<std::string> text) {
  if (text && !has(trap)) all_.push_back({trap, std::move(*text)});
}

bool ModelWarnings::has(ModelTrap trap) const {
  return std::any_of(all_.begin(), all_.end(),
                     [&](const ModelWarning& w) { return w.trap == trap; });
}

std::optional<std::string> large_motion(const MotionSizes& motion, bool stiffness_was_assumed) {
  const Rational square = motion.scale * motion.scale;
  std::string what;
  if (motion.turn > kLargestRotation * square) {
    what = "a turn by " + root(motion.turn / square) + " radians";
  }
  const Rational width = square * motion.width;
  std::size_t farthest = 0;
  Rational most = width;
  for (std::size_t i = 0; i < motion.contacts && !width.is_zero(); ++i) {
    Rational moved = motion.moved(i);
    if (moved <= most) continue;
    most = std::move(moved);
    farthest = i;
  }
  if (most > width) {
    what += (what.empty() ? "contact " : ", contact ") + std::to_string(farthest) +
            " moves by " + root(most / square) + " in a grasp " + root(motion.width) + " wide";
  }
  if (what.empty()) return std::nullopt;
  return (stiffness_was_assumed ? "stiffness that is not given was taken as 1, with which the "
                                  "motion found is too "
                                  "large for the model: "
                                : "the motion found is too large for the model: ") +
         what;
}

std::optional<std::string> lost_preload(
    std::size_t contacts,
    const std::function<std::pair<Rational, Rational>(std::size_t)>& preload_and_kept) {
  bool any = false;
  Rational largest_share = 0;
  for (std::size_t i = 0; i < contacts; ++i) {
    const auto [preload, kept] = preload_and_kept(i);
    if (preload.is_zero()) continue;
    any = true;
    if (kLeastPartOfPreload * kept >= preload) return std::nullopt;
    largest_share = std::max(largest_share, Rational(kept / preload));
  }
  if (!any) return std::nullopt;
  return "the preload is all but gone in this equilibrium: no contact keeps more than " +
         in_three_digits(to_double(100 * largest_share)) + " % of its own";
}

std::string unbalanced_preload() {
  return "the preloads do not balance, even with friction: the object moves before any load is "
         "applied";
}

std::optional<std::string> assumed_stiffness(const StiffnessTrial& trial) {
  if (trial.stiffness.size() > kMostContactsToVary) return std::nullopt;
  std::vector<Rational> others;
  for (std::size_t i = 0; i < trial.stiffness.size(); ++i) {
    const bool given = std::find(trial.assumed.begin(), trial.assumed.end(), ContactId(i)) ==
                       trial.assumed.end();
    if (given) others.push_back(trial.stiffness[i]);
  }
  if (!others.empty()) {
    const auto [least, most] = std::minmax_element(others.begin(), others.end());
    others = {*least, *most};
  }
  others.emplace_back(kStiffnessFactor);
  others.emplace_back(1, kStiffnessFactor);
  std::size_t nodes = trial.nodes + kNodesToVary;
  for (const ContactId contact : trial.assumed) {
    for (const Rational& other : others) {
      if (nodes == 0) return std::nullopt;
      if (other == trial.stiffness[contact.index()]) continue;
      if (!trial.may_differ(contact, other)) continue;
      if (trial.is_stable(contact, other, nodes).value_or(trial.stable) == trial.stable)
        continue;
      return "no stiffness is given for contact " + std::to_string(contact.index()) +
             ", so 1 was taken; with " + to_string(other) + " the verdict would be " +
             (trial.stable ? "unstable" : "stable");
    }
  }
  return std::nullopt;
}

template <std::size_t D>
bool is_certainly_unbalanced(std::vector<RestingContact<D>> contacts) {
  using Force = std::array<double, D>;
  constexpr std::size_t kForces = D == 3 ? 2 : 3;
  // Torques are divided by a typical arm, a power of two, which rounds nothing.
  double force = 0;
  double torque = 0;
  for (const auto& c : contacts) {
    for (std::size_t j = 0; j < D; ++j) {
      double size = std::fabs(c.push[j]);
      for (const Force& f : c.friction) size += std::fabs(f[j]);
      (j < kForces ? force : torque) += size;
    }
  }
  const double arm =
      force > 0 && torque > 0 ? std::exp2(std::round(std::log2(torque / force))) : 1;
  const auto scale = [&](Force& w) {
    for (std::size_t j = kForces; j < D; ++j) w[j] /= arm;
  };
  Force start{};
  for (auto& c : contacts) {
    scale(c.push);
    scale(c.error);
    for (Force& f : c.friction) scale(f);
    for (std::size_t j = 0; j < D; ++j) start[j] -= c.push[j];
  }
  struct Support {
    double work;
    Force wrench;
  };
  const auto most_work = [&](const Force& y) {
    Support support{0, {}};
    for (const auto& c : contacts) {
      Force along = c.push;
      std::array<double, std::tuple_size_v<decltype(c.friction)>> work{};
      double friction = 0;
      for (std::size_t k = 0; k < work.size(); ++k) {
        work[k] = dot(c.friction[k], y);
        friction = std::hypot(friction, work[k]);
      }
      for (std::size_t k = 0; k < work.size() && friction > 0; ++k) {
        for (std::size_t j = 0; j < D; ++j) along[j] += work[k] / friction * c.friction[k][j];
      }
      support.work += dot(c.push, y) + friction;
      for (std::size_t j = 0; j < D; ++j) support.wrench[j] += along[j];
    }
    return std::optional(support);
  };
  const auto found = nearest_wrench(start, most_work);
  if (!found.separated) return false;
  const Force& y = found.twist;
  double magnitude = 0;
  double error = 0;
  for (const auto& c : contacts) {
    for (std::size_t j = 0; j < D; ++j) {
      double size = std::fabs(c.push[j]);
      for (const Force& f : c.friction) size += std::fabs(f[j]);
      magnitude += size * std::fabs(y[j]);
      error += c.error[j] * std::fabs(y[j]);
    }
  }
  // Each term has fewer than 64 roundings, and each partial sum adds one; u = 2^-53 < 1.2e-16
  // leaves room for second order.
  const double roundings = 64 + static_cast<double>(contacts.size());
  constexpr double kUnitRoundoff = 1.2e-16;
  constexpr double kVanishing = 1e-150;  // squares may vanish below this
  return magnitude > kVanishing &&
         most_work(y)->work < -(2 * error + kUnitRoundoff * roundings * magnitude);
}

template bool is_certainly_unbalanced<3>(std::vector<RestingContact<3>>);
template bool is_certainly_unbalanced<6>(std::vector<RestingContact<6>>);

}  // namespace stickslip
