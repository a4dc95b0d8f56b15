// SPDX-License-Identifier: GPL-3.0-or-later
#include "moving_equilibrium.hpp"

#include <algorithm>
#include <cmath>

namespace stickslip::box_detail {
namespace {

constexpr double kStill = 1e-9;  // of a typical motion

}  // namespace

MovingEquilibrium::MovingEquilibrium(const ParameterBox& box, const Law& middle,
                                     const RoundedEquilibrium& near)
    : force_(middle.force),
      start_{{near.twist[0], near.twist[1], near.twist[2] * middle.length},
             Eigen::VectorXd::Zero(static_cast<Eigen::Index>(box.size())),
             std::vector<bool>(box.size())} {
  const auto add = [&](const Interval& interval, Parameter parameter, std::size_t index,
                       Eigen::Index& place, double unit) -> Range {
    place = -1;
    if (!interval.is_point()) {
      place = static_cast<Eigen::Index>(numbers_.size());
      numbers_.push_back({parameter, index});
    }
    return {to_double(interval.middle()) / unit,
            to_double(interval.high - interval.low) / (2 * unit)};
  };
  places_.resize(box.size());
  ranges_.resize(box.size());
  double stiffest = 0;
  for (std::size_t i = 0; i < box.size(); ++i) {
    const ParameterContact& c = box.contacts()[i];
    directions_.push_back({to_double(c.normal.x), to_double(c.normal.y)});
    for (std::size_t p = 0; p < c.parameters.size(); ++p) {
      const auto parameter = static_cast<Parameter>(p);
      const bool is_length = parameter == Parameter::kX || parameter == Parameter::kY;
      ranges_[i][p] =
          add(c.parameters[p], parameter, i, places_[i][p], is_length ? middle.length : 1);
    }
    const double n = std::hypot(directions_[i][0], directions_[i][1]);
    stiffest = std::max(stiffest, ranges_[i][5].middle * n);
    const RoundedEquilibrium::Force& force = near.forces[i];
    const double most = ranges_[i][3].middle * force.normal;
    if (!(most > 0)) continue;
    const double share = force.tangential / most;
    start_.shares[static_cast<Eigen::Index>(i)] = share;
    start_.sticks[i] = std::fabs(share) < 1;
  }
  for (std::size_t j = 0; j < 3; ++j) {
    load_[j] = add(box.wrench()[j], Parameter::kWrench, j, load_places_[j],
                   j == 2 ? middle.length : 1);
  }
  if (stiffest > 0) travel_ = std::max(force_ / stiffest, start_.motion.norm());
}

std::array<double, 6> MovingEquilibrium::numbers_at(std::size_t contact,
                                                    const Place& place) const {
  std::array<double, 6> result{};
  for (std::size_t p = 0; p < result.size(); ++p) {
    const Range& range = ranges_[contact][p];
    const Eigen::Index where = places_[contact][p];
    result[p] = range.middle + (where < 0 ? 0 : place[where] * range.half);
  }
  return result;
}

MovingEquilibrium::Contact MovingEquilibrium::contact_at(
    std::size_t index, const std::array<double, 6>& numbers) const {
  const auto [x, y, e, friction, preload, stiffness] = numbers;
  const auto [nx, ny] = directions_[index];
  const double ux = nx - e * ny;
  const double uy = ny + e * nx;
  return {{ux, uy, x * uy - y * ux}, {-uy, ux, x * ux + y * uy}, friction, preload, stiffness};
}

MovingEquilibrium::Grasp MovingEquilibrium::at(const Place& place) const {
  Grasp grasp;
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    grasp.contacts.push_back(contact_at(i, numbers_at(i, place)));
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const Eigen::Index where = load_places_[j];
    grasp.load[static_cast<Eigen::Index>(j)] =
        load_[j].middle + (where < 0 ? 0 : place[where] * load_[j].half);
  }
  return grasp;
}

double MovingEquilibrium::bounded_share(const Contact& c, const Motion& motion,
                                        double share) const {
  return std::clamp(share - c.tangent.dot(motion) / (kStill * travel_), -1.0, 1.0);
}

Eigen::Matrix3d MovingEquilibrium::derivative(const Grasp& grasp, const Motion& motion,
                                              const Eigen::VectorXd& shares,
                                              const std::vector<bool>& sticks) const {
  Eigen::Matrix3d result = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const Contact& c = grasp.contacts[i];
    const double a = c.preload - c.stiffness * c.normal.dot(motion);
    if (!(a > 0)) continue;
    const double friction = c.friction * shares[static_cast<Eigen::Index>(i)];
    result -= c.stiffness * (c.normal + friction * c.tangent) * c.normal.transpose();
    if (sticks[i]) {
      result -= a * c.friction / (kStill * travel_) * c.tangent * c.tangent.transpose();
    }
  }
  // Never singular.
  result.diagonal().array() -= 1e-12 * result.diagonal().cwiseAbs().sum() + 1e-300;
  return result;
}

std::optional<Equilibrium> MovingEquilibrium::near(const Place& place,
                                                   const Equilibrium& start) const {
  const Grasp grasp = at(place);
  Equilibrium now = start;
  constexpr int kSteps = 20;
  for (int step = 0; step < kSteps; ++step) {
    // Which contacts stick: those that a small slip back would not make slip.
    constexpr double kNear = 0.1;
    Motion sum = grasp.load;
    bool lawful = true;
    for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
      const Contact& c = grasp.contacts[i];
      const double a = c.preload - c.stiffness * c.normal.dot(now.motion);
      double& share = now.shares[static_cast<Eigen::Index>(i)];
      const double slip = c.tangent.dot(now.motion);
      const double trial = share - slip / (kNear * travel_);
      now.sticks[i] = a > 0 && std::fabs(trial) < 1;
      if (!now.sticks[i]) {
        const double bound = trial < 0 ? -1 : 1;
        lawful = lawful && (!(a > 0) || share == bound);
        share = bound;
      } else {
        lawful = lawful && std::fabs(slip) < 1e-6 * travel_;
      }
      if (a > 0) sum += a * (c.normal + share * c.friction * c.tangent);
    }
    constexpr double kBalanced = 1e-6;
    if (lawful && sum.norm() < kBalanced * force_) return now;
    for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
      const Contact& c = grasp.contacts[i];
      if (!now.sticks[i]) continue;
      const double a = c.preload - c.stiffness * c.normal.dot(now.motion);
      sum -= a * c.friction * c.tangent.dot(now.motion) / (kStill * travel_) * c.tangent;
    }
    const Motion change =
        -derivative(grasp, now.motion, now.shares, now.sticks).partialPivLu().solve(sum);
    if (!change.allFinite()) return std::nullopt;
    now.motion += change;
    for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
      if (!now.sticks[i]) continue;
      now.shares[static_cast<Eigen::Index>(i)] -=
          grasp.contacts[i].tangent.dot(now.motion) / (kStill * travel_);
    }
  }
  return std::nullopt;
}

EquilibriumPath MovingEquilibrium::follow(const Place& to) const {
  EquilibriumPath path;
  Equilibrium now = start_;
  double part = 0;
  double step = 0.5;
  constexpr double kLeastStep = 1.0 / 128;
  while (part < 1 && step >= kLeastStep) {
    const double next = std::min(1.0, part + step);
    if (auto found = near(next * to, now)) {
      now = std::move(*found);
      part = next;
      path.equilibria.push_back(now);
      step *= 2;
    } else {
      step /= 2;
    }
  }
  path.part = part;
  return path;
}

std::vector<LostWay> MovingEquilibrium::ways_out() const {
  std::vector<LostWay> lost;
  std::vector<Place> tried;
  Place place = middle();
  Equilibrium here = start_;
  double least = 2;
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::Matrix3Xd moving = moves(place, here);
    const Grasp grasp = at(place);
    bool better = false;
    for (std::size_t direction = 0; direction < 4 * grasp.contacts.size(); ++direction) {
      const Contact& c = grasp.contacts[direction / 4];
      const Motion out =
          (direction % 2 == 0 ? 1 : -1) * (direction % 4 < 2 ? c.normal : c.tangent);
      const Place to = (moving.transpose() * out).cwiseSign();
      if (std::find(tried.begin(), tried.end(), to) != tried.end()) continue;
      tried.push_back(to);
      const EquilibriumPath path = follow(to);
      if (path.part == 1) continue;
      lost.push_back({to, path.part});
      if (path.part < least && !path.equilibria.empty()) {
        least = path.part;
        better = true;
        place = path.part * to;
        here = path.equilibria.back();
      }
    }
    if (!better) break;
  }
  std::sort(lost.begin(), lost.end(),
            [](const LostWay& a, const LostWay& b) { return a.part < b.part; });
  return lost;
}

MovingEquilibrium::Motion MovingEquilibrium::force(const Motion& motion) const {
  const Grasp grasp = at(middle());
  Motion sum = grasp.load;
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const Contact& c = grasp.contacts[i];
    const double a = c.preload - c.stiffness * c.normal.dot(motion);
    const double share = bounded_share(c, motion, start_.shares[static_cast<Eigen::Index>(i)]);
    if (a > 0) sum += a * (c.normal + share * c.friction * c.tangent);
  }
  return sum;
}

Eigen::Matrix3Xd MovingEquilibrium::moves(const Place& place, const Equilibrium& here) const {
  Eigen::Matrix3Xd forces(3, static_cast<Eigen::Index>(numbers_.size()));
  for (std::size_t n = 0; n < numbers_.size(); ++n) {
    auto force = forces.col(static_cast<Eigen::Index>(n));
    const auto [parameter, index] = numbers_[n];
    if (parameter == Parameter::kWrench) {
      force = load_[index].half * Motion::Unit(static_cast<Eigen::Index>(index));
      continue;
    }
    const auto p = static_cast<std::size_t>(parameter);
    const auto wrench_at = [&, i = index](double end) -> Motion {
      std::array<double, 6> numbers = numbers_at(i, place);
      numbers[p] = ranges_[i][p].middle + end * ranges_[i][p].half;
      const Contact c = contact_at(i, numbers);
      const double a = c.preload - c.stiffness * c.normal.dot(here.motion);
      double share = here.shares[static_cast<Eigen::Index>(i)];
      // Where the contact sticks the object moves with its tangent.
      if (here.sticks[i]) share -= c.tangent.dot(here.motion) / (kStill * travel_);
      if (!(a > 0)) return Motion::Zero();
      return a * (c.normal + share * c.friction * c.tangent);
    };
    force = (wrench_at(1) - wrench_at(-1)) / 2;
  }
  if (numbers_.empty()) return forces;  // Eigen's solve() looks into no column
  return -derivative(at(place), here.motion, here.shares, here.sticks)
              .partialPivLu()
              .solve(forces);
}

}  // namespace stickslip::box_detail
