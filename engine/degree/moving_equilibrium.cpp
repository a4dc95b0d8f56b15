// SPDX-License-Identifier: GPL-3.0-or-later
#include "moving_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "engine/motion/dense.hpp"

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

/// Newton's method for a grasp whose friction and normal forces are smooth near 0: of the
/// equilibria of a grasp it finds one that is near, whatever modes end on the way, but only
/// about.
class SmoothedGrasp {
 public:
  explicit SmoothedGrasp(const RoundedGrasp& grasp) : grasp_(grasp) {}

  /// Moves d to an equilibrium that is smooth over lengths of `least`, from smoother ones on
  /// that are smooth over `first`. Returns false if it was lost.
  bool settle(Reals& d, double first, double least) const {
    constexpr int kMostLost = 12;
    constexpr double kSlow = 0.97;
    double smooth = first;
    if (!balance(d, smooth, 40)) return false;
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
        if (++lost > kMostLost || factor > kSlow) return false;
      }
    }
    return true;
  }

 private:
  Reals force(const Reals& d, double smooth, Eigen::MatrixXd* derivative = nullptr) const {
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

  bool balance(Reals& d, double smooth, int steps) const {
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

  Reals change_with(const Reals& d, double smooth) const {
    const double step = 1e-4 * smooth;
    Eigen::MatrixXd derivative;
    force(d, smooth, &derivative);
    const Reals change = (force(d, smooth + step) - force(d, smooth - step)) / (2 * step);
    return -solution(derivative, change);
  }

  const RoundedGrasp& grasp_;
};

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

std::vector<LostWay> MovingEquilibrium::ways_out() const {
  std::vector<LostWay> lost;
  std::vector<Place> tried;
  Place place = box_.middle();
  NearEquilibrium here = start_;
  double least = 2;
  const auto look_along = [&](const Eigen::MatrixXd& moving, const Reals& out) {
    const Place to = box_.farthest(moving.transpose() * out);
    if (std::find(tried.begin(), tried.end(), to) != tried.end()) return false;
    tried.push_back(to);
    EquilibriumPath path = follow(to);
    if (path.part == 1) return false;
    lost.push_back({to, path.part});
    if (!(path.part < least) || path.equilibria.empty()) return false;
    least = path.part;
    place = box_.middle() + path.part * (to - box_.middle());
    here = std::move(path.equilibria.back());
    return true;
  };
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::MatrixXd moving = moves(place, here);
    bool better = false;
    for (const RoundedContact& c : box_.at(place).contacts) {
      std::vector<Reals> ways{c.normal};
      for (const auto& row : c.slip.rowwise()) ways.emplace_back(row.transpose());
      for (const Reals& way : ways) {
        for (const int sign : {1, -1}) better = look_along(moving, sign * way) || better;
      }
    }
    if (!better) break;
  }
  std::sort(lost.begin(), lost.end(),
            [](const LostWay& a, const LostWay& b) { return a.part < b.part; });
  return lost;
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
  std::uint64_t state = 88172645463325252ULL;
  const auto random = [&] {  // xorshift: from -1 to 1
    state ^= state << 13U;
    state ^= state >> 7U;
    state ^= state << 17U;
    return static_cast<double>(state >> 11U) / static_cast<double>(1ULL << 52U) - 1;
  };
  const Place middle = box_.middle();
  std::vector<Reals> result;
  for (std::size_t k = 0; k < places; ++k) {
    Place to = middle;
    for (double& entry : to) entry = random();
    to = box_.farthest(to);
    for (std::size_t n = 0; n + 1 < box_.numbers().size(); ++n) {
      if (box_.numbers()[n].parameter != Parameter::kTurnU ||
          box_.numbers()[n + 1].parameter != Parameter::kTurnV) {
        continue;
      }
      constexpr double kPi = 3.14159265358979323846;
      const double angle = kPi * random();
      to[static_cast<Eigen::Index>(n)] = std::cos(angle);
      to[static_cast<Eigen::Index>(n) + 1] = std::sin(angle);
    }
    if (k % 3 == 0) {
      for (Eigen::Index n = 0; n < to.size(); ++n) {
        to[n] = middle[n] + std::fabs(random()) * (to[n] - middle[n]);
      }
    }
    const RoundedGrasp there = box_.at(to);
    for (const double first : {1e-3, 0.05, 1.0}) {
      constexpr double kLeast = 1e-6;
      Reals motion = start_.motion;
      if (!SmoothedGrasp(there).settle(motion, first * there.reach, kLeast * there.reach))
        continue;
      result.emplace_back(motion - start_.motion);
      break;
    }
  }
  return result;
}

}  // namespace stickslip
