// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/verdict_answer.hpp"

#include <utility>

#include "stickslip/arrangement/contact_states.hpp"
#include "stickslip/core/sign.hpp"
#include "stickslip/core/spatial_forces.hpp"
#include "stickslip/engine/refutation_summary.hpp"
#include "stickslip/engine/second_question.hpp"

namespace stickslip {

namespace {

Json magnitude_json(const ContactReport& contact, const Rational& coefficient) {
  if (coefficient.is_zero()) return number_json(Rational(0));
  if (const auto length = exact_sqrt(contact.length_squared)) {
    return number_json(Rational(coefficient * *length));
  }
  return number_json(enclose_sqrt(coefficient, contact.length_squared));
}

/// Adds the evidence that the grasp is stable.
struct EvidenceJson {
  const Answer& answer;
  Json& json;

  void operator()(const Witness& witness) const {
    json["twist"] = number_json(coordinates(witness.twist));
    Json& contacts = json["contacts"] = Json::array();
    for (const ContactReport& c : report_contacts(answer, witness)) {
      contacts.push_back({{"normal", magnitude_json(c, c.force.normal)},
                          {"tangential", magnitude_json(c, c.force.tangential)},
                          {"force", number_json(c.vector)},
                          {"slip", std::string(1, to_char(c.mode.slip))},
                          {"closed", c.mode.closed}});
    }
  }
  void operator()(const ShareWitness& witness) const {
    json["twist"] = number_json(witness.twist);
    Json& contacts = json["contacts"] = Json::array();
    const GraspBox& grasp = *answer.question.box();
    const std::vector<std::string> slips = slips_at(grasp, witness.twist);
    for (const SpatialForce& c : forces_of(grasp, witness.twist, witness.shares)) {
      const UncertainContact& contact = grasp.contacts[contacts.size()];
      contacts.push_back({{"force", number_json(vector_in(grasp, c.force))},
                          {"friction", number_json(vector_in(grasp, c.friction))},
                          {"slip", slips[contacts.size()]},
                          {"closed", c.normal.sign() > 0}});
      if (contact.torsion.is_zero()) continue;
      contacts.back()["moment"] = number_json(moment_of(c, contact));
    }
    if (grasp.mechanism) {
      json["springs"] = number_json(spring_forces_of(grasp, witness.twist));
    }
  }
  void operator()(const StabilityProof& proof) const {
    std::size_t nodes = 0;
    for (const auto& part : proof) {
      const auto* by_degree = std::get_if<DegreeProof>(&part);
      nodes += by_degree != nullptr ? by_degree->trees.size() : 0;
    }
    json["proof"] = {
        {"nodes", nodes}, {"parts", part_count(proof)}, {"at_rest", are_at_rest(proof)}};
    if (are_sticking(proof)) json["proof"]["sticking"] = true;
    if (are_untouched(proof)) json["proof"]["untouched"] = true;
  }
};

/// Adds the verdict and its reasons.
struct VerdictJson {
  const Answer& answer;
  Json& json;

  void operator()(const Stable& stable) const {
    std::visit(EvidenceJson{answer, json}, stable.proof);
  }
  void operator()(const Unstable& unstable) const {
    json["refutation"] = {{"nodes", unstable.tree.size()}};
    if (answer.problem) json["refutation"]["leaves"] = summarize(unstable.tree).leaves;
  }
  void operator()(const Fragile& fragile) const {
    json["examples"] = {{"stable", Json::parse(write_grasp(fragile.stable))},
                        {"unstable", Json::parse(write_grasp(fragile.unstable))}};
    json["differences"] =
        differences_json(differences(*answer.question.box(), fragile.stable, fragile.unstable));
  }
  void operator()(const Undecided& undecided) const { add_undecided(json, undecided); }
};

}  // namespace

std::vector<ContactReport> report_contacts(const Answer& answer, const Witness& witness) {
  std::vector<ContactReport> reports;
  for (std::size_t i = 0; i < answer.problem->size(); ++i) {
    const Vector2& n = answer.question.loaded().grasp.contacts()[i].normal;
    const ContactForce& f = witness.forces[i];
    reports.push_back({n.x * n.x + n.y * n.y, f, force_vector(n, f),
                       mode_of(*answer.problem, ContactId(i), witness.twist)});
  }
  return reports;
}

std::vector<std::size_t> enclosed_contacts(const GraspBox& box) {
  std::vector<std::size_t> contacts;
  for (std::size_t i = 0; i < box.contacts.size(); ++i) {
    if (needs_enclosure({{box.contacts[i]}, {}})) contacts.push_back(i);
  }
  return contacts;
}

std::optional<RationalRow> motion_near(const Answer& answer) {
  const auto* stable = std::get_if<Stable>(&answer.verdict);
  if (stable == nullptr || !std::holds_alternative<StabilityProof>(stable->proof)) return {};
  return stable->motion;
}

void add_undecided(Json& json, const Undecided& undecided) {
  json["limit"] = undecided.limit;
  json["reason"] = undecided.reason;
  if (!undecided.remedy.empty()) json["remedy"] = undecided.remedy;
  for (const Rational& d : undecided.near) json["near"].push_back(number_json(d));
}

void add_enclosed(Json& json, const std::vector<std::size_t>& contacts, unsigned bits) {
  if (contacts.empty()) return;
  json["enclosed"] = contacts;
  json["bits"] = bits;
}

SearchOptions to_draw() {
  SearchOptions options = by(Engine::kBranchAndBound);
  options.second = false;
  return options;
}

Json within_json(const Answer& within) {
  Json json{{"verdict", name_of(within.verdict)}};
  if (within.question.is_bounded()) {
    json["max_motion"] = number_json(within.question.box()->max_motion);
  } else {
    json["wrench"] = wrench_json(within.question.grasp.wrench());
  }
  return json;
}

Json to_json(const Answer& answer, const Warnings& warnings) {
  const Question& question = answer.question;
  const GraspBox* box = question.box();
  Json json;
  json["verdict"] = name_of(answer.verdict);
  // One grasp is no box, though it is proved as if it were.
  if (box != nullptr && !box->is_point()) json["box"] = true;
  json["name"] = question.description().name;
  if (!question.case_name.empty()) json["case"] = question.case_name;
  add_conventions(json, question.description());
  if (const Mechanism* mechanism = question.mechanism()) {
    json["coordinates"] = coordinate_names(*mechanism);
  }
  json["engine"] = answer.engine();
  json["normal_law"] = to_string(question.law);
  json["wrench"] = wrench_json(question.grasp.wrench());
  if (box != nullptr) {
    json["uncertain"] = uncertain_json(uncertain_numbers(*box));
    if (box->ball) json["ball"] = ball_json(*box->ball);
    add_enclosed(json, enclosed_contacts(*box), answer.bits);
  }
  if (const auto near = motion_near(answer)) json["near"] = number_json(*near);
  std::visit(VerdictJson{answer, json}, answer.verdict);
  if (question.is_bounded()) json["max_motion"] = number_json(box->max_motion);
  if (warnings) json["warnings"] = warnings_json(*warnings);
  if (answer.within) {
    json["within"] = to_json(*answer.within);
    json["within"].erase("name");
    if (!answer.within->question.is_bounded()) {
      json["within"]["distance"] =
          number_json(enclose_sqrt(1, squared_distance(question, answer.within->question)));
    }
  }
  json["stats"] = work_json(answer);
  return json;
}

Json warnings_json(const std::vector<ModelWarning>& warnings) {
  Json json = Json::array();
  for (const ModelWarning& warning : warnings) {
    json.push_back({{"trap", to_string(warning.trap)}, {"text", warning.text}});
  }
  return json;
}

}  // namespace stickslip
