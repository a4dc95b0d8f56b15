// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/space/spatial_question.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "stickslip/core/error.hpp"

namespace stickslip {

SpatialQuestion ask(const SpatialGrasp& grasp, const SpatialOptions& options) {
  SpatialQuestion question;
  question.grasp = grasp;
  question.law = options.law;
  question.preload = options.preload;
  question.uncertain = options.uncertain;
  question.direction = options.direction;
  question.preload_direction = options.preload_direction;
  question.grasp.cases.clear();
  if (options.wrench && options.case_name) {
    throw InputError("", "case", "a wrench is given as well", "give one of them");
  }
  if (options.wrench) {
    for (std::size_t j = 0; j < 6; ++j) {
      question.grasp.box.wrench[j] = point_interval((*options.wrench)[j]);
    }
  } else if (options.direction && !options.case_name) {
    question.grasp.box.wrench.assign(6, {});
  } else if (options.case_name || !grasp.cases.empty()) {
    std::vector<std::string> names;
    for (const SpatialCase& load : grasp.cases) names.push_back(load.name);
    question.grasp.box.wrench = grasp.cases[case_named(names, options.case_name)].wrench;
    question.case_name = options.case_name.value_or("");
  }
  if (options.preload) {
    for (UncertainContact& c : question.grasp.box.contacts) {
      c.preload = point_interval(*options.preload);
    }
  }
  if (options.preload_direction) {
    std::vector<Rational> preloads;
    for (const UncertainContact& c : question.grasp.box.contacts) preloads.push_back(c.preload.low);
    question.preload_growth = preload_growth(preloads, *options.preload_direction);
    for (UncertainContact& c : question.grasp.box.contacts) {
      if (options.preload_direction->scale) c.preload = {};
    }
  }
  question.wrench = question.grasp.box.wrench;
  question.grasp.box = question.grasp.box.widened(options.uncertain);
  const bool is_one_grasp = question.grasp.box.is_point();
  bool is_rational = true;
  for (std::size_t i = 0; i < question.grasp.box.contacts.size(); ++i) {
    const UncertainContact& c = question.grasp.box.contacts[i];
    const bool is_preloaded =
        !c.preload.high.is_zero() ||
        (!question.preload_growth.empty() && !question.preload_growth[i].is_zero());
    is_rational = is_rational && (!is_preloaded || exact_sqrt(dot(c.normal, c.normal)));
  }
  question.is_box = !is_one_grasp || !is_rational;
  if (question.is_margin()) {
    const Vector6 none{};
    require_growth(question.direction.value_or(none) != none, question.preload_growth,
                   question.preload_direction);
    if (!is_one_grasp) refuse_uncertain_margin();
  }
  return question;
}

}  // namespace stickslip
