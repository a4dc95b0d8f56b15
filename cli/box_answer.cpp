// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_answer.hpp"

#include <iostream>
#include <utility>
#include <vector>

#include "box_numbers.hpp"
#include "fragile_answer.hpp"
#include "stickslip/core/file.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

/// Of one grasp, of which exact forces are not known.
std::string near_text(const Vector3& motion, bool are_rational, NumberText& text) {
  return "An equilibrium is near the motion d = " + text(motion) + "." +
         (are_rational ? " Exact forces would have numbers of\nmany digits: --engine "
                         "branch-and-bound finds them, and the warnings that need them.\n"
                       : "\n");
}

}  // namespace

void print_text(const BoxAnswer& answer, const NumberOptions& output,
                const std::string& examples) {
  const auto& [question, decision] = answer;
  NumberText text(output);
  const std::vector<UncertainNumber> uncertain = uncertain_numbers(*question.box);
  std::cout << heading(question) << name_of(decision.verdict) << "\n\n"
            << "  load w    " << load_text(question.box->wrench, text) << "\n\n";
  std::cout << uncertain_text(uncertain, text);
  if (const auto* fragile = std::get_if<Fragile>(&decision.verdict)) {
    std::cout << fragile_text(differences(*question.box, fragile->stable, fragile->unstable),
                              text, examples);
  } else {
    std::cout << std::visit(Meaning{!uncertain.empty()}, decision.verdict);
  }
  const std::vector<std::size_t> enclosed = enclosed_contacts(*question.box);
  if (const auto near = motion_near(answer)) {
    std::cout << near_text(*near, enclosed.empty(), text);
  }
  std::cout << enclosure_text(enclosed, decision.bits,
                              !std::holds_alternative<Undecided>(decision.verdict))
            << text.note() << units_text(question.loaded.grasp)
            << engine_text(kIntervalsEngine, question.law);
}

void write_examples(const BoxAnswer& answer, const std::string& folder) {
  const Question& question = answer.question;
  write_two_examples(folder, *question.box, question.loaded.grasp.description(), question.law,
                     answer.decision.verdict, producer_of(kIntervalsEngine));
}

void write_certificate(const BoxAnswer& answer, const std::string& file) {
  write_certificate_of_box(answer, file);
}

}  // namespace stickslip
