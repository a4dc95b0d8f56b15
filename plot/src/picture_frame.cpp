// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_frame.hpp"

#include <algorithm>

namespace stickslip::plot_detail {
namespace {

constexpr std::size_t kFarAway = 2;  ///< sizes of the grasp

Vector2 difference(const Vector2& a, const Vector2& b) {
  return {a.x - b.x, a.y - b.y};
}

}  // namespace

Rational largest_entry(const Vector2& vector) {
  return std::max(Rational(abs(vector.x)), Rational(abs(vector.y)));
}

InkPoint ratio(const Vector2& vector, const Rational& size) {
  return {to_double(vector.x / size), to_double(vector.y / size)};
}

InkPoint direction(const Vector2& vector) {
  return unit(ratio(vector, largest_entry(vector)));
}

InkPoint PictureFrame::place(const Vector2& point) const {
  return ratio(difference(point, centre), radius);
}

Grasp PictureFrame::in_scene(const Grasp& grasp) const {
  const auto move = [&](Vector2& point) {
    point = difference(point, centre);
    point.x /= radius;
    point.y /= radius;
  };
  std::vector<Contact> contacts = grasp.contacts();
  for (Contact& c : contacts) move(c.position);
  GraspDescription description = grasp.description();
  for (Polygon& polygon : description.outline) {
    for (Ring& ring : polygon) std::for_each(ring.begin(), ring.end(), move);
  }
  return Grasp(std::move(contacts), std::move(description));
}

PictureFrame picture_frame(const Grasp& grasp) {
  PictureFrame frame;
  std::vector<Vector2> points;
  for (const Contact& c : grasp.contacts()) points.push_back(c.position);
  for (const Polygon& polygon : grasp.description().outline) {
    for (const Ring& ring : polygon) points.insert(points.end(), ring.begin(), ring.end());
  }
  if (points.empty()) return frame;
  Vector2 low = points.front();
  Vector2 high = low;
  for (const Vector2& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const Vector2 middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
  const Rational size = largest_entry(difference(high, middle));
  const bool in_one_place = size.is_zero();
  if (!in_one_place && largest_entry(middle) > kFarAway * size) frame.centre = middle;
  Rational radius = 0;
  for (const Vector2& p : points) {
    radius = std::max(radius, largest_entry(difference(p, frame.centre)));
  }
  if (!radius.is_zero()) frame.radius = radius;
  return frame;
}

Rational round_down(const Rational& value) {
  // The number of digits gives the power of ten to within one.
  const auto digits = [](const Integer& n) { return static_cast<long>(n.str().size()); };
  const long exponent = digits(numerator(value)) - digits(denominator(value)) + 1;
  const Integer power = pow(Integer(10), static_cast<unsigned>(std::abs(exponent)));
  Rational ten = exponent >= 0 ? Rational(power) : Rational(Integer(1), power);
  while (ten > value) ten /= 10;
  for (const int factor : {5, 2}) {
    if (factor * ten <= value) return factor * ten;
  }
  return ten;
}

std::string typeset(std::string text) {
  for (std::size_t at = 0; (at = text.find('-', at)) != std::string::npos;) {
    text.replace(at, 1, "\u2212");
  }
  return text;
}

std::string short_text(const Rational& value) {
  return typeset(to_readable_string(value));
}

std::string short_tuple(const std::vector<Rational>& values) {
  std::string text;
  for (const Rational& value : values) {
    text += (text.empty() ? "(" : ", ") + short_text(value);
  }
  return text + ")";
}

std::string force_unit(const Grasp& grasp) {
  const std::optional<Units>& units = grasp.description().units;
  return units ? " " + units->force : "";
}

std::string length_unit(const Grasp& grasp) {
  const std::optional<Units>& units = grasp.description().units;
  return units ? " " + units->length : "";
}

std::string torque_unit(const Grasp& grasp) {
  const std::optional<Units>& units = grasp.description().units;
  return units ? " " + units->torque() : "";
}

}  // namespace stickslip::plot_detail
