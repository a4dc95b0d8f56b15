// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/answers/asked_box.hpp"

namespace stickslip {

AskedBox asked_box(const Question& question) {
  const GraspBox centre = box_of(question.loaded);
  return {question.box.value_or(centre),
          centre,
          question.loaded.grasp.description(),
          question.case_name,
          question.law,
          question.uncertain};
}

AskedBox asked_box(const SpatialQuestion& question) {
  const GraspBox& box = question.grasp.box;
  return {box,          box.middle(),      question.grasp.description(), question.case_name,
          question.law, question.uncertain};
}

AskedBox asked_box(const std::variant<Question, SpatialQuestion>& question) {
  return std::visit([](const auto& asked) { return asked_box(asked); }, question);
}

}  // namespace stickslip
