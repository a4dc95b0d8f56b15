// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/answers/uncertain_numbers.hpp"

#include <algorithm>
#include <utility>

namespace stickslip {

std::vector<UncertainNumber> uncertain_numbers(const GraspBox& box) {
  std::vector<UncertainNumber> all;
  const auto add = [&](const std::string& place, const Interval& interval,
                       bool is_slope = false) {
    if (!interval.is_point()) all.push_back({place, interval, is_slope});
  };
  for (std::size_t i = 0; i < box.contacts.size(); ++i) {
    const UncertainContact& c = box.contacts[i];
    const std::string contact = "contacts[" + std::to_string(i) + "].";
    add(contact + "position[0]", c.x);
    add(contact + "position[1]", c.y);
    add(contact + "normal", {-c.slope, c.slope}, true);
    add(contact + "friction", c.friction);
    add(contact + "stiffness", c.stiffness);
    add(contact + "preload", c.preload);
  }
  for (std::size_t j = 0; j < box.wrench.size(); ++j) {
    add("wrench[" + std::to_string(j) + "]", box.wrench[j]);
  }
  return all;
}

std::vector<UncertainNumber> uncertain_numbers(const SpatialGrasp& box) {
  std::vector<UncertainNumber> all;
  for_each_number(box, [&](const std::string& place, const Interval& interval) {
    if (!interval.is_point()) all.push_back({place, interval});
  });
  return all;
}

std::vector<Rational> values_in(const GraspBox& box, const LoadedGrasp& loaded) {
  std::vector<Rational> values;
  const auto add = [&](const Interval& interval, const Rational& value) {
    if (!interval.is_point()) values.push_back(value);
  };
  for (std::size_t i = 0; i < box.contacts.size(); ++i) {
    const UncertainContact& c = box.contacts[i];
    const Contact& at = loaded.grasp.contacts()[i];
    const Vector2& n = c.normal;
    const Rational along = n.x * at.normal.x + n.y * at.normal.y;
    const Rational across = n.x * at.normal.y - n.y * at.normal.x;
    add(c.x, at.position.x);
    add(c.y, at.position.y);
    add({-c.slope, c.slope}, across / along);
    add(c.friction, at.friction);
    add(c.stiffness, at.stiffness);
    add(c.preload, at.preload);
  }
  const Vector3 w = coordinates(loaded.wrench);
  for (std::size_t j = 0; j < w.size(); ++j) add(box.wrench[j], w[j]);
  return values;
}

std::vector<Rational> values_in(const SpatialGrasp& box, const SpatialGrasp& grasp) {
  std::vector<bool> is_uncertain;
  for_each_number(box, [&](const std::string& /*place*/, const Interval& interval) {
    is_uncertain.push_back(!interval.is_point());
  });
  std::vector<Rational> values;
  std::size_t next = 0;
  for_each_number(grasp, [&](const std::string& /*place*/, const Interval& interval) {
    if (is_uncertain[next++]) values.push_back(interval.low);
  });
  return values;
}

std::vector<Difference> differences(std::vector<UncertainNumber> numbers,
                                    const std::vector<Rational>& stable,
                                    const std::vector<Rational>& unstable) {
  std::vector<Difference> all;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (stable[i] != unstable[i]) {
      all.push_back({std::move(numbers[i]), stable[i], unstable[i]});
    }
  }
  const auto part = [](const Difference& d) {
    return Rational(abs(d.unstable - d.stable) /
                    (d.number.interval.high - d.number.interval.low));
  };
  std::stable_sort(all.begin(), all.end(),
                   [&](const Difference& a, const Difference& b) { return part(a) > part(b); });
  return all;
}

Json differences_json(const std::vector<Difference>& differences) {
  Json json = Json::array();
  for (const Difference& d : differences) {
    json.push_back({{"place", d.number.place},
                    {"stable", number_json(d.stable)},
                    {"unstable", number_json(d.unstable)}});
  }
  return json;
}

Json interval_json(const Interval& interval) {
  if (interval.is_point()) return number_json(interval.low);
  return Json::array({number_json(interval.low), number_json(interval.high)});
}

Json uncertain_json(const std::vector<UncertainNumber>& numbers) {
  Json json = Json::array();
  for (const UncertainNumber& number : numbers) {
    json.push_back({{"place", number.place},
                    {number.is_slope ? "slope" : "interval",
                     number.is_slope ? number_json(number.interval.high)
                                     : interval_json(number.interval)}});
  }
  return json;
}

}  // namespace stickslip
