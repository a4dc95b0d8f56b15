// SPDX-License-Identifier: GPL-3.0-or-later
#include "margin_truth.hpp"

#include <set>

#include "family.hpp"
#include "json_edit.hpp"

namespace stickslip::test {

std::string lie_of(const CheckerInput& margin) {
  const Json resisted = Json::parse(margin.certificate).at("resisted");
  const Rational close = parse_rational("1e-20");
  std::set<Rational> multiples{0, close, 1000000};
  std::vector<std::pair<Rational, Rational>> intervals;
  Rational last = 0;
  for (const Json& entry : resisted) {
    const Rational low = number_of(entry[0]);
    const Rational high = entry[1].is_null() ? Rational(2000000) : number_of(entry[1]);
    intervals.emplace_back(low, high);
    multiples.insert({low - close, low, low + close, (low + high) / 2, (last + low) / 2});
    multiples.insert({high - close, high, high + close, high + 1});
    last = high;
  }
  const Question question = ask(parse_grasp(margin.grasp, "grasp"), margin.options);
  for (const Rational& multiple : multiples) {
    if (multiple < 0) continue;
    const Verdict verdict = decide(Problem(member(question, multiple), question.law)).verdict;
    bool claimed = false;
    for (const auto& [low, high] : intervals) {
      claimed = claimed || (low <= multiple && multiple <= high);
    }
    // Beyond what was put for infinity.
    if (!resisted.empty() && resisted.back()[1].is_null() && multiple > 2000000) claimed = true;
    if (std::holds_alternative<Stable>(verdict) != claimed) {
      return (claimed ? "not resisted: " : "resisted: ") + to_string(multiple);
    }
  }
  return "";
}

}  // namespace stickslip::test
