// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/quality.hpp"

#include <algorithm>
#include <utility>

#include "engine/box/short_numbers.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

/// Returns the largest force of the load and of preloads.
Rational largest_force(const GraspBox& grasp) {
  Rational most = 0;
  const auto consider = [&](const Interval& force) {
    most = std::max<Rational>(most, abs(force.low));
  };
  for (const Interval& component : grasp.wrench) consider(component);
  for (const UncertainContact& c : grasp.contacts) consider(c.preload);
  for (const Spring& spring : grasp.springs) consider(spring.force);
  return most;
}

}  // namespace

Quality find_quality(const GraspBox& grasp, NormalLaw law, LoadBall shape,
                     const QualityOptions& options,
                     const std::function<void(const Quality&)>& progress) {
  require(grasp.is_point(), "the quality of one grasp");
  Quality quality;
  const Rational force = largest_force(grasp);
  quality.scales = !grasp.is_bounded() && force.is_zero();
  shape.radius = box_detail::power_of_two_above(force);
  RadiusOptions of_radius = options.radius;
  of_radius.only_stable = true;
  if (quality.scales) of_radius.most = 1;
  if (options.at_most) of_radius.most = *options.at_most / shape.radius;
  quality.ball = grasp;
  quality.ball.ball = shape;
  quality.ball.check();
  const auto take = [&](const Radius& found) {
    quality.stable = found.stable;
    quality.limit = found.limit * shape.radius;
    if (found.stable != true) return;
    quality.proved = found.proved * shape.radius;
    if (found.refuted) quality.refuted = *found.refuted * shape.radius;
  };
  if (progress) progress(quality);
  quality.radii = find_radius(grasp, quality.ball, law, of_radius, [&](const Radius& so_far) {
    take(so_far);
    if (!progress) return;
    quality.radii = so_far;
    progress(quality);
  });
  take(quality.radii);
  return quality;
}

}  // namespace stickslip
