// SPDX-License-Identifier: GPL-3.0-or-later
#include "method_answer.hpp"

#include <algorithm>

#include "stickslip/core/error.hpp"
#include "stickslip/engine/decide_in_time.hpp"
#include "stickslip/engine/refutation_summary.hpp"

namespace stickslip {
namespace earlier_detail {

std::string Method::word() const {
  std::string result;
  for (const char letter : std::string(name)) {
    if (letter != ',') result += letter == ' ' ? '-' : letter;
  }
  return result;
}

bool Method::is_among(const std::vector<std::string>& words) const {
  return std::any_of(words.begin(), words.end(), [this](const std::string& given) {
    return given == word() || (short_name != nullptr && given == short_name);
  });
}

const std::vector<Method>& all_methods() {
  constexpr const char* kPangTrinkle = "Pang and Trinkle 2000";
  constexpr const char* kFerrariCanny = "Ferrari and Canny 1992";
  constexpr const char* kRobustness = "Prattichizzo et al. 1997";
  static const std::vector<Method> methods{
      {MethodId::kPassive, "passive equilibrium", "Haas-Heger et al. 2018", true, true},
      {MethodId::kFormClosure, "form closure", "Liu 1999", false, true},
      {MethodId::kFrictionless, "frictionless stable load", kPangTrinkle, true, true},
      {MethodId::kStronglyStable, "strongly stable load", kPangTrinkle, true, true},
      {MethodId::kWeaklyStable, "weakly stable load", kPangTrinkle, true, true},
      {MethodId::kWrenchSpaceL1, "grasp wrench space, L1", kFerrariCanny, false, true},
      {MethodId::kWrenchSpaceLinf, "grasp wrench space, Linf", kFerrariCanny, false, false},
      {MethodId::kLinearCompliance, "linear compliance", "Cutkosky and Kao 1989, Bicchi 1993",
       true, true},
      {MethodId::kThreeStates, "three-state compliance", "Prattichizzo et al. 1997", true,
       false},
      {MethodId::kFrictionCones, "friction cones alone", "Haas-Heger et al. 2018, Eqs. 1-4",
       true, true},
      {MethodId::kContactRobustness, "potential contact robustness", kRobustness, false, true,
       "PCR"},
      {MethodId::kGraspRobustness, "potential grasp robustness", kRobustness, false, true,
       "PGR"},
      {MethodId::kRigidMotionRobustness, "robustness of rigid motions",
       "Haas-Heger et al. 2018", false, false},
      {MethodId::kGraspMap, "least singular value", "Li and Sastry 1988; Kim and Oh 1991",
       false, true},
      {MethodId::kWrenchVolume, "volume of the wrench space", "Miller and Allen 1999", false,
       true},
      {MethodId::kLeastForce, "least normal forces", "Han, Trinkle and Li 2000", false, true},
      {MethodId::kInternalMargin, "margin of internal forces", "Kerr and Roth 1986", false,
       true},
      {MethodId::kCentroid, "distance of the centroid", "Ding et al. 2001", false, true},
  };
  return methods;
}

MethodAnswer of_load(bool accepts, std::string why, Json evidence) {
  return {accepts ? "stable" : "unstable", std::move(why), std::move(evidence)};
}

MethodAnswer given_up(const Undecided& undecided) {
  return {kNotComputed, in_words(undecided), {{"limit", undecided.limit}}};
}

MethodAnswer not_for(const InputError& error) {
  return {kNotComputed,
          error.place() + ": " + error.problem() + "; " + error.remedy(),
          {{"error", error.what()}}};
}

std::string contact_name(std::size_t index) {
  return "contact " + std::to_string(index);
}

std::string leaves_refuted(std::size_t count) {
  return "(" + std::to_string(count) + (count == 1 ? " leaf refuted)" : " leaves refuted)");
}

MethodAnswer refuted(const Trees& refutation, const std::string& why) {
  const RefutationSummary summary = summarize(refutation);
  return of_load(false, why + " " + leaves_refuted(summary.leaves),
                 {{"refutation", {{"nodes", summary.nodes}, {"leaves", summary.leaves}}}});
}

MethodAnswer closure_answer(const std::variant<FormClosure, FreeMotion>& found,
                            NumberText& text) {
  if (const auto* motion = std::get_if<FreeMotion>(&found)) {
    return {"not closed",
            "the contacts allow the motion " + text.direction(motion->motion),
            {{"motion", number_json(motion->motion)}}};
  }
  const auto& closure = std::get<FormClosure>(found);
  Json spanning = Json::array();
  for (const ContactId contact : closure.spanning) spanning.push_back(contact.index());
  return {
      "closed",
      "the contacts leave no motion, even without friction",
      {{"multipliers", number_json(closure.multipliers)}, {"spanning", std::move(spanning)}}};
}

MethodAnswer unresisted_answer(const UnresistedMotion& found, NumberText& text) {
  return of_load(false,
                 "no spring resists the motion " + text.direction(found.motion) +
                     ", along which the load does work",
                 {{"motion", number_json(found.motion)}});
}

std::vector<MethodRow> asked(const std::vector<Method>& among, const CompareOptions& options,
                             const std::function<MethodAnswer(MethodId)>& answer) {
  const std::vector<std::string>& words = options.methods;
  check_methods(words);
  std::vector<MethodRow> rows;
  for (const Method& method : among) {
    if (!words.empty() && !method.is_among(words)) continue;
    MethodAnswer a = given_up(out_of_time(options.time));
    if (!options.time.is_over()) options.time.finishes([&] { a = answer(method.id); });
    std::optional<bool> agrees;
    const std::string passive = all_methods().front().name;
    if (!rows.empty() && rows.front().method == passive && method.about_the_load &&
        a.verdict != kNotComputed && rows.front().verdict != "undecided" &&
        rows.front().verdict != kNotComputed) {
      agrees = a.verdict == rows.front().verdict;
    }
    rows.push_back({method.name, method.source, method.about_the_load, std::move(a.verdict),
                    std::move(a.why), std::move(a.evidence), agrees});
  }
  return rows;
}

std::optional<std::string> class_of(std::optional<bool> weakly, std::optional<bool> strongly) {
  if (weakly == false) return "must move";
  if (strongly == true) return "must hold";
  if (weakly && strongly) return "open";
  return std::nullopt;
}

void check_options(const Question& question, const CompareOptions& options) {
  if (options.edges > 0 && !question.in_space()) {
    throw InputError("", "edges", "the grasp is in the plane, where a cone has two edges",
                     "leave it out");
  }
  constexpr std::size_t kMostEdges = 64;
  if (options.edges > kMostEdges || options.edges == 1 || options.edges == 2) {
    throw InputError("", "edges", "the value is " + std::to_string(options.edges),
                     "a pyramid has from 3 to " + std::to_string(kMostEdges) +
                         " edges here; 0 is a round cone");
  }
  const std::size_t forces = options.most_forces.size();
  if (forces == 1 || forces == question.grasp.as_box().contacts.size()) return;
  throw InputError("", "max_force",
                   "there are " + std::to_string(forces) + " numbers, but not as many contacts",
                   "give one for all, or one for each");
}

GraspBox point_grasp(const Question& question) {
  if (question.in_space()) return point_in_space(question);
  problem_of(without_bound(question));
  return question.grasp.as_box();
}

}  // namespace earlier_detail

std::vector<std::string> method_words() {
  std::vector<std::string> words;
  for (const earlier_detail::Method& method : earlier_detail::all_methods()) {
    words.push_back(method.word());
    if (method.short_name != nullptr) words.emplace_back(method.short_name);
  }
  return words;
}

void check_methods(const std::vector<std::string>& words) {
  const std::vector<std::string> known = method_words();
  for (const std::string& word : words) {
    if (std::find(known.begin(), known.end(), word) != known.end()) continue;
    throw InputError("", "methods", "there is no method " + quote(word),
                     choice_of(word, known, "there are "));
  }
}

}  // namespace stickslip
