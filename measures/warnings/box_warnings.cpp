// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "contact_signs.hpp"
#include "edge_balance.hpp"
#include "engine/degree/newton.hpp"
#include "stickslip/core/spatial_forces.hpp"
#include "stickslip/measures/model_warnings.hpp"

namespace stickslip {

using namespace warnings_detail;

namespace {

Vector3 point_of(const UncertainContact& c) {
  return {c.position[0].low, c.position[1].low, c.position[2].low};
}

/// Returns a grasp of one body as one in space. (Friction across a planar grasp changes nothing
/// that the warnings are about.)
GraspBox seen_in_space(GraspBox grasp) {
  if (grasp.in_space()) return grasp;
  for (UncertainContact& c : grasp.contacts) {
    c.position.emplace_back();
    c.normal.emplace_back(0);
  }
  const Interval torque = grasp.wrench[2];
  grasp.wrench = {grasp.wrench[0], grasp.wrench[1], {}, {}, {}, torque};
  return grasp;
}

/// Returns a motion as one in space.
RationalRow seen_in_space(const RationalRow& motion) {
  if (motion.size() != 3) return motion;
  return {motion[0], motion[1], 0, 0, 0, motion[2]};
}

std::optional<std::string> large_motion_of(const GraspBox& grasp, const RationalRow& d,
                                           bool stiffness_was_assumed) {
  std::vector<Vector3> points;
  for (const UncertainContact& c : grasp.contacts) points.push_back(point_of(c));
  Integer common = 1;
  for (const Rational& entry : d) common = lcm(common, denominator(entry));
  const Rational scale(common);
  RationalRow scaled = d;
  for (Rational& entry : scaled) entry *= scale;
  const Vector3 turn{scaled[3], scaled[4], scaled[5]};
  const auto moved = [&](std::size_t i) {
    const Vector3 move = displacement(points[i], scaled);
    return dot(move, move);
  };
  return large_motion({scale, dot(turn, turn), points.size(), moved, squared_width(points)},
                      stiffness_was_assumed);
}

/// Returns the warning about lost preload of a grasp with these preloads. Kept forces are
/// rounded up if a normal has an irrational length.
std::optional<std::string> lost_preload_of(const GraspBox& grasp,
                                           const std::vector<Rational>& preloads,
                                           const RationalRow& d) {
  return lost_preload(preloads.size(), [&](std::size_t i) -> std::pair<Rational, Rational> {
    const UncertainContact& c = grasp.contacts[i];
    if (preloads[i].is_zero()) return {0, 0};
    constexpr unsigned kBits = 128;
    const ShortRoot length = short_sqrt(dot(c.normal, c.normal), kBits);
    const Rational rise = dot(vector3(c.normal), displacement(point_of(c), d));
    return {preloads[i], preloads[i] - c.stiffness.low * rise /
                                           (rise.sign() > 0 ? length.upper : length.lower)};
  });
}

/// Returns the preloaded contacts in doubles; nothing if a number is not moderate.
std::optional<std::vector<RestingContact<6>>> preloaded_contacts(
    const GraspBox& grasp, const std::vector<Rational>& preloads) {
  std::vector<RestingContact<6>> contacts;
  bool moderate = true;
  const auto read = [&](const Rational& value) {
    const double rounded = to_double(value);
    moderate = moderate && is_moderate(rounded) && (rounded != 0) == !value.is_zero();
    return rounded;
  };
  const auto read_three = [&](const Vector3& v) {
    return Double3{read(v[0]), read(v[1]), read(v[2])};
  };
  const auto unit = [](Double3 v) {
    const double length = std::hypot(v[0], v[1], v[2]);
    for (double& entry : v) entry /= length;
    return v;
  };
  for (std::size_t i = 0; i < preloads.size(); ++i) {
    if (preloads[i].is_zero()) continue;
    const UncertainContact& c = grasp.contacts[i];
    const Double3 point = read_three(point_of(c));
    const Double3 normal = unit(read_three(vector3(c.normal)));
    Double3 across{};  // along the axis that is the least along the normal
    std::size_t least = 0;
    for (std::size_t j = 1; j < 3; ++j) {
      if (std::fabs(normal[j]) < std::fabs(normal[least])) least = j;
    }
    across[least] = 1;
    const Double3 first = unit(cross(normal, across));
    const double preload = read(preloads[i]);
    const double friction = preload * read(c.friction.low);
    const auto wrench = [&](double size, const Double3& direction) {
      const Double3 torque = cross(point, direction);
      return std::array<double, 6>{size * direction[0], size * direction[1],
                                   size * direction[2], size * torque[0],
                                   size * torque[1],    size * torque[2]};
    };
    RestingContact<6>& contact = contacts.emplace_back();
    contact.push = wrench(preload, normal);
    contact.friction = {wrench(friction, first), wrench(friction, cross(normal, first))};
    // Directions and their angles are off by fewer than 40 roundings, all else by fewer.
    constexpr double kRounding = 1e-14;
    const double arm = std::fabs(point[0]) + std::fabs(point[1]) + std::fabs(point[2]);
    for (std::size_t j = 0; j < 6; ++j) {
      contact.error[j] = kRounding * (preload + friction) * (j < 3 ? 1 : arm);
    }
  }
  if (!moderate) return std::nullopt;
  return contacts;
}

std::vector<Rational> preloads_of(const GraspBox& grasp) {
  std::vector<Rational> preloads;
  for (const UncertainContact& c : grasp.contacts) preloads.push_back(c.preload.low);
  return preloads;
}

void add_unbalanced_preload(const GraspBox& grasp, const std::vector<Rational>& preloads,
                            ModelWarnings& warnings) {
  auto contacts = preloaded_contacts(grasp, preloads);
  if (!contacts || !is_certainly_unbalanced(std::move(*contacts))) return;
  warnings.add(ModelTrap::kUnbalancedPreload, unbalanced_preload());
}

GraspBox with_stiffness(GraspBox grasp, ContactId contact, const Rational& stiffness) {
  grasp.contacts[contact.index()].stiffness = point_interval(stiffness);
  return grasp;
}

std::optional<std::string> assumed_stiffness_of(const Answer& answer, bool stable) {
  const Question& question = answer.question;
  const GraspBox& grasp = *question.box();
  StiffnessTrial trial{
      {}, question.assumed_stiffness, stable, std::get<SearchWork>(answer.work).nodes, {}, {}};
  for (const UncertainContact& c : grasp.contacts) trial.stiffness.push_back(c.stiffness.low);
  trial.may_differ = [&](ContactId contact, const Rational& stiffness) {
    if (!stable) return true;  // doubles miss equilibria
    Question varied = question;
    varied.grasp = with_stiffness(grasp, contact, stiffness);
    for (UncertainContact& c : varied.grasp.box()->contacts) {
      c.friction = point_interval(friction_to_tell_by(stable) * c.friction.low);
    }
    const RoundedGrasp rounded = rounded_middle(law_of(varied, answer.bits));
    return Newton(rounded).solve_from(1).empty();
  };
  trial.is_stable = [&](ContactId contact, const Rational& stiffness,
                        std::size_t& left) -> std::optional<bool> {
    SearchOptions options;
    options.node_limit = left;
    options.bits = answer.bits;
    const BoxDecision varied =
        decide_box(with_stiffness(grasp, contact, stiffness), question.law, options);
    left -= std::min(left, 1 + varied.work.nodes);
    return is_stable(varied.verdict);
  };
  return assumed_stiffness(trial);
}

}  // namespace

std::vector<ModelWarning> warnings_detail::box_warnings(const Answer& answer,
                                                        bool only_of_motion) {
  const Question& question = answer.question;
  const bool is_on_edge = !only_of_motion && std::holds_alternative<Stable>(answer.verdict) &&
                          question.box()->is_point();
  const auto edge = is_on_edge ? balance_on_an_edge(question.grasp) : std::nullopt;
  ModelWarnings warnings;
  if (question.mechanism() != nullptr) {
    warnings.add(ModelTrap::kReversedContact, reversed_contacts(*question.box()));
    warnings.add(ModelTrap::kEdgeBalance, edge);
    return std::move(warnings).take();
  }
  if (!question.box()->is_point()) return {};
  const GraspBox grasp = seen_in_space(*question.box());
  const std::vector<Rational> preloads = preloads_of(grasp);
  const auto* stable = std::get_if<Stable>(&answer.verdict);
  const RationalRow motion = stable != nullptr ? seen_in_space(stable->motion) : RationalRow{};
  if (stable != nullptr) {
    warnings.add(ModelTrap::kLargeMotion,
                 large_motion_of(grasp, motion, !question.assumed_stiffness.empty()));
  }
  if (!only_of_motion) add_unbalanced_preload(grasp, preloads, warnings);
  if (stable != nullptr) {
    warnings.add(ModelTrap::kLostPreload, lost_preload_of(grasp, preloads, motion));
  }
  if (!only_of_motion && is_stable(answer.verdict)) {
    warnings.add(ModelTrap::kAssumedStiffness, assumed_stiffness_of(answer, stable != nullptr));
  }
  warnings.add(ModelTrap::kEdgeBalance, edge);
  return std::move(warnings).take();
}

std::vector<ModelWarning> model_warnings(const Question& question,
                                         const SpatialMargin& margin) {
  ModelWarnings warnings;
  if (question.mechanism() != nullptr) {
    warnings.add(ModelTrap::kReversedContact, reversed_contacts(*question.box()));
    return std::move(warnings).take();
  }
  const GraspBox grasp = seen_in_space(*question.box());
  const auto preloads_at = [&](const Rational& multiple) {
    std::vector<Rational> preloads = preloads_of(grasp);
    for (std::size_t i = 0; i < question.preload_growth.size(); ++i) {
      preloads[i] += multiple * question.preload_growth[i];
    }
    return preloads;
  };
  const auto look_at = [&](const Rational& multiple, const RationalRow& twist) {
    const RationalRow d = seen_in_space(twist);
    const auto at_multiple = [&](std::optional<std::string> text) {
      if (text) *text = "at the multiple " + to_readable_string(multiple) + " " + *text;
      return text;
    };
    warnings.add(ModelTrap::kLargeMotion,
                 at_multiple(large_motion_of(grasp, d, !question.assumed_stiffness.empty())));
    warnings.add(ModelTrap::kLostPreload,
                 at_multiple(lost_preload_of(grasp, preloads_at(multiple), d)));
  };
  for (const MultiplesClaim& claim : margin.claims) {
    const auto* resisted = std::get_if<ResistedMultiples>(&claim);
    const auto* segment =
        resisted != nullptr ? std::get_if<SpatialSegment>(&resisted->proof) : nullptr;
    if (segment == nullptr) continue;
    look_at(resisted->low, segment->start.twist);
    if (segment->end && resisted->high) look_at(*resisted->high, segment->end->twist);
  }
  const std::vector<Rational> base = preloads_at(0);
  const bool any = std::any_of(base.begin(), base.end(),
                               [](const Rational& preload) { return !preload.is_zero(); });
  add_unbalanced_preload(grasp, any ? base : preloads_at(1), warnings);
  return std::move(warnings).take();
}

}  // namespace stickslip
