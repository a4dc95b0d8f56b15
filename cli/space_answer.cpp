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
std::string load_text(const SpaceAnswer& answer, NumberText& text) {
  return load_text(answer.question.grasp.box.wrench, text);
}

void print_text(const SpaceAnswer& answer, const NumberOptions& output,
                const std::string& examples) {
  const auto& [question, decision, warnings] = answer;
  NumberText text(output);
  std::cout << heading(question.grasp.name, question.case_name) << name_of(decision.verdict)
            << "\n\n"
            << "  load w    " << load_text(answer, text) << '\n';
  const auto* stable = std::get_if<StableThroughout>(&decision.verdict);
  const auto* witness =
      stable != nullptr ? std::get_if<SpatialWitness>(&stable->proof) : nullptr;
  if (stable != nullptr) {
    std::cout << "  motion d  " << (witness != nullptr ? "" : "near ")
              << text(motion_of(*stable)) << '\n';
  }
  std::cout << '\n';
  if (witness != nullptr) {
    std::vector<std::vector<std::string>> rows{{"contact", "normal", "friction", "force", ""}};
    for (const SpatialForce& c :
         forces_of(question.grasp.box, witness->twist, witness->shares)) {
      const std::size_t i = rows.size() - 1;
      const RationalRow& n = question.grasp.box.contacts[i].normal;
      rows.push_back({std::to_string(i), text.root(c.normal, dot(n, n)), text(c.friction),
                      text(c.force), c.normal.sign() > 0 ? "closed" : "open"});
    }
    std::cout << format_table(rows) << '\n';
  }
  const std::vector<UncertainNumber> uncertain = uncertain_numbers(question.grasp.box);
  std::cout << uncertain_text(uncertain, text);
  if (const auto* fragile = std::get_if<Fragile>(&decision.verdict)) {
    std::cout << fragile_text(
        differences(question.grasp.box, fragile->stable, fragile->unstable), text, examples);
  }
  std::cout << std::visit(Meaning{!uncertain.empty()}, decision.verdict)
            << enclosure_text(enclosed_contacts(question.grasp.box), decision.bits,
                              !std::holds_alternative<Undecided>(decision.verdict))
            << "Load: force x, y, z, torque x, y, z. Motion: x, y, z, rotation x, y, z in "
               "radians.\n"
            << text.note() << units_text(question.grasp.units)
            << engine_text(kSpaceEngine, question.law);
  print(warnings);
}

void write_examples(const SpaceAnswer& answer, const std::string& folder) {
  const SpatialQuestion& question = answer.question;
  write_two_examples(folder, question.grasp.box, question.grasp.description(), question.law,
                     answer.decision.verdict, producer_of(kSpaceEngine));
}

void write_certificate(const SpaceAnswer& answer, const std::string& file) {
  write_certificate_of_box(answer, file);
}

}  // namespace stickslip
