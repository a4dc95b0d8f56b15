// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/certificate/proved_files.hpp"

#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/equilibrium/decide.hpp"

namespace stickslip {
namespace {

Question about(const GraspFile& file, NormalLaw law) {
  QuestionOptions options;
  options.law = law;
  return ask(file, options);
}

void require_verdict(bool stable, const std::string& found) {
  require(found == (stable ? "stable" : "unstable"),
          "a grasp that was found has another verdict");
}

}  // namespace

ProvedFiles proved_grasp(const LoadedGrasp& loaded, const GraspDescription& description,
                         NormalLaw law, bool stable, const std::string& producer) {
  const LoadedGrasp described{Grasp(loaded.grasp.contacts(), description), loaded.wrench};
  const Question question = about({described}, law);
  std::string certificate;
  if (question.box) {
    const BoxDecision decision = decide_box(*question.box, law);
    require_verdict(stable, name_of(decision.verdict));
    certificate = box_certificate_text(question, decision, producer);
  } else {
    const Verdict verdict = decide(problem_of(question)).verdict;
    require_verdict(stable, name_of(verdict));
    certificate = certificate_text(question, verdict, producer);
  }
  return {write_grasp(described), certificate};
}

ProvedFiles proved_grasp(const SpatialGrasp& grasp, NormalLaw law, bool stable,
                         const std::string& producer) {
  SpatialOptions options;
  options.law = law;
  const SpatialQuestion question = ask(grasp, options);
  const SpatialDecision decision = decide(question);
  require_verdict(stable, name_of(decision.verdict));
  return {write_grasp_file(question.grasp),
          spatial_certificate_text(question, decision, producer)};
}

ProvedFiles proved_box(const GraspBox& box, const GraspDescription& description, NormalLaw law,
                       const BoxDecision& decision, const std::string& producer) {
  if (box.is_point()) {
    const bool stable = std::holds_alternative<StableThroughout>(decision.verdict);
    return proved_grasp(box.middle(), description, law, stable, producer);
  }
  const GraspFile file{box.middle(description), {}, {}, box};
  return {write_grasp_file(file), box_certificate_text(about(file, law), decision, producer)};
}

std::vector<ProvedFiles> proved_radius(const Question& question, const Radius& radius,
                                       const std::string& producer) {
  require(question.box && radius.stable, "the radius of a box about a centre with a verdict");
  const GraspDescription& description = question.loaded.grasp.description();
  const auto grasp = [&](const LoadedGrasp& loaded, bool stable) {
    return proved_grasp(loaded, description, question.law, stable, producer);
  };
  std::vector<ProvedFiles> files;
  files.push_back(radius.proof
                      ? proved_box(question.box->scaled(question.loaded, radius.proved),
                                   description, question.law, *radius.proof, producer)
                      : grasp(question.loaded, *radius.stable));
  if (radius.example) files.push_back(grasp(*radius.example, !*radius.stable));
  return files;
}

}  // namespace stickslip
