// SPDX-License-Identifier: GPL-3.0-or-later
// Thousands of certificates of the engines and of margins, changed at random: all checkers say
// the same of each, to the rule, node and path; what is accepted is true. Which rule names
// which mistake is for tests/rules.
#include <gtest/gtest.h>

#include <functional>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "cases.hpp"
#include "family.hpp"
#include "random_grasps.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using Json = nlohmann::ordered_json;  // exact: what does not fit into a double is a string
using test::CheckerAnswer;
using test::CheckerInput;
using test::RandomSource;

constexpr std::size_t kLongest = 120;  ///< nodes; larger trees are accepted_test's

struct Mutant {
  std::string kind;
  CheckerInput input;
};

Rational number_of(const Json& value) {
  return value.is_string() ? parse_rational(value.get<std::string>())
                           : Rational(value.get<std::int64_t>());
}

Json json_of(const Rational& value) {
  if (denominator(value) == 1 && abs(numerator(value)) < (Integer(1) << 53)) {
    return numerator(value).convert_to<std::int64_t>();
  }
  return to_string(value);
}

/// The values inside of one for which this holds.
std::vector<Json*> values_in(Json& value, const std::function<bool(const Json&)>& good) {
  std::vector<Json*> found;
  if (good(value)) found.push_back(&value);
  if (!value.is_structured()) return found;
  for (Json& item : value) {
    for (Json* inside : values_in(item, good)) found.push_back(inside);
  }
  return found;
}

bool is_number(const Json& value) {
  const auto* text = value.get_ptr<const std::string*>();
  return value.is_number() || (text != nullptr && !text->empty() &&
                               text->find_first_not_of("-/0123456789") == std::string::npos);
}

bool is_list(const Json& value) {
  return value.is_array() && !value.empty();
}

/// One change anywhere inside of a value.
std::string change(RandomSource& random, Json& value) {
  const std::vector<Json*> numbers = values_in(value, is_number);
  const std::vector<Json*> lists = values_in(value, is_list);
  if (!numbers.empty() && !random.one_in(3)) {
    Json& one = *random.pick(numbers);
    const Rational old = number_of(one);
    switch (random.between(0, 5)) {
      case 0:
        one = json_of(-old);
        return "a sign";
      case 1:
        one = random.between(-2, 3);
        return "a small number";
      case 2:
        one = json_of(old + random.pick<Rational>({1, -1, Rational(-7, 3)}));
        return "another number";
      case 3:
        one = random.one_in(3) ? Json(nullptr) : Json(0);
        return "nothing";
      default:
        one = json_of(old + Rational(random.pick<int>({1, -1}), 1000000000));
        return "nearly the same number";
    }
  }
  if (lists.empty()) return "as it is";
  Json& list = *random.pick(lists);
  const auto last = static_cast<int>(list.size()) - 1;
  const auto at = static_cast<std::size_t>(random.between(0, last));
  switch (random.between(0, 3)) {
    case 0:
      list.erase(at);
      return "an element less";
    case 1:
      list.insert(list.begin() + static_cast<std::ptrdiff_t>(at), Json(list[at]));
      return "an element twice";
    case 2:
      std::swap(list[at], list[static_cast<std::size_t>(random.between(0, last))]);
      return "elements exchanged";
    default:
      if (list[0] == "slip" || list[0] == "separation") {
        list[0] = list[0] == "slip" ? "separation" : "slip";
        return "slip for separation";
      }
      // A leaf or a plane, or a motion.
      const Rational factor = random.pick<Rational>({-1, -1, 2, Rational(3, 7), 1000000007});
      for (Json& one : list) {
        if (is_number(one)) one = json_of(factor * number_of(one));
      }
      return factor < 0 ? "signs" : "a multiple";
  }
}

std::string damaged(RandomSource& random, std::string text) {
  static const std::string kLikely = "0123456789-+.,:/\"[]{}eE \\\n\xFF";
  const auto place = [&] {
    return static_cast<std::size_t>(random.between(0, static_cast<int>(text.size()) - 1));
  };
  if (random.one_in(8)) return text.substr(0, place());
  for (int edits = random.between(1, 3); edits > 0; --edits) {
    const char c = kLikely[static_cast<std::size_t>(
        random.between(0, static_cast<int>(kLikely.size()) - 1))];
    switch (random.between(0, 2)) {
      case 0:
        text[place()] = c;
        break;
      case 1:
        text.insert(place(), 1, c);
        break;
      default:
        if (text.size() > 1) text.erase(place(), 1);
    }
  }
  return text;
}

void mutate(RandomSource& random, const CheckerInput& original, int rounds,
            std::vector<Mutant>& mutants) {
  const Json certificate = Json::parse(original.certificate);
  for (int round = 0; round < rounds; ++round) {
    CheckerInput input = original;
    Json edited = certificate;
    // Mostly the evidence: what is in `question` is not as it is asked, and no more is looked
    // at.
    std::string kind;
    for (int k = random.one_in(3) ? 2 : 1; k > 0; --k) {
      std::vector<Json*> members;
      for (const char* name : {"twist", "shares", "tree", "resisted", "segments"}) {
        if (edited.contains(name) && !edited[name].empty()) members.push_back(&edited[name]);
      }
      const bool of_question = members.empty() || random.one_in(10);
      Json& part = of_question ? edited["question"] : *random.pick(members);
      kind = change(random, part) + (of_question ? " in the question" : "");
    }
    input.certificate = edited.dump();
    mutants.push_back({kind, input});
  }
  for (int round = 0; round < 3; ++round) {
    CheckerInput input = original;
    input.certificate = damaged(random, input.certificate);
    mutants.push_back({"bytes of the certificate", input});
    input = original;
    input.grasp = damaged(random, input.grasp);
    mutants.push_back({"bytes of the grasp file", input});
    input = original;
    Json grasp = Json::parse(input.grasp);
    const std::string kind = change(random, grasp[random.one_in(4) ? "wrench" : "contacts"]);
    input.grasp = grasp.dump();
    mutants.push_back({kind + " in the grasp file", input});
  }
}

std::vector<Mutant> all_mutants() {
  RandomSource random(5);
  std::vector<CheckerInput> originals;
  for (const test::Certified& one : test::all_certificates()) {
    // The engines often find the same evidence.
    if (one.size() > kLongest ||
        (!originals.empty() && originals.back().certificate == one.text)) {
      continue;
    }
    originals.push_back(one.input());
  }
  EXPECT_GE(originals.size(), 40u);
  std::vector<Mutant> mutants;
  for (const CheckerInput& one : originals) {
    mutate(random, one, 15, mutants);
    CheckerInput swapped = random.pick(originals);
    swapped.certificate = one.certificate;
    mutants.push_back({"the certificate of another grasp", swapped});
  }
  for (const test::CommittedCertificate& margin : test::all_margins()) {
    mutate(random, margin.input, 60, mutants);
  }
  return mutants;
}

/// A multiple at which a margin that was accepted is wrong, or nothing.
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
    const Verdict verdict =
        decide(Problem(test::member(question, multiple), question.law)).verdict;
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

/// The grasp file and question of an accepted certificate have that verdict.
void expect_true(const Mutant& mutant) {
  const CheckerInput& input = mutant.input;
  try {
    if (input.options.direction || input.options.preload_direction) {
      EXPECT_EQ(lie_of(input), "") << mutant.kind << "\n" << describe(input);
      return;
    }
    const Question question = ask(parse_grasp(input.grasp, "grasp"), input.options);
    const std::string verdict = question.box() != nullptr
                                    ? name_of(decide_box(*question.box(), question.law).verdict)
                                    : name_of(decide(problem_of(question)).verdict);
    const bool claims_stable = input.certificate.find("\"twist\"") != std::string::npos;
    EXPECT_EQ(verdict, claims_stable ? "stable" : "unstable") << mutant.kind << "\n"
                                                              << describe(input);
  } catch (const InputError& error) {
    ADD_FAILURE() << "accepted, but " << error.what() << "\n" << describe(input);
  }
}

/// Whether core reads the grasp file as the checkers do.
void expect_grasp_read_alike(const Mutant& mutant, const CheckerAnswer& answer) {
  bool legible = true;
  std::string reason;
  try {
    const Question question = ask(parse_grasp(mutant.input.grasp, "grasp", Intervals::kAllowed),
                                  mutant.input.options);
    // All certificates of margins are by segments, and that of claims is another.
    legible = !question.has_claims();
  } catch (const InputError& error) {
    legible = false;
    reason = error.what();
  }
  EXPECT_EQ(answer.result != "malformed", legible) << describe(answer) << "\n"
                                                   << reason << "\n"
                                                   << describe(mutant.input);
}

TEST(Mutations, EachIsAnsweredAlikeAndRightly) {
  const std::vector<Mutant> mutants = all_mutants();
  EXPECT_GE(mutants.size(), 2000u);
  std::vector<CheckerInput> inputs;
  for (const Mutant& mutant : mutants) inputs.push_back(mutant.input);
  const std::vector<CheckerAnswer> python = test::ask_python_checker(inputs);

  std::vector<CheckerAnswer> answers;
  std::map<std::string, std::map<std::string, std::size_t>> tally;
  for (std::size_t i = 0; i < mutants.size(); ++i) {
    const Mutant& mutant = mutants[i];
    const CheckerAnswer cpp = answers.emplace_back(ask_cpp_checker(mutant.input));
    EXPECT_TRUE(cpp.agrees_with(python[i]))
        << "C++: " << describe(cpp) << "\nPython: " << describe(python[i]) << "\n"
        << mutant.kind << "\n"
        << describe(mutant.input);
    if (cpp.result == "accepted") expect_true(mutant);
    if (mutant.kind == "bytes of the grasp file") expect_grasp_read_alike(mutant, cpp);
    ++tally[mutant.kind][cpp.result];
    ++tally["all"][cpp.result == "rejected" ? cpp.rule : cpp.result];
  }
  test::expect_js_checker_agrees(inputs, answers);
  test::expect_proved_checker_agrees(inputs, answers);

  // Changes are small enough for most rules to be the one that fails.
  EXPECT_GT(tally["all"]["accepted"], mutants.size() / 100);
  EXPECT_GE(tally["all"].size(), 14u);
  std::cout << mutants.size() << " mutants of " << tally.size() - 1 << " kinds\n";
  for (const auto& [kind, results] : tally) {
    std::cout << "  " << kind << ":";
    for (const auto& [result, count] : results) std::cout << " " << count << " " << result;
    std::cout << "\n";
  }
}

}  // namespace
}  // namespace stickslip
