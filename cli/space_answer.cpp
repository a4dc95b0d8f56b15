// SPDX-License-Identifier: GPL-3.0-or-later
#include "space_answer.hpp"

#include <iostream>
#include <utility>
#include <vector>

#include "box_numbers.hpp"
#include "fragile_answer.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/core/spatial_forces.hpp"
#include "terminal.hpp"
#include "warnings.hpp"

namespace stickslip {
namespace {

struct SpatialMeaning {
  bool wide;  ///< some number is an interval

  std::string operator()(const SpatiallyStable& stable) const {
    if (std::holds_alternative<SpatialWitness>(stable.proof)) {
      return "These forces balance the load, lie in their friction cones and oppose slip; "
             "checked exactly.\n";
    }
    const auto& proofs = std::get<SpatialParts>(stable.proof);
    const std::size_t parts = part_count(proofs);
    return (wide ? "Every grasp in the box holds the load. Proved for all of them at once"
                 : std::string("The grasp holds the load. Proved")) +
           (parts == 1 ? "" : ", in " + std::to_string(parts) + " parts") +
           (are_at_rest(proofs)
                ? ": nothing moves,\nas friction answers whatever load is left.\n"
                : ": the forces on the walls\naround motions near this one leave no way out "
                  "but "
                  "an equilibrium inside.\n");
  }
  std::string operator()(const SpatiallyUnstable& unstable) const {
    const std::size_t leaves = leaf_count(unstable.tree);
    return std::string(wide ? "No grasp in the box holds the load: no"
                            : "The grasp does not hold the load: no") +
           " motion and forces satisfy all conditions.\n" +
           (leaves == 1
                ? "Whatever the contacts do, along some virtual twist the load does more work "
                  "than they\ncan take up.\n"
                : "Proved by a tree of " + std::to_string(leaves) +
                      " leaves, which together cover all motions: in each, along some\n"
                      "virtual twist, the load does more work than the contacts can take "
                      "up.\n");
  }
  std::string operator()(const SpatiallyFragile& /*fragile*/) const { return ""; }
  std::string operator()(const Undecided& undecided) const {
    return undecided_text(undecided, wide);
  }
};

}  // namespace

std::string load_text(const SpaceAnswer& answer, NumberText& text) {
  return load_text(answer.question.grasp.wrench, text);
}

void print_text(const SpaceAnswer& answer, const NumberOptions& output,
                const std::string& examples) {
  const auto& [question, decision, warnings] = answer;
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
  std::cout << uncertain_text(uncertain, text);
  if (const auto* fragile = std::get_if<SpatiallyFragile>(&decision.verdict)) {
    std::cout << fragile_text(differences(question.grasp, fragile->stable, fragile->unstable),
                              text, examples);
  }
  std::cout << std::visit(SpatialMeaning{!uncertain.empty()}, decision.verdict)
            << enclosure_text(enclosed_contacts(question.grasp), decision.bits,
                              !std::holds_alternative<Undecided>(decision.verdict))
            << "Load: force x, y, z, torque x, y, z. Motion: x, y, z, rotation x, y, z in "
               "radians.\n"
            << text.note() << units_text(question.grasp.units)
            << engine_text("space", question.law);
  print(warnings);
}

void write_examples(const SpaceAnswer& answer, const std::string& folder) {
  const auto& [question, decision, warnings] = answer;
  const auto* fragile = std::get_if<SpatiallyFragile>(&decision.verdict);
  if (fragile == nullptr) {
    return say_no_examples(!question.grasp.is_point(), name_of(decision.verdict));
  }
  write_two_examples(
      folder, proved_grasp(fragile->stable, question.law, true, producer_of("space")),
      proved_grasp(fragile->unstable, question.law, false, producer_of("space")));
}

void write_certificate(const SpaceAnswer& answer, const std::string& file) {
  if (file.empty()) return;
  if (std::holds_alternative<SpatiallyFragile>(answer.decision.verdict)) {
    say_two_certificates();
  } else if (const auto certificate = certificate_of(answer)) {
    write_whole_file(file, *certificate);
  }
}

}  // namespace stickslip
