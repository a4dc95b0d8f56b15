// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/grasp_law.hpp"

#include <algorithm>
#include <cmath>

#include "stickslip/core/contact_row.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/motion_bound.hpp"

namespace stickslip {
namespace {

CornerRow planar_row(const RationalRow& p, const RationalRow& n,
                     const std::vector<RationalRow>& motion) {
  const Contact contact{{p[0], p[1]}, {n[0], n[1]}};
  CornerRow row{};
  row.normal = moved_by(row_of(normal_row(contact)), motion);
  row.set_slip({moved_by(row_of(tangent_row(contact)), motion)}, 1);
  return row;
}

/// Returns the row of a contact in space. Its slip is L^2 S, by rows: L^2 u - (n0.u) n with u =
/// (d1, d2, d3) + omega x p, and with torsion also L^2 n.omega.
CornerRow spatial_row(const RationalRow& p, const RationalRow& n, const RationalRow& n0,
                      bool has_torsion, const std::vector<RationalRow>& motion) {
  CornerRow row{};
  row.normal = moved_by(wrench_at(p, n), motion);
  const RationalRow along = wrench_at(p, n0);
  const Rational square = dot(n0, n0);
  std::vector<RationalRow> slip;
  for (std::size_t k = 0; k < 3; ++k) {
    RationalRow axis(3);
    axis[k] = 1;
    slip.push_back(wrench_at(p, axis));
    for (std::size_t j = 0; j < 6; ++j) slip[k][j] = square * slip[k][j] - n[k] * along[j];
    slip[k] = moved_by(slip[k], motion);
  }
  if (has_torsion) {
    slip.push_back(moved_by({0, 0, 0, square * n[0], square * n[1], square * n[2]}, motion));
  }
  row.set_slip(slip, square);
  return row;
}

void shrink(Interval& interval) {
  interval = point_interval(interval.middle());
}

/// Returns the place of a parameter of a contact's geometry; nothing for other parameters.
std::optional<std::size_t> geometry_index(Parameter parameter) {
  switch (parameter) {
    case Parameter::kX:
      return 0;
    case Parameter::kY:
      return 1;
    case Parameter::kTurn:
    case Parameter::kZ:
      return 2;
    case Parameter::kTurnU:
      return 3;
    case Parameter::kTurnV:
      return 4;
    default:
      return std::nullopt;
  }
}

template <class AnyContact>
auto& interval_of(AnyContact& c, Parameter parameter) {
  if (const auto index = geometry_index(parameter)) return c.place->geometry[*index];
  if (parameter == Parameter::kFriction) return c.friction;
  if (parameter == Parameter::kPreload) return c.preload;
  require(parameter == Parameter::kStiffness, "a wrench is of no contact");
  return c.stiffness;
}

}  // namespace

/// Adds a contact; `motion` is that of its place.
void GraspLaw::add_contact(const UncertainContact& c, std::vector<RationalRow> motion,
                           const Rational& rate, unsigned bits) {
  LawContact& contact = contacts.emplace_back();
  ContactPlace place{c.position, c.normal, turns_of(c), {}, std::move(motion)};
  for (const Turn& turn : place.turns) place.geometry.push_back({-turn.most, turn.most});
  contact.place = std::move(place);
  contact.friction = c.friction;
  const Rational square = dot(c.normal, c.normal);
  // The tangent e of the angle has 1/sqrt(1 + e^2) >= 1 - e^2/2 and 1/(1 + e^2) >= 1 - e^2.
  const Rational shortened = c.slope * c.slope;
  if (!c.preload.high.is_zero() || !rate.is_zero()) {
    const auto [lower, upper] = short_sqrt(1 / square, bits);
    contact.preload = {c.preload.low * (1 - shortened / 2) * lower, c.preload.high * upper};
    contact.rate = {rate * lower, rate * upper};
  }
  contact.stiffness = {c.stiffness.low * (1 - shortened) / square, c.stiffness.high / square};
  if (in_space_) {
    contact.axis = primitive_multiple<3>(vector3(c.normal));
    contact.squared_length = square;
    contact.spin_weight = c.torsion * c.torsion / square;
    const bool has_torsion = !c.torsion.is_zero();
    contact.directions.clear();
    for (const Turn& turn : contact.place->turns) {
      contact.directions.push_back(turn.direction);
      if (has_torsion) contact.directions.back().emplace_back(0);
    }
    if (has_torsion) contact.directions.push_back({0, 0, 0, 1});
  }
  add_corners(contact);
}

void GraspLaw::add_spring(const Spring& spring, const Rational& rate) {
  LawContact& contact = contacts.emplace_back();
  contact.is_spring = !spring.is_ratchet();
  contact.preload = spring.force;
  contact.rate = point_interval(rate);
  contact.stiffness = spring.stiffness;
  CornerRow& row = contact.corners.emplace_back();
  row.normal = spring.row;
  row.set_slip({RationalRow(motions)}, 1);
}

GraspLaw::GraspLaw(const GraspBox& box, NormalLaw law, unsigned bits,
                   const std::optional<Growth>& margin) {
  in_space_ = box.in_space();
  one_body_ = !box.mechanism;
  parameters_ = parameters_of(box);
  motions = box.wrench.size();
  if (motions + 2 > kMostCoordinates) {
    throw InputError(
        "", "bodies",
        "bodies and joints have " + std::to_string(motions) + " coordinates together",
        "margins, and boxes of uncertain numbers, have at most " +
            std::to_string(kMostCoordinates - 2) +
            ", 6 for each body in space or 3 in the plane, and 1 for each joint; of more there "
            "are verdicts about one grasp, and statics");
  }
  if (box.mechanism) {
    rotates.clear();
    for (std::size_t j = 0; j < motions; ++j) {
      rotates.push_back(box.mechanism->is_rotation(j) ? 1 : 0);
    }
  } else if (in_space_) {
    rotates = {0, 0, 0, 1, 1, 1};
  }
  wrench = box.wrench;
  if (box.ball) ball = BallPart::all_of(box);
  normal_law = law;
  max_motion = box.max_motion;
  const Growth rates = margin.value_or(Growth{});
  // (A box of many contacts is not copied for a verdict.)
  far_motion = (margin ? natural_bound(grown(box, rates.load, rates.preloads), kFarMotion)
                       : natural_bound(box, kFarMotion))
                   .value_or(RationalRow{});
  is_family = margin.has_value();
  growth.assign(motions, 0);
  if (!rates.load.empty()) growth = rates.load;
  const auto rate_of = [&](std::size_t i) {
    return rates.preloads.empty() ? Rational(0) : rates.preloads[i];
  };
  for (const UncertainContact& c : box.contacts) {
    add_contact(
        c,
        box.mechanism ? box.mechanism->motion_between(c.of, c.by) : std::vector<RationalRow>{},
        rate_of(contacts.size()), bits);
  }
  for (const Spring& spring : box.springs) add_spring(spring, rate_of(contacts.size()));
  complete();
}

void GraspLaw::add_corners(LawContact& contact) const {
  ContactPlace& place = *contact.place;
  const auto position = static_cast<std::ptrdiff_t>(place.normal.size());
  const auto normal_at = [&](const RationalRow& at) {
    return turned(place.normal, place.turns, {at.begin() + position, at.end()});
  };
  const auto row_at = [&](const RationalRow& at, const RationalRow& n) {
    return in_space_
               ? spatial_row(at, n, place.normal, !contact.spin_weight.is_zero(), place.motion)
               : planar_row(at, n, place.motion);
  };
  std::vector<RationalRow> corners{{}};
  RationalRow middle;
  for (const Interval& number : place.geometry) {
    middle.push_back(number.middle());
    std::vector<RationalRow> longer;
    for (const Rational& end : ends_of(number)) {
      for (const RationalRow& corner : corners) longer.emplace_back(corner).push_back(end);
    }
    corners = std::move(longer);
  }
  contact.corners.clear();
  contact.tilt = 0;
  for (const RationalRow& corner : corners) {
    const RationalRow n = normal_at(corner);
    contact.corners.push_back(row_at(corner, n));
    if (!in_space_) continue;  // nothing is projected
    contact.tilt = std::max<Rational>(contact.tilt, dot(n, n) / contact.squared_length - 1);
  }
  place.centre = row_at(middle, normal_at(middle));
}

/// Chooses the typical distance: the largest coordinate of a position. For one body in space it
/// is the largest moment arm |p x n| / |n| of a normal, unless that is much smaller than the
/// distance from the origin, as it is for fingers around it: friction turns these all the same.
void GraspLaw::complete() {
  const bool has_arms = in_space_ && one_body_;
  double distance = 0;
  double longest = 0;  // the longest arm
  for (const LawContact& c : contacts) {
    if (!c.place) continue;
    double square = 0;
    for (std::size_t j = 0; j < c.place->normal.size(); ++j) {
      double most = 0;
      for (const Rational& end : ends_of(c.place->geometry[j])) {
        most = std::max(most, std::fabs(to_double(end)));
      }
      square += most * most;
      if (!has_arms) distance = std::max(distance, most);
    }
    if (!has_arms) continue;
    distance = std::max(distance, std::sqrt(square));
    for (const CornerRow& row : c.corners) {  // (a turned n hardly changes it)
      double arm = 0;
      for (std::size_t j = 3; j < 6; ++j) arm = std::hypot(arm, to_double(row.normal[j]));
      longest = std::max(longest, arm / std::sqrt(to_double(c.squared_length)));
    }
  }
  constexpr double kMuchSmaller = 0.1;
  Law::complete(longest > kMuchSmaller * distance ? longest : distance);
}

GraspLaw GraspLaw::within(const MultipleRange& range) const {
  GraspLaw result = *this;
  result.multiples = range;
  return result;
}

GraspLaw GraspLaw::middle(const Rational& multiple) const {
  GraspLaw result = *this;
  result.growth.assign(motions, 0);
  result.is_family = false;
  if (ball) {
    const RationalRow beside = ball->load(ball->nearest());
    for (std::size_t j = 0; j < motions; ++j) {
      result.wrench[j] = point_interval(wrench[j].low + beside[j]);
    }
    result.ball.reset();
  }
  for (std::size_t j = 0; j < motions; ++j) {
    shrink(result.wrench[j]);
    if (is_family) {
      result.wrench[j] = point_interval(result.wrench[j].low + multiple * growth[j]);
    }
  }
  for (LawContact& c : result.contacts) {
    shrink(c.friction);
    c.preload = point_interval(c.preload.middle() + multiple * c.rate.middle());
    c.rate = {};
    shrink(c.stiffness);
    if (c.geometry_is_certain()) continue;
    for (Interval& number : c.place->geometry) shrink(number);
    add_corners(c);
  }
  result.complete();
  return result;
}

GraspLaw GraspLaw::without(const std::vector<ContactId>& ids) const {
  GraspLaw result = *this;
  for (auto id = ids.rbegin(); id != ids.rend(); ++id) {
    const std::size_t i = id->index();
    result.contacts.erase(result.contacts.begin() + static_cast<std::ptrdiff_t>(i));
    std::vector<ParameterId>& all = result.parameters_;
    const auto is_of_contact = [](const ParameterId& of) {
      return of.parameter != Parameter::kWrench;
    };
    all.erase(std::remove_if(
                  all.begin(), all.end(),
                  [&](const ParameterId& of) { return is_of_contact(of) && of.index == i; }),
              all.end());
    for (ParameterId& of : all) {
      if (is_of_contact(of) && of.index > i) --of.index;
    }
  }
  result.complete();
  return result;
}

const Interval& GraspLaw::load_interval(std::size_t component) const {
  return ball ? ball->parts.at(component) : wrench.at(component);
}

std::optional<Problem> GraspLaw::problem() const {
  if (in_space_ || !one_body_) return std::nullopt;
  std::vector<ContactRow> rows;
  for (const LawContact& c : contacts) {
    const CornerRow& row = c.corners.front();
    rows.push_back({wrench_of(row.normal), wrench_of(row.wrench_of({1})), c.friction.low,
                    c.preload.low, c.stiffness.low});
  }
  return Problem(std::move(rows), {wrench[0].low, wrench[1].low, wrench[2].low}, normal_law);
}

const Interval& GraspLaw::interval(const ParameterId& id) const {
  if (id.parameter == Parameter::kWrench) return load_interval(id.index);
  return interval_of(contacts.at(id.index), id.parameter);
}

std::vector<ParameterId> parameters_of(const GraspBox& box) {
  std::vector<ParameterId> result;
  std::vector<Parameter> each{Parameter::kX, Parameter::kY};
  if (box.in_space()) {
    each.insert(each.end(), {Parameter::kZ, Parameter::kTurnU, Parameter::kTurnV});
  } else {
    each.push_back(Parameter::kTurn);
  }
  each.insert(each.end(), {Parameter::kFriction, Parameter::kStiffness, Parameter::kPreload});
  for (std::size_t i = 0; i < box.contacts.size(); ++i) {
    for (const Parameter parameter : each) result.push_back({parameter, i});
  }
  for (std::size_t i = box.contacts.size(); i < box.elements(); ++i) {
    result.push_back({Parameter::kStiffness, i});
    result.push_back({Parameter::kPreload, i});
  }
  const std::size_t loads = box.ball ? box.ball_reach().size() : box.wrench.size();
  for (std::size_t j = 0; j < loads; ++j) result.push_back({Parameter::kWrench, j});
  return result;
}

std::pair<GraspLaw, GraspLaw> GraspLaw::halves(const PartSplit& split) const {
  const auto half = [&](bool upper) {
    GraspLaw result = *this;
    const bool is_load = split.parameter == Parameter::kWrench;
    Interval& cut = is_load ? (ball ? result.ball->parts : result.wrench).at(split.index)
                            : interval_of(result.contacts.at(split.index), split.parameter);
    require(cut.low < split.value && split.value < cut.high,
            "a part is cut inside its interval");
    (upper ? cut.low : cut.high) = split.value;
    if (!is_load && result.contacts[split.index].place) {
      result.add_corners(result.contacts[split.index]);
    }
    result.complete();
    return result;
  };
  return {half(false), half(true)};
}

GraspLaw law_of(const Question& question, unsigned bits) {
  std::optional<Growth> growth;
  if (question.is_margin()) {
    growth = Growth{question.direction.value_or(RationalRow{}), question.preload_growth};
  }
  return GraspLaw(*question.box(), question.law, bits, growth);
}

}  // namespace stickslip
