// SPDX-License-Identifier: GPL-3.0-or-later
#include "margin_truth.hpp"

#include <set>

#include "json_edit.hpp"

namespace stickslip::test {

std::string lie_of(const CheckerInput& margin) {
  const Json resisted = Json::parse(margin.certificate).at("resisted");
  const Rational close = parse_rational("1e-20");
  std::set<Rational> loads{0, close, 1000000};
  std::vector<std::pair<Rational, Rational>> intervals;
  Rational last = 0;
  for (const Json& entry : resisted) {
    const Rational low = number_of(entry[0]);
    const Rational high = entry[1].is_null() ? Rational(2000000) : number_of(entry[1]);
    intervals.emplace_back(low, high);
    loads.insert({low - close, low, low + close, (low + high) / 2, (last + low) / 2});
    loads.insert({high - close, high, high + close, high + 1});
    last = high;
  }
  const Question base = ask(parse_grasp(margin.grasp, "grasp"), margin.options);
  for (const Rational& load : loads) {
    if (load < 0) continue;
    LoadedGrasp loaded = base.loaded;
    loaded.wrench += load * *margin.direction;
    const Verdict verdict = decide(Problem(loaded, base.law)).verdict;
    bool claimed = false;
    for (const auto& [low, high] : intervals) {
      claimed = claimed || (low <= load && load <= high);
    }
    // Beyond what was put for infinity.
    if (!resisted.empty() && resisted.back()[1].is_null() && load > 2000000) claimed = true;
    if (std::holds_alternative<Stable>(verdict) != claimed) {
      return (claimed ? "not resisted: " : "resisted: ") + to_string(load);
    }
  }
  return "";
}

}  // namespace stickslip::test
