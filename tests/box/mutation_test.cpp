// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates of boxes that the program wrote, made wrong: all checkers reject each alike, by
// a rule that names what is wrong with it.
#include <gtest/gtest.h>

#include <set>

#include "box_cases.hpp"
#include "json_edit.hpp"
#include "stickslip/box/radius.hpp"

namespace stickslip {
namespace {

using test::BoxCase;
using test::CheckerAnswer;
using test::CheckerInput;
using test::input_of;
using test::Json;
using test::json_of;
using Rules = std::set<std::string>;

/// What was done, and the rules that name it: one, unless what fails first is a matter of
/// numbers. With no rules: accepted.
struct Mutant {
  std::string kind;
  CheckerInput input;
  Rules rules;
};

QuestionOptions options_of(const char* uncertain, NormalLaw law = NormalLaw::kUnilateral) {
  QuestionOptions options;
  options.law = law;
  if (*uncertain != '\0') options.uncertain = parse_tolerances(uncertain);
  return options;
}

/// Each side of a square is pressed upon, at places and with forces that differ.
LoadedGrasp square(const Wrench& wrench, const Rational& friction = Rational(1, 2)) {
  return {Grasp({{{-1, Rational(1, 4)}, {1, 0}, friction, 1, 2},
                 {{1, 0}, {-1, 0}, friction, 2, 2},
                 {{Rational(1, 8), -1}, {0, 1}, friction, 1, 2},
                 {{0, 1}, {0, -1}, friction, 1, 2}}),
          wrench};
}

/// A gripper that holds a weight of 3 by friction, with preloads of 8 in all.
LoadedGrasp jaw() {
  const Rational half(1, 2);
  return {Grasp({{{-1, -half}, {1, 0}, half, 1, 2},
                 {{-1, half}, {1, 0}, half, 1, 2},
                 {{1, -half}, {-1, 0}, half, 1, 2},
                 {{1, half}, {-1, 0}, half, 1, 2}}),
          {0, -3, 0}};
}

/// A block that is pushed aside by 2 and down by 1: unstable where friction is below 2.
std::string sliding_block(const Rational& friction) {
  return write_grasp({Grasp({{{0, 0}, {0, 1}, friction, 1, 0}}), {2, -1, 0}});
}

CheckerInput proved(const std::string& grasp, const QuestionOptions& options,
                    const std::string& verdict) {
  const BoxCase about{grasp, options};
  const BoxDecision decision = about.decide();
  if (name_of(decision.verdict) != verdict) {
    throw std::runtime_error(std::string(name_of(decision.verdict)) + ", not " + verdict);
  }
  return input_of(grasp, options, decision);
}

CheckerInput with(CheckerInput input, const Json& certificate) {
  input.certificate = certificate.dump();
  return input;
}

/// The end of the tree that begins at this node.
std::size_t end_of_tree(const Json& nodes, std::size_t first) {
  const std::string kind = nodes[first][0];
  const int children = kind == "leaf" ? 0 : kind == "slip" ? 3 : 2;
  std::size_t next = first + 1;
  for (int child = 0; child < children; ++child) next = end_of_tree(nodes, next);
  return next;
}

/// The nodes of a proof by degree, by walls of list 1 and list 2.
std::vector<Json> trees_of(const Json& nodes) {
  std::vector<Json> trees;
  for (std::size_t first = 0; first < nodes.size();) {
    const std::size_t end = end_of_tree(nodes, first);
    Json tree = Json::array();
    for (; first < end; ++first) tree.push_back(nodes[first]);
    trees.push_back(std::move(tree));
  }
  return trees;
}

Json joined(const std::vector<Json>& trees) {
  Json nodes = Json::array();
  for (const Json& tree : trees) {
    for (const Json& node : tree) nodes.push_back(node);
  }
  return nodes;
}

/// Numbers of a matrix, or of a vector, times a factor.
Json times(Json values, const Rational& factor) {
  for (Json& value : values) {
    value = value.is_array() ? times(value, factor) : json_of(factor * test::number_of(value));
  }
  return values;
}

/// The motion by which K must be moved along its first direction to lie beside itself: E d is
/// (2, 0, 0).
Vector3 one_width(const Json& walls) {
  const auto at = [&](std::size_t row, std::size_t column) {
    return test::number_of(walls[row][column]);
  };
  const Vector3 across{at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1),
                       at(1, 2) * at(2, 0) - at(1, 0) * at(2, 2),
                       at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0)};
  const Rational determinant =
      at(0, 0) * across[0] + at(0, 1) * across[1] + at(0, 2) * across[2];
  Vector3 result;
  for (std::size_t j = 0; j < 3; ++j) result[j] = 2 * across[j] / determinant;
  return result;
}

/// Of a proof by degree without cuts.
void mutate_degree(const std::string& name, const CheckerInput& original,
                   std::vector<Mutant>& mutants) {
  const Json certificate = Json::parse(original.certificate);
  ASSERT_EQ(certificate["parts"].size(), 1u) << name;
  const Json& part = certificate["parts"][0];
  const auto add = [&](const std::string& kind, const Json& edited, Rules rules) {
    Json all = certificate;
    all["parts"][0] = edited;
    mutants.push_back({kind + " of " + name, with(original, all), std::move(rules)});
  };
  const auto set = [&](const char* key, const Json& value) {
    Json edited = part;
    edited[key] = value;
    return edited;
  };
  const Rules bound{"leaf-bound", "leaf-direction"};
  add("nothing", part, {});
  const Vector3 width = one_width(part["walls"]);
  Json twist = part["twist"];
  for (std::size_t j = 0; j < 3; ++j) twist[j] = json_of(test::number_of(twist[j]) + width[j]);
  add("move d0 by one width", set("twist", twist), bound);
  add("turn the direction over", set("direction", times(part["direction"], -1)),
      {"leaf-direction"});
  const std::vector<Json> trees = trees_of(part["tree"]);
  ASSERT_EQ(trees.size(), 12u) << name;
  for (std::size_t wall = 0; wall < trees.size(); ++wall) {
    std::vector<Json> fewer = trees;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(wall));
    // Before the list is found short, the next tree may fail on this wall.
    add("drop a wall", set("tree", joined(fewer)),
        wall == 11 ? Rules{"tree-short"}
                   : Rules{"tree-short", "leaf-bound", "leaf-direction", "node-certain",
                           "part-inside"});
  }
  std::vector<Json> more = trees;
  more.push_back(trees.back());
  add("a wall too many", set("tree", joined(more)), {"tree-long"});
  std::vector<Json> swapped(trees.begin() + 6, trees.end());
  swapped.insert(swapped.end(), trees.begin(), trees.begin() + 6);
  add("swap the lists", set("tree", joined(swapped)), {"leaf-bound", "node-certain"});
}

/// A certificate about a box said of another one, in which the claim is false.
void widen(std::vector<Mutant>& mutants) {
  // The block holds from a friction of 2 on; so up to 2 it is fragile.
  const Rational tiny(1, 1000000000000);
  const auto up_to = [](const Rational& high) {
    GraspBox box = box_of(parse_grasp(sliding_block(1), "block").loaded());
    box.contacts[0].friction = {0, high};
    return test::file_of(box);
  };
  CheckerInput tight = proved(up_to(2 - tiny), {}, "unstable");
  mutants.push_back({"a tight box", tight, {}});
  for (const Rational& high : {Rational(2), Rational(2 + tiny)}) {
    tight.grasp = up_to(high);
    mutants.push_back({"a tight box, wider", tight, {"leaf-bound"}});
  }
  // Proved for one radius, said of one for which a counterexample is known.
  // The jaw is at rest; the other one slips, and more friction breaks it.
  const Rational less(2, 5);
  const LoadedGrasp slips{Grasp({{{-2, -1}, {1, 0}, less, 1, 1},
                                 {{-2, -1}, {0, 1}, less, 1, 1},
                                 {{2, -2}, {-1, 0}, less, 1, 1}}),
                          {-2, 2, -2}};
  for (const LoadedGrasp& centre : {jaw(), slips}) {
    const char* tolerances = "friction=10%,stiffness=10%";
    const GraspBox point = box_of(centre);
    const GraspBox box = point.widened(parse_tolerances(tolerances));
    const Radius radius = find_radius(point, box, NormalLaw::kUnilateral, {});
    ASSERT_TRUE(radius.proof && radius.refuted) << tolerances;
    CheckerInput input =
        input_of(test::file_of(box.scaled(point, radius.proved)), {}, *radius.proof);
    mutants.push_back({"proved radius", input, {}});
    input.grasp = test::file_of(box.scaled(point, *radius.refuted));
    mutants.push_back({"a refuted radius",
                       input,
                       {"leaf-bound", "leaf-direction", "rest-cone", "rest-reach"}});
  }
}

TEST(BoxMutations, EachIsRejectedAlikeAndByItsRule) {
  std::vector<Mutant> mutants;
  widen(mutants);
  const struct {
    const char* name;
    const char* uncertain;
    NormalLaw law;
  } squares[] = {{"friction", "friction=10%", NormalLaw::kUnilateral},
                 {"everything",
                  "friction=5%,stiffness=5%,preload=5%,position=0.005,normal=0.005,wrench=5%",
                  NormalLaw::kUnilateral},
                 {"bilateral", "friction=10%,preload=5%", NormalLaw::kBilateral}};
  for (const auto& [name, uncertain, law] : squares) {
    const CheckerInput original = proved(write_grasp(square({Rational(5, 2), 1, 1})),
                                         options_of(uncertain, law), "stable");
    mutate_degree(name, original, mutants);
    if (law != NormalLaw::kBilateral) continue;
    Json wide = Json::parse(original.certificate);
    wide["parts"][0]["walls"] = times(wide["parts"][0]["walls"], Rational(1, 10000));
    mutants.push_back({"K where contacts open", with(original, wide), {"degree-law"}});
  }
  // There is so little friction that the object moves with the load, and for some leaves a
  // small K. (Where friction takes up all changes, a K of any size serves.)
  const CheckerInput slippery =
      proved(write_grasp(square({Rational(3, 2), Rational(1, 2), 0}, Rational(1, 100))),
             options_of("wrench=10%"), "stable");
  mutate_degree("little friction", slippery, mutants);
  Json small = Json::parse(slippery.certificate);
  small["parts"][0]["walls"] = times(small["parts"][0]["walls"], 1000);
  mutants.push_back({"shrink K", with(slippery, small), {"leaf-bound"}});
  std::vector<CheckerInput> inputs;
  for (const Mutant& mutant : mutants) inputs.push_back(mutant.input);
  const std::vector<CheckerAnswer> python = test::ask_python_checker(inputs);
  std::vector<CheckerAnswer> answers;
  for (std::size_t i = 0; i < mutants.size(); ++i) {
    const Mutant& mutant = mutants[i];
    const CheckerAnswer cpp = answers.emplace_back(ask_cpp_checker(mutant.input));
    EXPECT_TRUE(cpp.agrees_with(python[i]))
        << mutant.kind << "\nC++: " << describe(cpp) << "\nPython: " << describe(python[i]);
    if (mutant.rules.empty()) {
      EXPECT_EQ(cpp.result, "accepted") << mutant.kind << ": " << describe(cpp);
    } else {
      EXPECT_EQ(mutant.rules.count(cpp.rule), 1u) << mutant.kind << ": " << describe(cpp);
    }
  }
  test::expect_js_checker_agrees(inputs, answers);
  test::expect_proved_checker_agrees(inputs, answers);
}

}  // namespace
}  // namespace stickslip
