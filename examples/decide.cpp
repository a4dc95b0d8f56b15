// SPDX-License-Identifier: GPL-3.0-or-later
// decide GRASP CERTIFICATE: decides, writes the proof, and has it checked.
#include <iostream>

#include "stickslip/stickslip.hpp"

int main(int argc, char** argv) try {
  if (argc != 3) return 2;
  const stickslip::Question question = ask(stickslip::read_any_grasp_file(argv[1]));
  const stickslip::Answer answer = decide(question);
  std::cout << name_of(answer.verdict) << '\n';
  const auto certificate = certificate_of(answer);
  if (!certificate) return 3;  // undecided, or fragile
  stickslip::write_whole_file(argv[2], *certificate);
  std::cout << refusal_of(answer.question, *certificate).value_or("accepted") << '\n';
} catch (const stickslip::InputError& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
