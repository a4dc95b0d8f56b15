// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/ball_part.hpp"

#include <algorithm>
#include <cmath>

namespace stickslip {

BallPart BallPart::all_of(const GraspBox& box) {
  BallPart part{
      box.ball->radius, box.ball->length, box.in_space() ? 3U : 2U, box.ball_motion(), {}};
  for (const Rational& most : box.ball_reach()) part.parts.push_back({-most, most});
  return part;
}

RationalRow BallPart::load(const RationalRow& z) const {
  RationalRow sum(motion.front().size());
  for (std::size_t k = 0; k < z.size(); ++k) {
    for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += z[k] * motion[k][j];
  }
  return sum;
}

Rational BallPart::most_work(const Row& y) const {
  Rational of_box = 0;
  Rational square = 0;
  for (std::size_t k = 0; k < motion.size(); ++k) {
    Rational along = dot(y, motion[k]);
    of_box += along * (along.sign() > 0 ? parts[k].high : parts[k].low);
    if (k >= forces) along *= length;
    square += along * along;
  }
  if (square.is_zero()) return 0;
  constexpr unsigned kBits = 64;
  return std::min(of_box, short_sqrt(radius * radius * square, kBits).upper);
}

double BallPart::unit(std::size_t component) const {
  return component < forces ? 1 : to_double(length);
}

namespace {

/// Returns the point of the whole ball at which a linear function of z is largest.
Eigen::VectorXd farthest_in_ball(const BallPart& ball, const Eigen::VectorXd& function) {
  Eigen::VectorXd z = function;
  const auto scale = [&] {
    for (Eigen::Index k = 0; k < z.size(); ++k) z[k] *= ball.unit(static_cast<std::size_t>(k));
  };
  scale();
  const double size = z.norm();
  if (size > 0) z *= to_double(ball.radius) / size;
  scale();
  return z;
}

}  // namespace

Eigen::VectorXd BallPart::worst(const Reals& y) const {
  const Eigen::VectorXd along = rounded * y;
  Eigen::VectorXd corner(along.size());
  for (Eigen::Index k = 0; k < along.size(); ++k) {
    const Interval& part = parts[static_cast<std::size_t>(k)];
    corner[k] = to_double(along[k] > 0 ? part.high : part.low);
  }
  const Eigen::VectorXd round = farthest_in_ball(*this, along);
  return corner.dot(along) < round.dot(along) ? corner : round;
}

Eigen::VectorXd BallPart::pulled_in(const Eigen::VectorXd& z) const {
  const RationalRow centre = nearest();
  const auto n = static_cast<Eigen::Index>(parts.size());
  Eigen::VectorXd from(n);
  Eigen::VectorXd way(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto component = static_cast<std::size_t>(k);
    from[k] = to_double(centre[component]) / unit(component);
    way[k] = z[k] / unit(component) - from[k];
  }
  // |from + part way| = radius.
  const double a = way.squaredNorm();
  const double b = from.dot(way);
  const double c = from.squaredNorm() - std::pow(to_double(radius), 2);
  const double root = b * b - a * c;
  const double part = a > 0 && root > 0 ? std::clamp((std::sqrt(root) - b) / a, 0.0, 1.0) : 0;
  Eigen::VectorXd result = from + part * way;
  for (Eigen::Index k = 0; k < n; ++k) result[k] *= unit(static_cast<std::size_t>(k));
  return result;
}

Eigen::VectorXd BallPart::farthest(const Eigen::VectorXd& function) const {
  Eigen::VectorXd result = farthest_in_ball(*this, function);
  for (Eigen::Index k = 0; k < result.size(); ++k) {
    const Interval& part = parts[static_cast<std::size_t>(k)];
    result[k] = std::clamp(result[k], to_double(part.low), to_double(part.high));
  }
  return pulled_in(result);
}

RationalRow BallPart::nearest() const {
  RationalRow z;
  for (const Interval& part : parts) {
    z.push_back(part.low.sign() > 0 ? part.low : part.high.sign() < 0 ? part.high : 0);
  }
  return z;
}

}  // namespace stickslip
