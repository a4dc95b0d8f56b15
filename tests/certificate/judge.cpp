// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge.hpp"

#include <map>
#include <nlohmann/json.hpp>

#include "check_refutation.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip::test {
namespace {

using Json = nlohmann::ordered_json;

struct NoOpinion {};

Rational number(const Json& value) {
  if (value.is_number_integer()) return Rational(value.dump());
  if (!value.is_string()) throw NoOpinion{};
  return parse_rational(value.get<std::string>());
}

Rational number_at(const Json& list, std::size_t i) {
  return number(list.at(i));
}

ContactId contact(const Json& value, std::size_t contacts) {
  const Rational index = number(value);
  // What lies beyond is as good as `contacts`.
  return ContactId(index < contacts ? index.convert_to<std::size_t>() : contacts);
}

CheckerAnswer rejected(const std::string& rule, std::optional<std::uint64_t> node = {}) {
  return {"rejected", rule, node, "", ""};
}

std::optional<CheckerAnswer> judge_question(const Question& question, const Json& stated) {
  if (number(stated.at("contacts")) != box_of(question.grasp).contacts.size()) {
    return rejected("question-contacts");
  }
  const Json& w = stated.at("wrench");
  const Wrench wrench{number_at(w, 0), number_at(w, 1), number_at(w, 2)};
  if (box_of(wrench) != wrench_of(question.grasp)) return rejected("question-wrench");
  std::optional<Rational> preload;
  if (stated.contains("preload")) preload = number(stated["preload"]);
  if (preload != question.preload) return rejected("question-preload");
  if (stated.at("normal_law") != to_string(question.law)) return rejected("question-law");
  return std::nullopt;
}

CheckerAnswer judge_witness(const Problem& problem, const Json& certificate) {
  const Json& d = certificate.at("twist");
  const Twist twist{number_at(d, 0), number_at(d, 1), number_at(d, 2)};
  std::map<std::size_t, Rational> shares;
  Rational above = -1;
  for (const Json& entry : certificate.at("shares")) {
    const Rational contact = number_at(entry, 0);
    const Rational share = number_at(entry, 1);
    if (contact <= above || contact >= problem.size() || abs(share) > 1) {
      return rejected("witness-share");
    }
    const auto i = contact.convert_to<std::size_t>();
    if (power(problem.rows()[i].tangent, twist) != 0) return rejected("witness-share");
    shares[i] = share;
    above = contact;
  }
  Wrench sum = problem.wrench();
  bool pressed = true;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    const Rational v = row.normal_coefficient(twist);
    pressed = pressed && v >= 0;
    if (v <= 0) continue;
    const Rational slip = power(row.tangent, twist);
    const Rational share = slip > 0 ? Rational(-1) : slip < 0 ? Rational(1) : shares[i];
    sum += v * row.normal + share * row.friction * v * row.tangent;
  }
  if (problem.law() == NormalLaw::kBilateral && !pressed) return rejected("witness-normal");
  if (!(sum == Wrench{})) return rejected("witness-balance");
  return {"accepted", "", {}, "", ""};
}

TreeNode node_of(const Json& node, std::size_t contacts) {
  const std::string kind = node.at(0).get<std::string>();
  if (kind == "slip") return SlipSplit{contact(node.at(1), contacts)};
  if (kind == "separation") return SeparationSplit{contact(node.at(1), contacts)};
  if (kind == "plane") {
    return PlaneCut{primitive_multiple(RationalRow{
        number_at(node, 1), number_at(node, 2), number_at(node, 3), number_at(node, 4), 0})};
  }
  // A positive multiple of y proves the same.
  return TwistLeaf{primitive_multiple(
      RationalRow{number_at(node, 1), number_at(node, 2), number_at(node, 3)})};
}

CheckerAnswer judge_tree(const Problem& problem, const Json& certificate) {
  Trees refutation;
  for (const Json& node : certificate.at("tree")) {
    refutation.push_back(node_of(node, problem.size()));
  }
  const std::optional<std::string> broken = check_refutation(problem, refutation);
  if (!broken) return {"accepted", "", {}, "", ""};
  // "node K: RULE"
  const std::size_t colon = broken->find(": ");
  const std::string rule = broken->substr(colon + 2);
  std::uint64_t node = std::stoull(broken->substr(5, colon - 5));
  // What the engines never produce, check_refutation refuses and the format allows.
  if (rule == "node-repeated" || rule == "node-law" || rule == "node-plane") throw NoOpinion{};
  // There K is the last node that was visited.
  if (rule == "tree-short") node = refutation.size();
  if (rule == "tree-long") ++node;
  return rejected(rule, node);
}

}  // namespace

std::optional<CheckerAnswer> third_opinion(const CheckerInput& input) {
  try {
    const Json certificate = Json::parse(input.certificate);
    const Question question = ask(parse_grasp(input.grasp, "grasp"), input.options);
    if (certificate.at("verdict") == "margin" || input.options.direction ||
        input.options.preload_direction) {
      throw NoOpinion{};
    }
    if (const auto answer = judge_question(question, certificate.at("question"))) return answer;
    if (input.options.uncertain.any()) return rejected("question-uncertain");
    const Problem problem = problem_of(question);
    return certificate.at("verdict") == "stable" ? judge_witness(problem, certificate)
                                                 : judge_tree(problem, certificate);
  } catch (const NoOpinion&) {
  } catch (const InputError&) {
  } catch (const NumberError&) {
  } catch (const Json::exception&) {
  }
  return std::nullopt;
}

}  // namespace stickslip::test
