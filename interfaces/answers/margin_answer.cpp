// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/margin_answer.hpp"

#include "stickslip/engine/second_question.hpp"

namespace stickslip {

namespace {

Json number_or_null(const std::optional<Rational>& number) {
  return number ? number_json(*number) : Json();
}

Json multiples_json(const std::vector<MarginInterval>& multiples) {
  Json json = Json::array();
  for (const auto& [low, high] : multiples) {
    json.push_back({number_json(low), number_or_null(high)});
  }
  return json;
}

Json head_json(const Question& question) {
  const GraspDescription& about = question.description();
  Json json;
  json["name"] = about.name;
  if (!question.case_name.empty()) json["case"] = question.case_name;
  add_conventions(json, about);
  json["normal_law"] = to_string(question.law);
  json["wrench"] = wrench_json(question.grasp.wrench());
  if (question.is_bounded()) json["max_motion"] = number_json(question.box()->max_motion);
  if (question.direction) json["direction"] = number_json(*question.direction);
  if (question.preload_direction) {
    json["preload_direction"] = preload_direction_json(*question.preload_direction);
  }
  return json;
}

void add_ends(Json& json, const std::vector<MarginInterval>& resisted) {
  json["least"] = resisted.empty() ? Json() : number_json(resisted.front().low);
  json["unbounded"] = !resisted.empty() && !resisted.back().high;
}

}  // namespace

Json preload_direction_json(const PreloadDirection& direction) {
  return direction.scale ? Json("scale") : number_json(direction.preloads);
}

std::optional<SecondMargin> margin_within(
    const Question& question, const SpatialMargin& margin, const SpatialMarginOptions& options,
    const std::function<void(const SpatialMargin&)>& progress) {
  SecondMargin within{question, {}};
  auto opposed = opposed_direction(question);
  if (!opposed && (!margin.ended_far || question.is_bounded())) return std::nullopt;
  if (opposed) within.question.direction = std::move(opposed);
  if (!question.is_bounded()) {
    GraspBox box = question.grasp.as_box();
    const auto bound = natural_bound(
        grown(box, question.direction.value_or(RationalRow{}), question.preload_growth),
        kFarMotion);
    if (!bound) return std::nullopt;
    box.max_motion = *bound;
    within.question.grasp = std::move(box);
  }
  within.margin = find_spatial_margin(within.question, options, progress);
  return within;
}

void add_within(Json& json, const SecondMargin& within) {
  Json& second = json["within"] = Json::object();
  if (within.question.is_bounded()) {
    second["max_motion"] = number_json(within.question.box()->max_motion);
  }
  if (within.question.direction) second["direction"] = number_json(*within.question.direction);
  second["resisted"] = multiples_json(within.margin.resisted());
  second["refuted"] = multiples_json(within.margin.refuted());
  second["stats"] = work_json(within.margin.work);
}

std::optional<Rational> least(const Margin& margin) {
  if (margin.resisted.empty()) return std::nullopt;
  return margin.resisted.front().low;
}

Json margin_json(const Question& question, const Margin& margin, const MarginWork& work,
                 const Warnings& warnings) {
  Json json = head_json(question);
  json["resisted"] = multiples_json(margin.resisted);
  add_ends(json, margin.resisted);
  if (warnings) json["warnings"] = warnings_json(*warnings);
  Json& stats = json["stats"] = Json::object();
  stats["ranges"] = work.ranges;
  stats["mode_programs"] = work.modes;
  for (const auto& [name, value] : counters(work.cone)) stats[name] = value;
  return json;
}

Json margin_json(const Question& question, const SpatialMargin& margin,
                 const Warnings& warnings) {
  Json json = head_json(question);
  const std::vector<MarginInterval> resisted = margin.resisted();
  json["resisted"] = multiples_json(resisted);
  json["refuted"] = multiples_json(margin.refuted());
  add_ends(json, resisted);
  if (warnings) json["warnings"] = warnings_json(*warnings);
  json["stats"] = work_json(margin.work);
  return json;
}

}  // namespace stickslip
