// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "method_answer.hpp"
#include "stickslip/earlier/robustness.hpp"

namespace stickslip {
namespace earlier_detail {
namespace {

/// \{ PCR and PGR, and that of rigid motions, of more contacts than these are not computed.
constexpr std::size_t kMostContacts = 64;
constexpr std::size_t kMostContactsInMotion = 24;
/// \}

constexpr std::array<const char*, 3> kStateNames{"stick", "slip", "detached"};

/// Returns bounds for people. Where they are closer than a millionth, they are moved apart.
DecimalEnclosure shown(const Robustness& found, const NumberText& text) {
  const Rational apart = found.upper / 2000000;
  const bool is_close = found.upper - found.lower < apart;
  return is_close ? text.around(found.lower - apart, found.upper + apart)
                  : text.around(found.lower, found.upper);
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

MethodAnswer robustness_answer(const GraspBox& grasp, MethodId method,
                               const CompareOptions& options, NumberText& text) {
  const std::size_t most_contacts =
      method == MethodId::kRigidMotionRobustness ? kMostContactsInMotion : kMostContacts;
  if (grasp.contacts.size() > most_contacts) {
    const std::string limit = std::to_string(most_contacts) + " contacts";
    return {kNotComputed, "there are more than " + limit, {{"limit", limit}}};
  }
  RobustnessOptions asked;
  asked.length = options.length;
  asked.most_forces = options.most_forces;
  asked.accuracy = options.accuracy;
  asked.node_limit = options.node_limit;
  Robustness found;
  try {
    found = method == MethodId::kContactRobustness ? potential_contact_robustness(grasp, asked)
                                                   : potential_grasp_robustness(grasp, asked);
  } catch (const InputError& error) {
    return not_for(error);
  }
  const std::string most =
      asked.most_forces.size() == 1 ? text(asked.most_forces[0]) : text(asked.most_forces);
  Json evidence{{"lower", number_json(found.lower)},
                {"upper", number_json(found.upper)},
                {"max_force", number_json(asked.most_forces)},
                {"complete", found.is_complete},
                {"nodes", found.nodes}};
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
  const DecimalEnclosure bounds = shown(found, text);
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
  if (!found.is_complete) {
    why += "; the search ended after " + std::to_string(found.nodes) + " nodes";
  }
  return {bounds.lower + " to " + bounds.upper, std::move(why), std::move(evidence)};
}

}  // namespace earlier_detail
}  // namespace stickslip
