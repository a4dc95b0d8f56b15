// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_model.hpp"

#include <cmath>
#include <utility>

#include "stickslip/core/contact_row.hpp"

namespace stickslip::box_detail {
namespace {

CornerPairs make_pairs(std::size_t dimensions) {
  const std::size_t corners = std::size_t{1} << dimensions;
  CornerPairs result{corners, 1, {}, {}};
  for (std::size_t k = 0; k < dimensions; ++k) result.cells *= 3;
  std::vector<std::size_t> count(result.cells, 0);
  for (std::size_t a = 0; a < corners; ++a) {
    for (std::size_t b = 0; b < corners; ++b) {
      std::size_t cell = 0;
      for (std::size_t k = dimensions; k-- > 0;) cell = 3 * cell + (a >> k & 1) + (b >> k & 1);
      result.cell.push_back(cell);
      ++count[cell];
    }
  }
  for (const std::size_t n : count) result.share.push_back(corners / n);
  return result;
}

/// The ends of an interval, or its only number.
std::vector<Rational> ends(const Interval& interval) {
  if (interval.is_point()) return {interval.low};
  return {interval.low, interval.high};
}

Integer common_denominator(const std::vector<Rational>& values) {
  Integer common = 1;
  for (const Rational& value : values) common = lcm(common, denominator(value));
  return common;
}

Integer times(const Rational& value, const Integer& factor) {
  return numerator(value) * (factor / denominator(value));
}

template <std::size_t n>
void add_once(std::vector<IntegerVector<n>>& planes, IntegerVector<n> plane) {
  if (std::find(planes.begin(), planes.end(), plane) == planes.end()) {
    planes.push_back(std::move(plane));
  }
}

const Interval& interval(const ParameterContact& contact, Parameter parameter) {
  return contact.parameters[static_cast<std::size_t>(parameter)];
}

/// The contact at each corner of its geometry: x, y and turn, the last of these slowest.
std::vector<Contact> corners_of(const ParameterContact& contact) {
  std::vector<Contact> corners;
  for (const Rational& e : ends(interval(contact, Parameter::kTurn))) {
    for (const Rational& y : ends(interval(contact, Parameter::kY))) {
      for (const Rational& x : ends(interval(contact, Parameter::kX))) {
        corners.push_back({{x, y}, turned(contact.normal, e)});
      }
    }
  }
  return corners;
}

}  // namespace

const CornerPairs& CornerPairs::of(std::size_t dimensions) {
  static const std::array<CornerPairs, 4> kPairs{make_pairs(0), make_pairs(1), make_pairs(2),
                                                 make_pairs(3)};
  return kPairs[dimensions];
}

BoxContact::BoxContact(const ParameterContact& contact) {
  const Interval& friction = interval(contact, Parameter::kFriction);
  const Interval& preload = interval(contact, Parameter::kPreload);
  const Interval& stiffness = interval(contact, Parameter::kStiffness);
  std::vector<Wrench> normals;
  std::vector<Wrench> tangents;
  std::vector<Rational> entries;
  for (const Contact& corner : corners_of(contact)) {
    normals.push_back(normal_row(corner));
    tangents.push_back(tangent_row(corner));
    for (const Wrench* row : {&normals.back(), &tangents.back()}) {
      for (const Rational& entry : coordinates(*row)) entries.push_back(entry);
    }
  }
  exact.length = common_denominator(entries);
  exact.cone = common_denominator({friction.low, friction.high});
  exact.law = common_denominator({preload.low, preload.high, stiffness.low, stiffness.high});
  const auto scaled = [&](const Wrench& row) -> IntegerVector3 {
    return {times(row.x, exact.length), times(row.y, exact.length),
            times(row.torque, exact.length)};
  };
  for (const Wrench& row : normals) exact.normals.push_back(scaled(row));
  for (const Wrench& row : tangents) exact.tangents.push_back(scaled(row));
  exact.frictions = {times(friction.low, exact.cone), times(friction.high, exact.cone)};
  exact.preloads = {times(preload.low, exact.law) * exact.length,
                    times(preload.high, exact.law) * exact.length};
  exact.stiffnesses = {times(stiffness.low, exact.law), times(stiffness.high, exact.law)};
  weight = Rational(1) / Rational(exact.length * exact.length * exact.cone * exact.law *
                                  Integer(normals.size()));
  for (std::size_t c = 0; c < normals.size(); ++c) {
    const Wrench& t = tangents[c];
    add_once(slips, primitive_multiple<5>({t.x, t.y, t.torque, 0, 0}));
    const Wrench& n = normals[c];
    for (const Rational& p : ends(preload)) {
      for (const Rational& k : ends(stiffness)) {
        add_once(separations, primitive_multiple<5>({-k * n.x, -k * n.y, -k * n.torque, p, 0}));
      }
    }
  }
}

BoxModel::BoxModel(const ParameterBox& box)
    : wrench(box.wrench()), law(box.law()), is_point(box.is_point()) {
  for (const ParameterContact& contact : box.contacts()) contacts.emplace_back(contact);
  double farthest = 0;
  for (const ParameterContact& contact : box.contacts()) {
    for (const Contact& corner : corners_of(contact)) {
      farthest = std::max({farthest, std::fabs(to_double(corner.position.x)),
                           std::fabs(to_double(corner.position.y))});
    }
  }
  if (farthest > 0 && std::isfinite(farthest)) length = farthest;
  const auto row = [&](const Wrench& w) -> std::array<double, 3> {
    return {to_double(w.x), to_double(w.y), to_double(w.torque) / length};
  };
  double largest = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const ParameterContact& contact = box.contacts()[i];
    ContactNumbers<double>& rounded = contacts[i].rounded;
    for (const Contact& corner : corners_of(contact)) {
      rounded.normals.push_back(row(normal_row(corner)));
      rounded.tangents.push_back(row(tangent_row(corner)));
    }
    const auto both = [&](Parameter parameter) -> std::array<double, 2> {
      const Interval& range = interval(contact, parameter);
      return {to_double(range.low), to_double(range.high)};
    };
    rounded.frictions = both(Parameter::kFriction);
    rounded.preloads = both(Parameter::kPreload);
    rounded.stiffnesses = both(Parameter::kStiffness);
    rounded.length = rounded.cone = rounded.law = 1;
    const auto& n = rounded.normals.front();
    largest = std::max(largest, rounded.preloads[1] * std::hypot(n[0], n[1]));
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const double scale = j == 2 ? length : 1;
    load[j] = {to_double(wrench[j].low) / scale, to_double(wrench[j].high) / scale};
    largest = std::max({largest, std::fabs(load[j][0]), std::fabs(load[j][1])});
  }
  if (largest > 0 && std::isfinite(largest)) force = largest;
  const auto check = [&](double entry) {
    constexpr double kLeast = 0x1p-200;
    constexpr double kMost = 0x1p200;
    const double size = std::fabs(entry);
    if (size != 0 && !(size >= kLeast && size <= kMost)) is_moderate = false;
  };
  // What a rational number that is not 0 has become.
  const auto check_exact = [&](const Rational& value) {
    const double entry = to_double(value);
    if (entry == 0 && !value.is_zero()) is_moderate = false;
    check(entry);
  };
  check(length);
  for (const Interval& component : wrench) {
    check_exact(component.low);
    check_exact(component.high);
  }
  for (const ParameterContact& contact : box.contacts()) {
    for (const Interval& range : contact.parameters) {
      check_exact(range.low);
      check_exact(range.high);
    }
    for (const Contact& corner : corners_of(contact)) {
      for (const Wrench& w : {normal_row(corner), tangent_row(corner)}) {
        for (const Rational& entry : coordinates(w)) check_exact(entry);
      }
    }
  }
}

}  // namespace stickslip::box_detail
