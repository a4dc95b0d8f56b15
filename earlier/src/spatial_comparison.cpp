// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "stickslip/core/error.hpp"
#include "stickslip/earlier/comparison.hpp"

namespace stickslip {
namespace {

constexpr const char* kWeak = "weakly-stable-load";
constexpr const char* kStrong = "strongly-stable-load";

Json spatial_forces_json(const GraspBox& grasp, const SpatialForces& forces) {
  Json json = Json::array();
  for (std::size_t i = 0; i < forces.size(); ++i) {
    Vector3 force = forces[i].friction;
    for (std::size_t j = 0; j < 3; ++j) {
      force[j] += forces[i].normal * grasp.contacts[i].normal[j];
    }
    json.push_back(number_json(force));
  }
  return json;
}

MethodRow spatial_row(const std::string& method, const std::string& verdict,
                      const std::string& why, Json evidence) {
  return {method, "Pang and Trinkle 2000", true, verdict, why, std::move(evidence), {}};
}

MethodRow weak_row(const GraspBox& grasp, const SpatialLoadClass& weak, NumberText& text) {
  const std::string name = "weakly stable load";
  if (const auto* forces = std::get_if<SpatialForces>(&weak)) {
    return spatial_row(name, "stable", "forces in the cones would balance the load",
                       {{"forces", spatial_forces_json(grasp, *forces)}});
  }
  if (const auto* motion = std::get_if<SpatialUnopposedMotion>(&weak)) {
    return spatial_row(name, "unstable",
                       "no force in the cones opposes the load along " +
                           text.direction(motion->twist),
                       {{"motion", number_json(motion->twist)}});
  }
  const auto& undecided = std::get<Undecided>(weak);
  return spatial_row(name, kNotComputed, in_words(undecided), {{"limit", undecided.limit}});
}

MethodRow strong_row(const GraspBox& grasp, const SpatialRigidVerdict& verdict,
                     NumberText& text) {
  const std::string name = "strongly stable load";
  if (const auto* stable = std::get_if<SpatialStronglyStable>(&verdict)) {
    const auto cases = std::count_if(
        stable->tree.begin(), stable->tree.end(),
        [](const SpatialNode& node) { return std::holds_alternative<SpatialLeaf>(node); });
    return spatial_row(name, "stable",
                       "rigid contacts leave no acceleration (" + std::to_string(cases) +
                           (cases == 1 ? " leaf refuted)" : " leaves refuted)"),
                       {{"forces", spatial_forces_json(grasp, stable->rest)}, {"cases", cases}});
  }
  if (const auto* open = std::get_if<SpatialOpenLoad>(&verdict)) {
    return spatial_row(
        name, "unstable", "rigid contacts allow the acceleration " + text(open->acceleration),
        {{"acceleration", number_json(open->acceleration)},
         {"forces", spatial_forces_json(grasp, open->forces)}});
  }
  if (std::holds_alternative<SpatialUnopposedMotion>(verdict)) {
    return spatial_row(name, "unstable", "the load is not weakly stable", Json::object());
  }
  const auto& undecided = std::get<Undecided>(verdict);
  return spatial_row(name, kNotComputed, in_words(undecided), {{"limit", undecided.limit}});
}

SpatialLoadClass weak_of(const GraspBox& grasp, const SpatialRigidVerdict* verdict) {
  if (verdict != nullptr) {
    if (const auto* motion = std::get_if<SpatialUnopposedMotion>(verdict)) return *motion;
    if (const auto* stable = std::get_if<SpatialStronglyStable>(verdict)) return stable->rest;
    if (const auto* open = std::get_if<SpatialOpenLoad>(verdict)) return open->rest;
  }
  return weakly_stable_load(grasp);
}

}  // namespace

Comparison compare_methods(const GraspBox& grasp, const std::vector<std::string>& methods,
                           const SpatialInertia& inertia, NumberText& text,
                           const SpatialRigidVerdict* verdict) {
  for (const std::string& word : methods) {
    if (word != kWeak && word != kStrong) {
      throw InputError("", "methods", word + " is done in the plane only, and the grasp is in "
                                             "space",
                       std::string("ask for ") + kWeak + " and " + kStrong);
    }
  }
  const auto asked = [&](const char* word) {
    return methods.empty() || std::find(methods.begin(), methods.end(), word) != methods.end();
  };
  Comparison result;
  std::optional<SpatialRigidVerdict> found;
  if (asked(kStrong)) {
    if (verdict == nullptr) verdict = &found.emplace(rigid_verdict(grasp, inertia));
    result.methods.push_back(strong_row(grasp, *verdict, text));
    if (const auto* undecided = std::get_if<Undecided>(verdict)) {
      result.undecided = *undecided;
    } else {
      result.load_class = name_of(*verdict);
    }
  }
  if (asked(kWeak)) {
    const SpatialLoadClass weak = weak_of(grasp, verdict);
    result.methods.push_back(weak_row(grasp, weak, text));
    if (std::holds_alternative<SpatialUnopposedMotion>(weak)) result.load_class = "must move";
    if (const auto* undecided = std::get_if<Undecided>(&weak)) result.undecided = *undecided;
  }
  return result;
}

}  // namespace stickslip
