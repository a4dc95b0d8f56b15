// SPDX-License-Identifier: GPL-3.0-or-later
#include "moving_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "smooth_newton.hpp"

namespace stickslip {
namespace {

/// A sticking contact yields by this part of the reach for all the friction that there may be.
constexpr double kYields = 1e-9;

/// The part of one contact in an equilibrium of another grasp, in its mode there: its wrench,
/// its slip if it sticks, and the most friction that there may be.
struct Part {
  Reals wrench;
  Eigen::VectorXd slip;
  double most;
};

Part part_of(const RoundedContact& c, const NearEquilibrium& near, std::size_t contact) {
  const double a = c.force(near.motion);
  Part part{a * c.normal, {}, a * c.slope};
  const Eigen::VectorXd s = c.slip * near.motion;
  if (near.sticks[contact] != 0) {
    part.slip = s;
    part.wrench +=
        c.slip.transpose() *
        Eigen::Map<const Eigen::Vector3d>(near.friction[contact].data()).head(s.size());
  } else if (s.norm() > 0) {
    part.wrench -= a * c.slope / s.norm() * (c.slip.transpose() * s);
  }
  return part;
}

}  // namespace

EquilibriumPath MovingEquilibrium::follow(const Place& to) const {
  EquilibriumPath path;
  NearEquilibrium now = start_;
  const Place from = box_.middle();
  double step = 0.5;
  constexpr double kLeastStep = 1.0 / 128;
  while (path.part < 1 && step >= kLeastStep) {
    const double next = std::min(1.0, path.part + step);
    const RoundedGrasp there = box_.at(from + next * (to - from));
    if (auto found = Newton(there).follow(now)) {
      now = std::move(*found);
      path.part = next;
      path.equilibria.push_back(now);
      step *= 2;
    } else {
      step /= 2;
    }
  }
  return path;
}

/// Lets friction that sticks yield a very little to a larger share of what there may be. That
/// moves nothing, but tells which way it will slip.
Eigen::MatrixXd MovingEquilibrium::moves(const Place& place,
                                         const NearEquilibrium& here) const {
  NearEquilibrium near = here;
  const RoundedGrasp grasp = box_.at(place);
  const ModalEquations equations(grasp, near);
  const std::size_t m = near.sticks.size();
  std::vector<Eigen::Index> first;  // the first of a contact's slips
  Eigen::Index slips = 0;
  for (std::size_t i = 0; i < m; ++i) {
    first.push_back(slips);
    if (near.sticks[i] != 0) slips += grasp.contacts[i].slip.rows();
  }
  Eigen::MatrixXd result(near.motion.size(), place.size());
  for (Eigen::Index n = 0; n < place.size(); ++n) {
    Reals off = Reals::Zero(near.motion.size());
    Eigen::VectorXd slip = Eigen::VectorXd::Zero(slips);
    std::vector<double> most(m);  // how much more friction there may be
    const auto number = static_cast<std::size_t>(n);
    const bool is_multiple = number == box_.numbers().size();
    for (const double sign : {0.5, -0.5}) {
      Place end = place;
      end[n] = sign > 0 ? 1 : -1;
      const auto add_contact = [&](std::size_t i) {
        const Part part = part_of(box_.contact_at(i, end), near, i);
        off += sign * part.wrench;
        slip.segment(first[i], part.slip.size()) += sign * part.slip;
        most[i] += sign * part.most;
      };
      if (is_multiple || box_.numbers()[number].parameter == Parameter::kWrench) {
        off += sign * box_.load_at(end);
      } else {
        add_contact(box_.numbers()[number].index);
      }
      for (std::size_t i = 0; is_multiple && i < m; ++i) add_contact(i);
    }
    const Reals change = equations.motion_change(off, slip);
    Eigen::VectorXd yields = equations.friction_change(off, change);
    for (std::size_t i = 0; i < m; ++i) {
      if (near.sticks[i] == 0) continue;
      const RoundedContact& c = grasp.contacts[i];
      const double all = c.slope * near.normal[i];
      const double more = most[i] - c.slope * c.stiffness * c.normal.dot(change);
      auto share = yields.segment(first[i], c.slip.rows());
      share -= more / all *
               Eigen::Map<const Eigen::Vector3d>(near.friction[i].data()).head(share.size());
      share *= kYields * grasp.reach / all;
    }
    result.col(n) = change + equations.motion_change(Reals::Zero(off.size()), yields);
  }
  return result;
}

std::vector<Reals> MovingEquilibrium::extremes(const Eigen::MatrixXd& rows) const {
  std::vector<Reals> result;
  for (const auto& row : rows.rowwise()) {
    for (const int sign : {1, -1}) {
      Place place = box_.middle();
      NearEquilibrium at = start_;
      constexpr int kRounds = 3;
      for (int round = 0; round < kRounds; ++round) {
        const Place to = box_.farthest(sign * (row * moves(place, at)).transpose());
        if (to == place) break;
        EquilibriumPath path = follow(to);
        for (const NearEquilibrium& e : path.equilibria) {
          result.emplace_back(e.motion - start_.motion);
        }
        if (path.part < 1) break;
        place = to;
        at = std::move(path.equilibria.back());
      }
    }
  }
  return result;
}

std::vector<Reals> MovingEquilibrium::cloud(std::size_t places) const {
  RandomCorners corners(box_);
  const Place middle = box_.middle();
  std::vector<Reals> result;
  for (std::size_t k = 0; k < places; ++k) {
    Place to = corners.next();
    if (k % 3 == 0) {
      for (Eigen::Index n = 0; n < to.size(); ++n) {
        to[n] = middle[n] + std::fabs(corners.number()) * (to[n] - middle[n]);
      }
    }
    const RoundedGrasp there = box_.at(to);
    if (const auto motion = SmoothNewton(there).follow(start_.motion)) {
      result.emplace_back(*motion - start_.motion);
    }
  }
  return result;
}

}  // namespace stickslip
