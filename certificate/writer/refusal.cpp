// SPDX-License-Identifier: GPL-3.0-or-later
#include <sstream>

#include "check.hpp"
#include "print.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/grasp_file.hpp"

namespace stickslip {

std::optional<std::string> refusal_of(const Question& question,
                                      const std::string& certificate) {
  std::istringstream grasp(write_grasp(question.grasp));
  std::istringstream proof(certificate);
  stickslip_check::Options options;
  options.bilateral = question.law == NormalLaw::kBilateral;
  const stickslip_check::Answer answer = stickslip_check::check(grasp, proof, options);
  if (std::holds_alternative<stickslip_check::Accepted>(answer)) return std::nullopt;
  return stickslip_check::as_text(answer);
}

}  // namespace stickslip
