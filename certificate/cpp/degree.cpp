// SPDX-License-Identifier: MIT
#include "degree.hpp"

#include <algorithm>
#include <utility>

namespace stickslip_check {
namespace {

/// A basis of the vectors that have the product 0 with every row: by elimination.
std::vector<Vector> kernel(std::vector<Vector> rows) {
  const std::size_t columns = rows[0].size();
  std::vector<Vector> basis;
  std::vector<std::size_t> pivots;  // column pivots[k] is 1 in row k, and else 0
  for (std::size_t j = 0; j < columns; ++j) {
    const std::size_t rank = pivots.size();
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rank),
                                    rows.end(), [&](const Vector& row) { return row[j] != 0; });
    if (pivot == rows.end()) continue;
    std::swap(*pivot, rows[rank]);
    const Rational inverse = 1 / rows[rank][j];
    for (Rational& c : rows[rank]) c *= inverse;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (k != rank) add(rows[k], Rational(-rows[k][j]), rows[rank]);
    }
    pivots.push_back(j);
  }
  for (std::size_t j = 0; j < columns; ++j) {
    if (std::find(pivots.begin(), pivots.end(), j) != pivots.end()) continue;
    basis.emplace_back(columns);
    basis.back()[j] = 1;
    for (std::size_t k = 0; k < pivots.size(); ++k) basis.back()[pivots[k]] = -rows[k][j];
  }
  return basis;
}

/// A basis of Z.
std::vector<Vector> free_motions(const Part& part) {
  return part.walls.empty() ? kernel({Vector(part.twist.size())}) : kernel(part.walls);
}

std::vector<Vector> transposed(const std::vector<Vector>& rows) {
  std::vector<Vector> result(rows[0].size());
  for (const Vector& row : rows) {
    for (std::size_t j = 0; j < row.size(); ++j) result[j].push_back(row[j]);
  }
  return result;
}

/// `degree-free`: what knows of the motion z, or nothing.
std::string what_sees(const Vector& z, const Box& box) {
  const Form motion = make_form(z);
  const auto sees = [&](const Form& row) { return sign_of_dot(row, motion) != 0; };
  const auto any = [&](const std::vector<Form>& rows) {
    return std::any_of(rows.begin(), rows.end(), sees);
  };
  for (std::size_t i = 0; i < box.size(); ++i) {
    const Row& row = box.row(i);
    if (any(row.normals)) return "contact " + std::to_string(i) + " presses";
    if (box.contact(i)[Parameter::kFriction].high > 0 &&
        std::any_of(row.slips.begin(), row.slips.end(), any)) {
      return "contact " + std::to_string(i) + " has friction";
    }
  }
  bool works = !(box.load.work(z) == Bounds(0));
  for (const Vector& growth : box.growths) works = works || dot(growth, z) != 0;
  return works ? "the load works" : "";
}

void require(bool good, const char* rule, const std::string& place, const std::string& found) {
  if (!good) throw Rejected{rule, std::nullopt, place, found};
}

/// `degree-walls`.
void check_walls(const Part& part, const std::string& place) {
  if (part.walls.empty()) return;
  // The c with sum c_j E_j = 0.
  const std::vector<Vector> dependent = kernel(transposed(part.walls));
  require(
      dependent.size() == (part.simplex ? 1 : 0), "degree-walls", place,
      part.simplex ? "E has not one row more than its rank" : "the rows of E are dependent");
  for (const Vector& c : dependent) {
    const auto same = [&](const Rational& x) { return sgn(x) != 0 && sgn(x) == sgn(c[0]); };
    require(std::all_of(c.begin(), c.end(), same), "degree-walls", place,
            "the rows of E are not on all sides, as c = " + show(c));
  }
}

/// `degree-free`, `degree-direction`.
void check_free(const Part& part, const Box& box, const std::string& place) {
  const std::vector<Vector> free = free_motions(part);
  for (const Vector& z : free) {
    const std::string seen = what_sees(z, box);
    require(seen.empty(), "degree-free", place, seen + " along " + show(z));
  }
  for (const std::vector<Vector>& matrix : {part.direction, transposed(part.direction)}) {
    require(kernel(matrix).size() == free.size(), "degree-direction", place,
            "the rank of A is not " + std::to_string(box.dimension() - free.size()));
    for (const Vector& z : free) {
      const auto zero = [&](const Vector& row) { return dot(row, z) == 0; };
      require(std::all_of(matrix.begin(), matrix.end(), zero), "degree-direction", place,
              "A takes or gives the free motion " + show(z));
    }
  }
}

/// C of the rows E, by columns: C_k is a sum of multiples of them, and E_i.C_k is 1 if i = k,
/// else 0. Where they are independent: by elimination of (E; Z) C = (1; 0).
std::vector<Vector> duals(std::vector<Vector> rows) {
  const std::size_t rank = rows.size();
  const std::size_t dimension = rows[0].size();
  for (Vector& z : kernel(rows)) rows.push_back(std::move(z));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].resize(dimension + rank);
    if (i < rank) rows[i][dimension + i] = -1;
  }
  std::vector<Vector> columns = kernel(std::move(rows));
  for (Vector& column : columns) column.resize(dimension);
  return columns;
}

/// Of K across the free motions: the least and the largest e_j of all its points, at s + t = 1.
std::vector<Bounds> reach_of(const Part& part) {
  const std::size_t dimension = part.twist.size();
  std::vector<Bounds> reach(dimension, Bounds(0));
  if (part.walls.empty()) return reach;
  if (!part.simplex) {
    for (const Vector& column : duals(part.walls)) {
      for (std::size_t j = 0; j < dimension; ++j) {
        reach[j] = {reach[j].low - abs(column[j]), reach[j].high + abs(column[j])};
      }
    }
    return reach;
  }
  // Without wall k, at the vertex across from it E_k.e = 1 - (sum c) / c_k.
  const Vector c = kernel(transposed(part.walls))[0];
  const std::vector<Vector> columns = duals({part.walls.begin(), part.walls.end() - 1});
  Rational all;
  for (const Rational& each : c) all += each;
  for (std::size_t k = 0; k < part.walls.size(); ++k) {
    Vector vertex(dimension);
    for (const Vector& column : columns) add(vertex, 1, column);
    if (k < columns.size()) add(vertex, Rational(-all / c[k]), columns[k]);
    for (std::size_t j = 0; j < dimension; ++j) {
      const bool first = k == 0;
      reach[j] = {first ? vertex[j] : std::min(reach[j].low, vertex[j]),
                  first ? vertex[j] : std::max(reach[j].high, vertex[j])};
    }
  }
  return reach;
}

/// `degree-bound`.
void check_bound(const Part& part, const Vector& bound, const std::string& place) {
  const std::vector<Bounds> reach = reach_of(part);
  for (std::size_t j = 0; j < bound.size(); ++j) {
    const Bounds motion(part.twist[j] + reach[j].low, part.twist[j] + reach[j].high);
    if (motion.low >= -bound[j] && motion.high <= bound[j]) continue;
    throw Rejected{"degree-bound", std::nullopt, place,
                   "motion " + std::to_string(j + 1) + " of K is from " + show(motion.low) +
                       " to " + show(motion.high) + ", beyond " + show(bound[j])};
  }
}

/// A wall F.(d - c) = z of K = {F.(d - c) <= z for all F}.
struct Wall {
  Vector outwards;  ///< F
  std::string name;
};

std::vector<Wall> walls_of(const Part& part) {
  std::vector<Wall> walls;
  for (std::size_t j = 0; j < part.walls.size(); ++j) {
    const std::string name = std::to_string(j + 1);
    walls.push_back({part.walls[j], part.simplex ? name : name + " +"});
    if (part.simplex) continue;
    walls.push_back({part.walls[j], name + " -"});
    for (Rational& c : walls.back().outwards) c = -c;
  }
  return walls;
}

/// Of points, row.(d - c) + more z, where K is {F.(d - c) <= z}. For a multiple l of h = 1,
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

/// The cone over K and these multiples, or over one of its walls.
std::vector<Condition> conditions_on(const Part& part, const Range& range,
                                     std::vector<Condition> conditions,
                                     const Wall* on = nullptr) {
  for (const Wall& wall : walls_of(part)) {
    Vector below = about(part, range, wall.outwards, -1);
    for (Rational& c : below) c = -c;
    conditions.push_back({std::move(below), on != nullptr && on->name == wall.name});
  }
  return conditions;
}

/// The cone over K, across these motions.
Cone cone_over(const Part& part, const Range& range, const std::vector<Vector>& across) {
  Cone cone(part.twist.size() + 2);
  const auto multiples = multiples_in(range, part.twist.size());
  for (const Condition& condition : conditions_on(part, range, multiples)) {
    cone = cone.cut(make_form(condition.a), condition.equality);
  }
  for (const Vector& z : across) cone = cone.cut(make_form(about(part, range, z)), true);
  return cone;
}

/// Whether v_i is of this sign at some ray.
bool has_sign(const Cone& cone, const Row& row, int sign) {
  return std::any_of(row.v.begin(), row.v.end(), [&](const Form& v) {
    return std::any_of(cone.rays().begin(), cone.rays().end(),
                       [&](const auto& ray) { return sign_of_dot(v, ray->x) == sign; });
  });
}

/// `degree-law`: the contact whose v_i may be below 0 in K, or nothing.
std::optional<std::size_t> opening(const Part& part, const Box& box, const Range& range) {
  const Cone cone = cone_over(part, range, {});
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (!is_spring(box.contact(i).sight) && has_sign(cone, box.row(i), -1)) return i;
  }
  return std::nullopt;
}

/// `degree-open`. Returns the contacts that are open on K.
std::vector<std::size_t> check_open(const Part& part, const Box& box, const Range& range,
                                    const Options& asked, const std::string& place) {
  const auto expect = [&](bool good, const std::string& found) {
    require(good, "degree-open", place, found);
  };
  std::vector<std::size_t> open;
  for (const Integer& i : part.open) {
    expect(i < box.size(), "there is no contact " + i.get_str());
    expect(open.empty() || i > open.back(), "contact " + i.get_str() + " is out of order");
    open.push_back(i.get_ui());
  }
  if (open.empty()) return open;
  expect(!asked.bilateral, "no contact opens under the bilateral law");
  const Cone cone = cone_over(part, range, free_motions(part));
  for (const std::size_t i : open) {
    const std::string name = std::to_string(i);
    expect(!is_spring(box.contact(i).sight), name + " is a spring, which does not open");
    expect(!has_sign(cone, box.row(i), 1), "v of contact " + name + " may be above 0 in K");
  }
  return open;
}

/// The number of a contact among those that are not open; of one that is, one that there is
/// not.
Integer number_of(const Integer& i, const std::vector<std::size_t>& open, std::size_t left) {
  const auto at = std::lower_bound(open.begin(), open.end(), i);
  if (at != open.end() && *at == i) return left;
  return i - static_cast<unsigned long>(at - open.begin());
}

/// A node about a grasp without the contacts that are open.
Node renumbered(Node node, const std::vector<std::size_t>& open, std::size_t left) {
  if (node.kind != NodeKind::kPart || node.parameter != Parameter::kWrench) {
    node.contact = number_of(node.contact, open, left);
  }
  if (node.moving) {
    auto twist = std::make_shared<MovingTwist>(*node.moving);
    for (OwnSlip& slip : twist->slips) slip.contact = number_of(slip.contact, open, left);
    node.moving = std::move(twist);
  }
  return node;
}

}  // namespace

TreeWalk check_degree(const Part& part, const std::shared_ptr<const Box>& whole,
                      const Range& range, const Options& asked, const std::string& place) {
  check_walls(part, place);
  const std::vector<std::size_t> open = check_open(part, *whole, range, asked, place);
  const auto box = open.empty() ? whole : std::make_shared<const Box>(whole->without(open));
  check_free(part, *box, place);
  if (asked.max_motion) check_bound(part, *asked.max_motion, place);
  const auto opens = asked.bilateral ? opening(part, *box, range) : std::nullopt;
  if (opens) {
    throw Rejected{
        "degree-law", std::nullopt, place,
        "v of contact " + std::to_string(*opens) + " may be below 0 at a vertex of K"};
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
    for (const Wall& wall : walls_of(part)) {
      roots.push_back({second ? middle : box, conditions_on(part, range, multiples, &wall),
                       false, place + (second ? ", middle wall " : ", wall ") + wall.name,
                       second ? direction : std::vector<Vector>{}});
    }
  }
  TreeWalk walk(std::move(roots), place);
  for (const Node& node : part.tree) {
    walk.visit(open.empty() ? node : renumbered(node, open, box->size()));
  }
  walk.finish();
  return walk;
}

PartWalk::PartWalk(const Options& asked, const std::shared_ptr<const Box>& box)
    : asked_(asked), awaited_{{box, "", 0}} {}

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
  if (part.at_rest) {
    check_rest(*part.at_rest, *here.box, {0, 0}, place);
    ++rests_;
    return;
  }
  if (part.sticking) {
    check_sticking(*part.sticking, *here.box, {0, 0}, asked_, place);
    ++stickings_;
    return;
  }
  if (!part.cut) {
    const TreeWalk walk = check_degree(part, here.box, {0, 0}, asked_, place);
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
