// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "stickslip/certificate/certificate.hpp"

namespace stickslip {
namespace {

std::string constant(const Rational& value) {
  const Integer num = abs(numerator(value));
  std::string text = num.str() + ".0";
  if (denominator(value) != 1) text = "(/ " + text + " " + denominator(value).str() + ".0)";
  return value.sign() < 0 ? "(- " + text + ")" : text;
}

/// (+ (* c x) ...), without the terms that are 0.
std::string sum(const std::vector<std::pair<Rational, std::string>>& terms) {
  std::string text;
  int count = 0;
  for (const auto& [factor, variable] : terms) {
    if (factor.is_zero()) continue;
    ++count;
    text += " ";
    if (variable.empty()) {
      text += constant(factor);
    } else if (factor == 1) {
      text += variable;
    } else {
      text += "(* " + constant(factor) + " " + variable + ")";
    }
  }
  if (count == 0) return "0.0";
  return count == 1 ? text.substr(1) : "(+" + text + ")";
}

std::string on_motion(const Wrench& row, const Rational& factor, const Rational& offset) {
  return sum({{factor * row.x, "dx"},
              {factor * row.y, "dy"},
              {factor * row.torque, "dr"},
              {offset, ""}});
}

std::string line(const std::string& condition) {
  return "(assert " + condition + ")\n";
}

}  // namespace

std::string smtlib_text(const Question& question) {
  const Problem problem = problem_of(question);
  std::string name = question.loaded().grasp.name();
  // What ends a line ends a comment, for some solvers also a carriage return.
  std::replace_if(
      name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; },
      ' ');
  std::string text =
      "; Passive stability of a planar grasp: sat means stable, unsat unstable.\n; " + name +
      "; normal law: " + to_string(question.law) +
      "\n(set-logic QF_LRA)\n"
      "(declare-const dx Real)\n(declare-const dy Real)\n(declare-const dr Real)\n";
  std::array<std::vector<std::pair<Rational, std::string>>, 3> balance;
  const Vector3 load = coordinates(problem.wrench());
  for (std::size_t j = 0; j < 3; ++j) balance[j].emplace_back(load[j], "");
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    const std::string a = "a_" + std::to_string(i);
    const std::string b = "b_" + std::to_string(i);
    text += "; contact " + std::to_string(i) + "\n(declare-const " + a +
            " Real)\n(declare-const " + b + " Real)\n";
    const Vector3 normal = coordinates(row.normal);
    const Vector3 tangent = coordinates(row.tangent);
    for (std::size_t j = 0; j < 3; ++j) {
      balance[j].emplace_back(normal[j], a);
      balance[j].emplace_back(tangent[j], b);
    }
    const std::string v = on_motion(row.normal, -row.stiffness, row.preload);
    const std::string closed = "(and (= " + a + " " + v + ") (>= " + a + " 0.0))";
    text += line(problem.law() == NormalLaw::kBilateral
                     ? closed
                     : "(or " + closed + " (and (= " + a + " 0.0) (<= " + v + " 0.0)))");
    const std::string edge = sum({{row.friction, a}});
    text += line("(and (<= " + b + " " + edge + ") (<= (- " + b + ") " + edge + "))");
    const std::string slip = on_motion(row.tangent, 1, 0);
    text += line("(or (= " + slip + " 0.0) (and (> " + slip + " 0.0) (= " + b + " (- " + edge +
                 "))) (and (< " + slip + " 0.0) (= " + b + " " + edge + ")))");
  }
  text += "; balance of force x, force y, torque\n";
  for (const auto& terms : balance) text += line("(= " + sum(terms) + " 0.0)");
  return text + "(check-sat)\n";
}

}  // namespace stickslip
