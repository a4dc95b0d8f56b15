// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/certificate/proved_files.hpp"

#include <utility>

#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/engine/decide_problem.hpp"

namespace stickslip {
namespace {

/// Returns the question about a box. A file has no ball of loads, so that is an option of the
/// question.
Question about(GraspBox box, NormalLaw law) {
  QuestionOptions options;
  options.law = law;
  options.uncertain.ball = std::exchange(box.ball, {});
  return ask({std::move(box)}, options);
}

void require_verdict(bool stable, const std::string& found) {
  require(found == (stable ? "stable" : "unstable"),
          "a grasp that was found has another verdict");
}

}  // namespace

ProvedFiles proved_grasp(const GraspBox& point, NormalLaw law, bool stable,
                         const std::string& producer) {
  if (simplest(point).single() == nullptr) {
    const BoxDecision decision = decide_box(point, law);
    require_verdict(stable, name_of(decision.verdict));
    return proved_box(point, law, decision, producer);
  }
  const Question question = about(point, law);
  const Verdict verdict = decide(problem_of(question)).verdict;
  require_verdict(stable, name_of(verdict));
  return {write_grasp(point), certificate_text(question, verdict, producer), {}, {}};
}

ProvedFiles proved_box(const GraspBox& box, NormalLaw law, const BoxDecision& decision,
                       const std::string& producer) {
  if (simplest(box).single() != nullptr) {
    const bool stable = std::holds_alternative<Stable>(decision.verdict);
    return proved_grasp(box, law, stable, producer);
  }
  return {write_grasp(box),
          certificate_text(about(box, law), decision.verdict, producer, decision.bits),
          box.ball ? "wrench=" + to_string(*box.ball) : "",
          {}};
}

std::vector<ProvedFiles> proved_decision(const GraspBox& box, NormalLaw law,
                                         const BoxDecision& decision,
                                         const std::string& producer) {
  if (const auto* fragile = std::get_if<Fragile>(&decision.verdict)) {
    return {proved_grasp(fragile->stable, law, true, producer),
            proved_grasp(fragile->unstable, law, false, producer)};
  }
  if (std::holds_alternative<Undecided>(decision.verdict)) return {};
  return {proved_box(box, law, decision, producer)};
}

std::vector<ProvedFiles> proved_radius(const GraspBox& centre, const GraspBox& box,
                                       NormalLaw law, const Radius& radius,
                                       const std::string& producer) {
  require(radius.stable.has_value(), "the radius of a box about a centre with a verdict");
  const auto grasp = [&](const GraspBox& point, bool stable) {
    return proved_grasp(point, law, stable, producer);
  };
  std::vector<ProvedFiles> files;
  files.push_back(
      radius.proof ? proved_box(box.scaled(centre, radius.proved), law, *radius.proof, producer)
                   : grasp(centre, *radius.stable));
  if (radius.example) files.push_back(grasp(*radius.example, !*radius.stable));
  return files;
}

}  // namespace stickslip
