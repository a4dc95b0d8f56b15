// SPDX-License-Identifier: GPL-3.0-or-later
#include "fragile_answer.hpp"

#include <iostream>
#include <utility>

#include "question_options.hpp"
#include "terminal.hpp"

namespace stickslip {

std::string Meaning::operator()(const StableThroughout& stable) const {
  const auto* proof = std::get_if<StabilityProof>(&stable.proof);
  if (proof == nullptr) {
    return "These forces balance the load, lie in their friction cones and oppose slip; "
           "checked exactly.\n";
  }
  const std::size_t parts = part_count(*proof);
  return (is_wide ? "Every grasp in the box holds the load. Proved for all of them at once"
                  : std::string("The grasp holds the load. Proved")) +
         (parts == 1 ? "" : ", in " + std::to_string(parts) + " parts") +
         (are_at_rest(*proof)
              ? ": nothing moves,\nas friction answers whatever load is left.\n"
              : ": the forces on the walls\naround motions near this one leave no way out but "
                "an equilibrium inside.\n");
}

std::string Meaning::operator()(const UnstableThroughout& unstable) const {
  const std::size_t leaves = leaf_count(unstable.tree);
  return std::string(is_wide ? "No grasp in the box holds the load: no"
                             : "The grasp does not hold the load: no") +
         " motion and forces satisfy all conditions.\n" +
         (leaves == 1
              ? "Whatever the contacts do, along some virtual twist the load does more work "
                "than they\ncan take up.\n"
              : "Proved by a tree of " + std::to_string(leaves) +
                    " leaves, which together cover all motions: in each, along some\n"
                    "virtual twist, the load does more work than the contacts can take up.\n");
}

std::string Meaning::operator()(const Undecided& undecided) const {
  return undecided_text(undecided, is_wide);
}

std::string fragile_text(const std::vector<Difference>& differences, NumberText& text,
                         const std::string& examples) {
  std::vector<std::vector<std::string>> rows{{"differs", "stable", "unstable"}};
  for (const Difference& d : differences) {
    rows.push_back({d.number.label(), text(d.stable), text(d.unstable)});
  }
  return "Some grasps in the box hold the load and some do not. Two of them, what differs most "
         "first:\n\n" +
         short_table(rows) + "\n" +
         (examples.empty()
              ? "--examples DIR writes both, each with a certificate of its verdict.\n"
              : "Both are in " + examples + ", each with a certificate of its verdict.\n");
}

void write_two_examples(const std::string& folder, const GraspBox& box, NormalLaw law,
                        const BoxVerdict& verdict, const std::string& producer) {
  const auto* fragile = std::get_if<Fragile>(&verdict);
  if (fragile == nullptr) return say_no_examples(!box.is_point(), name_of(verdict));
  write_proved_files("--examples", folder,
                     {{"stable", proved_grasp(fragile->stable, law, true, producer)},
                      {"unstable", proved_grasp(fragile->unstable, law, false, producer)}});
}

void say_no_examples(bool is_box, const std::string& verdict) {
  std::cerr << "stickslip: --examples: nothing is written: "
            << (is_box ? "the box is " : "the question is about one grasp, which is ")
            << verdict << (is_box ? ", and only one that is fragile has two examples" : "")
            << '\n';
}

}  // namespace stickslip
