// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/question.hpp"

#include <utility>

#include "stickslip/core/error.hpp"

namespace stickslip {

Question ask(const GraspFile& file, const QuestionOptions& options) {
  Question question{file.content, options.law, options.preload, {}, file.assumed_stiffness};
  if (options.wrench) question.loaded.wrench = *options.wrench;
  if (options.preload) {
    if (options.preload->sign() < 0) {
      throw InputError("", "preload", "the value is " + to_string(*options.preload),
                       "a preload is a normal force and must be 0 or more");
    }
    question.loaded.grasp = question.loaded.grasp.with_preload(*options.preload);
  }
  if (options.snap_tolerance &&
      (options.snap_tolerance->sign() <= 0 || *options.snap_tolerance >= 1)) {
    throw InputError("", "snap_normals", "the value is " + to_string(*options.snap_tolerance),
                     "it must lie between 0 and 1, such as 1e-9");
  }
  const std::optional<Rational>& tolerance =
      options.snap_tolerance ? options.snap_tolerance : file.snap_tolerance;
  if (tolerance) {
    SnapResult result = snap_normals(question.loaded.grasp, *tolerance);
    question.loaded.grasp = std::move(result.grasp);
    question.snapped = std::move(result.snapped);
  }
  return question;
}

}  // namespace stickslip
