// SPDX-License-Identifier: GPL-3.0-or-later
#include "weakest_corners.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/motion/dense.hpp"
#include "smooth_newton.hpp"
#include "stickslip/core/cancellation.hpp"

namespace stickslip {
namespace {

/// A multiple beyond it is no smaller one.
constexpr double kFarthest = 2;
/// The part of the reach over which laws are smooth, while descending.
constexpr double kSmooth = 0.02;

/// The largest multiple of a load that is held, and the motion there; 0 if none is found.
struct Limit {
  double multiple;
  Reals motion;
};

/// Returns the virtual twist that meets least resistance of those on which the load does work:
/// an object may be free to move in ways that the load does not see.
Reals least_resisted(const Eigen::MatrixXd& derivative, const Reals& load) {
  const SingularValues resistance = singular_values(derivative);
  Reals twist = Reals::Zero(load.size());
  for (Eigen::Index k = 0; k < load.size(); ++k) {
    constexpr double kNoWork = 1e-9;
    const double work = resistance.left.col(k).dot(load);
    const double most = resistance.values[0];
    const double value = std::max(resistance.values[k], kNoWork * most) / most;
    if (std::fabs(work) > kNoWork * load.norm()) {
      twist += work / (value * value) * resistance.left.col(k);
    }
  }
  return twist.normalized();
}

class Descent {
 public:
  Descent(const RoundedBox& box, const NearEquilibrium& middle) : box_(box), middle_(middle) {}

  /// Returns the largest multiple of the load that is held at a place.
  double multiple_at(const RoundedBox::Place& place) const {
    const auto settle = [](const RoundedGrasp& loaded, Reals& motion) {
      // The others that follow() tries cost more than they tell.
      constexpr double kFirst = 0.05;
      auto found = SmoothNewton(loaded).settle(motion, kFirst);
      if (found) motion = std::move(*found);
      return found.has_value();
    };
    return limit(box_.at(place), settle).multiple;
  }

  /// Returns the corner to which the multiple falls most steeply from a place. Where the load
  /// is lost some virtual twist meets no resistance: how its work changes with each number says
  /// how the multiple does.
  RoundedBox::Place below(const RoundedBox::Place& place) const {
    const RoundedGrasp grasp = box_.at(place);
    const double smooth = kSmooth * grasp.reach;
    const Limit held = limit(grasp, [&](const RoundedGrasp& loaded, Reals& motion) {
      constexpr int kSteps = 40;
      return SmoothNewton(loaded).balance(motion, smooth, kSteps);
    });
    Eigen::MatrixXd derivative;
    SmoothNewton(grasp).force(held.motion, smooth, &derivative);
    if (!derivative.allFinite()) return place;
    const Reals twist = least_resisted(derivative, grasp.load);
    const auto work_at = [&](const RoundedBox::Place& at) {
      RoundedGrasp there = box_.at(at);
      there.load *= held.multiple;
      return twist.dot(SmoothNewton(there).force(held.motion, smooth));
    };
    constexpr double kStep = 0.4;
    Eigen::VectorXd falls(place.size());
    for (Eigen::Index n = 0; n < place.size(); ++n) {
      RoundedBox::Place low = place;
      RoundedBox::Place high = place;
      low[n] = std::max(place[n] - kStep, -1.0);
      high[n] = std::min(place[n] + kStep, 1.0);
      falls[n] = work_at(high) - work_at(low);
    }
    return falls.allFinite() ? box_.farthest(falls) : place;
  }

 private:
  /// Climbs from where the load is held upwards. `hold` moves a motion to an equilibrium near
  /// it, and says whether there is one.
  template <class Hold>
  Limit limit(const RoundedGrasp& grasp, Hold hold) const {
    throw_if_cancelled();
    Limit held{0, middle_.motion};
    double lost = 0;
    RoundedGrasp loaded = grasp;
    const auto climb = [&](double multiple) {
      loaded.load = multiple * grasp.load;
      Reals motion = held.motion;
      if (hold(loaded, motion)) {
        held = {multiple, std::move(motion)};
      } else {
        lost = multiple;
      }
    };
    for (const double multiple : {1.0, 0.9, 0.75, 0.5}) {
      climb(multiple);
      if (held.multiple > 0) break;
    }
    if (held.multiple == 0) return held;
    constexpr double kFirstStep = 0.04;
    double step = kFirstStep;
    while (lost == 0 && held.multiple < kFarthest) {
      climb(held.multiple + step);
      step *= 1.5;
    }
    constexpr double kNear = 1e-3;
    while (lost - held.multiple > kNear) climb((held.multiple + lost) / 2);
    return held;
  }

  const RoundedBox& box_;
  const NearEquilibrium& middle_;
};

}  // namespace

std::vector<WeakCorner> weakest_corners(const RoundedBox& box, const NearEquilibrium& middle,
                                        std::size_t descents) {
  std::vector<WeakCorner> corners;
  // A step computes all contacts twice for each number.
  constexpr std::size_t kMostNumbers = 256;
  if (box.load_at(box.middle()).isZero(0) || box.numbers().size() > kMostNumbers)
    return corners;
  const Descent descent(box, middle);
  RandomCorners random(box);
  constexpr int kSteps = 3;
  for (std::size_t start = 0; start < descents; ++start) {
    RoundedBox::Place place = start == 0 ? box.middle() : random.next();
    for (int step = 0; step < kSteps; ++step) {
      RoundedBox::Place to = descent.below(place);
      if (to == place) break;
      place = std::move(to);
      const bool is_known = std::any_of(corners.begin(), corners.end(),
                                        [&](const WeakCorner& c) { return c.at == place; });
      if (!is_known) corners.push_back({place, descent.multiple_at(place)});
    }
  }
  std::sort(corners.begin(), corners.end(),
            [](const WeakCorner& a, const WeakCorner& b) { return a.multiple < b.multiple; });
  return corners;
}

}  // namespace stickslip
