// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_signs.hpp"

#include <algorithm>
#include <vector>

#include "stickslip/core/error.hpp"
#include "stickslip/core/outline.hpp"

namespace stickslip::warnings_detail {
namespace {

RationalRow middles(const std::vector<Interval>& numbers) {
  RationalRow row;
  for (const Interval& x : numbers) row.push_back(x.middle());
  return row;
}

RationalRow row_of(const Vector2& v) {
  return {v.x, v.y};
}

Rational cross2(const RationalRow& a, const RationalRow& b) {
  return a[0] * b[1] - a[1] * b[0];
}

bool is_on(const OutlineEdge& edge, const RationalRow& p) {
  const auto between = [](const Rational& a, const Rational& b, const Rational& x) {
    return std::min(a, b) <= x && x <= std::max(a, b);
  };
  return between(edge.from.x, edge.to.x, p[0]) && between(edge.from.y, edge.to.y, p[1]) &&
         dot(row_of(edge.inwards), p) == dot(row_of(edge.inwards), row_of(edge.from));
}

/// Returns true if the opposite of `force` can press a body at a place with these normals, of
/// one edge or of two that meet; false between more edges.
bool presses_when_reversed(const std::vector<RationalRow>& normals, RationalRow force) {
  for (Rational& entry : force) entry = -entry;
  if (normals.size() == 1) return dot(normals[0], force).sign() > 0;
  if (normals.size() != 2) return false;
  const int turn = cross2(normals[0], normals[1]).sign();
  if (turn == 0) return dot(normals[0], normals[1]).sign() > 0 && dot(normals[0], force) > 0;
  return cross2(normals[0], force).sign() * turn >= 0 &&
         cross2(force, normals[1]).sign() * turn >= 0;
}

class ContactSigns {
 public:
  explicit ContactSigns(const GraspBox& grasp)
      : grasp_(grasp), mechanism_(*grasp.mechanism), points_(mechanism_.bodies.size()) {
    for (std::size_t b = 0; b < points_.size(); ++b) {
      const Body& body = mechanism_.bodies[b];
      edges_.push_back(outline_edges(body.outline));
      for (const Polygon& polygon : body.outline) {
        for (const Vector2& v : polygon.front()) points_[b].push_back(row_of(v));
      }
      if (body.mesh) {
        for (const Vector3& v : body.mesh->vertices)
          points_[b].emplace_back(v.begin(), v.end());
      }
      points_[b].insert(points_[b].end(), body.weights.begin(), body.weights.end());
      if (!body.link || body.link->slides) continue;
      points_[b].push_back(body.link->at);
      if (body.link->on) points_[*body.link->on].push_back(body.link->at);
    }
    for (const UncertainContact& c : grasp.contacts) {
      for (const BodyIndex body : {c.of, c.by}) {
        if (body) points_[*body].push_back(middles(c.position));
      }
    }
  }

  bool is_reversed(const UncertainContact& c) const {
    if (leaves_outline(c.of, c, 1) || leaves_outline(c.by, c, -1)) return true;
    if (!is_on_wrong_side(c.of, c, 1)) return false;
    return c.by ? is_on_wrong_side(c.by, c, -1) : is_off_ground(c);
  }

 private:
  /// Returns true if p is on the outline of `body`, and only the opposite of sign n can press
  /// it there. Requires that sign n is the direction in which the contact pushes the body.
  bool leaves_outline(BodyIndex body, const UncertainContact& c, int sign) const {
    if (!body || edges_[*body].empty()) return false;
    std::vector<RationalRow> normals;
    const RationalRow p = middles(c.position);
    for (const std::vector<OutlineEdge>& polygon : edges_[*body]) {
      for (const OutlineEdge& edge : polygon) {
        if (is_on(edge, p)) normals.push_back(row_of(edge.inwards));
      }
    }
    RationalRow force = c.normal;
    for (Rational& entry : force) entry *= sign;
    return presses_when_reversed(normals, std::move(force));
  }

  /// Returns true if some known points of `body` are behind the contact, against sign n, and
  /// none are in front.
  bool is_on_wrong_side(BodyIndex body, const UncertainContact& c, int sign) const {
    const RationalRow here = middles(c.position);
    const Rational square = dot(c.normal, c.normal);
    bool any = false;
    for (RationalRow x : points_[*body]) {
      for (std::size_t j = 0; j < x.size(); ++j) x[j] -= here[j];
      const Rational side = dot(c.normal, x);
      // Rounded numbers put x on the plane.
      if (kFlatness * kFlatness * side * side <= square * dot(x, x)) continue;
      if (sign * side.sign() > 0) return false;
      any = true;
    }
    return any;
  }

  /// Returns true if every contact of the body with the ground on whose wrong side it is pushes
  /// it where its load pulls. Requires a contact by the ground with its body on the wrong side.
  bool is_off_ground(const UncertainContact& c) const {
    if (mechanism_.bodies[*c.of].link) return false;
    const std::size_t first = mechanism_.first_coordinate(*c.of);
    RationalRow pull;
    for (std::size_t j = 0; j < c.normal.size(); ++j) {
      pull.push_back(grasp_.wrench[first + j].middle());
    }
    return std::all_of(
        grasp_.contacts.begin(), grasp_.contacts.end(), [&](const UncertainContact& other) {
          return other.of != c.of || other.by || dot(other.normal, pull).sign() > 0 ||
                 !is_on_wrong_side(other.of, other, 1);
        });
  }

  const GraspBox& grasp_;
  const Mechanism& mechanism_;
  std::vector<std::vector<RationalRow>> points_;  ///< the known points of each body
  std::vector<std::vector<std::vector<OutlineEdge>>> edges_;
};

}  // namespace

std::optional<std::string> reversed_contacts(const GraspBox& grasp) {
  const ContactSigns signs(grasp);
  std::vector<std::size_t> reversed;
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    if (signs.is_reversed(grasp.contacts[i])) reversed.push_back(i);
  }
  if (reversed.empty()) return std::nullopt;
  const UncertainContact& c = grasp.contacts[reversed.front()];
  const auto place = [](std::size_t i) { return "contacts[" + std::to_string(i) + "]"; };
  const std::string of = quote(grasp.mechanism->name_of(c.of));
  const std::string by = c.by ? quote(grasp.mechanism->name_of(c.by)) : "the ground";
  std::string text = place(reversed.front()) + " would pull " + of + " and " + by +
                     " apart: its normal points away from " + of + ", which it presses, to " +
                     by + "; " + (c.by ? R"(swap "of" and "by", or )" : "") +
                     "turn the normal round";
  constexpr std::size_t kMostNamed = 8;
  for (std::size_t k = 1; k < std::min(reversed.size(), kMostNamed); ++k) {
    text += (k == 1 ? "; the same of " : ", ") + place(reversed[k]);
  }
  return text + (reversed.size() > kMostNamed ? ", ..." : "");
}

}  // namespace stickslip::warnings_detail
