// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/question.hpp"

#include "stickslip/core/error.hpp"

namespace stickslip {

Question ask(const GraspFile& file, const QuestionOptions& options) {
  Question question{file.content, options.law, options.preload, file.assumed_stiffness};
  if (options.wrench) question.loaded.wrench = *options.wrench;
  if (options.preload) {
    if (options.preload->sign() < 0) {
      throw InputError("", "preload", "the value is " + to_string(*options.preload),
                       "a preload is a normal force and must be 0 or more");
    }
    question.loaded.grasp = question.loaded.grasp.with_preload(*options.preload);
  }
  return question;
}

}  // namespace stickslip
