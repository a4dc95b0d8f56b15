// SPDX-License-Identifier: GPL-3.0-or-later
#include "examples.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/degree/newton.hpp"
#include "engine/degree/smooth_newton.hpp"
#include "engine/degree/weakest_corners.hpp"
#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip::box_detail {
namespace {

Rational pick(const Interval& interval, const Rational& place) {
  require(Rational(abs(place)) <= 1, "an example lies in its box");
  return interval.middle() + place * (interval.high - interval.low) / 2;
}

/// Returns the multiple of 2^-16 nearest to a number from -1 to 1, so that there is no load
/// along what is rounding alone. What is beyond, or no number, as doubles may overflow, becomes
/// an end or 0.
Rational on_grid(double place) {
  constexpr long long kSteps = 1 << 16;
  place = std::isnan(place) ? 0 : std::clamp(place, -1.0, 1.0);
  return {Integer(std::llround(place * kSteps)), Integer(kSteps)};
}

/// Returns whether Newton's method finds no equilibrium, neither from this one of another grasp
/// nor from others.
bool is_lost(const RoundedGrasp& grasp, const NearEquilibrium& equilibrium) {
  throw_if_cancelled();
  constexpr std::size_t kStarts = 12;
  const Newton newton(grasp);
  return !newton.follow(equilibrium) && !SmoothNewton(grasp).follow(equilibrium.motion) &&
         !newton.solve_thoroughly(kStarts);
}

/// The factor of bounds of turns, which are rounded up: with it no slope is above its own.
const Rational kWithin(1048575, 1048576);

/// Returns a slope near e, and not beyond it, for which 1 + slope^2 is the square of a rational
/// number: 2u / (1 - u^2).
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

/// Returns n turned, each way by a part of the most, from -1 to 1. In the plane it has a
/// rational length where that of n is and matters. In space it need not; but what is turned
/// both ways by all that each may be would be turned by more than the slope, and comes back to
/// it.
RationalRow turned_normal(const UncertainContact& c, const RationalRow& parts) {
  const std::vector<Turn> turns = turns_of(c);
  RationalRow e;
  for (std::size_t k = 0; k < turns.size(); ++k) e.push_back(parts[k] * turns[k].most);
  const bool keeps_length = !c.preload.high.is_zero() && exact_sqrt(dot(c.normal, c.normal));
  if (e.size() == 1 && keeps_length) e[0] = with_rational_length(e[0]);
  if (e.size() > 1) {
    constexpr int kGrain = 1 << 20;
    const double size = std::max(1.0, std::sqrt(to_double(dot(parts, parts))));
    const Rational inwards(static_cast<int>(kGrain / size), kGrain);
    for (Rational& entry : e) entry *= kWithin * inwards;
  }
  return turned(c.normal, turns, e);
}

/// Returns which turn of a normal a parameter is; nothing if it is none.
std::optional<std::size_t> turn_index(Parameter parameter) {
  if (parameter == Parameter::kTurn || parameter == Parameter::kTurnU) return 0;
  if (parameter == Parameter::kTurnV) return 1;
  return std::nullopt;
}

/// Returns the interval of a number; nullptr for a turn, and for a ball's load.
template <class Box>
auto* interval_of(Box& box, const ParameterId& id) {
  if (id.parameter == Parameter::kWrench) {
    return box.ball ? decltype(&box.wrench[0]){} : &box.wrench[id.index];
  }
  if (id.index >= box.contacts.size()) {
    auto& spring = box.springs[id.index - box.contacts.size()];
    return id.parameter == Parameter::kStiffness ? &spring.stiffness : &spring.force;
  }
  auto& c = box.contacts[id.index];
  switch (id.parameter) {
    case Parameter::kX:
      return &c.position[0];
    case Parameter::kY:
      return &c.position[1];
    case Parameter::kZ:
      return &c.position[2];
    case Parameter::kFriction:
      return &c.friction;
    case Parameter::kPreload:
      return &c.preload;
    case Parameter::kStiffness:
      return &c.stiffness;
    default:
      return decltype(&c.friction){};
  }
}

}  // namespace

Examples::Examples(const GraspBox& box, NormalLaw law) : box_(box), law_(law) {
  for (const ParameterId& id : parameters_of(box)) {
    const Interval* interval = interval_of(box, id);
    const bool is_certain = interval != nullptr ? interval->is_point()
                                                : turn_index(id.parameter).has_value() &&
                                                      box.contacts[id.index].slope.is_zero();
    if (!is_certain) numbers_.push_back(id);
  }
}

GraspBox Examples::at(const Place& place) const {
  GraspBox chosen = box_.middle();
  std::vector<RationalRow> turns(chosen.contacts.size(), RationalRow(2));
  RationalRow z = box_.ball ? box_.ball_reach() : RationalRow{};
  for (std::size_t n = 0; n < numbers_.size(); ++n) {
    const auto [parameter, i] = numbers_[n];
    if (const Interval* interval = interval_of(box_, numbers_[n])) {
      *interval_of(chosen, numbers_[n]) = point_interval(pick(*interval, place[n]));
    } else if (const auto k = turn_index(parameter)) {
      turns[i][*k] = place[n];
    } else {
      z[i] *= place[n];
    }
  }
  load(chosen, std::move(z));
  turn(chosen, turns);
  return chosen;
}

void Examples::load(GraspBox& chosen, RationalRow z) const {
  if (!box_.ball) return;
  const BallPart ball = BallPart::all_of(box_);
  const Rational square = box_.ball->squared_norm(z);
  if (square > ball.radius * ball.radius) {
    constexpr unsigned kBits = 24;
    const Rational grain(1, 1 << kBits);
    const Rational part = ball.radius / short_sqrt(square, 2 * kBits).upper / grain;
    for (Rational& component : z) component *= numerator(part) / denominator(part) * grain;
  }
  const RationalRow beside = ball.load(z);
  for (std::size_t j = 0; j < beside.size(); ++j) {
    chosen.wrench[j] = point_interval(box_.wrench[j].low + beside[j]);
  }
}

std::vector<Place> Examples::ball_directions() const {
  std::vector<std::size_t> axes;
  std::size_t count = 1;
  for (std::size_t n = 0; n < numbers_.size(); ++n) {
    if (numbers_[n].parameter != Parameter::kWrench) continue;
    axes.push_back(n);
    count *= 3;
  }
  const bool in_plane = axes.size() == 3;
  std::vector<Place> places;
  for (std::size_t code = 1; code < count; ++code) {  // digits in base 3
    Place place = middle();
    std::size_t moved = 0;
    std::size_t rest = code;
    for (const std::size_t n : axes) {
      constexpr int kAt[3] = {0, 1, -1};
      place[n] = kAt[rest % 3];
      if (rest % 3 != 0) ++moved;
      rest /= 3;
    }
    if (in_plane || moved == 1 || moved == axes.size()) places.push_back(std::move(place));
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return dot(a, a) < dot(b, b); });
  return places;
}

std::vector<Place> Examples::turned(const Place& place, const Rational& step) const {
  Rational square = 0;
  for (std::size_t n = 0; n < numbers_.size(); ++n) {
    if (numbers_[n].parameter == Parameter::kWrench) square += place[n] * place[n];
  }
  constexpr unsigned kBits = 16;
  const Rational size = square > 1 ? short_sqrt(square, kBits).upper : Rational(1);
  std::vector<Place> places;
  for (std::size_t n = 0; n < numbers_.size(); ++n) {
    if (numbers_[n].parameter != Parameter::kWrench) continue;
    for (const int sign : {1, -1}) {
      places.push_back(place);
      places.back()[n] += sign * step * size;
    }
  }
  return places;
}

Place Examples::loaded_along(const RationalRow& twist, Place place) const {
  const BallPart ball = BallPart::all_of(box_);
  const RationalRow reach = box_.ball_reach();
  Rational largest = 0;
  for (const bool is_known : {false, true}) {
    for (std::size_t n = 0; n < numbers_.size(); ++n) {
      const auto [parameter, i] = numbers_[n];
      if (parameter != Parameter::kWrench) continue;
      const Rational along = dot(ball.motion[i], twist) * reach[i];
      largest = std::max<Rational>(largest, abs(along));
      // The place is beyond the ball, so that the load is pulled to its border.
      if (is_known) place[n] = 2 * on_grid(to_double(along / largest));
    }
    if (largest.is_zero()) return place;
  }
  return place;
}

Place Examples::between_loads(const Place& one, const Place& other) const {
  const auto size_of = [&](const Place& place) {
    double square = 0;
    for (std::size_t n = 0; n < numbers_.size(); ++n) {
      if (numbers_[n].parameter == Parameter::kWrench) {
        square += std::pow(to_double(place[n]), 2);
      }
    }
    return std::sqrt(square);
  };
  Place place = one;
  const double sizes[] = {size_of(one), size_of(other)};
  for (std::size_t n = 0; n < numbers_.size(); ++n) {
    if (numbers_[n].parameter != Parameter::kWrench) continue;
    place[n] = on_grid(to_double(one[n]) / sizes[0]) + on_grid(to_double(other[n]) / sizes[1]);
  }
  return place;
}

void Examples::turn(GraspBox& chosen, const std::vector<RationalRow>& parts) const {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    UncertainContact& c = chosen.contacts[i];
    c.slope = box_.contacts[i].slope;
    if (!c.slope.is_zero()) c.normal = turned_normal(c, parts[i]);
    c.slope = 0;
  }
}

GraspBox Examples::between(const RationalRow& parts) const {
  GraspBox chosen = box_;
  std::size_t next = 0;
  std::vector<RationalRow> turns(chosen.contacts.size(), RationalRow(2));
  RationalRow z = box_.ball ? box_.ball_reach() : RationalRow{};
  for (const ParameterId& id : parameters_of(box_)) {
    const Rational place = 2 * parts[next++] - 1;
    if (Interval* interval = interval_of(chosen, id)) {
      *interval = point_interval(pick(*interval, place));
    } else if (const auto k = turn_index(id.parameter)) {
      turns[id.index][*k] = place;
    } else {
      z[id.index] *= place;
    }
  }
  chosen.ball.reset();
  load(chosen, std::move(z));
  turn(chosen, turns);
  return chosen;
}

Place Examples::place_at(const RoundedBox& rounded, const RoundedBox::Place& at) const {
  Place place = middle();
  for (std::size_t n = 0; n < numbers_.size(); ++n) {
    for (std::size_t k = 0; k < rounded.numbers().size(); ++k) {
      const ParameterId& number = rounded.numbers()[k];
      if (number.parameter == numbers_[n].parameter && number.index == numbers_[n].index) {
        place[n] = on_grid(at[static_cast<Eigen::Index>(k)]);
      }
    }
  }
  return place;
}

void Examples::visit_weak_corners(const NearEquilibrium& equilibrium,
                                  const std::function<bool(const Place&)>& visit) const {
  const GraspLaw law(box_, law_);
  const RoundedBox rounded(law);
  constexpr std::size_t kDescents = 32;
  for (const WeakCorner& corner : weakest_corners(rounded, equilibrium, kDescents)) {
    if (!(corner.multiple < 1)) return;
    if (!is_lost(rounded.at(corner.at), equilibrium)) continue;
    if (!visit(place_at(rounded, corner.at))) return;
  }
}

void Examples::visit_random_corners(const NearEquilibrium& equilibrium,
                                    const std::function<bool(const Place&)>& visit) const {
  const GraspLaw law(box_, law_);
  const RoundedBox rounded(law);
  RandomCorners corners(rounded);
  constexpr int kCorners = 64;
  for (int corner = 0; corner < kCorners; ++corner) {
    const RoundedBox::Place at = corners.next();
    if (is_lost(rounded.at(at), equilibrium) && !visit(place_at(rounded, at))) return;
  }
}

std::optional<Place> Examples::place_of(const GraspBox& grasp) const {
  Place place = middle();
  for (std::size_t n = 0; n < numbers_.size(); ++n) {
    const Interval* whole = interval_of(box_, numbers_[n]);
    const Interval* chosen = interval_of(grasp, numbers_[n]);
    if (whole == nullptr || chosen == nullptr) {
      const std::size_t i = numbers_[n].index;
      const bool is_middle = turn_index(numbers_[n].parameter) &&
                             grasp.contacts[i].normal == box_.contacts[i].normal;
      if (!is_middle) return std::nullopt;
      continue;
    }
    if (whole->is_point()) continue;
    place[n] = (chosen->low - whole->middle()) / ((whole->high - whole->low) / 2);
  }
  return place;
}

std::vector<Place> Examples::extremes() const {
  Place better = middle();
  Place worse = middle();
  for (std::size_t n = 0; n < numbers_.size(); ++n) {
    const auto [parameter, index] = numbers_[n];
    if (parameter == Parameter::kFriction || parameter == Parameter::kPreload) better[n] = 1;
    if (parameter == Parameter::kWrench && !box_.ball) {
      better[n] = box_.wrench[index].middle().sign() > 0 ? -1 : 1;
    }
    worse[n] = -better[n];
  }
  return {std::move(better), std::move(worse)};
}

std::vector<Place> Examples::single_ends(std::size_t most) const {
  std::vector<Place> places;
  if (numbers_.size() > most) return places;
  for (std::size_t n = 0; n < numbers_.size(); ++n) {
    for (const int end : {-1, 1}) {
      places.push_back(middle());
      places.back()[n] = end;
    }
  }
  return places;
}

}  // namespace stickslip::box_detail
