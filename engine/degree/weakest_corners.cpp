// SPDX-License-Identifier: GPL-3.0-or-later
#include "weakest_corners.hpp"

#include <algorithm>
#include <utility>

#include "smooth_newton.hpp"
#include "stickslip/core/cancellation.hpp"

namespace stickslip {
namespace {

/// A multiple beyond it is no smaller one.
constexpr double kFarthest = 2;

class Descent {
 public:
  Descent(const RoundedBox& box, const NearEquilibrium& middle) : box_(box), middle_(middle) {}

  /// Returns the largest multiple of the load at a place that is held, from where it is held
  /// upwards; 0 if none is found.
  double multiple_at(const RoundedBox::Place& place) const {
    throw_if_cancelled();
    const RoundedGrasp grasp = box_.at(place);
    Reals motion = middle_.motion;
    double held = 0;
    double lost = 0;
    for (const double multiple : {1.0, 0.9, 0.75, 0.5}) {
      climb(grasp, multiple, motion, held, lost);
      if (held > 0) break;
    }
    if (held == 0) return 0;
    constexpr double kFirstStep = 0.04;
    double step = kFirstStep;
    while (lost == 0 && held < kFarthest) {
      climb(grasp, held + step, motion, held, lost);
      step *= 1.5;
    }
    constexpr double kNear = 2e-3;
    while (lost - held > kNear) climb(grasp, (held + lost) / 2, motion, held, lost);
    return held;
  }

  /// Returns the corner to which the multiple falls most steeply from a place.
  RoundedBox::Place below(const RoundedBox::Place& place) const {
    constexpr double kStep = 0.4;
    Eigen::VectorXd falls(place.size());
    for (Eigen::Index n = 0; n < place.size(); ++n) {
      RoundedBox::Place to = place;
      to[n] = std::max(place[n] - kStep, -1.0);
      falls[n] = multiple_at(to);
      to[n] = std::min(place[n] + kStep, 1.0);
      falls[n] -= multiple_at(to);
    }
    return box_.farthest(falls);
  }

 private:
  static void climb(const RoundedGrasp& grasp, double multiple, Reals& motion, double& held,
                    double& lost) {
    RoundedGrasp loaded = grasp;
    loaded.load *= multiple;
    constexpr double kFirst = 0.05;  // the others that follow() tries cost more than they tell
    auto found = SmoothNewton(loaded).settle(motion, kFirst);
    (found ? held : lost) = multiple;
    if (found) motion = std::move(*found);
  }

  const RoundedBox& box_;
  const NearEquilibrium& middle_;
};

}  // namespace

std::vector<WeakCorner> weakest_corners(const RoundedBox& box, const NearEquilibrium& middle,
                                        std::size_t descents) {
  std::vector<WeakCorner> corners;
  if (box.load_at(box.middle()).isZero(0)) return corners;
  const Descent descent(box, middle);
  RandomCorners random(box);
  // A step asks twice for each number; of many numbers a descent takes too long.
  constexpr std::size_t kMostAsked = 256;
  const std::size_t steps = std::min<std::size_t>(
      3, kMostAsked / (2 * std::max<std::size_t>(box.numbers().size(), 1)));
  for (std::size_t start = 0; start < descents; ++start) {
    RoundedBox::Place place = start == 0 ? box.middle() : random.next();
    for (std::size_t step = 0; step < steps; ++step) {
      RoundedBox::Place to = descent.below(place);
      if (to == place) break;
      place = std::move(to);
      corners.push_back({place, descent.multiple_at(place)});
    }
  }
  std::sort(corners.begin(), corners.end(),
            [](const WeakCorner& a, const WeakCorner& b) { return a.multiple < b.multiple; });
  return corners;
}

}  // namespace stickslip
