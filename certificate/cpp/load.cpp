// SPDX-License-Identifier: MIT
#include "load.hpp"

#include <algorithm>
#include <utility>

namespace stickslip_check {
namespace {

Vector unit(std::size_t size, std::size_t j) {
  Vector e(size);
  e[j] = 1;
  return e;
}

}  // namespace

Load::Load(std::vector<Bounds> components)
    : w0_(components.size()), numbers_(std::move(components)) {
  for (std::size_t j = 0; j < w0_.size(); ++j) ways_.push_back(unit(w0_.size(), j));
}

Load::Load(Vector w0, const Ball& ball, const Matrix& motion) : w0_(std::move(w0)) {
  const std::size_t forces = ball.about.size();
  const Rational most_torque = ball.radius * ball.length;
  for (std::size_t j = 0; j < motion.rows.size(); ++j) {
    const bool of_force = j < forces;
    const Rational& most = of_force ? ball.radius : most_torque;
    ways_.push_back(combined(
        motion, of_force ? at_point(ball.about, unit(forces, j)) : unit(motion.rows.size(), j)));
    numbers_.emplace_back(-most, most);
    squares_.emplace_back(most * most);
  }
}

bool Load::certain() const {
  return std::all_of(numbers_.begin(), numbers_.end(), [](auto& z) { return z.certain(); });
}

Vector Load::lowest() const {
  Vector w = w0_;
  for (std::size_t j = 0; j < ways_.size(); ++j) add(w, numbers_[j].low, ways_[j]);
  return w;
}

Bounds Load::work(const Vector& y) const {
  Bounds in_box(0);
  Rational square;
  for (std::size_t j = 0; j < ways_.size(); ++j) {
    const Rational along = dot(ways_[j], y);
    const auto& [low, high] = numbers_[j];
    in_box.low += along * (along > 0 ? low : high);
    in_box.high += along * (along > 0 ? high : low);
    if (!squares_.empty()) square += squares_[j] * along * along;
  }
  const Rational of_w0 = dot(w0_, y);
  if (squares_.empty()) return {of_w0 + in_box.low, of_w0 + in_box.high};
  const Rational root = root_above(square);
  return {of_w0 + std::max(in_box.low, Rational(-root)), of_w0 + std::min(in_box.high, root)};
}

Load Load::with(std::size_t index, Bounds bounds) const {
  Load part = *this;
  part.numbers_[index] = std::move(bounds);
  return part;
}

Load Load::middle() const {
  Load point = *this;
  for (Bounds& z : point.numbers_) {
    if (squares_.empty()) {
      z = (z.low + z.high) / 2;
    } else {
      z = std::max(z.low, std::min(z.high, Rational(0)));
    }
  }
  return point;
}

}  // namespace stickslip_check
