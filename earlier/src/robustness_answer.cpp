// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "method_answer.hpp"
#include "stickslip/earlier/force_measures.hpp"
#include "stickslip/earlier/grasp_map.hpp"
#include "stickslip/earlier/robustness.hpp"

namespace stickslip {

using namespace earlier_detail;

namespace {

/// \{ PCR and PGR, and that of rigid motions, of more contacts than these are not computed;
/// nor are singular values of more than the former.
constexpr std::size_t kMostContacts = 64;
constexpr std::size_t kMostContactsInMotion = 24;
/// \}

}  // namespace

std::optional<RobustnessKind> CompareOptions::only_robustness() const {
  for (const Method& method : all_methods()) {
    if (methods.size() != 1 || !method.is_among(methods)) continue;
    if (method.id == MethodId::kContactRobustness) return RobustnessKind::kContact;
    if (method.id == MethodId::kGraspRobustness) return RobustnessKind::kGrasp;
  }
  return std::nullopt;
}

RobustnessOptions CompareOptions::for_robustness() const {
  RobustnessOptions result;
  result.length = length;
  result.most_forces = most_forces;
  result.accuracy = accuracy;
  result.node_limit = node_limit;
  result.edges = edges;
  return result;
}

Robustness robustness_to_prove(const Question& question, RobustnessKind kind,
                               const CompareOptions& options) {
  check_options(question, options);
  if (options.edges > 0) {
    throw InputError("", "edges", "a certificate is of round cones",
                     "leave out the edges, or the certificate");
  }
  const std::size_t count = question.grasp.as_box().contacts.size();
  if (count > kMostContacts) {
    throw InputError(
        "", "contacts", "there are " + std::to_string(count),
        "a robustness is computed of " + std::to_string(kMostContacts) + " at most");
  }
  return potential_robustness(kind, point_grasp(question), options.for_robustness());
}

namespace earlier_detail {
namespace {

constexpr std::array<const char*, 3> kStateNames{"stick", "slip", "detached"};

MethodAnswer too_many(std::size_t most) {
  const std::string limit = std::to_string(most) + " contacts";
  return {kNotComputed, "there are more than " + limit, {{"limit", limit}}};
}

/// Returns bounds >= 0 for people. Where they are closer than a millionth, they are moved
/// apart.
DecimalEnclosure shown(const Rational& lower, const Rational& upper, const NumberText& text) {
  const Rational apart = upper / 2000000;
  const bool is_close = upper - lower < apart;
  return is_close ? text.around(lower - apart, upper + apart) : text.around(lower, upper);
}

std::string in_words(const DecimalEnclosure& bounds) {
  return bounds.lower + " to " + bounds.upper;
}

/// Returns bounds of the root of a number between two.
Interval root_of(const Rational& low, const Rational& high) {
  constexpr unsigned kShownBits = 60;
  return {short_sqrt(low, kShownBits).lower, short_sqrt(high, kShownBits).upper};
}

Json interval_json(const Interval& x) {
  return {number_json(x.low), number_json(x.high)};
}

/// Returns "contact 1 slips, contacts 2 and 3 detached", or that all stick.
std::string in_words(const std::vector<SpringState>& states) {
  std::string result;
  for (const SpringState state : {SpringState::kSlip, SpringState::kDetached}) {
    std::vector<std::string> numbers;
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (states[i] == state) numbers.push_back(std::to_string(i));
    }
    if (numbers.empty()) continue;
    result += result.empty() ? "" : ", ";
    result += numbers.size() == 1 ? "contact " : "contacts ";
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      result += (k == 0 ? "" : k + 1 == numbers.size() ? " and " : ", ") + numbers[k];
    }
    result +=
        state == SpringState::kSlip ? (numbers.size() == 1 ? " slips" : " slip") : " detached";
  }
  return result.empty() ? "all contacts stick" : result;
}

}  // namespace

namespace {

/// Says so where cones are pyramids.
std::string by_pyramids(const CompareOptions& options) {
  return options.edges == 0
             ? ""
             : "; with pyramids of " + std::to_string(options.edges) + " edges as cones";
}

void add_edges(Json& evidence, const CompareOptions& options) {
  if (options.edges > 0) evidence["edges"] = options.edges;
}

}  // namespace

MethodAnswer robustness_answer(const GraspBox& grasp, MethodId method,
                               const CompareOptions& options, NumberText& text) {
  const std::size_t most_contacts =
      method == MethodId::kRigidMotionRobustness ? kMostContactsInMotion : kMostContacts;
  if (grasp.contacts.size() > most_contacts) return too_many(most_contacts);
  const RobustnessOptions asked = options.for_robustness();
  const Robustness found = options.robustness != nullptr ? *options.robustness
                           : method == MethodId::kRigidMotionRobustness
                               ? rigid_motion_robustness(grasp, asked)
                           : method == MethodId::kContactRobustness
                               ? potential_robustness(RobustnessKind::kContact, grasp, asked)
                               : potential_robustness(RobustnessKind::kGrasp, grasp, asked);
  const std::string most =
      asked.most_forces.size() == 1 ? text(asked.most_forces[0]) : text(asked.most_forces);
  Json evidence{{"lower", number_json(found.lower)},
                {"upper", number_json(found.upper)},
                {"max_force", number_json(asked.most_forces)},
                {"complete", found.is_complete},
                {"nodes", found.nodes}};
  add_edges(evidence, options);
  if (!found.has_full_rank) {
    return {"0", "the contacts leave a motion free, even if all stick", std::move(evidence)};
  }
  if (!found.balances) {
    return {"none", "no forces up to " + most + " in the cones balance the load",
            std::move(evidence)};
  }
  if (found.upper.is_zero()) {
    return {"0", "no internal forces keep contacts away from breaking a condition",
            std::move(evidence)};
  }
  std::string why;
  if (found.best) {
    evidence["distance"] = number_json(found.best->distance);
    evidence["inverse_square"] = number_json(found.best->inverse_square);
    Json& states = evidence["states"] = Json::array();
    Json& forces = evidence["forces"] = Json::array();
    for (std::size_t i = 0; i < found.best->states.size(); ++i) {
      states.push_back(kStateNames[static_cast<std::size_t>(found.best->states[i])]);
      forces.push_back(number_json(found.best->forces[i]));
    }
    why = "forces that a hand makes at will, up to " + most + ", are " +
          text(found.best->distance) + " from breaking a condition (" +
          in_words(found.best->states) + "); quality is of forces that arise passively";
  } else {
    why = "whether forces can be away from breaking a condition is open";
  }
  why += by_pyramids(options);
  if (!found.is_complete) {
    why += "; the search ended after " + std::to_string(found.nodes) + " nodes";
  }
  return {in_words(shown(found.lower, found.upper, text)), std::move(why), std::move(evidence)};
}

MethodAnswer grasp_map_answer(const GraspBox& grasp, const Rational& length, NumberText& text) {
  if (grasp.contacts.size() > kMostContacts) return too_many(kMostContacts);
  const GraspMapMeasures found = grasp_map_measures(grasp, length);
  const Interval least = root_of(found.least_square.low, found.least_square.high);
  const Interval largest = root_of(found.largest_square.low, found.largest_square.high);
  Json evidence{{"least", interval_json(least)},
                {"largest", interval_json(largest)},
                {"determinant", number_json(found.determinant)}};
  if (found.determinant.is_zero()) {
    return {"0", "some wrench cannot be given, whichever forces there are",
            std::move(evidence)};
  }
  const Interval isotropy{least.low / largest.high, least.high / largest.low};
  evidence["isotropy"] = interval_json(isotropy);
  return {in_words(shown(least.low, least.high, text)),
          "isotropy, the part of the largest that it is, " +
              in_words(shown(isotropy.low, isotropy.high, text)) + "; sqrt(det(G G^T)) = " +
              text.root(1, found.determinant) + "; neither cones nor preloads play a part",
          std::move(evidence)};
}

namespace {

/// A hull of more facets than these has no volume here.
constexpr std::size_t kMostFacets = 5000;

/// Returns bounds, or the number if both are it.
std::string bounds_in_words(const Rational& lower, const Rational& upper, NumberText& text) {
  return lower == upper ? text(lower) : in_words(shown(lower, upper, text));
}

Json rows_json(const std::vector<RationalRow>& rows) {
  Json json = Json::array();
  for (const RationalRow& row : rows) json.push_back(number_json(row));
  return json;
}

Json least_force_json(const LeastForce& found) {
  return {{"lower", number_json(found.lower)},
          {"upper", found.upper ? number_json(*found.upper) : Json(nullptr)},
          {"forces", rows_json(found.forces)},
          {"motion", number_json(found.twist)}};
}

}  // namespace

MethodAnswer wrench_volume_answer(const GraspBox& grasp, const CompareOptions& options,
                                  NumberText& text) {
  if (grasp.contacts.size() > kMostContacts) return too_many(kMostContacts);
  const std::optional<HullVolume> found =
      wrench_space_volume(grasp, options.length, kMostFacets, options.edges);
  if (!found) {
    const std::string limit = std::to_string(kMostFacets) + " facets";
    return {kNotComputed, "the hull has more than " + limit, {{"limit", limit}}};
  }
  Json evidence{{"lower", number_json(found->lower)}, {"upper", number_json(found->upper)}};
  add_edges(evidence, options);
  if (found->upper.is_zero()) {
    return {"0", "the wrenches of unit normal forces are flat", std::move(evidence)};
  }
  return {bounds_in_words(found->lower, found->upper, text),
          std::string("of the convex hull of 0 and unit normal forces with friction, ") +
              (grasp.in_space() && options.edges == 0
                   ? "whose discs are between polygons of eight corners"
                   : "torques over the length") +
              by_pyramids(options),
          std::move(evidence)};
}

MethodAnswer least_force_answer(const GraspBox& grasp, const CompareOptions& options,
                                NumberText& text) {
  if (grasp.contacts.size() > kMostContacts) return too_many(kMostContacts);
  const LeastForce sum = least_force(grasp, ForceBound::kL1, options.edges);
  const LeastForce largest = least_force(grasp, ForceBound::kLinf, options.edges);
  Json evidence{{"sum", least_force_json(sum)}, {"largest", least_force_json(largest)}};
  add_edges(evidence, options);
  if (!sum.balances || !largest.balances) {
    return {"none", "no forces in the cones balance the load", std::move(evidence)};
  }
  if (!sum.upper || !largest.upper) {
    return {kNotComputed, "whether forces in the cones balance the load is open",
            std::move(evidence)};
  }
  return {bounds_in_words(sum.lower, *sum.upper, text),
          "the least sum that balances the load; by others none need be above " +
              bounds_in_words(largest.lower, *largest.upper, text) +
              "; quality is of forces that arise passively" + by_pyramids(options),
          std::move(evidence)};
}

MethodAnswer internal_margin_answer(const GraspBox& grasp, const CompareOptions& options,
                                    NumberText& text) {
  if (grasp.contacts.size() > kMostContacts) return too_many(kMostContacts);
  const RobustnessOptions asked = options.for_robustness();
  const InternalMargin found = internal_margin(grasp, asked);
  Json evidence{{"lower", number_json(found.lower)},
                {"upper", number_json(found.upper)},
                {"max_force", number_json(asked.most_forces)},
                {"forces", rows_json(found.forces)},
                {"motion", number_json(found.twist)}};
  add_edges(evidence, options);
  const std::string most =
      asked.most_forces.size() == 1 ? text(asked.most_forces[0]) : text(asked.most_forces);
  if (!found.balances) {
    return {"none", "no forces up to " + most + " in the cones balance the load",
            std::move(evidence)};
  }
  if (found.upper.is_zero()) {
    return {"0", "no internal forces keep contacts away from breaking a condition",
            std::move(evidence)};
  }
  return {bounds_in_words(found.lower, found.upper, text),
          "how far the best forces up to " + most +
              " are from breaking a condition at any contact" + by_pyramids(options),
          std::move(evidence)};
}

MethodAnswer centroid_answer(const GraspBox& grasp, const RationalRow& centre,
                             NumberText& text) {
  if (grasp.contacts.empty()) {
    return {kNotComputed, "there are no contacts", {{"contacts", 0}}};
  }
  const Rational square = squared_distance_of_centroid(grasp, centre);
  return {text.root(1, square),
          "from the mean of the contacts to the centre of mass; forces play no part",
          {{"distance_squared", number_json(square)}}};
}

}  // namespace earlier_detail
}  // namespace stickslip
