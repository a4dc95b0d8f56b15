// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/answers/verdict_answer.hpp"

#include <utility>

#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/sign.hpp"
#include "stickslip/planar/rounded_equilibrium.hpp"

namespace stickslip {
namespace {

Json magnitude_json(const ContactReport& contact, const Rational& coefficient) {
  if (coefficient.is_zero()) return number_json(Rational(0));
  if (const auto length = exact_sqrt(contact.length_squared)) {
    return number_json(Rational(coefficient * *length));
  }
  return number_json(enclose_sqrt(coefficient, contact.length_squared));
}

}  // namespace

std::vector<ContactReport> report_contacts(const CaseAnswer& answer, const Witness& witness) {
  std::vector<ContactReport> reports;
  for (std::size_t i = 0; i < answer.problem.size(); ++i) {
    const Vector2& n = answer.question.loaded().grasp.contacts()[i].normal;
    const ContactForce& f = witness.forces[i];
    reports.push_back({n.x * n.x + n.y * n.y, f, force_vector(n, f),
                       mode_of(answer.problem, ContactId(i), witness.twist)});
  }
  return reports;
}

std::variant<Decision, BoxDecision> judge(const Problem& problem, Engine engine,
                                          std::size_t node_limit) {
  if (engine == Engine::kAuto && has_long_equilibria(problem)) {
    if (auto decision = prove_stable_by_degree(problem)) return std::move(*decision);
  }
  ConeOptions search;
  search.node_limit = node_limit;
  return decide(problem, engine, search);
}

BoxAnswer answer_by_degree(Question question, BoxDecision decision) {
  question.grasp = box_of(question.grasp);
  return {std::move(question), std::move(decision), {}};
}

Answer answer_to(Question question, const AnswerOptions& options) {
  if (const GraspBox* box = question.box()) {
    SearchOptions search;
    search.node_limit = options.node_limit;
    BoxDecision decision = decide_box(*box, question.law, search);
    Warnings warnings;
    if (options.warnings && question.in_space()) warnings = model_warnings(question, decision);
    return BoxAnswer{std::move(question), std::move(decision), std::move(warnings)};
  }
  Problem problem = problem_of(question);
  auto judged = judge(problem, options.engine, options.node_limit);
  if (auto* by_degree = std::get_if<BoxDecision>(&judged)) {
    return answer_by_degree(std::move(question), std::move(*by_degree));
  }
  auto& decision = std::get<Decision>(judged);
  Warnings warnings;
  if (options.warnings) warnings = model_warnings(question, problem, decision.verdict);
  return CaseAnswer{std::move(question), std::move(problem), std::move(decision),
                    std::move(warnings)};
}

void add_undecided(Json& json, const Undecided& undecided) {
  json["limit"] = undecided.limit;
  json["reason"] = undecided.reason;
  if (!undecided.remedy.empty()) json["remedy"] = undecided.remedy;
  for (const Rational& d : undecided.near) json["near"].push_back(number_json(d));
}

Json proof_json(const StabilityProof& proof) {
  std::size_t nodes = 0;
  for (const auto& part : proof) {
    const auto* by_degree = std::get_if<DegreeProof>(&part);
    nodes += by_degree != nullptr ? by_degree->trees.size() : 0;
  }
  return {{"nodes", nodes}, {"parts", part_count(proof)}, {"at_rest", are_at_rest(proof)}};
}

void add_enclosed(Json& json, const std::vector<std::size_t>& contacts, unsigned bits) {
  if (contacts.empty()) return;
  json["enclosed"] = contacts;
  json["bits"] = bits;
}

const char* name_of(const Answer& answer) {
  return std::visit([](const auto& a) { return name_of(a.decision.verdict); }, answer);
}

Json to_json(const CaseAnswer& answer) {
  const auto& [question, problem, decision, warnings] = answer;
  Json json;
  const Verdict& verdict = answer.verdict();
  json["verdict"] = name_of(verdict);
  json["name"] = question.loaded().grasp.name();
  if (!question.case_name.empty()) json["case"] = question.case_name;
  add_units(json, question.loaded().grasp);
  json["engine"] = decision.engine();
  json["normal_law"] = to_string(question.law);
  json["wrench"] = number_json(coordinates(problem.wrench()));
  if (const auto* stable = std::get_if<Stable>(&verdict)) {
    json["twist"] = number_json(coordinates(stable->witness.twist));
    Json& contacts = json["contacts"] = Json::array();
    for (const ContactReport& c : report_contacts(answer, stable->witness)) {
      contacts.push_back({{"normal", magnitude_json(c, c.force.normal)},
                          {"tangential", magnitude_json(c, c.force.tangential)},
                          {"force", number_json(c.vector)},
                          {"slip", std::string(1, to_char(c.mode.slip))},
                          {"closed", c.mode.closed}});
    }
  } else if (const auto* unstable = std::get_if<Unstable>(&verdict)) {
    const RefutationSummary summary = summarize(unstable->refutation);
    json["refutation"] = {{"nodes", summary.nodes}, {"leaves", summary.leaves}};
  } else {
    add_undecided(json, std::get<Undecided>(verdict));
  }
  if (warnings) json["warnings"] = warnings_json(*warnings);
  json["stats"] = std::visit([](const auto& work) { return work_json(work); }, decision.work);
  return json;
}

Json to_json(const Answer& answer) {
  return std::visit([](const auto& a) { return to_json(a); }, answer);
}

std::optional<std::string> certificate_of(const CaseAnswer& answer) {
  if (std::holds_alternative<Undecided>(answer.verdict())) return std::nullopt;
  return certificate_text(answer.question, answer.verdict(),
                          producer_of(answer.decision.engine()));
}

std::optional<std::string> certificate_of(const Answer& answer) {
  return std::visit([](const auto& a) { return certificate_of(a); }, answer);
}

std::string producer_of(const std::string& engine) {
  return "stickslip " STICKSLIP_VERSION ", engine " + engine;
}

Json warnings_json(const std::vector<ModelWarning>& warnings) {
  Json json = Json::array();
  for (const ModelWarning& warning : warnings) {
    json.push_back({{"trap", to_string(warning.trap)}, {"text", warning.text}});
  }
  return json;
}

}  // namespace stickslip
