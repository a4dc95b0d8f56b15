// SPDX-License-Identifier: MIT
/// \file
/// The rules of FORMAT.md §4 and §10 word by word, in rationals, without inheritance, rounding
/// or shortcuts: the twin that TreeWalk is compared with. And a prover that finds small
/// refutations.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "cone.hpp"
#include "question.hpp"
#include "support.hpp"
#include "tree.hpp"

namespace stickslip_check {

using Point = std::array<Rational, 4>;

inline Rational dot4(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

/// A generator (r, l) of FORMAT.md §10.
struct Lifted {
  Point r;
  Rational l;
};

/// About the loads wrench + lambda direction of a range; by default the one load `wrench`.
struct NaiveQuestion {
  std::vector<Row> rows;
  Vector3 wrench;
  bool bilateral = false;
  Vector3 direction{};
  LoadRange range{0, 0, true};

  Point v(std::size_t i) const {
    const Row& r = rows[i];
    return {Rational(-r.stiffness * r.normal[0]), Rational(-r.stiffness * r.normal[1]),
            Rational(-r.stiffness * r.normal[2]), r.preload};
  }
  Point tau(std::size_t i) const {
    const Row& r = rows[i];
    return {r.tangent[0], r.tangent[1], r.tangent[2], Rational(0)};
  }
};

struct NaiveRegion {
  const NaiveQuestion* question;
  Cone cone;
  std::vector<char> label;  // ' ', '+', '0', '-'
  std::vector<Point> strict;

  static NaiveRegion root(const NaiveQuestion& q) {
    NaiveRegion region{&q, Cone::half_space(), std::vector<char>(q.rows.size(), ' '), {}};
    region.strict.push_back({0, 0, 0, 1});
    for (std::size_t i = 0; q.bilateral && i < q.rows.size(); ++i) {
      region.cone = region.cone.cut(make_vector(q.v(i)), Side::kAtLeastZero);
    }
    return region;
  }

  NaiveRegion child(const Node& node, unsigned which) const {
    NaiveRegion result = *this;
    Point a;
    if (node.kind == NodeKind::kPlane) {
      for (std::size_t j = 0; j < 4; ++j) a[j] = node.numbers[j];
    } else {
      const std::size_t i = node.contact.get_ui();
      a = node.kind == NodeKind::kSlip ? question->tau(i) : question->v(i);
    }
    Side side = which == 0 ? Side::kAtLeastZero : Side::kAtMostZero;
    if (node.kind == NodeKind::kSlip) {
      result.label[node.contact.get_ui()] = "+0-"[which];
      if (which == 1) side = Side::kZero;
      if (which != 1) result.strict.push_back(a);
    } else if (which == 1) {
      result.strict.push_back(a);
    }
    result.cone = cone.cut(make_vector(a), side);
    return result;
  }

  std::vector<Point> rays() const {
    std::vector<Point> result;
    const auto add = [&](const Vector& x, int sign) {
      Point p;
      for (std::size_t j = 0; j < 4; ++j) p[j] = sign * Rational(x.x[j]);
      result.push_back(p);
    };
    for (const Vector& line : cone.lines()) {
      add(line, 1);
      add(line, -1);
    }
    for (const auto& ray : cone.rays()) add(ray->v, 1);
    return result;
  }

  bool barred(const std::vector<Point>& some) const {
    return std::any_of(strict.begin(), strict.end(), [&](const Point& s) {
      return std::all_of(some.begin(), some.end(),
                         [&](const Point& r) { return dot4(s, r) == 0; });
    });
  }

  std::vector<Lifted> lifted() const {
    const auto& [low, high, contains_low] = question->range;
    std::vector<Lifted> result;
    for (const Point& r : rays()) {
      result.push_back({r, Rational(low * r[3])});
      if (high && r[3] > 0) result.push_back({r, Rational(*high * r[3])});
    }
    if (!high) result.push_back({{0, 0, 0, 0}, 1});
    return result;
  }

  bool barred(const std::vector<Lifted>& some) const {
    std::vector<Point> points;
    for (const Lifted& x : some) points.push_back(x.r);
    if (barred(points)) return true;
    // p l + q h
    const auto zero_on_all = [&](int p, const Rational& q) {
      return std::all_of(some.begin(), some.end(),
                         [&](const Lifted& x) { return p * x.l + q * x.r[3] == 0; });
    };
    const auto& [low, high, contains_low] = question->range;
    if (!contains_low && zero_on_all(1, Rational(-low))) return true;
    return high && *high > low && zero_on_all(-1, *high);
  }

  bool void_holds() const { return barred(lifted()); }

  char sign(std::size_t i) const {
    if (label[i] != ' ') return label[i];
    const Point tau = question->tau(i);
    for (const int s : {1, -1}) {
      std::vector<Point> zero;
      bool good = true;
      for (const Point& r : rays()) {
        const Rational at = s * dot4(tau, r);
        good = good && at >= 0;
        if (at == 0) zero.push_back(r);
      }
      if (good && barred(zero)) return s > 0 ? '+' : '-';
    }
    return ' ';
  }

  bool leaf_holds(const Vector3& y, const std::vector<Rational>& theta) const {
    const std::vector<Lifted> all = lifted();
    if (barred(all)) return true;
    std::vector<Rational> g;
    for (const auto& [r, l] : all) {
      g.emplace_back(r[3] * dot(y, question->wrench) + l * dot(y, question->direction));
    }
    for (std::size_t i = 0; i < question->rows.size(); ++i) {
      const Row& row = question->rows[i];
      const Rational plus = dot(y, row.normal) - row.friction * dot(y, row.tangent);
      const Rational minus = dot(y, row.normal) + row.friction * dot(y, row.tangent);
      const char s = sign(i);
      const Rational alpha = s == '+' ? plus : (s == '-' ? minus : std::max(plus, minus));
      const Point v = question->v(i);
      const bool closed = std::all_of(all.begin(), all.end(),
                                      [&](const Lifted& x) { return dot4(v, x.r) >= 0; });
      const bool open = std::all_of(all.begin(), all.end(),
                                    [&](const Lifted& x) { return dot4(v, x.r) <= 0; });
      for (std::size_t k = 0; k < all.size(); ++k) {
        const Rational at = dot4(v, all[k].r);
        if (closed) {
          g[k] += alpha * at;
        } else if (open) {
          continue;
        } else if (alpha >= 0) {
          g[k] += alpha * std::max(Rational(0), at);
        } else {
          g[k] += alpha * theta[i] * at;
        }
      }
    }
    std::vector<Lifted> flat;
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (g[k] > 0) return false;
      if (g[k] == 0) flat.push_back(all[k]);
    }
    return barred(flat);
  }
};

/// Looks for a refutation with y among small integers. Returns false if it finds none.
class Prover {
 public:
  explicit Prover(const NaiveQuestion& question, std::size_t max_nodes = 300, int reach = 2)
      : question_(question), max_nodes_(max_nodes), reach_(reach) {}

  bool run() {
    nodes.clear();
    return prove(NaiveRegion::root(question_));
  }

  std::vector<std::string> nodes;

 private:
  bool prove(const NaiveRegion& region) {
    if (nodes.size() >= max_nodes_) return false;
    if (region.void_holds()) {
      nodes.emplace_back("[\"void\"]");
      return true;
    }
    for (int a = -reach_; a <= reach_; ++a) {
      for (int b = -reach_; b <= reach_; ++b) {
        for (int c = -reach_; c <= reach_; ++c) {
          for (const int t : {0, 1}) {
            const std::vector<Rational> theta(question_.rows.size(), Rational(t));
            if (!region.leaf_holds({Rational(a), Rational(b), Rational(c)}, theta)) continue;
            std::string text = "[\"leaf\", " + std::to_string(a) + ", " + std::to_string(b) +
                               ", " + std::to_string(c);
            if (t == 1) {
              for (std::size_t i = 0; i < theta.size(); ++i) {
                text += (i == 0 ? ", [[" : ", [") + std::to_string(i) + ", 1]";
              }
              text += "]";
            }
            nodes.push_back(text + "]");
            return true;
          }
        }
      }
    }
    for (const NodeKind kind : {NodeKind::kSlip, NodeKind::kSeparation}) {
      if (kind == NodeKind::kSeparation && question_.bilateral) continue;
      for (std::size_t i = 0; i < question_.rows.size(); ++i) {
        const Point f = kind == NodeKind::kSlip ? question_.tau(i) : question_.v(i);
        if (kind == NodeKind::kSlip && region.sign(i) != ' ') continue;
        if (kind == NodeKind::kSeparation && !crosses(region, f)) continue;
        Node node;
        node.kind = kind;
        node.contact = static_cast<unsigned long>(i);
        nodes.push_back((kind == NodeKind::kSlip ? "[\"slip\", " : "[\"separation\", ") +
                        std::to_string(i) + "]");
        for (unsigned k = 0; k < (kind == NodeKind::kSlip ? 3U : 2U); ++k) {
          if (!prove(region.child(node, k))) return false;
        }
        return true;
      }
    }
    return false;
  }

  static bool crosses(const NaiveRegion& region, const Point& f) {
    bool above = false;
    bool below = false;
    for (const Point& r : region.rays()) {
      above = above || dot4(f, r) > 0;
      below = below || dot4(f, r) < 0;
    }
    return above && below;
  }

  const NaiveQuestion& question_;
  std::size_t max_nodes_;
  int reach_;
};

/// The walk over the tree of a question.
inline TreeWalk walk_of(const NaiveQuestion& q) {
  return TreeWalk(q.rows, {q.wrench, q.direction, {q.range}}, q.bilateral);
}

/// The question that a grasp text asks.
inline NaiveQuestion naive_question(const std::string& grasp,
                                    const QuestionOptions& options = {}) {
  std::istringstream in(grasp);
  const Question question = read_question(in, "grasp", options);
  NaiveQuestion result;
  for (const GraspContact& contact : question.contacts) {
    result.rows.push_back(make_row(contact).value());
  }
  result.wrench = question.wrench;
  result.bilateral = question.bilateral;
  return result;
}

/// A small random contact: degenerate cases are frequent.
inline GraspContact random_contact(Random& random) {
  GraspContact contact;
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
