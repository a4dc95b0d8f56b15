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
  question.grasp.cases.clear();
  if (options.wrench && options.case_name) {
    throw InputError("", "case", "a wrench is given as well", "give one of them");
  }
  if (options.wrench) {
    for (std::size_t j = 0; j < 6; ++j) {
      question.grasp.wrench[j] = point_interval((*options.wrench)[j]);
    }
  } else if (options.case_name || !grasp.cases.empty()) {
    std::vector<std::string> names;
    for (const SpatialCase& load : grasp.cases) names.push_back(load.name);
    question.grasp.wrench = grasp.cases[case_named(names, options.case_name)].wrench;
    question.case_name = options.case_name.value_or("");
  }
  if (options.preload) {
    for (SpatialContact& c : question.grasp.contacts) {
      c.preload = point_interval(*options.preload);
    }
  }
  question.wrench = question.grasp.wrench;
  question.grasp = widened(std::move(question.grasp), options.uncertain);
  const auto is_certain = [](const auto& intervals) {
    return std::all_of(intervals.begin(), intervals.end(),
                       [](const Interval& interval) { return interval.is_point(); });
  };
  question.is_box = !is_certain(question.grasp.wrench);
  for (const SpatialContact& c : question.grasp.contacts) {
    question.is_box = question.is_box || !is_certain(c.position) || !c.friction.is_point() ||
                      !c.stiffness.is_point() || !c.preload.is_point() ||
                      (!c.preload.high.is_zero() && !exact_sqrt(dot(c.normal, c.normal)));
  }
  return question;
}

}  // namespace stickslip
