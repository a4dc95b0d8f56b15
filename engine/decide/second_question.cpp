// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/second_question.hpp"

#include <algorithm>
#include <utility>

#include "engine/large/decide_large.hpp"
#include "stickslip/engine/force_span.hpp"
#include "stickslip/engine/grasp_law.hpp"

namespace stickslip {
namespace {

/// Returns the motion of a grasp that holds, or nothing if none is known.
RationalRow motion_of(const Stable& stable) {
  if (const auto* witness = std::get_if<Witness>(&stable.proof)) {
    const auto [x, y, r] = coordinates(witness->twist);
    return {x, y, r};
  }
  return stable.motion;
}

Question with_grasp(Question question, GraspBox box) {
  question.grasp = std::move(box);
  return question;
}

std::optional<Question> bounded(const Question& question, const Verdict& verdict) {
  GraspBox box = question.grasp.as_box();
  const auto bound = natural_bound(box, kFarMotion);
  if (!bound) return std::nullopt;
  bool is_far = true;
  if (const auto* stable = std::get_if<Stable>(&verdict)) {
    const RationalRow motion = motion_of(*stable);
    is_far = false;
    for (std::size_t j = 0; j < motion.size(); ++j) {
      is_far = is_far || abs(motion[j]) > (*bound)[j];
    }
  }
  if (!is_far) return std::nullopt;
  box.max_motion = *bound;
  return with_grasp(question, std::move(box));
}

/// Returns the nearest load that no free motion sees, if the part of this one that it lacks is
/// rounding alone.
std::optional<RationalRow> without_rounding(const Law& law, const RationalRow& load) {
  const ForceSpan span(law);
  if (span.rank() == law.motions) return std::nullopt;
  const Rational length = law.short_length();
  RationalRow opposed = opposed_part(span, law, load, length);
  if (opposed == load) return std::nullopt;
  RationalRow off = load;
  for (std::size_t j = 0; j < off.size(); ++j) off[j] -= opposed[j];
  static const Rational kRounding = parse_rational("1e-24");  // the bound on squares
  if (law.squared_size(off, length) > kRounding * law.squared_size(load, length)) {
    return std::nullopt;
  }
  return opposed;
}

std::optional<Question> without_rounding(const Question& question) {
  GraspBox box = question.grasp.as_box();
  if (box.ball) return std::nullopt;
  RationalRow load;
  for (const Interval& component : box.wrench) {
    if (!component.is_point()) return std::nullopt;
    load.push_back(component.low);
  }
  const auto opposed = without_rounding(GraspLaw(box, question.law), load);
  if (!opposed) return std::nullopt;
  for (std::size_t j = 0; j < opposed->size(); ++j) {
    box.wrench[j] = point_interval((*opposed)[j]);
  }
  return with_grasp(question, std::move(box));
}

}  // namespace

std::optional<Question> second_question(const Question& question, const Verdict& verdict) {
  // A second answer about more contacts takes more memory than the first.
  constexpr std::size_t kMostContacts = 10000;
  const LoadedGrasp* one = question.grasp.single();
  if (one != nullptr && one->grasp.size() > kMostContacts) return std::nullopt;
  const GraspBox* box = question.box();
  if (box != nullptr && is_large(*box)) return std::nullopt;
  if (std::holds_alternative<Fragile>(verdict)) return std::nullopt;
  if (std::holds_alternative<Unstable>(verdict)) return without_rounding(question);
  if (question.is_bounded()) return std::nullopt;
  // A box that is undecided for other reasons takes as long once more.
  const auto* undecided = std::get_if<Undecided>(&verdict);
  if (undecided != nullptr && box != nullptr && !box->is_point() &&
      undecided->reason != "far") {
    return std::nullopt;
  }
  return bounded(question, verdict);
}

std::optional<RationalRow> opposed_direction(const Question& question) {
  if (!question.direction) return std::nullopt;
  return without_rounding(GraspLaw(question.grasp.as_box(), question.law), *question.direction);
}

Rational squared_distance(const Question& a, const Question& b) {
  const Law law = GraspLaw(a.grasp.as_box(), a.law);
  RationalRow difference = middle_of(a.grasp.wrench());
  const RationalRow other = middle_of(b.grasp.wrench());
  for (std::size_t j = 0; j < difference.size(); ++j) difference[j] -= other[j];
  return law.squared_size(difference, law.short_length());
}

}  // namespace stickslip
