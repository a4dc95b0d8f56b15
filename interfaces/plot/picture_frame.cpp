// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_frame.hpp"

#include <algorithm>
#include <cstdio>

namespace stickslip::plot_detail {
namespace {

constexpr std::size_t kFarAway = 2;  ///< sizes of the grasp

Vector2 difference(const Vector2& a, const Vector2& b) {
  return {a.x - b.x, a.y - b.y};
}

/// Returns the largest power of ten that is not above `value` > 0.
Rational power_of_ten_below(const Rational& value) {
  // The number of digits gives the power of ten to within one.
  const auto digits = [](const Integer& n) { return static_cast<long>(n.str().size()); };
  const long exponent = digits(numerator(value)) - digits(denominator(value)) + 1;
  const Integer power = pow(Integer(10), static_cast<unsigned>(std::abs(exponent)));
  Rational ten = exponent >= 0 ? Rational(power) : Rational(Integer(1), power);
  while (ten > value) ten /= 10;
  return ten;
}

/// Returns the nearest number of four significant digits; of two, the one away from 0.
Rational few_digits(const Rational& value) {
  if (value.is_zero()) return 0;
  const Rational size = abs(value);
  const Rational unit = power_of_ten_below(size) / 1000;
  const Rational units = size / unit + Rational(1, 2);
  const Rational rounded = unit * Rational(numerator(units) / denominator(units));
  return value.sign() < 0 ? Rational(-rounded) : rounded;
}

/// Returns the decimal text of a number of four significant digits.
std::string decimal(const Rational& value) {
  const std::string text = to_readable_string(value);
  if (text.find('/') == std::string::npos) return text;
  char digits[16];
  std::snprintf(digits, sizeof digits, "%.4g", to_double(value));
  return digits;
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

Surroundings surroundings(const std::vector<std::vector<Rational>>& points, std::size_t axes) {
  Surroundings found{std::vector<Rational>(axes)};
  if (points.empty()) return found;
  std::vector<Rational> middle(axes);
  Rational size = 0;
  Rational distance = 0;  // the distance of the middle
  for (std::size_t j = 0; j < axes; ++j) {
    const auto [low, high] =
        std::minmax_element(points.begin(), points.end(),
                            [j](const auto& a, const auto& b) { return a[j] < b[j]; });
    middle[j] = ((*low)[j] + (*high)[j]) / 2;
    size = std::max(size, Rational((*high)[j] - middle[j]));
    distance = std::max(distance, Rational(abs(middle[j])));
  }
  if (!size.is_zero() && distance > kFarAway * size) found.centre = middle;
  Rational radius = 0;
  for (const std::vector<Rational>& p : points) {
    for (std::size_t j = 0; j < axes; ++j) {
      radius = std::max(radius, Rational(abs(p[j] - found.centre[j])));
    }
  }
  if (!radius.is_zero()) found.radius = radius;
  return found;
}

PictureFrame picture_frame(const Grasp& grasp) {
  std::vector<std::vector<Rational>> points;
  for (const Contact& c : grasp.contacts()) points.push_back({c.position.x, c.position.y});
  for (const Polygon& polygon : grasp.description().outline) {
    for (const Ring& ring : polygon) {
      for (const Vector2& p : ring) points.push_back({p.x, p.y});
    }
  }
  const Surroundings around = surroundings(points, 2);
  return {{around.centre[0], around.centre[1]}, around.radius};
}

Rational round_down(const Rational& value) {
  const Rational ten = power_of_ten_below(value);
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

std::vector<std::string> point_labels(const std::vector<std::array<Rational, 2>>& points) {
  bool in_fractions = true;
  for (const auto& point : points) {
    for (const Rational& x : point) {
      in_fractions = in_fractions && short_text(x).find_first_of(".e") == std::string::npos;
    }
  }
  std::vector<std::string> labels;
  for (const auto& [x, y] : points) {
    const Rational near[] = {in_fractions ? x : few_digits(x),
                             in_fractions ? y : few_digits(y)};
    const auto text = [&](const Rational& value) {
      return typeset(in_fractions ? to_readable_string(value) : decimal(value));
    };
    labels.push_back((near[0] == x && near[1] == y ? "" : std::string(1, kRounded)) + "(" +
                     text(near[0]) + ", " + text(near[1]) + ")");
  }
  return labels;
}

std::string force_unit(const std::optional<Units>& units) {
  return units ? " " + units->force : "";
}

std::string length_unit(const std::optional<Units>& units) {
  return units ? " " + units->length : "";
}

std::string torque_unit(const std::optional<Units>& units) {
  return units ? " " + units->torque() : "";
}

}  // namespace stickslip::plot_detail
