// SPDX-License-Identifier: GPL-3.0-or-later
#include "smooth_newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/motion/dense.hpp"

namespace stickslip {

std::optional<Reals> SmoothNewton::settle(Reals d, double first) const {
  const double least = kLeast * grasp_.reach;
  constexpr int kMostLost = 12;
  constexpr double kSlow = 0.97;
  double smooth = first * grasp_.reach;
  if (!balance(d, smooth, 40)) return std::nullopt;
  double factor = 0.4;
  int lost = 0;
  while (smooth > least) {
    const double next = std::max(least, smooth * factor);
    Reals there = d;
    const Reals ahead = d + (next - smooth) * change_with(d, smooth);
    if (ahead.allFinite() && force(ahead, next).norm() < force(d, next).norm()) there = ahead;
    if (balance(there, next, 12)) {
      d = there;
      smooth = next;
      factor = std::max(0.1, factor * 0.7);
    } else {
      factor = std::sqrt(factor);
      if (++lost > kMostLost || factor > kSlow) return std::nullopt;
    }
  }
  return d;
}

std::optional<Reals> SmoothNewton::follow(const Reals& from) const {
  for (const double first : {1e-3, 0.05, 1.0}) {
    if (auto motion = settle(from, first)) return motion;
  }
  return std::nullopt;
}

Reals SmoothNewton::force(const Reals& d, double smooth, Eigen::MatrixXd* derivative) const {
  const Eigen::Index n = d.size();
  Reals sum = grasp_.load;
  if (derivative != nullptr) {
    *derivative = -1e-10 * grasp_.force / grasp_.reach * Eigen::MatrixXd::Identity(n, n);
  }
  for (const RoundedContact& c : grasp_.contacts) {
    const double v = c.separation(d);
    const double far = std::hypot(v, smooth * c.stiffness * c.size);
    const double a = c.is_spring ? v : (v + far) / 2;
    const double rate = c.is_spring ? 1 : far > 0 ? a / far : 0;
    const Eigen::VectorXd s = c.slip * d;
    const double over = std::hypot(s.norm(), smooth);
    const Eigen::VectorXd along = s / over;
    const Reals wrench = c.normal - c.slope * (c.slip.transpose() * along);
    sum += a * wrench;
    if (derivative == nullptr) continue;
    *derivative -= c.stiffness * rate * wrench * c.normal.transpose();
    *derivative -= a * c.slope / over *
                   (c.slip.transpose() * c.slip -
                    c.slip.transpose() * along * (along.transpose() * c.slip));
  }
  return sum;
}

bool SmoothNewton::balance(Reals& d, double smooth, int steps) const {
  constexpr double kBalanced = 1e-9;
  Eigen::MatrixXd derivative;
  Reals off = force(d, smooth, &derivative);
  for (int step = 0; step < steps; ++step) {
    const double before = off.norm();
    if (before < kBalanced * grasp_.force) return true;
    const Reals move = -solution(derivative, off);
    if (!move.allFinite()) return false;
    Reals best = d;
    double least = before;
    for (const double part : {1.0, 0.5, 0.25, 0.1, 0.03, 0.01}) {
      const Reals there = d + part * move;
      const double left = force(there, smooth).norm();
      if (left < least) {
        least = left;
        best = there;
        if (left < 0.7 * before) break;
      }
    }
    if (least >= before * (1 - 1e-6)) return false;
    d = best;
    off = force(d, smooth, &derivative);
  }
  return off.norm() < kBalanced * grasp_.force;
}

Reals SmoothNewton::change_with(const Reals& d, double smooth) const {
  const double step = 1e-4 * smooth;
  Eigen::MatrixXd derivative;
  force(d, smooth, &derivative);
  const Reals change = (force(d, smooth + step) - force(d, smooth - step)) / (2 * step);
  return -solution(derivative, change);
}

}  // namespace stickslip
