// SPDX-License-Identifier: MIT
// Every rule of FORMAT.md, made to fail alone, with its name, node and path.
#include <gtest/gtest.h>

#include "support.hpp"

namespace stickslip_check {
namespace {

/// One contact at the origin, mu = 1/2, k = 1, P = 0: N = (1,0,0), T = (0,1,0), v = -x, tau =
/// y.
std::string single(const std::string& wrench, const std::string& normal = "[1, 0]",
                   const std::string& preload = "0", const std::string& extra = "") {
  return R"({"format": "stickslip-grasp/1", "contacts": [{"position": [0, 0], "normal": )" +
         normal + R"(, "friction": "1/2", "preload": )" + preload + "}], \"wrench\": [" +
         wrench + "]" + extra + "}";
}

const std::string kHead = header(1, "1, 0, 0");
const std::string kGrasp = single("1, 0, 0");  // pulled away from its only contact
const std::string kLeaf = "[\"leaf\", -1, 0, 0]";

void expect_rule(const Answer& answer, const std::string& rule) {
  EXPECT_EQ(outcome(answer), rule) << explain(answer);
}

void expect_node(const Answer& answer, const std::string& rule, std::uint64_t node,
                 const std::string& path) {
  ASSERT_EQ(outcome(answer), rule) << explain(answer);
  const auto& rejected = std::get<Rejected>(answer);
  EXPECT_EQ(rejected.node, node);
  EXPECT_EQ(rejected.path, path);
  EXPECT_FALSE(rejected.found.empty());
}

Answer tree(const std::vector<std::string>& nodes) {
  return ask(kGrasp, refutation(kHead, nodes));
}

TEST(Rules, TheBaseIsAccepted) {
  const Answer answer = tree({kLeaf});
  ASSERT_EQ(outcome(answer), "accepted") << explain(answer);
  const auto& a = std::get<Accepted>(answer);
  EXPECT_EQ(a.contacts, 1U);
  EXPECT_EQ(a.wrench[0], "1");
  EXPECT_FALSE(a.preload);
  EXPECT_EQ(a.normal_law, "unilateral");
  EXPECT_EQ(a.nodes, 1U);
  EXPECT_EQ(a.leaves, 1U);
  EXPECT_EQ(a.voids, 0U);
}

TEST(Rules, QuestionContacts) {
  expect_rule(ask(kGrasp, refutation(header(2, "1, 0, 0"), {kLeaf})), "question-contacts");
  expect_rule(ask(kGrasp, replaced(refutation(kHead, {kLeaf}), "\"contacts\": 1",
                                   "\"contacts\": 99999999999999999999999999")),
              "question-contacts");
}

TEST(Rules, QuestionWrench) {
  expect_rule(ask(kGrasp, refutation(header(1, "2, 0, 0"), {kLeaf})), "question-wrench");
  expect_rule(ask(kGrasp, refutation(header(1, "\"2/2\", 0, \"-0\""), {kLeaf})), "accepted");
  QuestionOptions options;
  options.wrench = Vector3{2, 0, 0};
  expect_rule(ask(kGrasp, refutation(kHead, {kLeaf}), options), "question-wrench");
  expect_rule(ask(kGrasp, refutation(header(1, "2, 0, 0"), {kLeaf}), options), "accepted");
}

TEST(Rules, QuestionPreload) {
  const std::string with =
      replaced(refutation(kHead, {kLeaf}), "\"normal_law\"", "\"preload\": 0, \"normal_law\"");
  // The value is that of the file, but nobody replaced it.
  expect_rule(ask(kGrasp, with), "question-preload");
  QuestionOptions options;
  options.preload = Rational(0);
  expect_rule(ask(kGrasp, with, options), "accepted");
  expect_rule(ask(kGrasp, refutation(kHead, {kLeaf}), options), "question-preload");
  options.preload = Rational(1);
  expect_rule(ask(kGrasp, with, options), "question-preload");
}

TEST(Rules, QuestionLaw) {
  QuestionOptions options;
  options.bilateral = true;
  expect_rule(ask(kGrasp, refutation(kHead, {kLeaf}), options), "question-law");
  expect_rule(ask(kGrasp, refutation(header(1, "1, 0, 0", "bilateral"), {kLeaf})),
              "question-law");
  expect_rule(ask(kGrasp, refutation(header(1, "1, 0, 0", "bilateral"), {kLeaf}), options),
              "accepted");
}

TEST(Rules, QuestionNormals) {
  const std::string wrench = "1, 0, 0";
  const std::string near = "\"20/29\", \"21/29\"";  // 0.0244 from (1,1)/sqrt 2
  const auto with = [&](const std::string& normals) {
    return refutation(header(1, wrench, "unilateral", normals), {kLeaf});
  };
  const std::string snap = R"(, "normals": {"snap": 0.025})";
  const std::string grasp = single(wrench, "[1, 1]", "0", snap);
  expect_rule(ask(grasp, with("[[0, " + near + "]]")), "accepted");
  expect_rule(ask(grasp, with("[]")), "accepted");
  expect_rule(ask(single(wrench, "[1, 1]"), with("[[0, " + near + "]]")), "question-normals");
  expect_rule(ask(single(wrench, "[1, 1]"), with("[]")), "question-normals");
  expect_rule(ask(single(wrench, "[1, 1]", "0", R"(, "normals": {"snap": 0.024})"),
                  with("[[0, " + near + "]]")),
              "question-normals");
  expect_rule(
      ask(single(wrench, "[1, 1]", "0", R"(, "normals": "snap")"), with("[[0, " + near + "]]")),
      "question-normals");
  expect_rule(ask(grasp, with("[[0, \"20/29\", \"20/29\"]]")), "question-normals");
  expect_rule(ask(grasp, with("[[0, \"-20/29\", \"-21/29\"]]")), "question-normals");
  expect_rule(ask(grasp, with("[[1, " + near + "]]")), "question-normals");
  expect_rule(ask(grasp, with("[[0, " + near + "], [0, " + near + "]]")), "question-normals");
  // A normal of rational length is not to be moved.
  expect_rule(ask(single(wrench, "[20, 21]", "0", snap), with("[[0, " + near + "]]")),
              "question-normals");
  QuestionOptions options;
  options.snap_tolerance = Rational(1, 40);
  const Answer answer =
      ask(single(wrench, "[1, 1]", "1"), with("[[0, " + near + "]]"), options);
  ASSERT_EQ(outcome(answer), "accepted") << explain(answer);
  EXPECT_EQ(std::get<Accepted>(answer).snapped, 1U);
  EXPECT_EQ(std::get<Accepted>(answer).snapped_by, "2.44e-2");
  // What must be snapped and is not leaves no question.
  expect_rule(ask(single(wrench, "[1, 1]", "1"), with("[]"), options), "malformed");
  expect_rule(ask(single(wrench, "[1, 1]", "1"), refutation(kHead, {kLeaf})), "malformed");
}

TEST(Rules, WitnessOnRest) {
  const std::string grasp = fig1("1", "0, 0, 0");
  const std::string head = header(3, "0, 0, 0");
  const auto with = [&](const std::string& twist, const std::string& forces) {
    return ask(grasp, witness(head, twist, forces));
  };
  expect_rule(with("0, 0, 0", "[1, \"-1/2\"], [1, 0], [1, \"1/2\"]"), "accepted");
  expect_rule(with("0, 0, 0", "[1, \"-1/2\"], [1, 0]"), "witness-count");
  expect_rule(with("0, 0, 0", "[1, \"-1/2\"], [1, 0], [1, \"1/2\"], [0, 0]"), "witness-count");
  expect_rule(with("0, 0, 0", ""), "witness-count");
  expect_rule(with("0, 0, 0", "[1, \"-1/2\"], [1, 0], [1, \"1/3\"]"), "witness-balance");
  // Balanced, but not what the springs give.
  expect_rule(with("0, 0, 0", "[2, \"-1/2\"], [1, 0], [2, \"1/2\"]"), "witness-normal");
  expect_rule(with("0, 0, 0", "[0, 0], [0, 0], [0, 0]"), "witness-normal");
}

TEST(Rules, WitnessConeAndDissipation) {
  // Fig. 4 has forces in balance with themselves: tangential (1, -1, -1, 1) b.
  const auto with = [&](const std::string& twist, const std::string& forces) {
    return ask(fig4("1", "0, 0, 0"), witness(header(4, "0, 0, 0"), twist, forces));
  };
  expect_rule(with("0, 0, 0", "[1, \"1/2\"], [1, \"-1/2\"], [1, \"-1/2\"], [1, \"1/2\"]"),
              "accepted");
  expect_rule(with("0, 0, 0", "[1, 1], [1, -1], [1, -1], [1, 1]"), "witness-cone");
  // Moving along y with all friction 0: not the most dissipation.
  expect_rule(with("0, 1, 0", "[1, 0], [1, 0], [1, 0], [1, 0]"), "witness-dissipation");
  // Moving up under a wrench up, friction on the side that pushes along.
  expect_rule(ask(fig4("1", "0, 2, 0"),
                  witness(header(4, "0, 2, 0"), "0, -1, 0",
                          "[1, \"-1/2\"], [1, \"-1/2\"], [1, \"1/2\"], [1, \"1/2\"]")),
              "witness-dissipation");
}

TEST(Rules, WitnessNormalUnderBothLaws) {
  // d = (0, 2, 0) opens contact 1: allowed only under the unilateral law.
  const std::string forces = "[1, \"-1/2\"], [0, 0], [1, \"1/2\"]";
  expect_rule(ask(fig1("1", "0, 1, 0"), witness(header(3, "0, 1, 0"), "0, 2, 0", forces)),
              "accepted");
  QuestionOptions options;
  options.bilateral = true;
  const std::string head = header(3, "0, 1, 0", "bilateral");
  expect_rule(ask(fig1("1", "0, 1, 0"), witness(head, "0, 2, 0", forces), options),
              "witness-normal");
  expect_rule(ask(fig1("1", "0, 1, 0"), witness(head, "0, 1, 0", forces), options), "accepted");
}

TEST(Rules, NodeContact) {
  expect_node(tree({"[\"slip\", 1]", kLeaf, kLeaf, kLeaf}), "node-contact", 0, "root");
  expect_node(tree({"[\"separation\", 0]", "[\"slip\", 18446744073709551616]"}), "node-contact",
              1, "separation 0 closed");
}

TEST(Rules, NodeRepeated) {
  expect_node(tree({"[\"slip\", 0]", "[\"slip\", 0]"}), "node-repeated", 1, "slip 0 +");
  expect_node(
      tree({"[\"slip\", 0]", kLeaf, "[\"separation\", 0]", kLeaf, "[\"separation\", 0]"}),
      "node-repeated", 4, "slip 0 0, separation 0 open");
  // On different paths both are allowed.
  expect_rule(tree({"[\"separation\", 0]", "[\"slip\", 0]", kLeaf, kLeaf, kLeaf,
                    "[\"slip\", 0]", kLeaf, kLeaf, kLeaf}),
              "accepted");
  std::vector<std::string> planes(65, "[\"plane\", 0, 0, 0, 1]");
  const Answer answer = tree(planes);
  ASSERT_EQ(outcome(answer), "node-repeated");
  EXPECT_EQ(std::get<Rejected>(answer).node, 64U);
  planes.pop_back();
  planes.push_back(kLeaf);
  for (int i = 0; i < 64; ++i) planes.emplace_back("[\"void\"]");
  expect_rule(tree(planes), "accepted");
}

TEST(Rules, NodePlane) {
  expect_node(tree({"[\"plane\", 1, 0, 0, 0]", "[\"plane\", 0, \"0/7\", \"-0\", 0]"}),
              "node-plane", 1, "plane +");
}

TEST(Rules, NodeLaw) {
  QuestionOptions options;
  options.bilateral = true;
  expect_node(ask(kGrasp,
                  refutation(header(1, "1, 0, 0", "bilateral"),
                             {"[\"slip\", 0]", kLeaf, kLeaf, "[\"separation\", 0]"}),
                  options),
              "node-law", 3, "slip 0 -");
}

TEST(Rules, TreeShort) {
  expect_node(tree({}), "tree-short", 0, "root");
  expect_node(tree({"[\"slip\", 0]", kLeaf, kLeaf}), "tree-short", 3, "slip 0 -");
  expect_node(tree({"[\"separation\", 0]", "[\"slip\", 0]"}), "tree-short", 2,
              "separation 0 closed, slip 0 +");
}

TEST(Rules, TreeLong) {
  expect_node(tree({kLeaf, kLeaf}), "tree-long", 1, "");
  expect_node(tree({"[\"separation\", 0]", kLeaf, kLeaf, "[\"void\"]"}), "tree-long", 3, "");
}

TEST(Rules, LeafBound) {
  expect_node(tree({"[\"leaf\", 1, 0, 0]"}), "leaf-bound", 0, "root");
  // g = 0 everywhere.
  expect_node(tree({"[\"leaf\", 0, 0, 0]"}), "leaf-bound", 0, "root");
  // alpha is -1 - 1/2 where the contact slips up; with y = (-1, 4, 0) it is -1 + 2 where it
  // sticks.
  expect_rule(tree({"[\"slip\", 0]", "[\"leaf\", -1, 1, 0]", kLeaf, kLeaf}), "accepted");
  expect_node(tree({"[\"slip\", 0]", kLeaf, "[\"separation\", 0]", "[\"leaf\", -1, 4, 0]"}),
              "leaf-bound", 3, "slip 0 0, separation 0 closed");
}

TEST(Rules, LeafBoundOnHome) {
  // Pushed onto its contact: stable. No y refutes any part that holds the equilibrium (-1, 0,
  // 0).
  const std::string head = header(1, "-1, 0, 0");
  for (const char* y : {"1, 0, 0", "-1, 0, 0", "0, 1, 0", "1, 1, 1", "0, 0, 1"}) {
    const std::string leaf = std::string("[\"leaf\", ") + y + "]";
    expect_rule(ask(single("-1, 0, 0"), refutation(head, {leaf})), "leaf-bound");
  }
}

TEST(Rules, LeafTheta) {
  const auto leaf = [](const std::string& list) {
    return "[\"leaf\", -1, 0, 0, " + list + "]";
  };
  expect_rule(tree({leaf("[]")}), "accepted");
  expect_rule(tree({leaf("[[0, 0]]")}), "accepted");
  expect_node(tree({leaf("[[1, 0]]")}), "leaf-theta", 0, "root");
  expect_node(tree({leaf("[[0, 0], [0, 0]]")}), "leaf-theta", 0, "root");
  expect_node(tree({leaf("[[0, -1]]")}), "leaf-theta", 0, "root");
  expect_node(tree({leaf("[[0, \"3/2\"]]")}), "leaf-theta", 0, "root");
  // Even where theta has no effect, and even where nothing is left to refute.
  expect_node(tree({"[\"separation\", 0]", kLeaf, leaf("[[0, 2]]")}), "leaf-theta", 2,
              "separation 0 open");
  expect_node(tree({"[\"plane\", 0, 0, 0, 1]", kLeaf, leaf("[[0, 2]]")}), "leaf-theta", 2,
              "plane -");
  // With theta > 0 the bound is linear: g = -h + theta x is positive on the line of x.
  expect_node(tree({leaf("[[0, \"1/2\"]]")}), "leaf-bound", 0, "root");
  // There theta is needed: pushed by (-1,0,0), cut to v <= h/2.
  expect_rule(
      ask(single("-1, 0, 0"),
          refutation(header(1, "-1, 0, 0"), {"[\"plane\", -2, 0, 0, -1]", "[\"leaf\", 1, 0, 0]",
                                             "[\"leaf\", 1, 0, 0]"})),
      "leaf-bound");
}

TEST(Rules, VoidRegion) {
  expect_node(tree({"[\"void\"]"}), "void-region", 0, "root");
  expect_rule(tree({"[\"plane\", 0, 0, 0, 1]", kLeaf, "[\"void\"]"}), "accepted");
  expect_node(tree({"[\"plane\", 0, 0, 0, 1]", "[\"void\"]"}), "void-region", 1, "plane +");
  // The second child of a plane seen twice is covered by the first.
  expect_rule(
      tree({"[\"plane\", 1, 0, 0, 0]", "[\"plane\", 1, 0, 0, 0]", kLeaf, "[\"void\"]", kLeaf}),
      "accepted");
  // Below the second child of a plane, its function is strict: the plane itself is void.
  expect_rule(
      tree({"[\"plane\", 1, 0, 0, 0]", kLeaf, "[\"plane\", 1, 0, 0, 0]", "[\"void\"]", kLeaf}),
      "accepted");
  // Not so below the first.
  expect_node(tree({"[\"plane\", 1, 0, 0, 0]", "[\"plane\", -1, 0, 0, 0]", "[\"void\"]"}),
              "void-region", 2, "plane +, plane +");
}

TEST(Rules, VoidChildrenOfSlip) {
  // On the plane tau = 0 the + and - children are covered by 0, and 0 by nothing.
  const std::vector<std::string> start{"[\"plane\", 0, 1, 0, 0]", "[\"plane\", 0, -1, 0, 0]"};
  const auto with = [&](const std::vector<std::string>& rest) {
    std::vector<std::string> nodes = start;
    nodes.insert(nodes.end(), rest.begin(), rest.end());
    return tree(nodes);
  };
  expect_rule(with({"[\"slip\", 0]", "[\"void\"]", kLeaf, "[\"void\"]", kLeaf, kLeaf}),
              "accepted");
  expect_node(with({"[\"slip\", 0]", "[\"void\"]", "[\"void\"]"}), "void-region", 4,
              "plane +, plane +, slip 0 0");
  // A strict function is inherited: below the child + of the slip, the plane again is void.
  expect_rule(
      tree({"[\"slip\", 0]", "[\"plane\", 0, -1, 0, 0]", "[\"void\"]", kLeaf, kLeaf, kLeaf}),
      "accepted");
}

TEST(Rules, TheFirstRuleInOrderIsReported) {
  expect_rule(ask(kGrasp, refutation(header(2, "2, 0, 0", "bilateral", "[]"), {})),
              "question-contacts");
  expect_node(tree({"[\"slip\", 0]", "[\"void\"]", "[\"leaf\", 1, 0, 0]", "[\"slip\", 7]"}),
              "void-region", 1, "slip 0 +");
}

}  // namespace
}  // namespace stickslip_check
