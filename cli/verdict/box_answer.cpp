// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_answer.hpp"

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

/// Of one grasp in the plane, of which exact forces are not known.
std::string near_text(const RationalRow& motion, bool are_rational, NumberText& text) {
  return "An equilibrium is near the motion d = " + text(motion) + "." +
         (are_rational ? " Exact forces would have numbers of\nmany digits: --engine "
                         "branch-and-bound finds them, and the warnings that need them.\n"
                       : "\n");
}

/// What is known of an equilibrium in space, contact by contact if it is exact.
std::string equilibrium_text(const GraspBox& grasp, const StableThroughout& stable,
                             NumberText& text) {
  const auto* witness = std::get_if<SpatialWitness>(&stable.proof);
  if (witness == nullptr) return "  motion d  near " + text(stable.motion) + "\n\n";
  std::vector<std::vector<std::string>> rows{{"contact", "normal", "friction", "force", ""}};
  for (const SpatialForce& c : forces_of(grasp, witness->twist, witness->shares)) {
    const std::size_t i = rows.size() - 1;
    const RationalRow& n = grasp.contacts[i].normal;
    rows.push_back({std::to_string(i), text.root(c.normal, dot(n, n)), text(c.friction),
                    text(c.force), c.normal.sign() > 0 ? "closed" : "open"});
  }
  return "  motion d  " + text(witness->twist) + "\n\n" + format_table(rows) + "\n";
}

}  // namespace

void print_text(const BoxAnswer& answer, const NumberOptions& output,
                const std::string& examples) {
  const auto& [question, decision, warnings] = answer;
  const GraspBox& box = *question.box();
  NumberText text(output);
  const std::vector<UncertainNumber> uncertain = uncertain_numbers(box);
  const std::vector<std::size_t> enclosed = enclosed_contacts(box);
  const auto* stable = std::get_if<StableThroughout>(&decision.verdict);
  std::cout << heading(question) << name_of(decision.verdict) << "\n\n"
            << "  load w    " << load_text(box.wrench, text) << '\n'
            << (question.in_space() && stable != nullptr ? equilibrium_text(box, *stable, text)
                                                         : "\n")
            << uncertain_text(uncertain, text);
  if (const auto* fragile = std::get_if<Fragile>(&decision.verdict)) {
    std::cout << fragile_text(differences(box, fragile->stable, fragile->unstable), text,
                              examples);
  } else {
    std::cout << std::visit(Meaning{!uncertain.empty()}, decision.verdict);
  }
  const auto near = motion_near(answer);
  if (near && !question.in_space()) std::cout << near_text(*near, enclosed.empty(), text);
  std::cout << enclosure_text(enclosed, decision.bits,
                              !std::holds_alternative<Undecided>(decision.verdict))
            << (question.in_space() ? "Load: force x, y, z, torque x, y, z. Motion: x, y, z, "
                                      "rotation x, y, z in radians.\n"
                                    : "")
            << text.note() << units_text(question)
            << engine_text(box_engine(question), question.law);
  print(warnings);
}

void write_examples(const BoxAnswer& answer, const std::string& folder) {
  const Question& question = answer.question;
  write_two_examples(folder, *question.box(), question.law, answer.decision.verdict,
                     producer_of(box_engine(question)));
}

void write_certificate(const BoxAnswer& answer, const std::string& file) {
  if (file.empty()) return;
  if (const auto certificate = certificate_of(answer)) {
    write_whole_file(file, *certificate);
  } else if (!std::holds_alternative<Undecided>(answer.decision.verdict)) {
    std::cerr << "stickslip: --certificate: nothing is written: what proves that a box is "
                 "fragile is two grasps, each with a certificate; --examples DIR writes them\n";
  }
}

}  // namespace stickslip
