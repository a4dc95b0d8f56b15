// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

std::string constant(const Rational& value) {
  const Integer num = abs(numerator(value));
  std::string text = num.str() + ".0";
  if (denominator(value) != 1) text = "(/ " + text + " " + denominator(value).str() + ".0)";
  return value.sign() < 0 ? "(- " + text + ")" : text;
}

using Terms = std::vector<std::pair<Rational, std::string>>;

/// Returns (+ (* c x) ...), without the terms that are 0.
std::string sum(const Terms& terms) {
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

std::string declared(const std::string& name) {
  return "(declare-const " + name + " Real)\n";
}

std::string head(const Question& question, const char* where, const char* logic) {
  std::string name = question.description().name;
  // A character that ends a line ends a comment, for some solvers also a carriage return.
  std::replace_if(
      name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; },
      ' ');
  return std::string("; Passive stability of a grasp ") + where +
         ": sat means stable, unsat unstable.\n; " + name +
         "; normal law: " + to_string(question.law) + "\n(set-logic " + logic + ")\n";
}

/// Returns the wrench of a unit of force along each axis at a point, by rows; the motion of the
/// point is its transpose times the twist.
std::vector<RationalRow> unit_wrenches(const RationalRow& p) {
  if (p.size() == 2) return {{1, 0, Rational(-p[1])}, {0, 1, p[0]}};
  return {{1, 0, 0, 0, p[2], Rational(-p[1])},
          {0, 1, 0, Rational(-p[2]), 0, p[0]},
          {0, 0, 1, p[1], Rational(-p[0]), 0}};
}

/// Returns the law of a normal force a; springs and preload press with v.
std::string normal_law(NormalLaw law, const std::string& a, const std::string& v) {
  const std::string closed = "(and (= " + a + " " + v + ") (>= " + a + " 0.0))";
  return line(law == NormalLaw::kBilateral
                  ? closed
                  : "(or " + closed + " (and (= " + a + " 0.0) (<= " + v + " 0.0)))");
}

std::string squares(const std::vector<std::string>& terms) {
  std::string text = "(+";
  for (const std::string& x : terms) text += " (* " + x + " " + x + ")";
  return text + ")";
}

/// Returns one grasp with Coulomb's cone as it is. A contact's forces are a n + f with f.n = 0,
/// the slip is s. The law of normals gives a, |f| <= mu a |n|, and if s is not 0, f is -t s of
/// that length.
std::string nonlinear_text(const Question& question, const GraspBox& grasp) {
  const bool in_space = grasp.in_space();
  std::string text = head(question, in_space ? "in space" : "in the plane", "QF_NRA");
  const std::vector<std::string> motions =
      in_space ? std::vector<std::string>{"dx", "dy", "dz", "rx", "ry", "rz"}
               : std::vector<std::string>{"dx", "dy", "dr"};
  std::vector<Terms> balance;
  for (const Interval& component : grasp.wrench) balance.push_back({{component.low, ""}});
  for (const std::string& motion : motions) text += declared(motion);
  for (std::size_t j = 0; j < grasp.max_motion.size(); ++j) {
    const Rational& most = grasp.max_motion[j];
    text += line("(<= " + constant(-most) + " " + motions[j] + " " + constant(most) + ")");
  }
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const UncertainContact& c = grasp.contacts[i];
    const std::string id = "_" + std::to_string(i);
    const std::string a = "a" + id;
    text += "; contact " + std::to_string(i) + "\n" + declared(a);
    RationalRow position;
    for (const Interval& coordinate : c.position) position.push_back(coordinate.low);
    const std::vector<RationalRow> axes = unit_wrenches(position);
    Rational square = 0;
    for (const Rational& n : c.normal) square += n * n;
    Terms pressing;  // P/|n| - k/|n|^2 n.(motion of the point)
    const Rational& preload = c.preload.low;
    if (const std::optional<Rational> length = exact_sqrt(square)) {
      pressing.emplace_back(preload / *length, "");
    } else if (!preload.is_zero()) {
      const std::string root = "length" + id;
      text += declared(root) + line("(and (> " + root + " 0.0) (= (* " + root + " " + root +
                                    ") " + constant(square) + "))");
      pressing.emplace_back(preload / square, root);
    }
    RationalRow normal(motions.size());
    for (std::size_t k = 0; k < axes.size(); ++k) {
      for (std::size_t j = 0; j < motions.size(); ++j) normal[j] += c.normal[k] * axes[k][j];
    }
    for (std::size_t j = 0; j < motions.size(); ++j) {
      pressing.emplace_back(-c.stiffness.low / square * normal[j], motions[j]);
      balance[j].emplace_back(normal[j], a);
    }
    text += normal_law(question.law, a, sum(pressing));
    if (c.friction.low.is_zero()) continue;
    std::vector<std::string> friction;
    Terms across;
    std::string still;
    std::string against;
    const std::string strength = "t" + id;
    text += declared(strength);
    for (std::size_t k = 0; k < axes.size(); ++k) {
      friction.push_back(std::string("f") + "xyz"[k] + id);
      text += declared(friction.back());
      across.emplace_back(c.normal[k], friction.back());
      Terms slip;
      for (std::size_t j = 0; j < motions.size(); ++j) {
        balance[j].emplace_back(axes[k][j], friction.back());
        slip.emplace_back(axes[k][j] - c.normal[k] / square * normal[j], motions[j]);
      }
      const std::string s = sum(slip);
      still += " (= " + s + " 0.0)";
      against += " (= " + friction.back() + " (- (* " + strength + " " + s + ")))";
    }
    const std::string size = squares(friction);
    const Rational slope = c.friction.low * c.friction.low * square;
    const std::string most = "(* " + constant(slope) + " " + a + " " + a + ")";
    text += line("(= " + sum(across) + " 0.0)") + line("(<= " + size + " " + most + ")");
    text += line("(or (and" + still + ") (and (>= " + strength + " 0.0) (= " + size + " " +
                 most + ")" + against + "))");
  }
  text += "; balance of forces, then of torques\n";
  for (const Terms& terms : balance) text += line("(= " + sum(terms) + " 0.0)");
  return text + "(check-sat)\n";
}

}  // namespace

std::string smtlib_text(const Question& question) {
  if (const GraspBox* box = question.box()) {
    if (box->is_point()) return nonlinear_text(question, *box);
    throw InputError("", "", "some numbers of the grasp are intervals",
                     "export writes one grasp; `stickslip decide` decides all in the box");
  }
  const Problem problem = problem_of(question);
  std::string text = head(question, "in the plane", "QF_LRA");
  for (const char* motion : {"dx", "dy", "dr"}) text += declared(motion);
  std::array<Terms, 3> balance;
  const Vector3 load = coordinates(problem.wrench());
  for (std::size_t j = 0; j < 3; ++j) balance[j].emplace_back(load[j], "");
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    const std::string a = "a_" + std::to_string(i);
    const std::string b = "b_" + std::to_string(i);
    text += "; contact " + std::to_string(i) + "\n" + declared(a) + declared(b);
    const Vector3 normal = coordinates(row.normal);
    const Vector3 tangent = coordinates(row.tangent);
    for (std::size_t j = 0; j < 3; ++j) {
      balance[j].emplace_back(normal[j], a);
      balance[j].emplace_back(tangent[j], b);
    }
    text += normal_law(problem.law(), a, on_motion(row.normal, -row.stiffness, row.preload));
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
