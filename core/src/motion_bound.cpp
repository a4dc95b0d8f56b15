// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/motion_bound.hpp"

#include <algorithm>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

[[noreturn]] void refuse_bound(std::string problem, std::string remedy) {
  throw InputError("", "max_motion", std::move(problem), std::move(remedy));
}

Rational most_of(const Interval& interval) {
  return std::max<Rational>(abs(interval.low), abs(interval.high));
}

/// Returns the least number of two decimal digits that is not below this one, which is above 0.
Rational in_two_digits(const Rational& value) {
  Rational unit = 1;
  while (unit * 10 > value) unit /= 10;
  while (unit * 100 <= value) unit *= 10;
  const Rational digits = value / unit;  // 10 <= digits < 100
  const Integer below = numerator(digits) / denominator(digits);
  return Rational(Rational(below) == digits ? below : Integer(below + 1)) * unit;
}

/// The spread of the contacts: the middle of the box around them, half of its widest side, and
/// the largest coordinate of a contact.
struct Spread {
  RationalRow centre;
  Rational half{0};
  Rational farthest{0};
};

Spread spread_of(const GraspBox& box) {
  Spread spread{RationalRow(box.in_space() ? 3 : 2)};
  for (std::size_t j = 0; j < spread.centre.size() && !box.contacts.empty(); ++j) {
    Rational low = box.contacts.front().position[j].low;
    Rational high = box.contacts.front().position[j].high;
    for (const UncertainContact& c : box.contacts) {
      low = std::min(low, c.position[j].low);
      high = std::max(high, c.position[j].high);
    }
    spread.centre[j] = (low + high) / 2;
    spread.half = std::max<Rational>(spread.half, (high - low) / 2);
    spread.farthest = std::max({spread.farthest, Rational(abs(low)), Rational(abs(high))});
  }
  for (const UncertainContact& c : box.contacts) {
    if (spread.half.is_zero()) spread.half = c.torsion;
  }
  if (spread.half.is_zero()) spread.half = spread.farthest;
  if (spread.half.is_zero()) spread.half = 1;
  return spread;
}

/// Returns the torque of the load of one body about the centre of the contacts.
RationalRow torque_about(const RationalRow& centre, const WrenchBox& wrench) {
  RationalRow w;
  for (const Interval& component : wrench) w.push_back(component.middle());
  if (centre.size() == 2) return {w[2] - (centre[0] * w[1] - centre[1] * w[0])};
  const Vector3 moment = cross(vector3(centre), Vector3{w[0], w[1], w[2]});
  return {w[3] - moment[0], w[4] - moment[1], w[5] - moment[2]};
}

bool is_rotation(const GraspBox& box, std::size_t coordinate) {
  if (box.mechanism) return box.mechanism->is_rotation(coordinate);
  return coordinate >= (box.in_space() ? 3U : 2U);
}

}  // namespace

MotionBound parse_motion_bound(std::string_view text) {
  MotionBound bound;
  if (text == "none") return bound;
  const auto number = [](std::string_view spelled) {
    try {
      return parse_rational(spelled);
    } catch (const NumberError& error) {
      refuse_bound(
          quote(std::string(spelled)) + ": " + error.what(),
          "give a length and an angle, as in 0.01,0.02, a number for each coordinate, a factor "
          "of the natural motion, as in 1000x, or none");
    }
  };
  if (!text.empty() && text.back() == 'x') {
    bound.factor = number(text.substr(0, text.size() - 1));
    if (bound.factor->sign() <= 0) {
      refuse_bound("the factor is " + to_readable_string(*bound.factor),
                   "give a number above 0");
    }
    return bound;
  }
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    bound.numbers.push_back(number(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return bound;
}

RationalRow bound_of(const GraspBox& box, const MotionBound& asked) {
  if (asked.factor) {
    if (auto natural = natural_bound(box, *asked.factor)) return *natural;
    refuse_bound(
        "there is neither load nor preload, or no contact, so that motions have no natural "
        "size",
        "give a length and an angle, as in 0.01,0.02");
  }
  RationalRow numbers = asked.numbers;
  if (numbers.empty()) return {};
  for (const Rational& number : numbers) {
    if (number.sign() > 0) continue;
    refuse_bound("a bound of motions is " + to_readable_string(number), "give numbers above 0");
  }
  const std::size_t motions = box.wrench.size();
  const bool has_joints = box.mechanism && !box.mechanism->joints.empty();
  if (numbers.size() == 2 && !has_joints) {
    const RationalRow both = std::move(numbers);
    numbers.clear();
    for (std::size_t j = 0; j < motions; ++j)
      numbers.push_back(both[is_rotation(box, j) ? 1 : 0]);
  }
  if (numbers.size() != motions) {
    refuse_bound(
        (numbers.size() == 1 ? "there is 1 number"
                             : "there are " + std::to_string(numbers.size()) + " numbers") +
            " for " + std::to_string(motions) + " coordinates of motions",
        "give one for each" + std::string(has_joints ? "" : ", or two: a length and an angle"));
  }
  return numbers;
}

bool is_within(const RationalRow& motion, const RationalRow& bound) {
  for (std::size_t j = 0; j < bound.size(); ++j) {
    if (abs(motion[j]) > bound[j]) return false;
  }
  return true;
}

std::optional<RationalRow> natural_bound(const GraspBox& box, const Rational& factor) {
  if (box.contacts.empty()) return std::nullopt;
  const Spread spread = spread_of(box);
  Rational force = 0;
  for (std::size_t j = 0; j < box.wrench.size(); ++j) {
    const Interval& w = box.wrench[j];
    if (!is_rotation(box, j)) {
      force += most_of(w);
    } else {
      force += (box.mechanism ? most_of(w) : Rational((w.high - w.low) / 2)) / spread.half;
    }
  }
  if (!box.mechanism) {
    for (const Rational& torque : torque_about(spread.centre, box.wrench)) {
      force += abs(torque) / spread.half;
    }
  }
  if (box.ball) force += box.ball->radius * (1 + box.ball->length / spread.half);
  Rational softest = box.contacts.front().stiffness.low;
  for (const UncertainContact& c : box.contacts) {
    force += c.preload.high;
    softest = std::min(softest, c.stiffness.low);
  }
  for (const Spring& spring : box.springs) {
    force += most_of(spring.force);
    if (spring.stiffness.low.sign() > 0) softest = std::min(softest, spring.stiffness.low);
  }
  if (force.is_zero()) return std::nullopt;
  const Rational pressed = factor * force / softest;
  RationalRow bound;
  for (std::size_t j = 0; j < box.wrench.size(); ++j) {
    bound.push_back(in_two_digits(
        is_rotation(box, j) ? Rational(pressed / spread.half)
                            : Rational(pressed * (1 + spread.farthest / spread.half))));
  }
  return bound;
}

Rational characteristic_length(const GraspBox& box) {
  return in_two_digits(spread_of(box).half);
}

GraspBox grown(GraspBox box, const RationalRow& load, const std::vector<Rational>& preloads) {
  const auto add = [](Interval& number, const Rational& more) {
    number.low += more;
    number.high += more;
  };
  for (std::size_t j = 0; j < load.size(); ++j) add(box.wrench[j], load[j]);
  for (std::size_t i = 0; i < preloads.size(); ++i) {
    const std::size_t spring = i - std::min(i, box.contacts.size());
    add(i < box.contacts.size() ? box.contacts[i].preload : box.springs[spring].force,
        preloads[i]);
  }
  return box;
}

}  // namespace stickslip
