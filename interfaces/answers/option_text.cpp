// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/option_text.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "stickslip/core/error.hpp"

namespace stickslip {

Wrench wrench_option(const std::string& option, const std::string& value) {
  const std::vector<Rational> numbers = rationals_at(option, value);
  if (numbers.size() != 3) {
    throw InputError("", option,
                     quote(value) + " has " + std::to_string(numbers.size()) + " numbers",
                     "give force x, force y and torque as in " + option + " 0,-11/10,0");
  }
  return wrench_of(numbers);
}

Rational positive_option(const std::string& option, const std::string& value) {
  Rational number = rational_at(option, value);
  if (number.sign() > 0) return number;
  throw InputError("", option, "the value is " + value,
                   "give a number above 0, such as 1/1000");
}

Rational accuracy_option(const std::string& value) {
  const bool percent = !value.empty() && value.back() == '%';
  const std::string number = value.substr(0, value.size() - (percent ? 1 : 0));
  const Rational accuracy = rational_at("--accuracy", number) / (percent ? 100 : 1);
  if (accuracy.sign() > 0 && accuracy < 1) return accuracy;
  throw InputError("", "--accuracy", "the value is " + value,
                   "it is a part of the radius: give more than 0 and less than 100%");
}

InputError in_options(const InputError& error, const std::string& name) {
  for (const std::string option :
       {"--wrench", "--preload", "--direction", "--preload-direction", "--methods",
        "--max-force", "--edges"}) {
    std::string place = option.substr(2);
    std::replace(place.begin(), place.end(), '-', '_');
    if (error.place() == place) return {"", option, error.problem(), error.remedy()};
  }
  if (error.place() == "case" || error.place() == "uncertain" || error.place() == "balanced") {
    return {name, "--" + error.place(), error.problem(), error.remedy()};
  }
  return error.in_file(name);
}

Question ask_with_options(GraspFile file, const QuestionOptions& options,
                          const std::string& name, bool takes_boxes) {
  try {
    Question question = ask(std::move(file), options);
    // This is refused while the options are known. Margins of a box are claims.
    if (question.box() != nullptr && !takes_boxes && !question.is_margin()) {
      require_one_grasp(question);
    }
    return question;
  } catch (const InputError& error) {
    if (error.place() == "max_motion" && options.max_motion) {
      throw InputError("", "--max-motion", error.problem(), error.remedy());
    }
    throw in_options(error, name);
  }
}

}  // namespace stickslip
