// SPDX-License-Identifier: GPL-3.0-or-later
#include "space_answer.hpp"

#include <iostream>
#include <utility>
#include <vector>

#include "box_numbers.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/core/spatial_forces.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

std::vector<UncertainNumber> uncertain_numbers(const SpatialGrasp& grasp) {
  std::vector<UncertainNumber> numbers;
  const auto add = [&](const std::string& place, const Interval& interval) {
    if (!interval.is_point()) numbers.push_back({place, interval});
  };
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const SpatialContact& c = grasp.contacts[i];
    const std::string path = "contacts[" + std::to_string(i) + "].";
    for (std::size_t j = 0; j < 3; ++j) {
      add(path + "position[" + std::to_string(j) + "]", c.position[j]);
    }
    add(path + "friction", c.friction);
    add(path + "stiffness", c.stiffness);
    add(path + "preload", c.preload);
  }
  for (std::size_t j = 0; j < 6; ++j) {
    add("wrench[" + std::to_string(j) + "]", grasp.wrench[j]);
  }
  return numbers;
}

struct SpatialMeaning {
  bool wide;  ///< some number is an interval

  std::string operator()(const SpatiallyStable& stable) const {
    if (std::holds_alternative<SpatialWitness>(stable.proof)) {
      return "These forces balance the load, lie in their friction cones and oppose slip; "
             "checked exactly.\n";
    }
    return (wide ? "Every grasp in the box holds the load. Proved for all of them at once"
                 : std::string("The grasp holds the load. Proved")) +
           ": the forces on the walls\nof a box of motions around this one leave no way out "
           "but "
           "an equilibrium inside.\n";
  }
  std::string operator()(const SpatiallyUnstable& unstable) const {
    const std::size_t leaves = leaf_count(unstable.tree);
    return std::string(wide ? "No grasp in the box holds the load: no"
                            : "The grasp does not hold the load: no") +
           " motion and forces satisfy all conditions.\nProved in " + std::to_string(leaves) +
           (leaves == 1 ? " case" : " cases, which together cover all motions: in each") +
           ", along some virtual twist, the\nload does more work than the contacts can take "
           "up.\n";
  }
  std::string operator()(const Undecided& undecided) const {
    return "Not decided: " + undecided.limit + ". Nothing is known about the verdict" +
           (wide ? ", which need\nnot be the same for all grasps in the box.\n"
                 : "; on a threshold\nthere need not be a proof at all.\n");
  }
};

}  // namespace

SpaceAnswer answer_in_space(SpatialQuestion question, std::size_t node_limit) {
  SpatialSearchOptions options;
  options.node_limit = node_limit;
  SpatialDecision decision = decide(question, options);
  return {std::move(question), std::move(decision)};
}

Json to_json(const SpaceAnswer& answer) {
  const auto& [question, decision] = answer;
  Json json;
  json["verdict"] = name_of(decision.verdict);
  if (question.is_box) json["box"] = true;
  json["name"] = question.grasp.name;
  if (!question.case_name.empty()) json["case"] = question.case_name;
  add_units(json, question.grasp.units);
  json["engine"] = "space";
  json["normal_law"] = to_string(question.law);
  json["wrench"] = wrench_json(question.grasp.wrench);
  if (const auto* stable = std::get_if<SpatiallyStable>(&decision.verdict)) {
    if (const auto* witness = std::get_if<SpatialWitness>(&stable->proof)) {
      json["twist"] = number_json(witness->twist);
      Json& contacts = json["contacts"] = Json::array();
      for (const SpatialForce& c : forces_of(question.grasp, witness->twist, witness->shares)) {
        contacts.push_back({{"force", number_json(c.force)},
                            {"friction", number_json(c.friction)},
                            {"closed", c.normal.sign() > 0}});
      }
    } else {
      const auto& proof = std::get<SpatialDegreeProof>(stable->proof);
      json["near"] = number_json(stable->motion);
      json["proof"] = {{"nodes", proof.trees.size()}};
    }
  } else if (const auto* unstable = std::get_if<SpatiallyUnstable>(&decision.verdict)) {
    json["refutation"] = {{"nodes", unstable->tree.size()}};
  } else {
    json["limit"] = std::get<Undecided>(decision.verdict).limit;
  }
  json["stats"] = work_json(decision.work);
  return json;
}

Json work_json(const SpatialWork& work) {
  Json json = Json::object();
  for (const auto& [name, value] : counters(work)) json[name] = value;
  return json;
}

std::string load_text(const SpaceAnswer& answer, NumberText& text) {
  return load_text(answer.question.grasp.wrench, text);
}

void print_text(const SpaceAnswer& answer, const NumberOptions& output,
                const std::string& /*examples*/) {
  const auto& [question, decision] = answer;
  NumberText text(output);
  std::cout << heading(question.grasp.name, question.case_name) << name_of(decision.verdict)
            << "\n\n"
            << "  load w    " << load_text(answer, text) << '\n';
  const auto* stable = std::get_if<SpatiallyStable>(&decision.verdict);
  const auto* witness =
      stable != nullptr ? std::get_if<SpatialWitness>(&stable->proof) : nullptr;
  if (stable != nullptr) {
    std::cout << "  motion d  " << (witness != nullptr ? "" : "near ") << text(stable->motion)
              << '\n';
  }
  std::cout << '\n';
  if (witness != nullptr) {
    std::vector<std::vector<std::string>> rows{{"contact", "normal", "friction", "force", ""}};
    for (const SpatialForce& c : forces_of(question.grasp, witness->twist, witness->shares)) {
      const std::size_t i = rows.size() - 1;
      const Vector3& n = question.grasp.contacts[i].normal;
      rows.push_back({std::to_string(i), text.root(c.normal, dot(n, n)), text(c.friction),
                      text(c.force), c.normal.sign() > 0 ? "closed" : "open"});
    }
    std::cout << format_table(rows) << '\n';
  }
  const std::vector<UncertainNumber> uncertain = uncertain_numbers(question.grasp);
  std::cout << uncertain_text(uncertain, text)
            << std::visit(SpatialMeaning{!uncertain.empty()}, decision.verdict)
            << "Load: force x, y, z, torque x, y, z. Motion: x, y, z, rotation x, y, z in "
               "radians.\n"
            << text.note() << units_text(question.grasp.units)
            << engine_text("space", question.law);
}

void write_examples(const SpaceAnswer& answer, const std::string& /*folder*/) {
  std::cerr
      << "stickslip: --examples: nothing is written: two grasps with opposite verdicts are "
         "sought in the plane only; this is "
      << name_of(answer.decision.verdict) << "\n";
}

void write_certificate(const SpaceAnswer& answer, const std::string& file) {
  if (file.empty() || std::holds_alternative<Undecided>(answer.decision.verdict)) return;
  write_whole_file(file,
                   spatial_certificate_text(answer.question, answer.decision, kSpaceProducer));
}

}  // namespace stickslip
