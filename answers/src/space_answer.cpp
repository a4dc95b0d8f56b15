// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/answers/verdict_answer.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/spatial_forces.hpp"

namespace stickslip {

std::vector<std::size_t> enclosed_contacts(const SpatialGrasp& box) {
  std::vector<std::size_t> contacts;
  for (std::size_t i = 0; i < box.contacts.size(); ++i) {
    const SpatialContact& c = box.contacts[i];
    if (!c.preload.high.is_zero() && !exact_sqrt(dot(c.normal, c.normal))) {
      contacts.push_back(i);
    }
  }
  return contacts;
}

Json to_json(const SpaceAnswer& answer) {
  const auto& [question, decision, warnings] = answer;
  Json json;
  json["verdict"] = name_of(decision.verdict);
  const bool is_box = !question.grasp.is_point();
  if (is_box) json["box"] = true;
  json["name"] = question.grasp.name;
  if (!question.case_name.empty()) json["case"] = question.case_name;
  add_units(json, question.grasp.units);
  json["engine"] = "space";
  json["normal_law"] = to_string(question.law);
  json["wrench"] = wrench_json(question.grasp.wrench);
  if (is_box) json["uncertain"] = uncertain_json(uncertain_numbers(question.grasp));
  add_enclosed(json, enclosed_contacts(question.grasp), decision.bits);
  if (const auto* stable = std::get_if<StableThroughout>(&decision.verdict)) {
    if (const auto* witness = std::get_if<SpatialWitness>(&stable->proof)) {
      json["twist"] = number_json(witness->twist);
      Json& contacts = json["contacts"] = Json::array();
      for (const SpatialForce& c : forces_of(question.grasp, witness->twist, witness->shares)) {
        contacts.push_back({{"force", number_json(c.force)},
                            {"friction", number_json(c.friction)},
                            {"closed", c.normal.sign() > 0}});
      }
    } else {
      json["near"] = number_json(motion_of(*stable));
      json["proof"] = proof_json(std::get<StabilityProof>(stable->proof));
    }
  } else if (const auto* unstable = std::get_if<UnstableThroughout>(&decision.verdict)) {
    json["refutation"] = {{"nodes", unstable->tree.size()}};
  } else if (const auto* fragile = std::get_if<Fragile<SpatialGrasp>>(&decision.verdict)) {
    json["examples"] = {{"stable", Json::parse(write_grasp_file(fragile->stable))},
                        {"unstable", Json::parse(write_grasp_file(fragile->unstable))}};
    json["differences"] =
        differences_json(differences(question.grasp, fragile->stable, fragile->unstable));
  } else {
    add_undecided(json, std::get<Undecided>(decision.verdict));
  }
  if (warnings) json["warnings"] = warnings_json(*warnings);
  json["stats"] = work_json(decision.work);
  return json;
}

std::optional<std::string> certificate_of(const SpaceAnswer& answer) {
  if (!throughout(answer.decision)) return std::nullopt;
  return spatial_certificate_text(answer.question, answer.decision, producer_of("space"));
}

}  // namespace stickslip
