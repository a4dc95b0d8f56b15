// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/box/parameter_box.hpp"

#include <algorithm>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

Rational length_squared(const Vector2& n) {
  return n.x * n.x + n.y * n.y;
}

/// The greatest j / 2^s <= sqrt(square) with j of this many bits, and (j + 1) / 2^s.
Interval enclosed_root(const Rational& square, unsigned bits) {
  const Integer& num = numerator(square);
  const Integer& den = denominator(square);
  // 2^s sqrt(square) has j as its whole part: s such that j has the right number of bits is at
  // most one off the difference of the lengths.
  long s = static_cast<long>(bits) -
           (static_cast<long>(msb(num)) - static_cast<long>(msb(den))) / 2 - 1;
  const auto whole = [&](long shift) -> Integer {
    const auto by = static_cast<unsigned long>(std::labs(2 * shift));
    return sqrt(Integer(shift >= 0 ? Integer(num << by) / den : num / Integer(den << by)));
  };
  Integer j = whole(s);
  while (msb(j) + 1 < bits) j = whole(++s);
  while (msb(j) + 1 > bits) j = whole(--s);
  const Integer unit = Integer(1) << static_cast<unsigned long>(std::labs(s));
  const auto scaled = [&](const Integer& n) {
    return s >= 0 ? Rational(n, unit) : Rational(n * unit);
  };
  return {scaled(j), scaled(j + 1)};
}

/// 1/|n|, or what it lies between.
Interval inverse_length(const Vector2& normal, unsigned bits) {
  const Rational square = 1 / length_squared(normal);
  if (const auto root = exact_sqrt(square)) return {*root, *root};
  return enclosed_root(square, bits);
}

ParameterContact parameters_of(const UncertainContact& c, unsigned bits) {
  const Rational shortened = c.slope * c.slope;
  const Rational square = length_squared(c.normal);
  Interval preload;
  if (!c.preload.high.is_zero()) {
    const Interval inverse = inverse_length(c.normal, bits);
    preload = {c.preload.low * (1 - shortened / 2) * inverse.low,
               c.preload.high * inverse.high};
  }
  return {c.normal,
          {c.x,
           c.y,
           {-c.slope, c.slope},
           c.friction,
           preload,
           {c.stiffness.low * (1 - shortened) / square, c.stiffness.high / square}}};
}

}  // namespace

const char* to_string(Parameter parameter) {
  constexpr const char* kNames[] = {"x",       "y",         "turn",  "friction",
                                    "preload", "stiffness", "wrench"};
  return kNames[static_cast<std::size_t>(parameter)];
}

ParameterBox::ParameterBox(const GraspBox& box, NormalLaw law, unsigned bits)
    : wrench_(box.wrench), law_(law) {
  for (const UncertainContact& c : box.contacts) contacts_.push_back(parameters_of(c, bits));
}

const Interval& ParameterBox::interval(Parameter parameter, std::size_t index) const {
  if (parameter == Parameter::kWrench) return wrench_.at(index);
  return contacts_.at(index).parameters[static_cast<std::size_t>(parameter)];
}

std::pair<ParameterBox, ParameterBox> ParameterBox::halves(const PartSplit& split) const {
  const auto half = [&](bool upper) {
    ParameterBox result = *this;
    Interval& cut = split.parameter == Parameter::kWrench
                        ? result.wrench_.at(split.index)
                        : result.contacts_.at(split.index)
                              .parameters[static_cast<std::size_t>(split.parameter)];
    require(cut.low < split.value && split.value < cut.high,
            "a part is cut inside its interval");
    (upper ? cut.low : cut.high) = split.value;
    return result;
  };
  return {half(false), half(true)};
}

ParameterBox ParameterBox::middle() const {
  ParameterBox result = *this;
  const auto shrink = [](Interval& interval) { interval = point_interval(interval.middle()); };
  for (ParameterContact& c : result.contacts_) {
    for (Interval& interval : c.parameters) shrink(interval);
  }
  for (Interval& interval : result.wrench_) shrink(interval);
  return result;
}

bool needs_enclosure(const GraspBox& box) {
  return std::any_of(box.contacts.begin(), box.contacts.end(), [](const UncertainContact& c) {
    return !c.preload.high.is_zero() && !exact_sqrt(length_squared(c.normal));
  });
}

}  // namespace stickslip
