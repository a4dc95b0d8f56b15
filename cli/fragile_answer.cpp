// SPDX-License-Identifier: GPL-3.0-or-later
#include "fragile_answer.hpp"

#include <iostream>
#include <utility>

#include "question_options.hpp"

namespace stickslip {

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

void write_two_examples(const std::string& folder, ProvedFiles stable, ProvedFiles unstable) {
  write_proved_files("--examples", folder,
                     {{"stable", std::move(stable)}, {"unstable", std::move(unstable)}});
}

void say_no_examples(bool is_box, const std::string& verdict) {
  std::cerr << "stickslip: --examples: nothing is written: "
            << (is_box ? "the box is " : "the question is about one grasp, which is ")
            << verdict << (is_box ? ", and only one that is fragile has two examples" : "")
            << '\n';
}

void say_two_certificates() {
  std::cerr << "stickslip: --certificate: nothing is written: what proves that a box is "
               "fragile is two grasps, each with a certificate; --examples DIR writes them\n";
}

}  // namespace stickslip
