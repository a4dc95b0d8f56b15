// SPDX-License-Identifier: GPL-3.0-or-later
// Tiny boxes against Z3: whether some grasp of the box has an equilibrium, in the words of
// physics, with unit normals. Uncertain numbers are unknowns, so this is not linear; where the
// solver gives up it says nothing.
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <sstream>

#include "box_cases.hpp"
#include "rounds.hpp"
#include "smt_solver.hpp"

namespace stickslip {
namespace {

using test::RandomSource;

std::string literal(const Rational& value) {
  const Rational size = abs(value);
  const std::string text =
      "(/ " + numerator(size).str() + ".0 " + denominator(size).str() + ".0)";
  return value.sign() < 0 ? "(- " + text + ")" : text;
}

class Script {
 public:
  /// An unknown in the interval, or a number.
  std::string number(const std::string& name, const Interval& interval) {
    if (interval.is_point()) return literal(interval.low);
    declare(name);
    require("(<= " + literal(interval.low) + " " + name + " " + literal(interval.high) + ")");
    return name;
  }
  std::string declare(const std::string& name) {
    out_ << "(declare-fun " << name << " () Real)\n";
    return name;
  }
  std::string define(const std::string& name, const std::string& term) {
    out_ << "(define-fun " << name << " () Real " << term << ")\n";
    return name;
  }
  void require(const std::string& condition) { out_ << "(assert " << condition << ")\n"; }
  std::string text() const { return out_.str(); }

 private:
  std::ostringstream out_;
};

std::string product(const std::string& a, const std::string& b) {
  return "(* " + a + " " + b + ")";
}
std::string sum(const std::string& a, const std::string& b) {
  return "(+ " + a + " " + b + ")";
}
std::string difference(const std::string& a, const std::string& b) {
  return "(- " + a + " " + b + ")";
}

/// Satisfiable iff some grasp of the box is stable.
std::string some_grasp_is_stable(const GraspBox& box, NormalLaw law) {
  Script script;
  std::array<std::string, 3> total;
  for (std::size_t j = 0; j < 3; ++j) {
    total[j] = script.number("w" + std::to_string(j), box.wrench[j]);
  }
  for (const char* name : {"dx", "dy", "dr"}) script.declare(name);
  for (std::size_t i = 0; i < box.contacts.size(); ++i) {
    const UncertainContact& c = box.contacts[i];
    const std::string id = std::to_string(i);
    const std::string px = script.number("px" + id, c.position[0]);
    const std::string py = script.number("py" + id, c.position[1]);
    const std::string mu = script.number("mu" + id, c.friction);
    const std::string k = script.number("k" + id, c.stiffness);
    const std::string preload = script.number("P" + id, c.preload);
    const std::string nx = script.declare("nx" + id);
    const std::string ny = script.declare("ny" + id);
    const std::string along =
        sum(product(literal(c.normal[0]), nx), product(literal(c.normal[1]), ny));
    const std::string across =
        difference(product(literal(c.normal[0]), ny), product(literal(c.normal[1]), nx));
    const std::string reach = product(literal(c.slope), along);
    script.require("(= 1.0 " + sum(product(nx, nx), product(ny, ny)) + ")");
    script.require("(> " + along + " 0.0)");
    script.require("(<= (- " + reach + ") " + across + " " + reach + ")");
    const std::string mx = script.define("mx" + id, difference("dx", product("dr", py)));
    const std::string my = script.define("my" + id, sum("dy", product("dr", px)));
    const std::string v = script.define(
        "v" + id, difference(preload, product(k, sum(product(nx, mx), product(ny, my)))));
    const std::string slip =
        script.define("slip" + id, difference(product(nx, my), product(ny, mx)));
    const std::string a = script.declare("a" + id);
    const std::string b = script.declare("b" + id);
    const std::string limit = script.define("limit" + id, product(mu, a));
    const std::string closed = "(and (>= " + v + " 0.0) (= " + a + " " + v + "))";
    const std::string open = "(and (<= " + v + " 0.0) (= " + a + " 0.0))";
    script.require(law == NormalLaw::kBilateral ? closed : "(or " + closed + " " + open + ")");
    script.require("(<= (- " + limit + ") " + b + " " + limit + ")");
    script.require("(=> (> " + slip + " 0.0) (= " + b + " (- " + limit + ")))");
    script.require("(=> (< " + slip + " 0.0) (= " + b + " " + limit + "))");
    const std::string fx = script.define("fx" + id, difference(product(nx, a), product(ny, b)));
    const std::string fy = script.define("fy" + id, sum(product(ny, a), product(nx, b)));
    total[0] = sum(total[0], fx);
    total[1] = sum(total[1], fy);
    total[2] = sum(total[2], difference(product(px, fy), product(py, fx)));
  }
  for (const std::string& part : total) script.require("(= 0.0 " + part + ")");
  return "(reset)\n(set-option :timeout 1500)\n" + script.text() + "(check-sat)\n";
}

/// One or two contacts, with one or two kinds of uncertainty.
test::BoxCase tiny_box(RandomSource& random) {
  const Grasp grasp =
      test::degenerate_grasp(random, static_cast<std::size_t>(random.between(1, 2)));
  const NormalLaw law = random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
  const Wrench wrench =
      random.one_in(2) ? test::small_wrench(random) : test::planted_wrench(random, grasp, law);
  test::BoxCase result{write_grasp({grasp, wrench})};
  result.options.law = law;
  result.options.uncertain = parse_tolerances(random.pick<std::string>(
      {"friction=10%", "friction=20%,wrench=10%", "wrench=10%", "wrench=0.1",
       "preload=20%,friction=5%", "normal=0.05", "position=0.01,friction=10%"}));
  return result.question().box() != nullptr ? result : tiny_box(random);
}

TEST(AgainstZ3, WhetherSomeGraspOfATinyBoxIsStable) {
  if (test::kSanitized) GTEST_SKIP() << "nothing new is run";
  RandomSource random(31);
  std::vector<test::BoxCase> cases;
  std::vector<std::string> verdicts;
  std::string script;
  while (cases.size() < 24) {
    const test::BoxCase about = tiny_box(random);
    const BoxDecision decision = about.decide();
    if (std::holds_alternative<Undecided>(decision.verdict)) continue;
    script += some_grasp_is_stable(about.box(), about.options.law);
    cases.push_back(about);
    verdicts.emplace_back(name_of(decision.verdict));
  }
  const std::vector<std::string> answers = test::ask_solver(STICKSLIP_Z3, "-smt2", script);
  ASSERT_EQ(answers.size(), cases.size());
  std::map<std::string, int> tally;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    ++tally[verdicts[i] + " " + answers[i]];
    if (answers[i] == "unknown") continue;
    EXPECT_EQ(answers[i], verdicts[i] == "unstable" ? "unsat" : "sat") << describe(cases[i]);
  }
  for (const auto& [what, count] : tally) std::cout << what << ": " << count << "\n";
  EXPECT_GE(tally["unstable unsat"], 5);
  EXPECT_GE(tally["stable sat"] + tally["fragile sat"], 5);
}

}  // namespace
}  // namespace stickslip
