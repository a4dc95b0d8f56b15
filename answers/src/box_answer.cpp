// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/answers/verdict_answer.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/spatial_forces.hpp"

namespace stickslip {

std::vector<std::size_t> enclosed_contacts(const GraspBox& box) {
  std::vector<std::size_t> contacts;
  for (std::size_t i = 0; i < box.contacts.size(); ++i) {
    if (needs_enclosure({{box.contacts[i]}, {}})) contacts.push_back(i);
  }
  return contacts;
}

void add_verdict(Json& json, const GraspBox& box, const BoxDecision& decision) {
  if (const auto* unstable = std::get_if<UnstableThroughout>(&decision.verdict)) {
    json["refutation"] = {{"nodes", unstable->tree.size()}};
  } else if (const auto* fragile = std::get_if<Fragile>(&decision.verdict)) {
    json["examples"] = {{"stable", Json::parse(write_grasp(fragile->stable))},
                        {"unstable", Json::parse(write_grasp(fragile->unstable))}};
    json["differences"] =
        differences_json(differences(box, fragile->stable, fragile->unstable));
  } else if (const auto* undecided = std::get_if<Undecided>(&decision.verdict)) {
    add_undecided(json, *undecided);
  }
}

std::optional<RationalRow> motion_near(const BoxAnswer& answer) {
  const auto* stable = std::get_if<StableThroughout>(&answer.decision.verdict);
  if (stable == nullptr || std::holds_alternative<SpatialWitness>(stable->proof)) return {};
  if (!answer.question.in_space() && !answer.question.box()->is_point()) return {};
  return stable->motion;
}

namespace {

Json contacts_json(const GraspBox& grasp, const SpatialWitness& witness) {
  Json contacts = Json::array();
  for (const SpatialForce& c : forces_of(grasp, witness.twist, witness.shares)) {
    contacts.push_back({{"force", number_json(c.force)},
                        {"friction", number_json(c.friction)},
                        {"closed", c.normal.sign() > 0}});
  }
  return contacts;
}

}  // namespace

Json to_json(const BoxAnswer& answer) {
  const auto& [question, decision, warnings] = answer;
  const GraspBox& box = *question.box();
  Json json;
  json["verdict"] = name_of(decision.verdict);
  // One grasp is none, though it is proved as if it were.
  if (!box.is_point()) json["box"] = true;
  json["name"] = box.description.name;
  if (!question.case_name.empty()) json["case"] = question.case_name;
  add_units(json, box.description.units);
  json["engine"] = box_engine(question);
  json["normal_law"] = to_string(question.law);
  json["wrench"] = wrench_json(box.wrench);
  json["uncertain"] = uncertain_json(uncertain_numbers(box));
  add_enclosed(json, enclosed_contacts(box), decision.bits);
  if (const auto near = motion_near(answer)) json["near"] = number_json(*near);
  if (const auto* stable = std::get_if<StableThroughout>(&decision.verdict)) {
    if (const auto* witness = std::get_if<SpatialWitness>(&stable->proof)) {
      json["twist"] = number_json(witness->twist);
      json["contacts"] = contacts_json(box, *witness);
    } else {
      json["proof"] = proof_json(std::get<StabilityProof>(stable->proof));
    }
  }
  add_verdict(json, box, decision);
  if (warnings) json["warnings"] = warnings_json(*warnings);
  json["stats"] = work_json(decision.work);
  return json;
}

std::optional<std::string> certificate_of(const BoxAnswer& answer) {
  if (!throughout(answer.decision)) return std::nullopt;
  return box_certificate_text(answer.question, answer.decision,
                              producer_of(box_engine(answer.question)));
}

}  // namespace stickslip
