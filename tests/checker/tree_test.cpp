// SPDX-License-Identifier: MIT
// The walk against its naive twin, and the soundness of FORMAT.md §5 as a property.
#include "tree.hpp"

#include <gtest/gtest.h>

#include "naive.hpp"

namespace stickslip_check {
namespace {

NaiveQuestion random_question(Random& random, int max_contacts) {
  NaiveQuestion q;
  const int m = between(random, 0, max_contacts);
  for (int i = 0; i < m; ++i) q.rows.push_back(make_row(random_contact(random)).value());
  for (Rational& c : q.wrench) c = between(random, -3, 3);
  q.bilateral = between(random, 0, 3) == 0;
  if (between(random, 0, 1) == 0) return q;
  // A gap, with ends where a bound is often exactly 0.
  for (Rational& c : q.direction) c = between(random, -2, 2);
  q.range = {Rational(between(random, 0, 3)) / 2, std::nullopt, false};
  if (between(random, 0, 2) > 0)
    q.range.high = q.range.low + Rational(between(random, 1, 4)) / 2;
  q.range.contains_low = q.range.low == 0 && between(random, 0, 1) == 0;
  return q;
}

Node leaf(Random& random, const NaiveQuestion& q, std::vector<Rational>& theta) {
  Node node;
  node.kind = NodeKind::kLeaf;
  for (int j = 0; j < 3; ++j) node.numbers.emplace_back(between(random, -2, 2));
  theta.assign(q.rows.size(), 0);
  for (std::size_t i = 0; i < q.rows.size(); ++i) {
    if (between(random, 0, 2) != 0) continue;
    theta[i] = Rational(between(random, 0, 2)) / 2;
    node.thetas.emplace_back(static_cast<unsigned long>(i), theta[i]);
  }
  return node;
}

/// Some inner node that is allowed below `used` (slips, then separations).
bool random_split(Random& random, const NaiveQuestion& q, std::vector<bool>& used, Node& node) {
  const int m = static_cast<int>(q.rows.size());
  const int kind = between(random, 0, 4);
  if (kind == 0 || m == 0) {
    node.kind = NodeKind::kPlane;
    node.numbers.clear();
    for (int j = 0; j < 4; ++j) node.numbers.emplace_back(between(random, -1, 1));
    return std::any_of(node.numbers.begin(), node.numbers.end(),
                       [](const Rational& a) { return a != 0; });
  }
  const bool slip = kind <= 2 || q.bilateral;
  const int i = between(random, 0, m - 1);
  const auto slot = static_cast<std::size_t>(slip ? i : i + m);
  if (used[slot]) return false;
  used[slot] = true;
  node.kind = slip ? NodeKind::kSlip : NodeKind::kSeparation;
  node.contact = i;
  return true;
}

std::string rule_of(TreeWalk& walk, const Node& node) {
  try {
    walk.visit(node);
    return "";
  } catch (const Rejected& rejected) {
    return rejected.rule;
  }
}

/// Visits a random tree, asking for a random leaf or void wherever it ends.
class RandomTree {
 public:
  RandomTree(Random& random, const NaiveQuestion& q)
      : random_(random), q_(q), walk_(walk_of(q)), exact_(walk_of(q)) {
    exact_.use_exact_bounds_only();
    grow(NaiveRegion::root(q), std::vector<bool>(2 * q.rows.size()), 0);
    EXPECT_NO_THROW(walk_.finish());
  }

  std::size_t accepted = 0;
  std::size_t rejected = 0;

 private:
  void grow(const NaiveRegion& region, std::vector<bool> used, int depth) {
    Node node;
    if (depth < 6 && between(random_, 0, 5) != 0 && random_split(random_, q_, used, node)) {
      EXPECT_EQ(rule_of(walk_, node), "");
      EXPECT_EQ(rule_of(exact_, node), "");
      for (unsigned k = 0; k < (node.kind == NodeKind::kSlip ? 3U : 2U); ++k) {
        grow(region.child(node, k), used, depth + 1);
      }
      return;
    }
    node = Node{};
    bool holds = false;
    const char* rule = "void-region";
    if (between(random_, 0, 4) == 0) {
      holds = region.void_holds();
    } else {
      std::vector<Rational> theta;
      node = leaf(random_, q_, theta);
      holds = region.leaf_holds({node.numbers[0], node.numbers[1], node.numbers[2]}, theta);
      rule = "leaf-bound";
    }
    EXPECT_EQ(rule_of(walk_, node), holds ? "" : rule);
    EXPECT_EQ(rule_of(exact_, node), holds ? "" : rule);
    ++(holds ? accepted : rejected);
  }

  Random& random_;
  const NaiveQuestion& q_;
  TreeWalk walk_;
  TreeWalk exact_;
};

TEST(Tree, AgreesWithTheNaiveTwin) {
  Random random(4711);
  std::size_t accepted = 0;
  std::size_t rejected = 0;
  for (int trial = 0; trial < 800; ++trial) {
    const NaiveQuestion q = random_question(random, 4);
    const RandomTree tree(random, q);
    accepted += tree.accepted;
    rejected += tree.rejected;
  }
  EXPECT_GT(accepted, 500U);
  EXPECT_GT(rejected, 500U);
}

/// An equilibrium by construction: d and the forces first, then the wrench that they balance.
NaiveQuestion stable_question(Random& random, Vector3& d) {
  for (;;) {
    NaiveQuestion q = random_question(random, 4);
    for (Rational& c : d) c = Rational(between(random, -2, 2)) / 2;
    // Balanced under wrench + lambda direction, lambda among the loads.
    const auto& [low, high, contains_low] = q.range;
    Rational lambda =
        low + (high ? Rational((*high - low) / 3) : Rational(between(random, 1, 9)));
    if (contains_low && between(random, 0, 1) == 0) lambda = low;
    q.wrench = sum({0, 0, 0}, Rational(-lambda), q.direction);
    bool possible = true;
    for (const Row& row : q.rows) {
      Rational a = row.preload - row.stiffness * dot(row.normal, d);
      if (a < 0 && q.bilateral) possible = false;
      if (a < 0) a = 0;
      const Rational slip = dot(row.tangent, d);
      const int sigma = slip > 0 ? -2 : (slip < 0 ? 2 : between(random, -2, 2));
      const Rational b = row.friction * a * sigma / 2;
      for (std::size_t j = 0; j < 3; ++j) {
        q.wrench[j] -= a * row.normal[j] + b * row.tangent[j];
      }
    }
    if (possible) return q;
  }
}

// FORMAT.md §5: where the equilibrium is at home, no leaf and no void is ever accepted.
TEST(Tree, NothingRefutesTheHomeOfAnEquilibrium) {
  Random random(1953);
  std::size_t asked = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    Vector3 d;
    const NaiveQuestion q = stable_question(random, d);
    const Point x{d[0], d[1], d[2], Rational(1)};
    TreeWalk walk = walk_of(q);
    std::vector<bool> used(2 * q.rows.size());
    const int depth = between(random, 0, 8);
    for (int k = 0; k < depth; ++k) {
      Node node;
      if (!random_split(random, q, used, node)) continue;
      ASSERT_EQ(rule_of(walk, node), "");
      Point f;
      if (node.kind == NodeKind::kPlane) {
        for (std::size_t j = 0; j < 4; ++j) f[j] = node.numbers[j];
      } else {
        const std::size_t i = node.contact.get_ui();
        f = node.kind == NodeKind::kSlip ? q.tau(i) : q.v(i);
      }
      const Rational at = dot4(f, x);
      unsigned home = at < 0 ? 1 : 0;
      if (node.kind == NodeKind::kSlip) home = at > 0 ? 0 : (at == 0 ? 1 : 2);
      // Stand-ins for the siblings in front; whether they hold does not matter here.
      for (unsigned s = 0; s < home; ++s) rule_of(walk, Node{});
    }
    std::vector<Rational> theta;
    const bool ask_void = between(random, 0, 4) == 0;
    const Node last = ask_void ? Node{} : leaf(random, q, theta);
    ASSERT_EQ(rule_of(walk, last), ask_void ? "void-region" : "leaf-bound")
        << "trial " << trial;
    ++asked;
  }
  EXPECT_EQ(asked, 3000U);
}

TEST(Tree, RefutationsOfRandomGraspsAreAccepted) {
  Random random(2018);
  std::size_t proved = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const NaiveQuestion q = random_question(random, 3);
    Prover prover(q, 120, 1);
    if (!prover.run()) continue;
    ++proved;
    std::string w;
    for (const Rational& c : q.wrench) w += (w.empty() ? "" : ", ") + c.get_str();
    // The walk itself, since the grasp has no file: by way of a certificate's nodes.
    TreeWalk walk = walk_of(q);
    for (const std::string& text : prover.nodes) {
      Node node;
      const auto number = [&](std::size_t from) { return std::stoi(text.substr(from)); };
      if (text.find("slip") != std::string::npos) {
        node.kind = NodeKind::kSlip;
        node.contact = number(9);
      } else if (text.find("separation") != std::string::npos) {
        node.kind = NodeKind::kSeparation;
        node.contact = number(15);
      } else if (text.find("leaf") != std::string::npos) {
        node.kind = NodeKind::kLeaf;
        std::size_t at = text.find(',');
        for (int j = 0; j < 3; ++j) {
          node.numbers.emplace_back(number(at + 1));
          at = text.find(',', at + 1);
        }
        if (text.find("[[") != std::string::npos) {
          for (std::size_t i = 0; i < q.rows.size(); ++i) {
            node.thetas.emplace_back(static_cast<unsigned long>(i), Rational(1));
          }
        }
      }
      ASSERT_EQ(rule_of(walk, node), "") << text;
    }
    EXPECT_NO_THROW(walk.finish());
    EXPECT_EQ(walk.nodes(), prover.nodes.size());
  }
  EXPECT_GT(proved, 60U);
}

TEST(Tree, EachRangeHasItsTree) {
  // Without contacts nothing resists but the load 0, at lambda = 1.
  Node leaf;
  leaf.kind = NodeKind::kLeaf;
  const auto with = [&](int y) {
    leaf.numbers = {y, 0, 0};
    return leaf;
  };
  const LoadRange below{0, 1, true};
  const LoadRange above{1, std::nullopt, false};
  const Loads loads{{-1, 0, 0}, {1, 0, 0}, {below, above}};
  {
    TreeWalk walk({}, loads, false);
    EXPECT_EQ(rule_of(walk, with(1)), "");
    EXPECT_THROW(walk.finish(), Rejected);
    EXPECT_EQ(rule_of(walk, with(-1)), "");
    EXPECT_NO_THROW(walk.finish());
    EXPECT_EQ(walk.trees(), 2U);
    EXPECT_EQ(walk.nodes(), 2U);
    EXPECT_EQ(rule_of(walk, with(-1)), "tree-long");
  }
  for (const int y : {-1, 0}) {
    TreeWalk walk({}, loads, false);
    EXPECT_EQ(rule_of(walk, with(y)), "leaf-bound");
  }
  for (const int y : {1, 0}) {
    TreeWalk walk({}, loads, false);
    EXPECT_EQ(rule_of(walk, with(1)), "");
    EXPECT_EQ(rule_of(walk, with(y)), "leaf-bound");
  }
}

TEST(Tree, FewRaysNeedTheExactSum) {
  // Unit normals of long denominators, all contacts pushed apart by the wrench.
  std::vector<Row> rows;
  for (int k = 1; k <= 40; ++k) {
    GraspContact contact;
    const Rational t = Rational(k) / 101;
    const Rational norm = 1 + t * t;
    contact.normal = {Rational((1 - t * t) / norm), Rational(2 * t / norm)};
    contact.position = {Rational(-contact.normal[0]), Rational(-contact.normal[1])};
    contact.friction = Rational(1, 10);
    contact.stiffness = Rational(k + 1) / 7;
    rows.push_back(make_row(contact).value());
  }
  TreeWalk walk(rows, {{1, 0, 0}}, false);
  Node node;
  node.kind = NodeKind::kLeaf;
  node.numbers = {-1, 0, 0};
  EXPECT_EQ(rule_of(walk, node), "");
  // At the root, the lines have g = 0; the ray with h > 0 is settled by the rounded bound.
  EXPECT_LE(walk.exact_bounds(), 6U);
}

}  // namespace
}  // namespace stickslip_check
