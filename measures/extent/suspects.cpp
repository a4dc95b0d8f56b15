// SPDX-License-Identifier: GPL-3.0-or-later
#include "suspects.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "engine/box/single_grasp.hpp"
#include "stickslip/measures/margin.hpp"

namespace stickslip::extent_detail {

using box_detail::Examples;
using box_detail::Place;

namespace {

/// Returns the problem of the grasp at a place; nothing in space and of several bodies.
std::optional<Problem> problem_at(const Examples& examples, const Place& place) {
  return GraspLaw(examples.at(place), examples.law()).middle().problem();
}

/// Returns how far the load is from the nearest multiple of it at which the verdict changes:
/// below 0 if the grasp is unstable. Nothing if no multiple changes it. Requires a problem.
std::optional<double> distance(const Examples& examples, const Place& place) {
  const Problem problem = problem_at(examples, place).value();
  if (problem.wrench() == Wrench{}) return std::nullopt;
  const auto found =
      find_margin(problem.with_wrench({}).along({row_of(problem.wrench())}), {2000});
  const auto* margin = std::get_if<Margin>(&found);
  if (margin == nullptr) return std::nullopt;
  std::optional<double> nearest;
  bool stable = false;
  const auto consider = [&](const Rational& end) {
    const double off = std::fabs(to_double(end - 1));
    if (!nearest || off < *nearest) nearest = off;
  };
  for (const MarginInterval& interval : margin->resisted) {
    if (!interval.low.is_zero()) consider(interval.low);
    if (interval.high) consider(*interval.high);
    stable = stable || (interval.low <= 1 && (!interval.high || *interval.high >= 1));
  }
  if (nearest && !stable) nearest = -*nearest;
  return nearest;
}

}  // namespace

std::vector<Place> suspects(const Examples& examples, bool middle_is_stable) {
  if (!problem_at(examples, examples.middle())) {
    std::vector<Place> ends = examples.extremes();
    if (middle_is_stable) std::swap(ends.front(), ends.back());
    return ends;
  }
  const std::vector<ParameterId>& numbers = examples.numbers();
  std::vector<Place> places;
  const double sign = middle_is_stable ? 1 : -1;
  Place best = examples.middle();
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    std::array<std::optional<double>, 2> off;
    for (const int end : {-1, 1}) {
      Place place = examples.middle();
      place[n] = end;
      off[end > 0] = distance(examples, place);
    }
    if (off[0] && off[1]) best[n] = sign * *off[0] <= sign * *off[1] ? -1 : 1;
    if (off[0].has_value() != off[1].has_value()) best[n] = off[0] ? -1 : 1;
  }
  places.push_back(best);
  // Tries less friction, more friction, and the opposite of what was found: far from the middle
  // thresholds may go the other way.
  for (const int friction : {-1, 1}) {
    Place place = best;
    for (std::size_t n = 0; n < numbers.size(); ++n) {
      if (numbers[n].parameter == Parameter::kFriction) place[n] = friction;
    }
    places.push_back(std::move(place));
  }
  constexpr std::size_t kFew = 12;
  if (numbers.size() > kFew) return places;
  // Tries one number at a time.
  const std::optional<double> reached = distance(examples, best);
  double least = reached ? sign * *reached : HUGE_VAL;
  Place improved = best;
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    Place place = improved;
    place[n] = -place[n];
    const std::optional<double> off = distance(examples, place);
    if (off && sign * *off < least) {
      least = sign * *off;
      improved = std::move(place);
    }
  }
  if (improved != best) places.insert(places.begin(), std::move(improved));
  return places;
}

}  // namespace stickslip::extent_detail
