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

std::string in_words(std::size_t n, const char* what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

struct Meaning {
  bool wide;  ///< some number is an interval

  std::string operator()(const StableThroughout& stable) const {
    const std::size_t parts = part_count(stable.parts);
    return (wide ? "Every grasp in the box holds the load. Proved for all of them at once"
                 : std::string("The grasp holds the load. Proved")) +
           (parts == 1 ? "" : ", in " + in_words(parts, "part")) +
           ": the forces on\nthe walls around some motions leave no way out but an equilibrium "
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
    return undecided_text(undecided, wide);
  }
  std::string operator()(const Fragile& /*fragile*/) const { return ""; }
};

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
  const auto* fragile = std::get_if<Fragile>(&answer.decision.verdict);
  if (fragile == nullptr) {
    return say_no_examples(!answer.question.box->is_point(), name_of(answer.decision.verdict));
  }
  const Question& question = answer.question;
  const auto proved = [&](const LoadedGrasp& grasp, bool stable) {
    return proved_grasp(grasp, question.loaded.grasp.description(), question.law, stable,
                        producer_of(kIntervalsEngine));
  };
  write_two_examples(folder, proved(fragile->stable, true), proved(fragile->unstable, false));
}

void write_certificate(const BoxAnswer& answer, const std::string& file) {
  if (file.empty()) return;
  if (std::holds_alternative<Fragile>(answer.decision.verdict)) {
    say_two_certificates();
  } else if (const auto certificate = certificate_of(answer)) {
    write_whole_file(file, *certificate);
  }
}

}  // namespace stickslip
