// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/comparison_answer.hpp"

#include <utility>

#include "stickslip/core/error.hpp"
#include "stickslip/core/motion_bound.hpp"
#include "stickslip/interfaces/option_text.hpp"

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

void require_positive(const std::string& option, const Rational& number, const char* remedy) {
  if (number.sign() > 0) return;
  throw InputError("", option, "there is the value " + to_string(number), remedy);
}

}  // namespace

ComparisonAsked comparison_asked(const ComparisonText& text) {
  ComparisonAsked asked;
  CompareOptions& options = asked.options;
  try {
    check_methods(text.methods);
  } catch (const InputError& error) {
    throw in_options(error, "");
  }
  options.methods = text.methods;
  options.edges = text.edges;
  if (!text.max_force.empty()) {
    options.most_forces = rationals_at("--max-force", text.max_force);
    for (const Rational& f : options.most_forces) {
      require_positive("--max-force", f, "a largest force must be above 0");
    }
  }
  if (!text.accuracy.empty()) options.accuracy = accuracy_option(text.accuracy);
  if (!text.length.empty()) {
    asked.length = rational_at("--length", text.length);
    require_positive("--length", *asked.length, "a characteristic length must be above 0");
  }
  if (!text.inertia.empty()) asked.inertia = inertia_numbers("--inertia", text.inertia);
  return asked;
}

CompareOptions options_for(const ComparisonAsked& asked, const Question& question) {
  CompareOptions options = asked.options;
  const bool in_space = question.in_space();
  options.length =
      asked.length ? *asked.length : characteristic_length(question.grasp.as_box());
  options.inertia = asked.inertia ? inertia_of("--inertia", *asked.inertia, in_space)
                                  : Inertia::of_length(options.length, in_space);
  return options;
}

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
