// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_answer.hpp"

#include <algorithm>
#include <iostream>
#include <utility>
#include <vector>

#include "box_numbers.hpp"
#include "fragile_answer.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/file.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

constexpr const char* kProducer = "stickslip " STICKSLIP_VERSION ", engine box";

std::vector<std::size_t> enclosed_contacts(const GraspBox& box) {
  std::vector<std::size_t> contacts;
  for (std::size_t i = 0; i < box.contacts.size(); ++i) {
    if (needs_enclosure({{box.contacts[i]}, {}})) contacts.push_back(i);
  }
  return contacts;
}

std::size_t count_parts(const StabilityProof& proof) {
  return static_cast<std::size_t>(std::count_if(
      proof.begin(), proof.end(),
      [](const auto& part) { return std::holds_alternative<DegreeProof>(part); }));
}

std::string in_words(std::size_t n, const char* what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

struct Meaning {
  bool wide;  ///< some number is an interval

  std::string operator()(const StableThroughout& stable) const {
    const std::size_t parts = count_parts(stable.parts);
    return (wide ? "Every grasp in the box holds the load. Proved for all of them at once"
                 : std::string("The grasp holds the load. Proved")) +
           (parts == 1 ? "" : ", in " + in_words(parts, "part")) +
           ": the forces on\nthe walls of a box of motions leave no way out but an equilibrium "
           "inside.\n";
  }
  std::string operator()(const UnstableThroughout& unstable) const {
    return (wide ? "No grasp in the box holds the load. Proved for all of them at once"
                 : std::string("The grasp does not hold the load. Proved")) +
           ", by a tree of " + in_words(unstable.tree.size(), "node") +
           ":\nwherever the object moves, along some virtual twist the load does more work "
           "than "
           "the\ncontacts can take up.\n";
  }
  std::string operator()(const Undecided& undecided) const {
    return "Not decided: " + undecided.limit + ".\n" +
           (wide ? "Neither is the whole box proved, nor are two grasps with opposite verdicts "
                   "known.\n"
                 : "");
  }
  std::string operator()(const Fragile& /*fragile*/) const { return ""; }
};

std::string enclosure_text(const BoxAnswer& answer) {
  const std::vector<std::size_t> contacts = enclosed_contacts(*answer.question.box);
  if (contacts.empty()) return "";
  constexpr std::size_t kMostNamed = 8;
  std::string names;
  for (std::size_t i = 0; i < std::min(contacts.size(), kMostNamed); ++i) {
    names += (i == 0 ? "" : ", ") + std::to_string(contacts[i]);
  }
  if (contacts.size() > kMostNamed) names += ", ...";
  const bool proved = !std::holds_alternative<Undecided>(answer.decision.verdict);
  return (contacts.size() == 1 ? "The normal of contact " : "The normals of contacts ") +
         names +
         (contacts.size() == 1 ? " has an irrational length" : " have irrational lengths") +
         " |n|: P/|n| was enclosed to " + std::to_string(answer.decision.bits) + " bits" +
         (proved ? ",\nand the verdict is proved for all numbers in there.\n" : ".\n");
}

}  // namespace

BoxAnswer answer_box(Question question, std::size_t node_limit) {
  BoxOptions options;
  options.node_limit = node_limit;
  BoxDecision decision = decide_box(*question.box, question.law, options);
  return {std::move(question), std::move(decision)};
}

Json to_json(const BoxAnswer& answer) {
  const auto& [question, decision] = answer;
  const GraspBox& box = *question.box;
  Json json;
  json["verdict"] = name_of(decision.verdict);
  json["box"] = true;
  json["name"] = question.loaded.grasp.name();
  if (!question.case_name.empty()) json["case"] = question.case_name;
  add_units(json, question.loaded.grasp);
  json["engine"] = "box";
  json["normal_law"] = to_string(question.law);
  json["wrench"] = wrench_json(box.wrench);
  json["uncertain"] = uncertain_json(uncertain_numbers(box));
  if (needs_enclosure(box)) {
    json["enclosed"] = enclosed_contacts(box);
    json["bits"] = decision.bits;
  }
  if (const auto* stable = std::get_if<StableThroughout>(&decision.verdict)) {
    json["proof"] = {{"parts", count_parts(stable->parts)}};
  } else if (const auto* unstable = std::get_if<UnstableThroughout>(&decision.verdict)) {
    json["refutation"] = {{"nodes", unstable->tree.size()}};
  } else if (const auto* fragile = std::get_if<Fragile>(&decision.verdict)) {
    json["examples"] = {{"stable", Json::parse(write_grasp(fragile->stable))},
                        {"unstable", Json::parse(write_grasp(fragile->unstable))}};
    json["differences"] = Differences(box, fragile->stable, fragile->unstable).json();
  } else {
    json["limit"] = std::get<Undecided>(decision.verdict).limit;
  }
  const BoxWork& work = decision.work;
  json["stats"] = {{"nodes", work.nodes},
                   {"proofs", work.proofs},
                   {"examples", work.examples},
                   {"parts", work.parts}};
  return json;
}

void print_text(const BoxAnswer& answer, const NumberOptions& output,
                const std::string& examples) {
  const auto& [question, decision] = answer;
  NumberText text(output);
  const std::vector<UncertainNumber> uncertain = uncertain_numbers(*question.box);
  std::cout << heading(question) << name_of(decision.verdict) << "\n\n"
            << "  load w    " << load_text(question.box->wrench, text) << "\n\n";
  std::cout << uncertain_text(uncertain, text);
  if (const auto* fragile = std::get_if<Fragile>(&decision.verdict)) {
    std::cout
        << Differences(*question.box, fragile->stable, fragile->unstable).text(text, examples);
  } else {
    std::cout << std::visit(Meaning{!uncertain.empty()}, decision.verdict);
  }
  std::cout << enclosure_text(answer) << text.note() << units_text(question.loaded.grasp)
            << engine_text("box", question.law);
}

void write_examples(const BoxAnswer& answer, const std::string& folder) {
  const auto* fragile = std::get_if<Fragile>(&answer.decision.verdict);
  if (fragile == nullptr) {
    return say_no_examples("the box is", name_of(answer.decision.verdict));
  }
  const Question& question = answer.question;
  const auto proved = [&](const LoadedGrasp& grasp, bool stable) {
    return proved_grasp(grasp, question.loaded.grasp.description(), question.law, stable,
                        kProducer);
  };
  write_two_examples(folder, proved(fragile->stable, true), proved(fragile->unstable, false));
}

void write_certificate(const BoxAnswer& answer, const std::string& file) {
  if (file.empty() || std::holds_alternative<Undecided>(answer.decision.verdict)) return;
  if (std::holds_alternative<Fragile>(answer.decision.verdict)) return say_two_certificates();
  write_whole_file(file, box_certificate_text(answer.question, answer.decision, kProducer));
}

}  // namespace stickslip
