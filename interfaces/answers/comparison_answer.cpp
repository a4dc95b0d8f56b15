// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/comparison_answer.hpp"

#include <utility>

namespace stickslip {
namespace {

Json class_json(const std::optional<RigidClass>& rigid_class) {
  return rigid_class ? Json(to_string(*rigid_class)) : Json();
}

template <class Range>
Json ranges_json(const Question& question, const Inertia& inertia,
                 const std::vector<Range>& ranges) {
  Json json{{"name", question.description().name},
            {"wrench", number_json(coordinates(question.loaded().wrench))},
            {"inertia", inertia_json(inertia)}};
  if (question.direction) json["direction"] = number_json(*question.direction);
  add_conventions(json, question.description());
  Json& classes = json["classes"] = Json::array();
  for (const Range& range : ranges) {
    classes.push_back({{"class", class_json(range.rigid_class)},
                       {"low", number_json(range.low)},
                       {"high", range.high ? number_json(*range.high) : Json(nullptr)},
                       {"has_low", range.has_low},
                       {"has_high", range.has_high}});
  }
  return json;
}

}  // namespace

Json comparison_json(const Question& question, const Rational& length, const Inertia& inertia,
                     const Comparison& comparison) {
  Json wrench = Json::array();
  for (const Interval& w : question.grasp.wrench()) wrench.push_back(number_json(w.low));
  Json json{{"name", question.description().name},
            {"normal_law", to_string(question.law)},
            {"wrench", std::move(wrench)},
            {"length", number_json(length)},
            {"inertia", inertia_json(inertia)},
            {"class", comparison.load_class ? Json(*comparison.load_class) : Json(nullptr)}};
  if (const auto& undecided = comparison.undecided) {
    json["reason"] = undecided->reason;
    json["limit"] = undecided->limit;
  }
  if (question.is_bounded()) json["max_motion"] = number_json(question.box()->max_motion);
  add_conventions(json, question.description());
  Json& methods = json["methods"] = Json::array();
  for (const MethodRow& row : comparison.methods) {
    methods.push_back({{"method", row.method},
                       {"source", row.source},
                       {"about", row.about_the_load ? "load" : "grasp"},
                       {"verdict", row.verdict},
                       {"agrees", row.agrees ? Json(*row.agrees) : Json(nullptr)},
                       {"why", row.why},
                       {"evidence", row.evidence}});
  }
  return json;
}

Json classes_json(const Question& question, const Inertia& inertia,
                  const std::vector<ClassRange>& ranges) {
  return ranges_json(question, inertia, ranges);
}

Json classes_json(const Question& question, const Inertia& inertia,
                  const std::vector<FactorRange>& ranges) {
  return ranges_json(question, inertia, ranges);
}

}  // namespace stickslip
