// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/answers/verdict_answer.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/spatial_forces.hpp"

namespace stickslip {

Json to_json(const SpaceAnswer& answer) {
  const auto& [question, decision, warnings] = answer;
  Json json;
  json["verdict"] = name_of(decision.verdict);
  const bool is_box = !question.grasp.box.is_point();
  if (is_box) json["box"] = true;
  json["name"] = question.grasp.name;
  if (!question.case_name.empty()) json["case"] = question.case_name;
  add_units(json, question.grasp.units);
  json["engine"] = kSpaceEngine;
  json["normal_law"] = to_string(question.law);
  json["wrench"] = wrench_json(question.grasp.box.wrench);
  if (is_box) json["uncertain"] = uncertain_json(uncertain_numbers(question.grasp.box));
  add_enclosed(json, enclosed_contacts(question.grasp.box), decision.bits);
  if (const auto* stable = std::get_if<StableThroughout>(&decision.verdict)) {
    if (const auto* witness = std::get_if<SpatialWitness>(&stable->proof)) {
      json["twist"] = number_json(witness->twist);
      Json& contacts = json["contacts"] = Json::array();
      for (const SpatialForce& c :
           forces_of(question.grasp.box, witness->twist, witness->shares)) {
        contacts.push_back({{"force", number_json(c.force)},
                            {"friction", number_json(c.friction)},
                            {"closed", c.normal.sign() > 0}});
      }
    } else {
      json["near"] = number_json(motion_of(*stable));
      json["proof"] = proof_json(std::get<StabilityProof>(stable->proof));
    }
  }
  add_verdict(json, question.grasp.box, question.grasp.description(), decision);
  if (warnings) json["warnings"] = warnings_json(*warnings);
  json["stats"] = work_json(decision.work);
  return json;
}

std::optional<std::string> certificate_of(const SpaceAnswer& answer) {
  if (!throughout(answer.decision)) return std::nullopt;
  return spatial_certificate_text(answer.question, answer.decision, producer_of(kSpaceEngine));
}

}  // namespace stickslip
