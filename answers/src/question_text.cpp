// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/answers/question_text.hpp"

#include <algorithm>
#include <vector>

#include "stickslip/core/error.hpp"
#include "stickslip/equilibrium/option_text.hpp"

namespace stickslip {
namespace {

Vector6 six_numbers(const char* option, const std::string& value) {
  const std::vector<Rational> numbers = numbers_option(option, value);
  if (numbers.size() != 6) {
    throw InputError("", option,
                     quote(value) + " has " + std::to_string(numbers.size()) + " numbers",
                     "the grasp is in space: give force x, y, z and torque x, y, z");
  }
  Vector6 result;
  std::copy(numbers.begin(), numbers.end(), result.begin());
  return result;
}

}  // namespace

QuestionOptions question_options(const QuestionText& text) {
  QuestionOptions options;
  if (!text.wrench.empty()) options.wrench = wrench_option("--wrench", text.wrench);
  if (!text.case_name.empty()) options.case_name = text.case_name;
  if (!text.preload.empty()) options.preload = number_option("--preload", text.preload);
  if (!text.direction.empty()) options.direction = wrench_option("--direction", text.direction);
  if (text.preload_direction == "scale") {
    options.preload_direction = PreloadDirection{true, {}};
  } else if (!text.preload_direction.empty()) {
    options.preload_direction =
        PreloadDirection{false, numbers_option("--preload-direction", text.preload_direction)};
  }
  if (!text.uncertain.empty()) {
    try {
      options.uncertain = parse_tolerances(text.uncertain);
    } catch (const InputError& error) {
      throw InputError("", "--uncertain", error.problem(), error.remedy());
    }
  }
  options.law = text.normal_law == "bilateral" ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
  return options;
}

SpatialOptions spatial_options(const QuestionText& text) {
  SpatialOptions asked;
  if (!text.wrench.empty()) asked.wrench = six_numbers("--wrench", text.wrench);
  if (!text.direction.empty()) asked.direction = six_numbers("--direction", text.direction);
  // The rest is said as in the plane.
  QuestionText others = text;
  others.wrench.clear();
  others.direction.clear();
  const QuestionOptions options = question_options(others);
  asked.preload = options.preload;
  asked.preload_direction = options.preload_direction;
  asked.law = options.law;
  asked.case_name = options.case_name;
  asked.uncertain = options.uncertain;
  return asked;
}

SpatialQuestion ask_with_options(const SpatialGrasp& grasp, const SpatialOptions& options,
                                 const std::string& name) {
  try {
    return ask(grasp, options);
  } catch (const InputError& error) {
    throw in_options(error, name);
  }
}

}  // namespace stickslip
