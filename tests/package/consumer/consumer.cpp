// SPDX-License-Identifier: GPL-3.0-or-later
// consumer GRASP CERTIFICATE: decides, writes the certificate, prints the verdict.
#include <iostream>

#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/engine/decide.hpp"
#include "stickslip/interfaces/grasp_plot.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const stickslip::Question question = ask(stickslip::read_grasp_file(argv[1]), {});
  const stickslip::Problem problem(question.loaded(), question.law);
  const stickslip::Decision decision = decide(problem);
  stickslip::write_whole_file(
      argv[2], stickslip::certificate_text(question, decision.verdict, "consumer"));
  std::cout << stickslip::name_of(decision.verdict) << ' '
            << stickslip::plot_grasp(question, decision.verdict).size() << '\n';
}
