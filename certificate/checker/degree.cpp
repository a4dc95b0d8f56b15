// SPDX-License-Identifier: MIT
#include "degree.hpp"

#include <algorithm>
#include <utility>

namespace stickslip_check {
namespace {

/// Whether the determinant is 0: by elimination.
bool singular(std::vector<Vector> m) {
  for (std::size_t j = 0; j < m.size(); ++j) {
    const auto pivot = std::find_if(m.begin() + static_cast<std::ptrdiff_t>(j), m.end(),
                                    [&](const Vector& row) { return row[j] != 0; });
    if (pivot == m.end()) return true;
    std::swap(*pivot, m[j]);
    for (std::size_t i = j + 1; i < m.size(); ++i) {
      const Rational factor = m[i][j] / m[j][j];
      for (std::size_t k = j; k < m.size(); ++k) m[i][k] -= factor * m[j][k];
    }
  }
  return false;
}

/// Of points, row.(d - c) + more z, where K is {|E_j.(d - c)| <= z}. For a multiple l of h = 1,
/// c is on the way from twist to end_twist, and z = 1; without an end c = h twist + (l / low -
/// h) end_twist, and z = l / low.
Vector about(const Part& part, const Range& range, const Vector& row, int more = 0) {
  const Rational begin = dot(row, part.twist);
  const Rational way = dot(row, part.end_twist) - begin;
  Vector a = row;
  if (!range.high) {
    a.emplace_back(way);
    a.emplace_back((more - begin - way) / range.low);
    return a;
  }
  const Rational rate = way == 0 ? Rational(0) : Rational(way / (*range.high - range.low));
  a.emplace_back(more - begin + range.low * rate);
  a.emplace_back(-rate);
  return a;
}

/// The multiples of a range; h may be 0 where there is no end.
std::vector<Condition> multiples_in(const Range& range, std::size_t dimension) {
  std::vector<Condition> conditions = conditions_of(range, dimension);
  if (range.high) return conditions;
  conditions[0].strict = false;
  Vector multiple(dimension + 2);
  multiple.back() = 1;
  conditions.push_back({std::move(multiple), false, true});
  return conditions;
}

/// The cone over K and these multiples, or over the wall E_j.(d - c) = sign z of K.
std::vector<Condition> conditions_on(const Part& part, const Range& range,
                                     std::vector<Condition> conditions, std::size_t wall,
                                     int sign) {
  for (std::size_t k = 0; k < part.walls.size(); ++k) {
    if (k == wall) {
      conditions.push_back({about(part, range, part.walls[k], -sign), true});
      continue;
    }
    Vector below = about(part, range, part.walls[k], -1);
    for (Rational& c : below) c = -c;
    conditions.push_back({about(part, range, part.walls[k], 1)});
    conditions.push_back({std::move(below)});
  }
  return conditions;
}

/// `degree-law`: the contact whose v_i may be below 0 in K, or nothing.
std::optional<std::size_t> opening(const Part& part, const Box& box, const Range& range) {
  const std::size_t no_wall = box.dimension();
  Cone cone(box.dimension() + 2);
  const auto multiples = multiples_in(range, box.dimension());
  for (const Condition& condition : conditions_on(part, range, multiples, no_wall, 0)) {
    cone = cone.cut(make_form(condition.a), condition.equality);
  }
  for (std::size_t i = 0; i < box.size(); ++i) {
    for (const Form& v : box.row(i).v) {
      for (const auto& ray : cone.rays()) {
        if (sign_of_dot(v, ray->x) < 0) return i;
      }
    }
  }
  return std::nullopt;
}

}  // namespace

TreeWalk check_degree(const Part& part, const std::shared_ptr<const Box>& box,
                      const Range& range, bool bilateral, const std::string& place) {
  const auto require = [&](bool good, const char* rule, const std::string& found) {
    if (!good) throw Rejected{rule, std::nullopt, place, found};
  };
  require(!singular(part.walls), "degree-walls", "det E = 0");
  require(!singular(part.direction), "degree-direction", "det A = 0");
  if (bilateral) {
    const auto i = opening(part, *box, range);
    require(
        !i, "degree-law",
        "v of contact " + std::to_string(i.value_or(0)) + " may be below 0 at a vertex of K");
  }
  std::vector<Vector> direction;
  for (const Vector& row : part.direction) direction.push_back(about(part, range, row));
  const auto middle = std::make_shared<const Box>(box->middle());
  const Rational middle_multiple =
      range.high ? Rational((range.low + *range.high) / 2) : Rational(2 * range.low);
  std::vector<Root> roots;
  for (const bool second : {false, true}) {
    if (!second && box->certain() && range.high == range.low) continue;
    const auto multiples = multiples_in(
        second ? Range{middle_multiple, middle_multiple} : range, box->dimension());
    for (std::size_t j = 0; j < box->dimension(); ++j) {
      for (const int sign : {1, -1}) {
        roots.push_back({second ? middle : box, conditions_on(part, range, multiples, j, sign),
                         false,
                         place + (second ? ", middle wall " : ", wall ") +
                             std::to_string(j + 1) + (sign > 0 ? " +" : " -"),
                         second ? direction : std::vector<Vector>{}});
      }
    }
  }
  TreeWalk walk(std::move(roots), place);
  for (const Node& node : part.tree) walk.visit(node);
  walk.finish();
  return walk;
}

PartWalk::PartWalk(bool bilateral, const std::shared_ptr<const Box>& box)
    : bilateral_(bilateral), awaited_{{box, "", 0}} {}

void PartWalk::visit(const Part& part) {
  std::string place = "part " + std::to_string(parts_++);
  if (awaited_.empty()) {
    throw Rejected{"tree-long", std::nullopt, place, "everything was complete before this"};
  }
  const Awaited here = std::move(awaited_.back());
  awaited_.pop_back();
  place += here.path;
  if (here.depth > most_depth(*here.box)) {
    throw Rejected{"node-depth", std::nullopt, place,
                   "more than " + std::to_string(most_depth(*here.box)) + " parts above this"};
  }
  if (!part.cut) {
    const TreeWalk walk = check_degree(part, here.box, {0, 0}, bilateral_, place);
    ++proofs_;
    nodes_ += walk.nodes();
    leaves_ += walk.leaves();
    return;
  }
  try {
    Halves halves = cut_in_two(*here.box, part.by);
    const std::string path = here.path + ", ";
    awaited_.push_back({halves.high, path + half_name(part.by, true), here.depth + 1});
    awaited_.push_back({halves.low, path + half_name(part.by, false), here.depth + 1});
  } catch (const Rejected& rejected) {
    throw Rejected{rejected.rule, std::nullopt, place, rejected.found};
  }
}

void PartWalk::finish() const {
  if (awaited_.empty()) return;
  throw Rejected{"tree-short", std::nullopt,
                 "part " + std::to_string(parts_) + awaited_.back().path,
                 "the list ends before this part"};
}

}  // namespace stickslip_check
