// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Balance of one grasp with contacts that stick or slip, as they do at an equilibrium nearby,
/// by augmented Lagrangians in double precision: proposals only.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "double_model.hpp"
#include "stickslip/equilibrium/search/independent_rows.hpp"
#include "stickslip/equilibrium/search/rounded_equilibrium.hpp"

namespace stickslip::equilibrium_detail {

/// Motions around an equilibrium: |walls (d - middle)| <= 1 by coordinates.
struct ModeCell {
  Eigen::Vector3d middle;
  Eigen::Matrix3d walls;
  Eigen::Matrix3d direction;  ///< about how forces answer motions, beyond what sticks
};

/// Beside the friction that they have, sticking contacts have springs, and it becomes what
/// these do. Contacts that break a law change the mode. Inside, rotations are times the length.
class ModeBalance {
 public:
  using Motion = Eigen::Vector3d;

  ModeBalance(const DoubleModel& model, const RoundedEquilibrium& near)
      : model_(model), at_(near.twist[0], near.twist[1], near.twist[2] * model.length) {
    for (std::size_t i = 0; i < model.contacts.size(); ++i) {
      const ContactDoubles& c = model.contacts[i];
      const auto& [normal, tangential, still] = near.forces[i];
      const double most = normal * scaled(c.friction).norm() / scaled(c.slip).norm();
      const double share = most > 0 ? std::clamp(tangential / most, -1.0, 1.0) : 0;
      contacts_.push_back({scaled(c.normal), scaled(c.friction), share, still});
    }
    constexpr int kSteps = 40;
    for (int step = 0; step < kSteps; ++step) improve();
  }

  /// The largest one, up to its shape, on which no contact opens, closes, or begins or ends to
  /// slip, but for those that stick or are about on the border. It is thin where contacts
  /// stick; else a force is left over on its walls. Not finite if there is none.
  ModeCell cell() const {
    const Eigen::Matrix3d corners = walls_.inverse();
    double size = force_;
    const auto keep = [&](double value, const Motion& row, double scale) {
      constexpr double kOnBorder = 1e-9;
      if (!(std::fabs(value) > kOnBorder * scale)) return;
      size = std::min(size, std::fabs(value) / (row.transpose() * corners).lpNorm<1>());
    };
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const auto& [normal, friction, share, sticks] = contacts_[i];
      const double v = pressing(i);
      keep(v, model_.contacts[i].stiffness * normal, force_);
      if (!(v > 0) || sticks) continue;
      keep(friction.dot(at_), friction, friction.norm() * force_ / stiffness_);
    }
    const Motion units(1, 1, model_.length);
    return {at_.cwiseQuotient(units), walls_ / size * units.asDiagonal(),
            units.asDiagonal() * direction_ * units.asDiagonal()};
  }

 private:
  struct Contact {
    Motion normal;
    Motion friction;  ///< mu T
    double share;     ///< of the friction, in [-1, 1]
    bool sticks;
  };
  struct Sticking {
    Motion row;  ///< mu T
    double spare;
    std::size_t contact;
  };

  template <class Entries>
  Motion scaled(const Entries& a) const {
    return {a[0], a[1], a[2] / model_.length};
  }
  /// v
  double pressing(std::size_t i) const {
    const ContactDoubles& c = model_.contacts[i];
    return c.separation[3] - c.stiffness * contacts_[i].normal.dot(at_);
  }

  void improve() {
    Motion sum = scaled(model_.load);
    Eigen::Matrix3d answer = Eigen::Matrix3d::Zero();
    std::vector<Sticking> sticking;
    force_ = 0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const auto& [normal, friction, share, sticks] = contacts_[i];
      const double v = pressing(i);
      if (!(v > 0)) continue;
      const Motion edge = normal + share * friction;
      sum += v * edge;
      force_ += v * normal.head<2>().norm();
      answer += model_.contacts[i].stiffness * edge * normal.transpose();
      // A little beyond what there is, so that all that stick are taken.
      if (sticks) sticking.push_back({friction, v * (1.0000001 - std::fabs(share)), i});
    }
    stiffness_ = answer.norm();
    direction_ = answer;
    const double spring = 3 * stiffness_;
    // If those whose slips are independent stay, the others do.
    IndependentRows independent(3);
    std::vector<Sticking> chosen;
    constexpr double kIndependent = 1e-3;
    while (const auto which = independent.take_best(sticking, kIndependent)) {
      const Motion row = sticking[*which].row.normalized();
      walls_.row(static_cast<Eigen::Index>(chosen.size())) = stiffness_ * row.transpose();
      direction_ += spring * row * row.transpose();
      sum -= spring * row.dot(at_) * row;
      chosen.push_back(sticking[*which]);
    }
    // On virtual twists across their slips their friction does no work.
    const Eigen::MatrixXd across = independent.complement();
    walls_.bottomRows(across.cols()) = across.transpose() * answer;
    at_ += direction_.partialPivLu().solve(sum);
    for (Contact& c : contacts_) c.sticks = c.sticks || c.friction.dot(at_) * c.share >= 0;
    for (const Sticking& s : chosen) {
      Contact& c = contacts_[s.contact];
      c.share -= spring * s.row.dot(at_) / (s.row.squaredNorm() * pressing(s.contact));
      c.sticks = std::fabs(c.share) <= 1 + 1e-9;
      c.share = std::clamp(c.share, -1.0, 1.0);
    }
  }

  const DoubleModel& model_;
  Motion at_;
  std::vector<Contact> contacts_;
  Eigen::Matrix3d walls_;  ///< E up to its size
  Eigen::Matrix3d direction_;
  double force_ = 0;
  double stiffness_ = 0;
};

}  // namespace stickslip::equilibrium_detail
