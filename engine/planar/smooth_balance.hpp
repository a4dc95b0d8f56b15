// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Balance with friction made smooth, by Newton's method in double precision: proposals only.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "double_model.hpp"
#include "engine/motion/dense.hpp"

namespace stickslip {

/// Returns how forces answer motions where contacts neither open nor slip: as springs do, in
/// both directions.
inline Eigen::Matrix3d spring_stiffness(const DoubleModel& model) {
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
  for (const ContactDoubles& c : model.contacts) {
    for (const double* entries : {c.normal.data(), c.slip.data()}) {
      const Eigen::Vector3d row(entries);
      stiffness += c.stiffness * row * row.transpose();
    }
  }
  return stiffness;
}

/// Balance with friction made smooth, -mu c_n clamp(T.d / epsilon), as three equations in d.
class SmoothBalance {
 public:
  /// Balances a problem, whose model must outlive it.
  explicit SmoothBalance(const DoubleModel& model) : model_(model) {}

  /// \{ The slip up to which friction is smooth.
  void set_epsilon(double epsilon) { epsilon_ = epsilon; }
  double epsilon() const { return epsilon_; }
  /// \}
  /// Presses all contacts by so much more: adds it to every v.
  void set_squeeze(double squeeze) { squeeze_ = squeeze; }
  /// Chooses the member of a family, by h and l; they are 1 and 0 at first.
  void set_member(double h, double l) {
    h_ = h;
    l_ = l;
  }
  /// Returns the point (d, h, l).
  Double5 point(const Eigen::Vector3d& d) const { return {d[0], d[1], d[2], h_, l_}; }
  /// Returns the friction over its most, with a sign.
  double friction_ratio(double slip) const { return std::clamp(-slip / epsilon_, -1.0, 1.0); }

  /// Returns whether some contact is pulled at noticeably. A law may forbid that: here contacts
  /// open.
  bool opens(const Eigen::Vector3d& d) const {
    constexpr double kNoticeable = 1e-6;
    const Double5 x = point(d);
    return std::any_of(model_.contacts.begin(), model_.contacts.end(), [&](const auto& c) {
      const double pull = -dot(c.separation, x) * std::hypot(c.normal[0], c.normal[1]);
      return pull > kNoticeable * model_.force;
    });
  }

  /// Returns the sum of all wrenches, and sets its derivative.
  Eigen::Vector3d residual(const Eigen::Vector3d& d, Eigen::Matrix3d& derivative) const {
    Eigen::Vector3d sum;
    for (Eigen::Index j = 0; j < 3; ++j) {
      const auto k = static_cast<std::size_t>(j);
      sum[j] = h_ * model_.load[k] + l_ * model_.growth[k];
    }
    derivative.setZero();
    const Double5 x = point(d);
    for (const ContactDoubles& c : model_.contacts) {
      const double v = dot(c.separation, x) + squeeze_;
      if (v <= 0) continue;
      const double slip = dot(c.slip, x);
      const double ratio = friction_ratio(slip);
      const Eigen::Map<const Eigen::Vector3d> normal(c.normal.data());
      const Eigen::Map<const Eigen::Vector3d> friction(c.friction.data());
      const Eigen::Vector3d edge = normal + ratio * friction;
      sum += v * edge;
      derivative += edge * Eigen::Map<const Eigen::RowVector3d>(c.separation.data());
      if (std::fabs(ratio) < 1) {
        derivative -=
            (v / epsilon_) * friction * Eigen::Map<const Eigen::RowVector3d>(c.slip.data());
      }
    }
    return sum;
  }

  /// Returns the size of a wrench as a force, with torques over the typical distance.
  double norm(const Eigen::Vector3d& wrench) const {
    return std::fabs(wrench[0]) + std::fabs(wrench[1]) + std::fabs(wrench[2]) / model_.length;
  }

  /// Improves d by Newton's method with step halving, until the norm of the residual is at most
  /// `enough`. Returns the norm that was reached.
  double solve(Eigen::Vector3d& d, int steps, double enough) const {
    Eigen::Matrix3d derivative;
    Eigen::Vector3d sum = residual(d, derivative);
    double size = norm(sum);
    for (int step = 0; step < steps && size > enough; ++step) {
      // The derivative is negative definite without friction; this keeps it regular.
      derivative.diagonal().array() -= 1e-12 * derivative.diagonal().cwiseAbs().sum() + 1e-300;
      const Eigen::Vector3d change = solution(derivative, -sum);
      if (!change.allFinite()) return size;
      const double before = size;
      for (double factor = 1; factor > 1e-3 && !(size < before); factor *= 0.5) {
        const Eigen::Vector3d next = d + factor * change;
        const Eigen::Vector3d next_sum = residual(next, derivative);
        const double next_size = norm(next_sum);
        if (next_size < before) {
          d = next;
          sum = next_sum;
          size = next_size;
        }
      }
      if (!(size < before)) return size;
    }
    return size;
  }

 private:
  const DoubleModel& model_;
  double epsilon_ = 1;
  double squeeze_ = 0;
  double h_ = 1;
  double l_ = 0;
};

}  // namespace stickslip
