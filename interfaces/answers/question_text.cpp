// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/question_text.hpp"

#include <utility>

#include "stickslip/core/error.hpp"
#include "stickslip/interfaces/option_text.hpp"

namespace stickslip {
QuestionOptions question_options(const QuestionText& text) {
  QuestionOptions options;
  if (!text.wrench.empty()) options.wrench = rationals_at("--wrench", text.wrench);
  if (!text.case_name.empty()) options.case_name = text.case_name;
  if (!text.preload.empty()) options.preload = rational_at("--preload", text.preload);
  if (!text.direction.empty()) options.direction = rationals_at("--direction", text.direction);
  if (text.preload_direction == "scale") {
    options.preload_direction = PreloadDirection{true, {}};
  } else if (!text.preload_direction.empty()) {
    options.preload_direction =
        PreloadDirection{false, rationals_at("--preload-direction", text.preload_direction)};
  }
  if (!text.uncertain.empty()) {
    try {
      options.uncertain = parse_tolerances(text.uncertain);
    } catch (const InputError& error) {
      throw InputError("", "--uncertain", error.problem(), error.remedy());
    }
  }
  if (!text.max_motion.empty()) {
    try {
      options.max_motion = parse_motion_bound(text.max_motion);
    } catch (const InputError& error) {
      throw InputError("", "--max-motion", error.problem(), error.remedy());
    }
  }
  options.law = text.normal_law == "bilateral" ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
  return options;
}

Question contacts_alone(GraspFile file) {
  if (!file.content.has_certain_elements()) {
    throw InputError("", "grasp", "some number is an interval", "give one grasp");
  }
  QuestionOptions without_load;
  without_load.wrench = RationalRow(file.content.wrench().size());
  Question question = as_one_body(ask(std::move(file), without_load));
  // Normals may have any length, and motions no bound.
  const GraspBox* box = question.box();
  if (box != nullptr && !box->in_space() && !box->mechanism) question.grasp = loaded_of(*box);
  return question;
}

}  // namespace stickslip
