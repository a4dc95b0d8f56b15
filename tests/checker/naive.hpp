// SPDX-License-Identifier: MIT
/// \file
/// The rules of FORMAT.md §4 word by word, in rationals, without rounding or sets of
/// conditions: the twin that TreeWalk is compared with.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "cone.hpp"
#include "question.hpp"
#include "support.hpp"
#include "tree.hpp"

namespace stickslip_check {

constexpr std::size_t kN = kPlanar + 2;

/// FORMAT.md §1, of a contact without uncertainty; of what is none, T is 0.
struct NaiveRow {
  Vector normal;   ///< N
  Vector tangent;  ///< T
  Rational friction;
  Vector v;
  bool slips = true;
  bool spring = false;

  NaiveRow() = default;
  explicit NaiveRow(const ContactBox& c) : friction(c[Parameter::kFriction].low) {
    const Rational& px = c[Parameter::kX].low;
    const Rational& py = c[Parameter::kY].low;
    const Vector& n = c.normal;
    normal = {n[0], n[1], Rational(px * n[1] - py * n[0])};
    tangent = {Rational(-n[1]), n[0], Rational(px * n[0] + py * n[1])};
    for (const Rational& entry : normal) v.emplace_back(-c[Parameter::kStiffness].low * entry);
    v.insert(v.end(), {c[Parameter::kPreload].low, c.growth.low});
  }
};

struct NaiveQuestion {
  explicit NaiveQuestion(Question asked, Range of = {0, 0})
      : question(std::move(asked)), range(std::move(of)) {
    for (std::size_t i = 0; i < question.box->size(); ++i) {
      rows.emplace_back(question.box->contact(i));
    }
    wrench = question.box->load.lowest();
  }

  NaiveQuestion(Question asked, Range of, std::vector<NaiveRow> naive)
      : question(std::move(asked)), range(std::move(of)), rows(std::move(naive)) {
    wrench = question.box->load.lowest();
  }

  Question question;
  Range range;
  std::vector<NaiveRow> rows;
  Vector wrench;

  std::size_t size() const { return rows.size(); }
  std::size_t n() const { return wrench.size() + 2; }
  Vector v(std::size_t i) const { return rows[i].v; }
  Vector tau(std::size_t i) const {
    Vector tau = rows[i].tangent;
    tau.resize(n());
    return tau;
  }
  Rational power(const Vector& y, const Vector& x) const {
    return x[n() - 2] * dot(y, wrench) + x[n() - 1] * dot(y, question.growth);
  }
};

struct NaiveRegion {
  const NaiveQuestion* q;
  Cone cone;
  std::vector<Vector> strict;

  static NaiveRegion root(const NaiveQuestion& q) {
    NaiveRegion region{&q, Cone(q.n()), {}};
    const auto cut = [&](const Vector& a, bool strictly) {
      region.cone = region.cone.cut(make_form(a));
      if (strictly) region.strict.push_back(a);
    };
    const auto of_h_and_l = [&](const Rational& h, const Rational& l) {
      Vector a(q.n());
      a[q.n() - 2] = h;
      a[q.n() - 1] = l;
      return a;
    };
    cut(of_h_and_l(1, 0), true);
    cut(of_h_and_l(-q.range.low, 1), q.range.open_low);
    if (q.range.high) cut(of_h_and_l(*q.range.high, -1), q.range.open_high);
    for (std::size_t i = 0; q.question.asked.bilateral && i < q.size(); ++i) {
      if (!q.rows[i].spring) cut(q.v(i), false);
    }
    return region;
  }

  NaiveRegion child(const Node& node, unsigned which) const {
    Vector a = node.numbers;
    const bool slip = node.kind == NodeKind::kSlip;
    if (node.kind != NodeKind::kPlane) {
      const std::size_t i = node.contact.get_ui();
      a = slip ? q->tau(i) : q->v(i);
    }
    NaiveRegion result = *this;
    const bool middle = slip && which == 1;
    if (slip ? !middle : which == 1) result.strict.push_back(a);
    const Form form = make_form(a);
    result.cone = cone.cut(which == 0 || middle ? form : negative(form), middle);
    return result;
  }

  std::vector<Vector> rays() const {
    std::vector<Vector> result;
    for (const Form& line : cone.lines()) {
      const Form other = negative(line);
      result.emplace_back(line.begin(), line.end());
      result.emplace_back(other.begin(), other.end());
    }
    for (const auto& ray : cone.rays()) result.emplace_back(ray->x.begin(), ray->x.end());
    return result;
  }

  bool barred(const std::vector<Vector>& some) const {
    return std::any_of(strict.begin(), strict.end(), [&](const Vector& s) {
      return std::all_of(some.begin(), some.end(),
                         [&](const Vector& r) { return dot(s, r) == 0; });
    });
  }

  char sign(std::size_t i) const {
    const Vector tau = q->tau(i);
    for (const int s : {1, -1}) {
      std::vector<Vector> zero;
      bool good = true;
      for (const Vector& r : rays()) {
        const Rational at = s * dot(tau, r);
        good = good && at >= 0;
        if (at == 0) zero.push_back(r);
      }
      if (good && barred(zero)) return s > 0 ? '+' : '-';
    }
    return ' ';
  }

  bool leaf_holds(const Vector& y) const {
    const std::vector<Vector> all = rays();
    if (barred(all)) return true;
    std::vector<Rational> g;
    for (const Vector& r : all) g.push_back(q->power(y, r));
    for (std::size_t i = 0; i < q->size(); ++i) {
      const NaiveRow& row = q->rows[i];
      const Rational plus = dot(y, row.normal) - row.friction * dot(y, row.tangent);
      const Rational minus = dot(y, row.normal) + row.friction * dot(y, row.tangent);
      const char s = sign(i);
      const Rational alpha = s == '+' ? plus : (s == '-' ? minus : std::max(plus, minus));
      const bool closed =
          row.spring || std::all_of(all.begin(), all.end(),
                                    [&](const Vector& r) { return dot(row.v, r) >= 0; });
      for (std::size_t k = 0; k < all.size(); ++k) {
        const Rational at = dot(row.v, all[k]);
        const Rational zero = 0;
        g[k] += closed ? Rational(alpha * at)
                       : Rational(std::max(zero, alpha) * std::max(zero, at));
      }
    }
    std::vector<Vector> flat;
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (g[k] > 0) return false;
      if (g[k] == 0) flat.push_back(all[k]);
    }
    return barred(flat);
  }
};

/// The walk over the tree of a question, which must outlive it.
inline TreeWalk walk_of(const NaiveQuestion& q) {
  return TreeWalk(roots_of(q.question, {q.range}));
}

inline Node random_leaf(Random& random, std::size_t dimension) {
  Node node;
  for (std::size_t j = 0; j < dimension; ++j) node.numbers.emplace_back(between(random, -2, 2));
  if (between(random, 0, 4) == 0) node.numbers.assign(dimension, 0);
  return node;
}

inline Node random_split(Random& random, const NaiveQuestion& q) {
  const int m = static_cast<int>(q.size());
  const int kind = between(random, 0, 4);
  Node node;
  if (kind == 0 || m == 0) {
    node.kind = NodeKind::kPlane;
    for (std::size_t j = 0; j < q.n(); ++j) node.numbers.emplace_back(between(random, -1, 1));
    return node;
  }
  node.kind = kind <= 2 ? NodeKind::kSlip : NodeKind::kSeparation;
  node.contact = between(random, 0, m - 1);
  const NaiveRow& row = q.rows[node.contact.get_ui()];
  if (node.kind == NodeKind::kSlip ? !row.slips : row.spring) return random_split(random, q);
  return node;
}

inline std::string rule_of(TreeWalk& walk, const Node& node) {
  try {
    walk.visit(node);
    return "";
  } catch (const Rejected& rejected) {
    return rejected.rule;
  }
}

/// Visits a random tree, asking for a random leaf wherever it ends.
class RandomTree {
 public:
  RandomTree(Random& random, const NaiveQuestion& q)
      : random_(random), q_(q), walk_(walk_of(q)) {
    grow(NaiveRegion::root(q), 0);
    EXPECT_NO_THROW(walk_.finish());
  }

  std::size_t accepted = 0;
  std::size_t rejected = 0;

 private:
  void grow(const NaiveRegion& region, int depth) {
    if (depth < 6 && between(random_, 0, 5) != 0) {
      const Node node = random_split(random_, q_);
      EXPECT_EQ(rule_of(walk_, node), "");
      for (unsigned k = 0; k < (node.kind == NodeKind::kSlip ? 3U : 2U); ++k) {
        grow(region.child(node, k), depth + 1);
      }
      return;
    }
    const Node node = random_leaf(random_, q_.n() - 2);
    const bool holds = region.leaf_holds(node.numbers);
    EXPECT_EQ(rule_of(walk_, node), holds ? "" : "leaf-bound");
    ++(holds ? accepted : rejected);
  }

  Random& random_;
  const NaiveQuestion& q_;
  TreeWalk walk_;
};

/// A small random contact: degenerate cases are frequent.
inline Contact random_contact(Random& random) {
  Contact contact;
  contact.position = {Rational(between(random, -2, 2)), Rational(between(random, -2, 2))};
  constexpr int kNormals[][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {3, 4}, {-4, 3}, {2, 0}};
  const int* n = kNormals[between(random, 0, 6)];
  contact.normal = {Rational(n[0]), Rational(n[1])};
  contact.friction = Rational(between(random, 0, 3), 2);
  contact.stiffness = between(random, 1, 2);
  contact.preload = between(random, 0, 2);
  return contact;
}

}  // namespace stickslip_check
