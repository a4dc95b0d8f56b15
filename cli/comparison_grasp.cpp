// SPDX-License-Identifier: GPL-3.0-or-later
// The methods that ask about a grasp, whatever its load.
#include "comparison.hpp"
#include "comparison_text.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/earlier/form_closure.hpp"

namespace stickslip {
namespace {

MethodRow about_grasp(std::string method, const char* source, const char* verdict,
                      std::string why, Json evidence) {
  return {std::move(method),  source, verdict, std::nullopt, false, std::move(why),
          std::move(evidence)};
}

}  // namespace

MethodRow form_closure_row(const Problem& problem, NumberText& text) {
  const char* const source = "Liu 1999";
  const auto result = form_closure(problem);
  if (const auto* found = std::get_if<FormClosure>(&result)) {
    Json multipliers = Json::array();
    for (const Rational& m : found->multipliers) multipliers.push_back(number_json(m));
    return about_grasp("form closure", source, "closed",
                       "the contacts leave no motion, even without friction",
                       {{"multipliers", multipliers},
                        {"spanning",
                         {found->spanning[0].index(), found->spanning[1].index(),
                          found->spanning[2].index()}}});
  }
  const Twist& d = std::get<FreeMotion>(result).twist;
  return about_grasp("form closure", source, "not closed",
                     "the contacts allow the motion " + text.direction(d), motion_json(d));
}

MethodRow wrench_space_row(const Problem& problem, ForceBound bound, const Rational& length,
                           NumberText& text) {
  const std::string method =
      std::string("grasp wrench space, ") + (bound == ForceBound::kL1 ? "L1" : "Linf");
  const char* const source = "Ferrari and Canny 1992";
  if (problem.size() > kMostContactsForWrenchSpace) {
    const std::string limit = std::to_string(kMostContactsForWrenchSpace) + " contacts";
    return about_grasp(method, source, kNotComputed, "beyond " + limit, {{"limit", limit}});
  }
  std::vector<HalfSpace> facets;
  try {
    facets = wrench_space_facets(problem, bound, length);
  } catch (const InputError& error) {
    return about_grasp(method, source, kNotComputed,
                       error.place() + ": " + error.problem() + "; " + error.remedy(),
                       {{"error", error.what()}});
  }
  const GraspQuality quality = ferrari_canny_quality(facets);
  const HalfSpace& nearest = quality.nearest;
  const Twist normal{Rational(nearest.normal[0]), Rational(nearest.normal[1]),
                     Rational(nearest.normal[2])};
  const std::optional<Rational> exact = exact_sqrt(quality.radius_squared);
  Json evidence{{"radius_squared", number_json(quality.radius_squared)}};
  evidence["radius"] =
      exact ? number_json(*exact) : number_json(enclose_sqrt(1, quality.radius_squared));
  evidence["facet"] = {{"normal", number_json(coordinates(normal))},
                       {"offset", number_json(nearest.offset)}};
  evidence["facets"] = facets.size();
  if (bound == ForceBound::kL1) {
    Json& slice = evidence["zero_torque_slice"] = Json::array();
    for (const Vector2& vertex : zero_torque_slice(problem))
      slice.push_back(number_json(vertex));
  }
  const bool closure = quality.radius_squared.sign() > 0;
  const std::string radius = text.root(1, quality.radius_squared);
  return about_grasp(method, source, closure ? "closed" : "not closed",
                     closure ? "force closure: the largest ball has radius " + radius +
                                   ", at the facet " + text(normal) +
                                   ".x <= " + text(nearest.offset)
                             : "no force closure, quality 0: no wrench x with " +
                                   text.direction(normal) + ".x > 0 can be applied",
                     std::move(evidence));
}

}  // namespace stickslip
