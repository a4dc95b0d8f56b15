// SPDX-License-Identifier: GPL-3.0-or-later
#include "examples.hpp"

#include <cmath>
#include <utility>

#include "planar_grasps.hpp"
#include "stickslip/degree/moving_equilibrium.hpp"
#include "stickslip/equilibrium/margin.hpp"

namespace stickslip::box_detail {
namespace {

Rational pick(const Interval& interval, int place) {
  return place < 0 ? interval.low : place > 0 ? interval.high : interval.middle();
}

/// The slope at most e, near it, of which 1 + slope^2 is the square of a rational number:
/// 2u / (1 - u^2).
Rational with_rational_length(const Rational& e) {
  const double target = to_double(abs(e));
  constexpr double kGrain = 1 << 20;
  double steps = std::floor(kGrain * std::tan(std::atan(target) / 2));
  Rational slope;
  do {
    const Rational u = Rational(Integer(static_cast<long long>(steps))) /
                       Rational(Integer(static_cast<long long>(kGrain)));
    slope = 2 * u / (1 - u * u);
    steps -= 1;
  } while (slope > abs(e) && steps >= 0);
  return e.sign() < 0 ? Rational(-slope) : slope;
}

}  // namespace

Examples::Examples(const GraspBox& box, NormalLaw law) : box_(box), law_(law) {
  for (std::size_t i = 0; i < box.contacts.size(); ++i) {
    const UncertainContact& c = box.contacts[i];
    const auto add = [&](Parameter parameter, bool certain) {
      if (!certain) numbers_.push_back({parameter, i});
    };
    add(Parameter::kX, c.x.is_point());
    add(Parameter::kY, c.y.is_point());
    add(Parameter::kTurn, c.slope.is_zero());
    add(Parameter::kFriction, c.friction.is_point());
    add(Parameter::kPreload, c.preload.is_point());
    add(Parameter::kStiffness, c.stiffness.is_point());
  }
  for (std::size_t j = 0; j < box.wrench.size(); ++j) {
    if (!box.wrench[j].is_point()) numbers_.push_back({Parameter::kWrench, j});
  }
}

LoadedGrasp Examples::at(const Place& place) const {
  GraspBox chosen = box_;
  std::vector<Rational> turns(box_.contacts.size());
  for (std::size_t n = 0; n < numbers_.size(); ++n) {
    const auto [parameter, index] = numbers_[n];
    const auto set = [&, at = place[n]](Interval& interval) {
      interval = point_interval(pick(interval, at));
    };
    if (parameter == Parameter::kWrench) {
      set(chosen.wrench[index]);
      continue;
    }
    UncertainContact& c = chosen.contacts[index];
    if (parameter == Parameter::kX) set(c.x);
    if (parameter == Parameter::kY) set(c.y);
    if (parameter == Parameter::kFriction) set(c.friction);
    if (parameter == Parameter::kPreload) set(c.preload);
    if (parameter == Parameter::kStiffness) set(c.stiffness);
    if (parameter == Parameter::kTurn) turns[index] = Rational(place[n]) * c.slope;
  }
  std::vector<Contact> contacts;
  for (std::size_t i = 0; i < chosen.contacts.size(); ++i) {
    const UncertainContact& c = chosen.contacts[i];
    const Vector2& n = c.normal;
    const bool keeps_length =
        !c.preload.high.is_zero() && exact_sqrt(n.x * n.x + n.y * n.y).has_value();
    const Rational e = keeps_length ? with_rational_length(turns[i]) : turns[i];
    contacts.push_back({{c.x.middle(), c.y.middle()},
                        turned(n, e),
                        c.friction.middle(),
                        c.stiffness.middle(),
                        c.preload.middle()});
  }
  const WrenchBox& w = chosen.wrench;
  return {Grasp(std::move(contacts)), {w[0].middle(), w[1].middle(), w[2].middle()}};
}

std::vector<std::pair<Place, double>> Examples::without(const Witness& equilibrium) const {
  const GraspLaw law(box_, law_);
  const RoundedBox rounded(law);
  const GraspLaw middle_law = law.middle();
  const MovingEquilibrium moving(
      rounded, near(rounded_middle(middle_law),
                    rounded_equilibrium(box_detail::problem_of(middle_law), equilibrium)));
  std::vector<std::pair<Place, double>> result;
  for (const LostWay& way : moving.ways_out()) {
    Place place = middle();
    for (std::size_t n = 0; n < numbers_.size(); ++n) {
      for (std::size_t k = 0; k < rounded.numbers().size(); ++k) {
        const ParameterId& number = rounded.numbers()[k];
        if (number.parameter == numbers_[n].parameter && number.index == numbers_[n].index) {
          place[n] = static_cast<int>(way.to[static_cast<Eigen::Index>(k)]);
        }
      }
    }
    result.emplace_back(std::move(place), way.part);
  }
  return result;
}

std::vector<Place> Examples::extremes() const {
  Place better = middle();
  Place worse = middle();
  for (std::size_t n = 0; n < numbers_.size(); ++n) {
    const auto [parameter, index] = numbers_[n];
    if (parameter == Parameter::kFriction || parameter == Parameter::kPreload) better[n] = 1;
    if (parameter == Parameter::kWrench) {
      better[n] = box_.wrench[index].middle().sign() > 0 ? -1 : 1;
    }
    worse[n] = -better[n];
  }
  return {std::move(better), std::move(worse)};
}

/// How far the load is from the nearest multiple of it at which the verdict changes: below 0 if
/// the grasp is unstable. Nothing if no multiple changes it.
std::optional<double> Examples::distance(const Place& place) const {
  const LoadedGrasp grasp = at(place);
  if (grasp.wrench == Wrench{}) return std::nullopt;
  const Problem problem = box_detail::problem_of(GraspLaw(box_of(grasp), law_).middle());
  const auto found = find_margin(problem.with_wrench({}).along({grasp.wrench}), {2000});
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

std::vector<Place> Examples::suspects(bool middle_is_stable) const {
  std::vector<Place> places;
  const double sign = middle_is_stable ? 1 : -1;
  Place best = middle();
  for (std::size_t n = 0; n < numbers_.size(); ++n) {
    std::array<std::optional<double>, 2> off;
    for (const int end : {-1, 1}) {
      Place place = middle();
      place[n] = end;
      off[end > 0] = distance(place);
    }
    if (off[0] && off[1]) best[n] = sign * *off[0] <= sign * *off[1] ? -1 : 1;
    if (off[0].has_value() != off[1].has_value()) best[n] = off[0] ? -1 : 1;
  }
  places.push_back(best);
  // Less friction, more friction, and the opposite of what was found: thresholds that go the
  // other way far from the middle.
  for (const int friction : {-1, 1}) {
    Place place = best;
    for (std::size_t n = 0; n < numbers_.size(); ++n) {
      if (numbers_[n].parameter == Parameter::kFriction) place[n] = friction;
    }
    places.push_back(std::move(place));
  }
  constexpr std::size_t kFew = 12;
  if (numbers_.size() > kFew) return places;
  // One number at a time.
  const std::optional<double> reached = distance(best);
  double least = reached ? sign * *reached : HUGE_VAL;
  Place improved = best;
  for (std::size_t n = 0; n < numbers_.size(); ++n) {
    Place place = improved;
    place[n] = -place[n];
    const std::optional<double> off = distance(place);
    if (off && sign * *off < least) {
      least = sign * *off;
      improved = std::move(place);
    }
  }
  if (improved != best) places.insert(places.begin(), std::move(improved));
  return places;
}

}  // namespace stickslip::box_detail
