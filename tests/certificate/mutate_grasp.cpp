// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "json_edit.hpp"

namespace stickslip::test {
namespace {

/// A positive or nonnegative property, changed.
Json changed(RandomSource& random, const Json& value) {
  return json_of(number_of(value) +
                 random.pick<Rational>({1, Rational(1, 2), Rational(1, 1000000000)}));
}

}  // namespace

void mutate_grasp(RandomSource& random, const Certified& original, Mutants& mutants) {
  const Json grasp = Json::parse(original.about.grasp);
  const auto add = [&](const std::string& kind, const Json& edited, Expectation expected = {}) {
    CheckerInput input = original.input();
    input.grasp = edited.dump();
    mutants.push_back({kind, original.name(), std::move(input), std::move(expected)});
  };
  Json edited = grasp;
  edited["name"] = "another name";
  add("rename the grasp", edited, Expectation::accepted());
  edited["format"] = "stickslip-grasp/3";
  add("wrong version of the grasp", edited, Expectation::malformed());
  if (!original.about.options.wrench) {
    edited = grasp;
    Json& entry = edited["wrench"][any_of(random, grasp["wrench"])];
    entry = changed(random, entry);
    add("change the grasp's wrench", edited, Expectation::of_rule("question-wrench"));
  }
  if (grasp["contacts"].empty()) return;
  edited = grasp;
  edited["contacts"].erase(any_of(random, grasp["contacts"]));
  add("drop a contact", edited, Expectation::of_rule("question-contacts"));
  edited = grasp;
  edited["contacts"].push_back(grasp["contacts"][0]);
  add("add a contact", edited, Expectation::of_rule("question-contacts"));
  for (const char* key : {"position", "normal", "friction", "stiffness", "preload"}) {
    edited = grasp;
    Json& value = edited["contacts"][any_of(random, grasp["contacts"])][key];
    if (value.is_array()) {
      Json& entry = value[any_of(random, value)];
      entry = changed(random, entry);
    } else {
      value = changed(random, value);
    }
    add(std::string("change the grasp's ") + key, edited);
  }
  edited = grasp;
  std::reverse(edited["contacts"].begin(), edited["contacts"].end());
  add("reverse the contacts", edited);
}

void swap_grasps(const Certified& one, const Certified& other, Mutants& mutants) {
  mutants.push_back({"swap grasps",
                     one.name() + " for " + other.name(),
                     {other.about.grasp, one.text, other.about.options},
                     {}});
}

}  // namespace stickslip::test
