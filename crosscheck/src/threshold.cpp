// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "stickslip/crosscheck/claim.hpp"

namespace stickslip {
namespace {

void lower(std::optional<Rational>& smallest, const Rational& value) {
  if (!smallest || value < *smallest) smallest = value;
}

/// The size of the load in units of force, and the length that makes torques comparable.
struct Scale {
  Rational force;
  Rational length;
};

Scale scale_of(const Wrench& load, const Grasp& grasp) {
  Scale scale{0, largest_coordinate(grasp)};
  scale.force = std::max<Rational>({abs(load.x), abs(load.y), abs(load.torque) / scale.length});
  if (scale.force.is_zero()) {
    for (const Contact& c : grasp.contacts()) scale.force = std::max(scale.force, c.preload);
  }
  if (scale.force.is_zero()) scale.force = 1;
  return scale;
}

}  // namespace

std::optional<Rational> ThresholdDistance::smallest() const {
  if (!along_load || !along_axes) return along_load ? along_load : along_axes;
  return std::min(*along_load, *along_axes);
}

ThresholdDistance threshold_distance(const Problem& problem, const Grasp& grasp,
                                     const ConeOptions& options) {
  ThresholdDistance result;
  /// What is resisted, or nothing at the limit.
  const auto margin = [&](const Problem& base, const Wrench& direction) {
    auto found = find_margin(base.along({direction}), options);
    if (auto* undecided = std::get_if<Undecided>(&found)) {
      result.limit = std::move(undecided->limit);
      return std::optional<Margin>();
    }
    return std::optional<Margin>(std::get<Margin>(std::move(found)));
  };
  const Wrench& load = problem.wrench();
  if (!(load == Wrench{})) {
    if (const auto found = margin(problem.with_wrench({}), load)) {
      for (const MarginInterval& interval : found->resisted) {
        // 0 is where the multiples begin, and not where resistance does.
        if (interval.low.sign() > 0) lower(result.along_load, abs(interval.low - 1));
        if (interval.high) lower(result.along_load, abs(*interval.high - 1));
      }
    }
  }
  const auto [force, length] = scale_of(load, grasp);
  for (const int sign : {1, -1}) {
    for (const Wrench& axis :
         {Wrench{force, 0, 0}, Wrench{0, force, 0}, Wrench{0, 0, force * length}}) {
      const Wrench direction = Rational(sign) * axis;
      const auto found = margin(problem, direction);
      if (!found || found->resisted.empty()) continue;
      const MarginInterval& first = found->resisted.front();
      // The nearest change: the end of what holds, or the beginning of what would.
      const bool holds = first.low.is_zero();
      if (holds && !first.high) continue;
      const Rational& change = holds ? *first.high : first.low;
      if (!result.along_axes || change < *result.along_axes) {
        result.along_axes = change;
        result.axis = direction;
      }
    }
  }
  return result;
}

}  // namespace stickslip
