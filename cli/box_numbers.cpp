// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_numbers.hpp"

#include "terminal.hpp"

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

std::string uncertain_text(const std::vector<UncertainNumber>& numbers, NumberText& text) {
  if (numbers.empty()) return "";
  std::vector<std::vector<std::string>> rows{{"uncertain", "from", "to"}};
  for (const UncertainNumber& number : numbers) {
    rows.push_back({number.label(), text(number.interval.low), text(number.interval.high)});
  }
  return short_table(rows) + "\n";
}

std::string short_table(std::vector<std::vector<std::string>> rows) {
  constexpr std::size_t kMostRows = 12;
  const std::size_t left_out = rows.size() - 1 > kMostRows ? rows.size() - 1 - kMostRows : 0;
  rows.resize(rows.size() - left_out);
  std::string text;
  std::string table = format_table(rows, Align::kLeft);
  for (std::size_t begin = 0; begin < table.size();) {
    const std::size_t end = table.find('\n', begin) + 1;
    text += "  " + table.substr(begin, end - begin);
    begin = end;
  }
  if (left_out > 0) text += "  and " + std::to_string(left_out) + " more, which --json lists\n";
  return text;
}

}  // namespace stickslip
