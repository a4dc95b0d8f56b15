// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/answers/verdict_answer.hpp"
#include "stickslip/certificate/certificate.hpp"

namespace stickslip {

std::vector<std::size_t> enclosed_contacts(const GraspBox& box) {
  std::vector<std::size_t> contacts;
  for (std::size_t i = 0; i < box.contacts.size(); ++i) {
    if (needs_enclosure({{box.contacts[i]}, {}})) contacts.push_back(i);
  }
  return contacts;
}

void add_verdict(Json& json, const GraspBox& box, const GraspDescription& description,
                 const BoxDecision& decision) {
  if (const auto* unstable = std::get_if<UnstableThroughout>(&decision.verdict)) {
    json["refutation"] = {{"nodes", unstable->tree.size()}};
  } else if (const auto* fragile = std::get_if<Fragile>(&decision.verdict)) {
    const auto file = [&](const GraspBox& grasp) {
      return Json::parse(write_grasp(grasp, description));
    };
    json["examples"] = {{"stable", file(fragile->stable)},
                        {"unstable", file(fragile->unstable)}};
    json["differences"] =
        differences_json(differences(box, fragile->stable, fragile->unstable));
  } else if (const auto* undecided = std::get_if<Undecided>(&decision.verdict)) {
    add_undecided(json, *undecided);
  }
}

std::optional<Vector3> motion_near(const BoxAnswer& answer) {
  const auto* stable = std::get_if<StableThroughout>(&answer.decision.verdict);
  const GraspBox& box = *answer.question.box;
  if (stable == nullptr || !box.is_point()) return std::nullopt;
  const RationalRow& near = stable->motion;
  return Vector3{near[0], near[1], near[2]};
}

Json to_json(const BoxAnswer& answer) {
  const auto& [question, decision] = answer;
  const GraspBox& box = *question.box;
  Json json;
  json["verdict"] = name_of(decision.verdict);
  // One grasp is none, though it is proved as if it were.
  if (!box.is_point()) json["box"] = true;
  json["name"] = question.loaded.grasp.name();
  if (!question.case_name.empty()) json["case"] = question.case_name;
  add_units(json, question.loaded.grasp);
  json["engine"] = kIntervalsEngine;
  json["normal_law"] = to_string(question.law);
  json["wrench"] = wrench_json(box.wrench);
  json["uncertain"] = uncertain_json(uncertain_numbers(box));
  add_enclosed(json, enclosed_contacts(box), decision.bits);
  if (const auto* stable = std::get_if<StableThroughout>(&decision.verdict)) {
    if (const auto near = motion_near(answer)) json["near"] = number_json(*near);
    json["proof"] = proof_json(std::get<StabilityProof>(stable->proof));
  }
  add_verdict(json, box, question.loaded.grasp.description(), decision);
  json["stats"] = work_json(decision.work);
  return json;
}

std::optional<std::string> certificate_of(const BoxAnswer& answer) {
  if (!throughout(answer.decision)) return std::nullopt;
  return box_certificate_text(answer.question, answer.decision, producer_of(kIntervalsEngine));
}

}  // namespace stickslip
