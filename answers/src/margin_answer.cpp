// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/answers/margin_answer.hpp"

namespace stickslip {
namespace {

Json number_or_null(const std::optional<Rational>& number) {
  return number ? number_json(*number) : Json();
}

Json preload_direction_json(const PreloadDirection& direction) {
  if (direction.scale) return "scale";
  Json json = Json::array();
  for (const Rational& rate : direction.rates) json.push_back(number_json(rate));
  return json;
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
  add_units(json, about.units);
  json["normal_law"] = to_string(question.law);
  json["wrench"] = wrench_json(wrench_of(question.grasp));
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
