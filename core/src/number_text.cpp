// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/number_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

bool holds_numbers(const Json& value) {
  return value.is_exact() ||
         (value.is_array() && std::any_of(value.begin(), value.end(), holds_numbers));
}

/// Returns the double nearest to a decimal or fraction. It does not use parse_rational(), which
/// limits what people write: answers have longer numbers and larger exponents.
double nearest_double(const std::string& text) {
  if (text.find_first_of(".e") == std::string::npos) return to_double(Rational(text));
  double nearest = 0;
  const char* end = text.data() + text.size();
  const auto found = std::from_chars(text.data(), end, nearest);
  require(found.ptr == end, "an answer has numbers of its own form");
  if (found.ec != std::errc::result_out_of_range) return nearest;
  return text.find("e-") == std::string::npos ? HUGE_VAL : 0.0;
}

Json nearest_doubles(const Json& value) {
  if (value.is_exact()) {
    const double nearest = nearest_double(value.text());
    return std::isfinite(nearest) ? Json(nearest) : Json();
  }
  if (!value.is_array()) return value;
  Json doubles = Json::array();
  for (const Json& entry : value) doubles.push_back(nearest_doubles(entry));
  return doubles;
}

}  // namespace

std::string NumberText::operator()(const Rational& value) {
  if (exact_) return to_string(value);
  std::string text = to_readable_string(value);
  has_rounded_ |= text.front() == kRounded;
  return text;
}

std::string NumberText::operator()(const RootSum& value) {
  if (const auto rational = value.rational()) return (*this)(*rational);
  if (exact_) {
    has_enclosed_ = true;
    const DecimalEnclosure enclosure = enclose(value);
    return enclosure.lower + ".." + enclosure.upper;
  }
  has_rounded_ = true;
  return to_readable_string(value);
}

std::string NumberText::tuple(const std::vector<Rational>& v) {
  std::string text;
  for (const Rational& entry : v) text += (text.empty() ? "(" : ", ") + (*this)(entry);
  return text + ")";
}

std::string NumberText::scaled_tuple(std::vector<Rational> v) {
  if (exact_) return tuple(v);
  constexpr int kLargestSmallInteger = 99;
  Rational largest = 0;
  Integer common = 1;
  for (const Rational& entry : v) {
    largest = std::max(largest, Rational(abs(entry)));
    common = lcm(common, denominator(entry));
  }
  if (largest.is_zero()) return tuple(v);
  Integer divisor = 0;
  for (const Rational& entry : v) divisor = gcd(divisor, numerator(Rational(entry * common)));
  const Rational to_integers(common, divisor);
  const Rational scale =
      largest * to_integers <= kLargestSmallInteger ? to_integers : Rational(1 / largest);
  for (Rational& entry : v) entry *= scale;
  return tuple(v);
}

std::string NumberText::note() const {
  std::string text;
  if (has_rounded_) text += "~ marks what is rounded to six digits" + remedy_ + ".\n";
  if (has_enclosed_) text += "a..b encloses an irrational number.\n";
  return text;
}

Json number_json(const Rational& value) {
  return Json::exact(to_string(value));
}

Json decimal_json(const std::string& decimal) {
  return Json::exact(decimal);
}

Json number_json(const DecimalEnclosure& enclosure) {
  return Json::array({Json::exact(enclosure.lower), Json::exact(enclosure.upper)});
}

Json number_json(const std::vector<Integer>& v) {
  return number_json(std::vector<Rational>(v.begin(), v.end()));
}

Json number_json(const RootSum& value) {
  const auto rational = value.rational();
  return rational ? number_json(*rational) : number_json(enclose(value));
}

Json number_json(const std::vector<Rational>& v) {
  Json json = Json::array();
  for (const Rational& entry : v) json.push_back(number_json(entry));
  return json;
}

Json number_json(const Vector2& v) {
  return Json::array({number_json(v.x), number_json(v.y)});
}

Json finished(const Json& tree, bool floats) {
  if (tree.is_exact()) return tree.text();
  if (tree.is_array()) {
    Json result = Json::array();
    for (const Json& value : tree) result.push_back(finished(value, floats));
    return result;
  }
  if (!tree.is_object()) return tree;
  Json result = Json::object();
  for (const auto& [key, value] : tree.members()) {
    result[key] = finished(value, floats);
    if (floats && holds_numbers(value)) result[key + "_float"] = nearest_doubles(value);
  }
  return result;
}

void add_conventions(Json& json, const GraspDescription& description) {
  if (const std::optional<Units>& units = description.units) {
    json["units"] = {{"length", units->length}, {"force", units->force}};
  }
  if (!description.gravity.empty()) json["gravity"] = number_json(description.gravity);
  if (description.rounded_normals.empty()) return;
  Json& normals = json["rounded_normals"] = Json::array();
  for (const RoundedNormal& one : description.rounded_normals) {
    normals.push_back({{"contact", one.contact.index()}, {"angle", number_json(one.degrees)}});
  }
}

}  // namespace stickslip
