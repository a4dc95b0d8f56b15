// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/question.hpp"

#include <algorithm>
#include <utility>

#include "stickslip/core/contact_row.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

WrenchBox wrench_asked(const GraspFile& file, const QuestionOptions& options) {
  const std::optional<std::string>& name = options.case_name;
  if (options.wrench && name) {
    throw InputError("", "case", "a wrench is given as well", "give one of them");
  }
  if (options.wrench) return box_of(*options.wrench);
  if (!name && options.direction) return box_of(Wrench{});
  if (!name && file.cases.empty()) {
    return file.box ? file.box->wrench : box_of(file.content.wrench);
  }
  std::vector<std::string> names;
  for (const NamedLoad& load : file.cases) names.push_back(load.name);
  const NamedLoad& chosen = file.cases[case_named(names, name)];
  return chosen.box.value_or(box_of(chosen.wrench));
}

bool all_zero(const std::vector<Rational>& values) {
  return std::all_of(values.begin(), values.end(),
                     [](const Rational& value) { return value.is_zero(); });
}

bool has_irrational_preload(const Grasp& grasp) {
  return std::any_of(grasp.contacts().begin(), grasp.contacts().end(), [](const Contact& c) {
    return !c.preload.is_zero() &&
           !exact_sqrt(c.normal.x * c.normal.x + c.normal.y * c.normal.y);
  });
}

/// Sets the box of a question that is one.
void enclose(Question& question, std::optional<GraspBox> of_file, const WrenchBox& wrench) {
  const bool certain = !of_file && wrench == box_of(question.loaded.wrench);
  if (question.is_margin()) {
    if (!certain || question.uncertain.any()) refuse_uncertain_margin();
    return;
  }
  if (certain && !question.uncertain.any() && !has_irrational_preload(question.loaded.grasp)) {
    return;
  }
  GraspBox box = of_file ? std::move(*of_file) : box_of(question.loaded);
  if (question.preload) {
    for (UncertainContact& c : box.contacts) c.preload = point_interval(*question.preload);
  }
  box.wrench = wrench;
  box = box.widened(question.uncertain);
  if (box.is_point() && !needs_enclosure(box)) return;
  question.loaded = box.planar_middle(question.loaded.grasp.description());
  if (!(wrench == box_of(question.loaded.wrench))) question.uncertain_wrench = wrench;
  question.box = std::move(box);
}

}  // namespace

std::vector<Rational> preload_growth(const std::vector<Rational>& preloads,
                                     const PreloadDirection& direction) {
  if (direction.scale) return preloads;
  if (direction.rates.size() != preloads.size()) {
    throw InputError("", "preload_direction",
                     "there are " + std::to_string(direction.rates.size()) + " numbers for " +
                         std::to_string(preloads.size()) + " contacts",
                     "give one for each contact, or the word scale for all in proportion");
  }
  for (std::size_t i = 0; i < direction.rates.size(); ++i) {
    if (direction.rates[i].sign() >= 0) continue;
    throw InputError(
        "", "preload_direction",
        "the number of contact " + std::to_string(i) + " is " + to_string(direction.rates[i]),
        "preloads grow, and do not fall: give 0 or more");
  }
  return direction.rates;
}

void refuse_uncertain_margin() {
  throw InputError("", "uncertain", "a margin needs numbers, and some are uncertain",
                   "give one number for each, or ask only whether the load is held");
}

void require_growth(bool load_grows, const std::vector<Rational>& growth,
                    const std::optional<PreloadDirection>& direction) {
  if (load_grows || !all_zero(growth)) return;
  if (!direction) {
    throw InputError("", "direction", "the direction is 0",
                     "give the wrench whose multiples are asked for, such as 0,1,0");
  }
  throw InputError(
      "", "preload_direction",
      direction->scale ? "there is no preload to scale" : "all of its numbers are 0",
      direction->scale ? "give a preload, or how each one grows"
                       : "give a number above 0 to a contact whose preload grows");
}

Question ask(GraspFile file, const QuestionOptions& options) {
  const WrenchBox wrench = wrench_asked(file, options);
  Question question{{std::move(file.content.grasp), planar_middle(wrench)},
                    options.law,
                    options.preload,
                    std::move(file.assumed_stiffness),
                    options.direction,
                    options.preload_direction,
                    {},
                    options.case_name.value_or(""),
                    options.uncertain};
  Grasp& grasp = question.loaded.grasp;
  if (options.preload) {
    if (options.preload->sign() < 0) {
      throw InputError("", "preload", "the value is " + to_string(*options.preload),
                       "a preload is a normal force and must be 0 or more");
    }
    grasp = grasp.with_preload(*options.preload);
  }
  if (options.preload_direction) {
    std::vector<Rational> preloads;
    for (const Contact& c : grasp.contacts()) preloads.push_back(c.preload);
    question.preload_growth = preload_growth(preloads, *options.preload_direction);
    if (options.preload_direction->scale) grasp = grasp.with_preload(0);
  }
  if (question.is_margin()) {
    require_growth(!(question.direction.value_or(Wrench{}) == Wrench{}),
                   question.preload_growth, question.preload_direction);
  }
  enclose(question, std::move(file.box), wrench);
  return question;
}

Problem problem_of(const Question& question) {
  if (question.box && !question.box->is_point()) {
    throw InputError("", "", "some numbers are uncertain, and this needs one grasp",
                     "give one number for each; only whether the load is held can be asked of "
                     "all grasps in a box");
  }
  Problem base(question.loaded, question.law);
  if (!question.is_margin()) return base;
  Growth growth{question.direction.value_or(Wrench{})};
  if (!question.preload_growth.empty()) {
    const Grasp growing = question.loaded.grasp.with_preloads(question.preload_growth);
    for (const ContactRow& row : contact_rows(growing)) growth.preloads.push_back(row.preload);
  }
  return base.along(growth);
}

}  // namespace stickslip
