// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/uncertain_numbers.hpp"

#include <algorithm>
#include <utility>

#include "stickslip/engine/box_verdict.hpp"

namespace stickslip {

namespace {

/// Returns all numbers of a box, certain ones too.
std::vector<UncertainNumber> numbers_of(const GraspBox& box) {
  std::vector<UncertainNumber> all;
  for (std::size_t i = 0; i < box.contacts.size(); ++i) {
    const UncertainContact& c = box.contacts[i];
    const std::string contact = "contacts[" + std::to_string(i) + "].";
    for (std::size_t j = 0; j < c.position.size(); ++j) {
      all.push_back({contact + "position[" + std::to_string(j) + "]", c.position[j]});
    }
    if (box.in_space()) {
      const std::vector<Turn> turns = turns_of(c);
      for (const std::size_t k : {0U, 1U}) {
        all.push_back({contact + (k == 0 ? "normal.turn_u" : "normal.turn_v"),
                       {-turns[k].most, turns[k].most},
                       k + 1});
      }
    } else {
      all.push_back({contact + "normal", {-c.slope, c.slope}, 1});
    }
    all.push_back({contact + "friction", c.friction});
    all.push_back({contact + "stiffness", c.stiffness});
    all.push_back({contact + "preload", c.preload});
  }
  for (const Spring& spring : box.springs) {
    all.push_back({spring.place + ".stiffness", spring.stiffness});
    all.push_back({spring.place + "." + force_name(spring), spring.force});
  }
  const WrenchBox loads = loads_of(box);
  for (std::size_t j = 0; j < loads.size(); ++j) {
    all.push_back({"wrench[" + std::to_string(j) + "]", loads[j]});
  }
  return all;
}

/// Returns by how much a grasp has turned the normal of a contact of the box, this way.
Rational turn_of(const UncertainContact& c, const RationalRow& turned, std::size_t way) {
  const RationalRow across = turns_of(c)[way].direction;
  return dot(across, turned) * dot(c.normal, c.normal) /
         (dot(c.normal, turned) * dot(across, across));
}

}  // namespace

std::vector<UncertainNumber> uncertain_numbers(const GraspBox& box) {
  std::vector<UncertainNumber> all = numbers_of(box);
  all.erase(std::remove_if(all.begin(), all.end(),
                           [](const UncertainNumber& n) { return n.interval.is_point(); }),
            all.end());
  return all;
}

std::vector<Rational> values_in(const GraspBox& box, const GraspBox& grasp) {
  const std::vector<UncertainNumber> intervals = numbers_of(box);
  const std::vector<UncertainNumber> numbers = numbers_of(grasp);
  std::vector<Rational> values;
  const std::size_t others = box.wrench.size() + 2 * box.springs.size();
  const std::size_t contact_numbers =
      box.contacts.empty() ? 1 : (intervals.size() - others) / box.contacts.size();
  for (std::size_t n = 0; n < intervals.size(); ++n) {
    if (intervals[n].interval.is_point()) continue;
    if (const std::size_t way = intervals[n].turn; way > 0) {
      const std::size_t i = n / contact_numbers;
      values.push_back(turn_of(box.contacts[i], grasp.contacts[i].normal, way - 1));
    } else {
      values.push_back(numbers[n].interval.low);
    }
  }
  return values;
}

std::vector<Difference> differences(const GraspBox& box, const GraspBox& stable,
                                    const GraspBox& unstable) {
  std::vector<UncertainNumber> numbers = uncertain_numbers(box);
  const std::vector<Rational> held = values_in(box, stable);
  const std::vector<Rational> lost = values_in(box, unstable);
  std::vector<Difference> all;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (held[i] != lost[i]) all.push_back({std::move(numbers[i]), held[i], lost[i]});
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

Json wrench_json(const WrenchBox& wrench) {
  Json json = Json::array();
  for (const Interval& w : wrench) json.push_back(interval_json(w));
  return json;
}

Json ball_json(const LoadBall& ball) {
  Json json{{"radius", number_json(ball.radius)}, {"length", number_json(ball.length)}};
  if (!ball.about.empty()) {
    Json& about = json["about"] = Json::array();
    for (const Rational& x : ball.about) about.push_back(number_json(x));
  }
  if (!ball.body.empty()) json["body"] = ball.body;
  return json;
}

Json uncertain_json(const std::vector<UncertainNumber>& numbers) {
  Json json = Json::array();
  for (const UncertainNumber& number : numbers) {
    json.push_back({{"place", number.place},
                    {number.is_turn() ? "slope" : "interval",
                     number.is_turn() ? number_json(number.interval.high)
                                      : interval_json(number.interval)}});
  }
  return json;
}

}  // namespace stickslip
