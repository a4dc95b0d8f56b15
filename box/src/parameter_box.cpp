// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/box/parameter_box.hpp"

#include <algorithm>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

Rational length_squared(const Vector2& n) {
  return n.x * n.x + n.y * n.y;
}

/// 1/|n|, or what it lies between.
Interval inverse_length(const Vector2& normal, unsigned bits) {
  const auto [lower, upper] = short_sqrt(1 / length_squared(normal), bits);
  return {lower, upper};
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

bool ParameterBox::is_point() const {
  const auto certain = [](const Interval& interval) { return interval.is_point(); };
  return std::all_of(wrench_.begin(), wrench_.end(), certain) &&
         std::all_of(contacts_.begin(), contacts_.end(), [&](const ParameterContact& c) {
           return std::all_of(c.parameters.begin(), c.parameters.end(), certain);
         });
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
