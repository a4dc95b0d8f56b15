// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/model_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "stickslip/equilibrium/decide.hpp"
#include "stickslip/equilibrium/search/region_program.hpp"

namespace stickslip {
namespace {

std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string root(const Rational& square) {
  return rounded(std::sqrt(to_double(square)));
}

Rational squared_length(const Vector2& v) {
  return v.x * v.x + v.y * v.y;
}

/// The square of the diagonal of the box around the contacts.
Rational squared_width(const std::vector<Contact>& contacts) {
  if (contacts.empty()) return 0;
  Vector2 low = contacts.front().position;
  Vector2 high = low;
  for (const Contact& c : contacts) {
    low = {std::min(low.x, c.position.x), std::min(low.y, c.position.y)};
    high = {std::max(high.x, c.position.x), std::max(high.y, c.position.y)};
  }
  return squared_length({high.x - low.x, high.y - low.y});
}

std::optional<std::string> large_motion(const Question& question, const Twist& d) {
  const std::vector<Contact>& contacts = question.loaded.grasp.contacts();
  std::string motion;
  if (abs(d.r) > kLargestRotation) {
    motion = "a turn by " + rounded(to_double(abs(d.r))) + " radians";
  }
  const Rational width = squared_width(contacts);
  // A witness may have a denominator of thousands of digits: once, and not at each contact.
  const Rational scale(lcm(lcm(denominator(d.x), denominator(d.y)), denominator(d.r)));
  const Twist scaled{scale * d.x, scale * d.y, scale * d.r};
  const Rational scaled_width = scale * scale * width;
  std::size_t farthest = 0;
  Rational moved = scaled_width;
  for (std::size_t i = 0; i < contacts.size() && !width.is_zero(); ++i) {
    const Vector2& p = contacts[i].position;
    const Rational distance =
        squared_length({scaled.x - scaled.r * p.y, scaled.y + scaled.r * p.x});
    if (distance <= moved) continue;
    moved = distance;
    farthest = i;
  }
  if (moved > scaled_width) {
    motion += (motion.empty() ? "contact " : ", contact ") + std::to_string(farthest) +
              " moves by " + root(moved / (scale * scale)) + " in a grasp " + root(width) +
              " wide";
  }
  if (motion.empty()) return std::nullopt;
  return "the motion found is too large for the model: " + motion +
         (question.assumed_stiffness.empty() ? "" : "; stiffness not given was taken as 1");
}

bool is_preloaded(const ContactRow& row) {
  return !row.preload.is_zero();
}

/// Whether friction balances the normal forces P_i at the motion 0, without load.
bool preloads_balance(const Problem& problem) {
  Region at_rest = Region::root(problem);
  for (std::size_t j = 0; j < 3; ++j) {
    IntegerVector5 axis{};
    axis[j] = 1;
    // Half-spaces that contain their planes: neither makes anything strict.
    at_rest = std::move(at_rest).plane_child(axis, Side::kPositive);
    at_rest = std::move(at_rest).plane_child(negated(axis), Side::kPositive);
  }
  const auto outcome = solve_region(problem.with_wrench({}), at_rest, nullptr);
  return std::holds_alternative<RelaxedPoint>(outcome);
}

/// Of a family at its multiple.
std::optional<std::string> lost_preload(const Problem& problem, const Twist& d,
                                        const Rational& multiple = 0) {
  const IntegerVector5 point = primitive_multiple<5>({d.x, d.y, d.r, 1, multiple});
  Vector5 x;
  std::copy(point.begin(), point.end(), x.begin());
  bool any = false;
  Rational largest_share = 0;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const Vector5& v = problem.separation(ContactId(i));
    const Rational preload = v[3] * x[3] + v[4] * x[4];
    if (preload.is_zero()) continue;
    any = true;
    const Rational kept = dot(v, x);
    if (kLeastPartOfPreload * kept >= preload) return std::nullopt;
    largest_share = std::max(largest_share, Rational(kept / preload));
  }
  if (!any) return std::nullopt;
  return "the preload is all but gone in this equilibrium: no contact keeps more than " +
         rounded(to_double(100 * largest_share)) + " % of its own";
}

/// The verdict with another stiffness of one contact; nothing if it is not found soon.
std::optional<bool> is_stable_with(const Question& question, ContactId contact,
                                   const Rational& stiffness) {
  std::vector<Contact> contacts = question.loaded.grasp.contacts();
  contacts[contact.index()].stiffness = stiffness;
  ConeOptions options;
  options.node_limit = 10000;
  const Verdict verdict =
      decide(Problem({Grasp(std::move(contacts)), question.loaded.wrench}, question.law),
             Engine::kCone, options)
          .verdict;
  if (std::holds_alternative<Undecided>(verdict)) return std::nullopt;
  return std::holds_alternative<Stable>(verdict);
}

/// The smallest and the largest stiffness that the file gives; none if it gives none.
std::vector<Rational> given_extremes(const Question& question) {
  std::vector<Rational> given;
  const std::vector<ContactId>& assumed = question.assumed_stiffness;
  for (std::size_t i = 0; i < question.loaded.grasp.size(); ++i) {
    if (std::find(assumed.begin(), assumed.end(), ContactId(i)) != assumed.end()) continue;
    given.push_back(question.loaded.grasp[ContactId(i)].stiffness);
  }
  if (given.empty()) return {};
  const auto [least, most] = std::minmax_element(given.begin(), given.end());
  return {*least, *most};
}

std::optional<std::string> assumed_stiffness(const Question& question, bool stable) {
  if (question.loaded.grasp.size() > kMostContactsToVary) return std::nullopt;
  std::vector<Rational> others = given_extremes(question);
  others.emplace_back(kStiffnessFactor);
  others.emplace_back(1, kStiffnessFactor);
  for (const ContactId contact : question.assumed_stiffness) {
    for (const Rational& other : others) {
      if (is_stable_with(question, contact, other).value_or(stable) == stable) continue;
      return "no stiffness is given for contact " + std::to_string(contact.index()) +
             ", so 1 was taken; with " + to_string(other) + " the verdict would be " +
             (stable ? "unstable" : "stable");
    }
  }
  return std::nullopt;
}

}  // namespace

const char* to_string(ModelTrap trap) {
  constexpr const char* kNames[] = {"large-motion", "unbalanced-preload", "lost-preload",
                                    "assumed-stiffness"};
  return kNames[static_cast<std::size_t>(trap)];
}

namespace {

class Warnings {
 public:
  void add(ModelTrap trap, std::optional<std::string> text) {
    if (text && !has(trap)) all.push_back({trap, std::move(*text)});
  }

  bool has(ModelTrap trap) const {
    return std::any_of(all.begin(), all.end(),
                       [&](const ModelWarning& w) { return w.trap == trap; });
  }

  std::vector<ModelWarning> all;
};

bool is_preloaded(const Problem& problem) {
  return std::any_of(problem.rows().begin(), problem.rows().end(),
                     [](const ContactRow& row) { return is_preloaded(row); });
}

/// Of what is no family.
void add_unbalanced_preload(const Problem& problem, Warnings& warnings) {
  if (!is_preloaded(problem) || preloads_balance(problem)) return;
  warnings.add(ModelTrap::kUnbalancedPreload,
               "the preloads do not balance, even with friction: the object moves before any "
               "load is applied");
}

}  // namespace

std::vector<ModelWarning> model_warnings(const Question& question, const Verdict& verdict) {
  const Problem problem = problem_of(question);
  const auto* stable = std::get_if<Stable>(&verdict);
  Warnings warnings;
  if (stable != nullptr) {
    warnings.add(ModelTrap::kLargeMotion, large_motion(question, stable->witness.twist));
  }
  add_unbalanced_preload(problem, warnings);
  if (stable != nullptr) {
    warnings.add(ModelTrap::kLostPreload, lost_preload(problem, stable->witness.twist));
  }
  if (!std::holds_alternative<Undecided>(verdict)) {
    warnings.add(ModelTrap::kAssumedStiffness, assumed_stiffness(question, stable != nullptr));
  }
  return std::move(warnings.all);
}

std::vector<ModelWarning> model_warnings(const Question& question, const Margin& margin) {
  const Problem family = problem_of(question);
  Warnings warnings;
  const auto look_at = [&](const Rational& multiple, const Twist& d) {
    const auto at_multiple = [&](std::optional<std::string> text) {
      if (text) *text = "at the multiple " + to_readable_string(multiple) + " " + *text;
      return text;
    };
    if (!warnings.has(ModelTrap::kLargeMotion)) {
      warnings.add(ModelTrap::kLargeMotion, at_multiple(large_motion(question, d)));
    }
    if (warnings.has(ModelTrap::kLostPreload)) return;
    warnings.add(ModelTrap::kLostPreload, at_multiple(lost_preload(family, d, multiple)));
  };
  for (const MarginSegment& segment : margin.segments) {
    look_at(segment.low, segment.start.twist);
    if (segment.high) look_at(*segment.high, segment.end.twist);
  }
  const Problem base = family.at(0);
  add_unbalanced_preload(is_preloaded(base) ? base : family.at(1), warnings);
  return std::move(warnings.all);
}

}  // namespace stickslip
