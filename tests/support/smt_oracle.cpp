// SPDX-License-Identifier: GPL-3.0-or-later
#include "smt_oracle.hpp"

#include <optional>
#include <sstream>
#include <stdexcept>

#include "smt_solver.hpp"

namespace stickslip::test {
namespace {

std::string literal(const Rational& value) {
  std::ostringstream out;
  const Rational magnitude = abs(value);
  out << "(/ " << numerator(magnitude) << ".0 " << denominator(magnitude) << ".0)";
  return value < 0 ? "(- " + out.str() + ")" : out.str();
}

/// The length of v if it is rational.
std::optional<Rational> rational_length(const Vector2& v) {
  const Rational square = v.x * v.x + v.y * v.y;
  const Rational root(Integer(sqrt(numerator(square))), Integer(sqrt(denominator(square))));
  return root * root == square ? std::optional<Rational>(root) : std::nullopt;
}

/// The number, and in a family what the multiple l adds to it.
std::string growing(const Rational& base, const Rational& rate) {
  if (rate == 0) return literal(base);
  return "(+ " + literal(base) + " (* " + literal(rate) + " l))";
}

/// Contact i: forces cn, ct along n and t; the motion (mx, my) of the contact point. `growth`
/// is that of its preload.
void write_contact(std::ostream& out, const Contact& contact, const Rational& growth,
                   std::size_t i, NormalLaw law, Model model) {
  const std::string id = std::to_string(i);
  Vector2 n = contact.normal;
  // cn = P - k n.m for a unit normal. Along a normal of irrational length L, without preload,
  // cn is the force over L, and n.m is L times the normal motion.
  Rational spring = contact.stiffness;
  if (const std::optional<Rational> length = rational_length(n)) {
    n = {n.x / *length, n.y / *length};
  } else {
    if (contact.preload != 0 || growth != 0)
      throw std::invalid_argument("preload along an irrational normal");
    spring /= n.x * n.x + n.y * n.y;
  }
  const std::string nx = literal(n.x);
  const std::string ny = literal(n.y);
  const std::string tx = literal(-n.y);
  const std::string ty = literal(n.x);
  const std::string px = literal(contact.position.x);
  const std::string py = literal(contact.position.y);
  const std::string mu = literal(contact.friction);
  const auto define = [&](const char* name, const std::string& term) {
    out << "(define-fun " << name << id << " () Real " << term << ")\n";
  };
  const auto var = [&](const char* name) { return name + id; };
  const auto dot = [](const std::string& ax, const std::string& bx, const std::string& ay,
                      const std::string& by) {
    return "(+ (* " + ax + " " + bx + ") (* " + ay + " " + by + "))";
  };

  out << "(declare-fun " << var("cn") << " () Real)\n(declare-fun " << var("ct")
      << " () Real)\n";
  define("mx", "(- x (* r " + py + "))");
  define("my", "(+ y (* r " + px + "))");
  define("v", "(- " + growing(contact.preload, growth) + " (* " + literal(spring) + " " +
                  dot(nx, var("mx"), ny, var("my")) + "))");
  define("slip", dot(tx, var("mx"), ty, var("my")));
  define("fx", dot(nx, var("cn"), tx, var("ct")));
  define("fy", dot(ny, var("cn"), ty, var("ct")));
  define("torque", "(- (* " + px + " " + var("fy") + ") (* " + py + " " + var("fx") + "))");

  const auto assert_that = [&](const std::string& condition) {
    out << "(assert " << condition << ")\n";
  };
  const std::string cn = var("cn");
  const std::string ct = var("ct");
  const std::string v = var("v");
  const std::string slip = var("slip");
  const std::string closed = "(and (= " + cn + " " + v + ") (>= " + v + " 0.0))";
  const std::string open = "(and (= " + cn + " 0.0) (<= " + v + " 0.0))";
  define("limit", "(* " + mu + " " + cn + ")");
  const std::string limit = var("limit");
  const std::string in_cone = "(and (>= " + cn + " 0.0) (<= " + ct + " " + limit +
                              ") (>= " + ct + " (- " + limit + ")))";
  const std::string dissipates = "(or (= " + slip + " 0.0) (and (> " + slip + " 0.0) (= " + ct +
                                 " (- " + limit + "))) (and (< " + slip + " 0.0) (= " + ct +
                                 " " + limit + ")))";
  const std::string tangential_spring =
      "(= " + ct + " (- (* " + literal(spring) + " " + slip + ")))";
  const std::string unloaded = "(= " + ct + " 0.0)";
  assert_that(in_cone);
  switch (model) {
    case Model::kPassive:
      assert_that(dissipates);
      [[fallthrough]];
    case Model::kConesAlone:
      assert_that(law == NormalLaw::kUnilateral ? "(or " + closed + " " + open + ")" : closed);
      break;
    case Model::kWeak:
      break;
    case Model::kFrictionless:
      assert_that(unloaded);
      break;
    case Model::kAccelerates: {
      const std::string apart = dot(nx, var("mx"), ny, var("my"));
      assert_that("(>= " + apart + " 0.0)");
      assert_that("(or (= " + cn + " 0.0) (= " + apart + " 0.0))");
      assert_that(dissipates);
      break;
    }
    case Model::kLinearSprings:
      assert_that(closed);
      assert_that(tangential_spring);
      break;
    case Model::kThreeStates:
      assert_that("(or (and " + closed + " " + tangential_spring + ") (and " + closed + " " +
                  unloaded + ") (and " + open + " " + unloaded + "))");
      break;
  }
}

/// The load and the contacts' parts sum to `total`.
void write_balance(std::ostream& out, const char* total, const std::string& load,
                   const char* part, std::size_t count) {
  out << "(assert (= " << total << " (+ 0.0 " << load;
  for (std::size_t i = 0; i < count; ++i) out << ' ' << part << i;
  out << ")))\n";
}

}  // namespace

namespace {

/// With growths as in a Question.
std::string assertions(const LoadCase& load_case, Model model, const Wrench& load_growth,
                       const std::vector<Rational>& preload_growth) {
  std::ostringstream out;
  out << "(declare-fun x () Real)\n(declare-fun y () Real)\n(declare-fun r () Real)\n";
  const std::vector<Contact>& contacts = load_case.loaded.grasp.contacts();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Rational growth = preload_growth.empty() ? Rational(0) : preload_growth[i];
    write_contact(out, contacts[i], growth, i, load_case.law, model);
  }
  const bool moves = model == Model::kAccelerates;
  const Wrench& w = load_case.loaded.wrench;
  write_balance(out, moves ? "x" : "0.0", growing(w.x, load_growth.x), "fx", contacts.size());
  write_balance(out, moves ? "y" : "0.0", growing(w.y, load_growth.y), "fy", contacts.size());
  write_balance(out, moves ? "r" : "0.0", growing(w.torque, load_growth.torque), "torque",
                contacts.size());
  if (moves) out << "(assert (not (and (= x 0.0) (= y 0.0) (= r 0.0))))\n";
  return out.str();
}

/// In the order of the questions.
std::vector<std::string> answers_to(const std::vector<std::string>& questions) {
  std::string text;
  for (const std::string& assertions : questions) {
    text += "(reset)\n(set-logic QF_LRA)\n" + assertions + "(check-sat)\n";
  }
  std::vector<std::string> answers = ask_solver(STICKSLIP_Z3, "-smt2", text);
  for (std::string& answer : answers) {
    if (answer == "sat") answer = "stable";
    if (answer == "unsat") answer = "unstable";
  }
  if (answers.size() != questions.size()) {
    throw std::runtime_error("z3 gave " + std::to_string(answers.size()) + " lines for " +
                             std::to_string(questions.size()) +
                             " questions, last: " + (answers.empty() ? "" : answers.back()));
  }
  return answers;
}

}  // namespace

std::string smt_assertions(const LoadCase& load_case, Model model) {
  return assertions(load_case, model, {}, {});
}

std::vector<std::string> ask_z3(const std::vector<LoadCase>& load_cases, Model model) {
  std::vector<std::string> questions;
  for (const LoadCase& load_case : load_cases) {
    questions.push_back(smt_assertions(load_case, model));
  }
  return answers_to(questions);
}

std::vector<std::string> ask_z3(const std::vector<FamilyCase>& families) {
  std::vector<std::string> questions;
  for (const auto& [margin, range] : families) {
    std::string text = std::string("(declare-fun l () Real)\n(assert (") +
                       (range.has_low ? ">= " : "> ") + "l " + literal(range.low) + "))\n";
    if (range.high) text += "(assert (< l " + literal(*range.high) + "))\n";
    text += assertions({margin.loaded(), margin.law}, Model::kPassive,
                       margin.direction ? wrench_of(*margin.direction) : Wrench{},
                       margin.preload_growth);
    questions.push_back(std::move(text));
  }
  return answers_to(questions);
}

}  // namespace stickslip::test
