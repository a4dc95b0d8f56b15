// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/model_warnings.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "box_warnings.hpp"
#include "edge_balance.hpp"
#include "engine/equilibrium/long_rationals.hpp"
#include "engine/planar/double_model.hpp"
#include "engine/planar/few_shares.hpp"
#include "engine/planar/region_program.hpp"
#include "engine/planar/witness_search.hpp"

namespace stickslip {

namespace {

std::optional<std::string> large_motion_of(const Question& question, const Twist& d) {
  const std::vector<Contact>& contacts = question.loaded().grasp.contacts();
  std::vector<std::array<Rational, 2>> points;
  for (const Contact& c : contacts) points.push_back({c.position.x, c.position.y});
  // A witness may have a denominator of thousands of digits, so it is scaled once, not at each
  // contact.
  const ScaledTwist scaled(d);
  const Twist& t = scaled.twist;
  const auto moved = [&](std::size_t i) -> Rational {
    const Rational x = t.x - t.r * points[i][1];
    const Rational y = t.y + t.r * points[i][0];
    return x * x + y * y;
  };
  return large_motion({scaled.scale, t.r * t.r, points.size(), moved, squared_width(points)},
                      !question.assumed_stiffness.empty());
}

/// Returns the warning about lost preload of a problem, or of a family at its multiple.
std::optional<std::string> lost_preload_of(const Problem& problem, const Twist& d,
                                           const Rational& multiple = 0) {
  const IntegerVector5 point = primitive_multiple<5>({d.x, d.y, d.r, 1, multiple});
  Vector5 x;
  std::copy(point.begin(), point.end(), x.begin());
  return lost_preload(problem.size(), [&](std::size_t i) {
    const Vector5& v = problem.separation(ContactId(i));
    return std::pair{Rational(v[3] * x[3] + v[4] * x[4]), dot(v, x)};
  });
}

bool is_preloaded(const Problem& problem) {
  return std::any_of(problem.rows().begin(), problem.rows().end(),
                     [](const ContactRow& row) { return !row.preload.is_zero(); });
}

/// Returns the preloaded contacts in doubles; nothing if a number is not moderate.
std::optional<std::vector<RestingContact<3>>> preloaded_contacts(const Problem& problem) {
  std::vector<RestingContact<3>> contacts;
  bool moderate = true;
  const auto read = [&](const Rational& value) {
    const double rounded = to_double(value);
    moderate = moderate && is_moderate(rounded) && (rounded != 0) == !value.is_zero();
    return rounded;
  };
  for (const ContactRow& row : problem.rows()) {
    if (row.preload.is_zero()) continue;
    const double preload = read(row.preload);
    const double friction = preload * read(row.friction);
    const Vector3 normal = coordinates(row.normal);
    const Vector3 tangent = coordinates(row.tangent);
    RestingContact<3>& c = contacts.emplace_back();
    for (std::size_t j = 0; j < 3; ++j) {
      c.push[j] = preload * read(normal[j]);
      c.friction[0][j] = friction * read(tangent[j]);
      constexpr double kRounding = 1e-15;  // fewer than five factors and products
      c.error[j] = kRounding * (std::fabs(c.push[j]) + std::fabs(c.friction[0][j]));
    }
  }
  if (!moderate) return std::nullopt;
  return contacts;
}

/// Returns true if friction balances the normal forces P_i at the motion 0, without load.
bool preloads_balance(const Problem& problem) {
  auto contacts = preloaded_contacts(problem);
  if (contacts && is_certainly_unbalanced(std::move(*contacts))) return false;
  const Problem unloaded = problem.with_wrench({});
  if (find_forces(unloaded, {})) return true;
  Region at_rest = Region::root(problem);
  for (std::size_t j = 0; j < 3; ++j) {
    IntegerVector5 axis{};
    axis[j] = 1;
    // Both half-spaces contain their planes, so no condition is strict.
    at_rest = std::move(at_rest).plane_child(axis, Side::kPositive);
    at_rest = std::move(at_rest).plane_child(negated(axis), Side::kPositive);
  }
  const auto outcome = solve_region(unloaded, at_rest, nullptr);
  return std::holds_alternative<RelaxedPoint>(outcome);
}

/// Requires that the problem is no family.
void add_unbalanced_preload(const Problem& problem, ModelWarnings& warnings) {
  if (!is_preloaded(problem) || preloads_balance(problem)) return;
  warnings.add(ModelTrap::kUnbalancedPreload, unbalanced_preload());
}

/// Proposes, by doubles, whether another stiffness of one contact changes the verdict.
class StiffnessInDoubles {
 public:
  StiffnessInDoubles(const Problem& problem, bool stable)
      : problem_(problem), model_(problem), stable_(stable) {
    const double factor = to_double(friction_to_tell_by(stable));
    for (ContactDoubles& c : model_.contacts) {
      for (double& entry : c.friction) entry *= factor;
    }
  }

  bool may_differ(ContactId contact, const Rational& stiffness) {
    // Doubles that start from rest miss equilibria, and let contacts open, which the bilateral
    // law forbids.
    if (!stable_ || problem_.law() == NormalLaw::kBilateral) return true;
    ContactDoubles& c = model_.contacts[contact.index()];
    const ContactDoubles before = c;
    const double all = model_.stiffness;
    const double factor = to_double(stiffness / problem_.row(contact).stiffness);
    for (std::size_t j = 0; j < 3; ++j) c.separation[j] *= factor;
    c.stiffness *= factor;
    model_.stiffness += c.stiffness - before.stiffness;
    const bool is_stable = !newton_equilibria(model_, 0, 1).empty();
    c = before;
    model_.stiffness = all;
    return is_stable != stable_;
  }

 private:
  const Problem& problem_;
  DoubleModel model_;
  bool stable_;
};

std::optional<std::string> assumed_stiffness_of(const Question& question,
                                                const Problem& problem, bool stable,
                                                std::size_t nodes) {
  const std::vector<Contact>& contacts = question.loaded().grasp.contacts();
  if (question.assumed_stiffness.empty() || contacts.size() > kMostContactsToVary) {
    return std::nullopt;
  }
  StiffnessInDoubles in_doubles(problem, stable);
  StiffnessTrial trial{{}, question.assumed_stiffness, stable, nodes, {}, {}};
  for (const Contact& c : contacts) trial.stiffness.push_back(c.stiffness);
  trial.may_differ = [&](ContactId contact, const Rational& stiffness) {
    return in_doubles.may_differ(contact, stiffness);
  };
  trial.is_stable = [&](ContactId contact, const Rational& stiffness,
                        std::size_t& left) -> std::optional<bool> {
    std::vector<Contact> varied = contacts;
    varied[contact.index()].stiffness = stiffness;
    SearchOptions options;
    options.node_limit = left;
    BranchWork work;
    const Verdict verdict = branch_and_bound(
        Problem({Grasp(std::move(varied)), question.loaded().wrench}, question.law), options,
        &work);
    left -= std::min(left, 1 + work.nodes);
    if (std::holds_alternative<Undecided>(verdict)) return std::nullopt;
    return std::holds_alternative<Stable>(verdict);
  };
  return assumed_stiffness(trial);
}

}  // namespace

std::vector<ModelWarning> model_warnings(const Answer& answer, bool only_of_motion) {
  if (!answer.problem) return warnings_detail::box_warnings(answer, only_of_motion);
  const Question& question = answer.question;
  const Problem& problem = *answer.problem;
  const Verdict& verdict = answer.verdict;
  const auto* stable = std::get_if<Stable>(&verdict);
  const auto* unstable = std::get_if<Unstable>(&verdict);
  ModelWarnings warnings;
  if (stable != nullptr) {
    warnings.add(ModelTrap::kLargeMotion, large_motion_of(question, stable->witness().twist));
  }
  if (!only_of_motion) add_unbalanced_preload(problem, warnings);
  if (stable != nullptr) {
    warnings.add(ModelTrap::kLostPreload, lost_preload_of(problem, stable->witness().twist));
  }
  if (!only_of_motion && !std::holds_alternative<Undecided>(verdict)) {
    const std::size_t nodes = unstable != nullptr ? unstable->tree.size() : 0;
    warnings.add(ModelTrap::kAssumedStiffness,
                 assumed_stiffness_of(question, problem, stable != nullptr, nodes));
  }
  if (!only_of_motion && stable != nullptr) {
    warnings.add(ModelTrap::kEdgeBalance, warnings_detail::balance_on_an_edge(question.grasp));
  }
  return std::move(warnings).take();
}

std::vector<ModelWarning> model_warnings(const Question& question, const Margin& margin) {
  const Problem family = problem_of(question);
  ModelWarnings warnings;
  const auto look_at = [&](const Rational& multiple, const Twist& d) {
    const auto at_multiple = [&](std::optional<std::string> text) {
      if (text) *text = "at the multiple " + to_readable_string(multiple) + " " + *text;
      return text;
    };
    if (!warnings.has(ModelTrap::kLargeMotion)) {
      warnings.add(ModelTrap::kLargeMotion, at_multiple(large_motion_of(question, d)));
    }
    if (warnings.has(ModelTrap::kLostPreload)) return;
    warnings.add(ModelTrap::kLostPreload, at_multiple(lost_preload_of(family, d, multiple)));
  };
  for (const MarginSegment& segment : margin.segments) {
    look_at(segment.low, segment.start.twist);
    if (segment.high) look_at(*segment.high, segment.end.twist);
  }
  const Problem base = family.at(0);
  add_unbalanced_preload(is_preloaded(base) ? base : family.at(1), warnings);
  return std::move(warnings).take();
}

}  // namespace stickslip
