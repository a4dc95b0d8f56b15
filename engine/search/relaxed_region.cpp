// SPDX-License-Identifier: GPL-3.0-or-later
#include "relaxed_region.hpp"

#include <algorithm>
#include <utility>

#include "stickslip/lp/exact_system.hpp"

namespace stickslip {
namespace {

void add(LpWork& sum, const LpWork& part) {
  sum.double_pivots += part.double_pivots;
  sum.exact_pivots += part.exact_pivots;
  sum.basis_confirmed = sum.basis_confirmed && part.basis_confirmed;
  sum.tier = std::max(sum.tier, part.tier);
  sum.largest_bits = std::max(sum.largest_bits, part.largest_bits);
}

}  // namespace

RelaxedRegion::RelaxedRegion(std::size_t motions, std::vector<LoadedGenerator> generators)
    : motions_(motions), generators_(std::move(generators)) {
  for (const LoadedGenerator& g : generators_) wrenches_.push_back(g.load);
}

Rational RelaxedRegion::OpenContact::most(std::size_t generator) const {
  const Rational& v = contact.separations[generator];
  return contact.is_mixed && v.sign() < 0 ? Rational(0) : v;
}

void RelaxedRegion::add(RelaxedContact contact) {
  const std::size_t edge = contact.slip ? RelaxedContact::edge_against(*contact.slip) : 0;
  OpenContact open{std::move(contact)};
  if (!open.contact.is_mixed) {
    open.edge = edge;
    push(open, edge, 1);
  }
  if (!open.contact.is_settled()) open_.push_back(std::move(open));
}

/// Adds the wrenches of a contact that pushes along an edge with all it may, or takes them
/// away.
void RelaxedRegion::push(const OpenContact& open, std::size_t edge, int sign) {
  for (std::size_t g = 0; g < generators_.size(); ++g) {
    const Rational most = open.most(g);
    if (!most.is_zero()) add_multiple(wrenches_[g], sign * most, open.contact.edges[edge]);
  }
}

/// Has all open contacts push along the edges that do the most work on a twist.
void RelaxedRegion::push_against(const RationalRow& twist) {
  for (OpenContact& open : open_) {
    const std::array<Rational, 2> works{dot(open.contact.edges[0], twist),
                                        dot(open.contact.edges[1], twist)};
    std::optional<std::size_t> edge = works[0] >= works[1] ? 0 : 1;
    if (open.contact.slip) edge = RelaxedContact::edge_against(*open.contact.slip);
    if (open.contact.is_mixed && works[*edge].sign() <= 0) edge.reset();
    if (edge == open.edge) continue;
    if (open.edge) push(open, *open.edge, -1);
    if (edge) push(open, *edge, 1);
    open.edge = edge;
  }
}

std::vector<Rational> RelaxedRegion::bounds(const RationalRow& twist) {
  push_against(twist);
  std::vector<Rational> result;
  for (const RationalRow& wrench : wrenches_) result.push_back(dot(twist, wrench));
  return result;
}

void RelaxedRegion::start_from(const RationalRow& twist) {
  add_columns(twist, heights(), 0, 0);
}

std::vector<Rational> RelaxedRegion::heights() const {
  std::vector<Rational> result;
  for (const LoadedGenerator& g : generators_) result.push_back(g.x[height()]);
  return result;
}

std::variant<RelaxedSum, RationalRow> RelaxedRegion::solve(LpWork& work) {
  if (generators_.empty()) return RationalRow(motions_);
  std::vector<Rational> sum;
  for (std::size_t k = 0; k < generators_.front().positive.size(); ++k) {
    std::vector<Rational> scale;
    for (const LoadedGenerator& g : generators_) scale.push_back(g.positive[k]);
    auto outcome = optimize(scale, 0, work);
    if (auto* twist = std::get_if<RationalRow>(&outcome)) return std::move(*twist);
    const std::vector<Rational>& found = std::get<Optimal>(outcome).point;
    sum.resize(found.size());
    add_multiple(sum, 1, found);
  }
  // None of the functions is negative anywhere, so all of them are positive in the sum.
  return point(sum);
}

std::optional<RelaxedSum> RelaxedRegion::extreme(int sign, LpWork& work) {
  const auto outcome = optimize(heights(), sign, work);
  if (std::holds_alternative<RationalRow>(outcome)) return std::nullopt;
  if (const auto* unbounded = std::get_if<Unbounded>(&outcome)) return point(unbounded->ray);
  return point(std::get<Optimal>(outcome).point);
}

/// Solves sum lambda_c (wrench_c, scale_c) = (0, 1), lambda >= 0, so that the multiple is
/// largest (sign = 1), smallest (-1) or any (0); returns a ray if it grows without end. If
/// there is no solution, returns a twist y whose bounds are <= 0, = 0 only where the scale is
/// 0.
std::variant<Optimal, Unbounded, RationalRow> RelaxedRegion::optimize(
    const std::vector<Rational>& scale, int sign, LpWork& work) {
  while (true) {
    LpWork part;
    const LpResult result = stickslip::solve(program(scale, sign), &part);
    stickslip::add(work, part);
    if (const auto* unbounded = std::get_if<Unbounded>(&result)) return *unbounded;
    const auto* optimal = std::get_if<Optimal>(&result);
    const std::vector<Rational>& y =
        optimal != nullptr ? optimal->dual : std::get<Infeasible>(result).farkas;
    RationalRow twist(y.begin(), y.end() - 1);
    if (add_columns(twist, scale, y.back(), optimal != nullptr ? sign : 0)) continue;
    if (optimal != nullptr) return *optimal;
    return twist;
  }
}

LinearProgram RelaxedRegion::program(const std::vector<Rational>& scale, int sign) const {
  LinearProgram program;
  program.add_variables(columns_.size(), VariableKind::kNonNegative);
  for (std::size_t j = 0; j < height(); ++j) {
    std::vector<Rational> row;
    for (const Column& c : columns_) row.push_back(c.wrench[j]);
    program.add_row(std::move(row), Relation::kEqual, 0);
  }
  std::vector<Rational> scales;
  for (const Column& c : columns_) scales.push_back(scale[c.generator]);
  program.add_row(std::move(scales), Relation::kEqual, 1);
  if (sign == 0) return program;
  std::vector<Rational> cost;
  for (const Column& c : columns_) cost.push_back(-sign * generators_[c.generator].x.back());
  program.minimize(std::move(cost));
  return program;
}

/// Adds, on each generator, the corner that does the most work on the twist, if its reduced
/// cost is negative: y.wrench + z scale > cost. Returns false if there are none.
bool RelaxedRegion::add_columns(const RationalRow& twist, const std::vector<Rational>& scale,
                                const Rational& z, int sign) {
  push_against(twist);
  bool added = false;
  for (std::size_t g = 0; g < generators_.size(); ++g) {
    Rational excess = z * scale[g] + dot(twist, wrenches_[g]);
    if (sign != 0) excess += sign * generators_[g].x.back();
    if (excess.sign() <= 0) continue;
    added = true;
    Column& column = columns_.emplace_back(Column{g, {}, wrenches_[g]});
    for (const OpenContact& open : open_) column.edges.push_back(open.edge);
  }
  return added;
}

/// Returns the combination of columns, scaled to h = 1; where h = 0, to the multiple 1.
RelaxedSum RelaxedRegion::point(const std::vector<Rational>& weights) const {
  RelaxedSum result;
  result.x.resize(generators_.front().x.size());
  for (const OpenContact& open : open_) result.pushes.push_back({open.contact.contact, {}});
  std::vector<Rational> by_generator(generators_.size());
  for (std::size_t c = 0; c < weights.size(); ++c) {
    by_generator[columns_[c].generator] += weights[c];
  }
  for (std::size_t g = 0; g < generators_.size(); ++g) {
    if (!by_generator[g].is_zero()) add_multiple(result.x, by_generator[g], generators_[g].x);
  }
  result.is_ray = result.x[height()].is_zero();
  const Rational scale = 1 / (result.is_ray ? result.x.back() : result.x[height()]);
  for (Rational& entry : result.x) entry *= scale;
  for (Rational& weight : by_generator) weight *= scale;
  for (std::size_t c = 0; c < weights.size(); ++c) {
    if (weights[c].is_zero()) continue;
    const Column& column = columns_[c];
    for (std::size_t q = 0; q < open_.size(); ++q) {
      if (!column.edges[q]) continue;
      result.pushes[q].along[*column.edges[q]] +=
          scale * weights[c] * open_[q].most(column.generator);
    }
  }
  find_breaches(by_generator, result);
  return result;
}

void RelaxedRegion::find_breaches(const std::vector<Rational>& by_generator,
                                  RelaxedSum& sum) const {
  Rational widest = 0;
  Rational widest_separation = 0;
  const auto consider = [](const Rational& gap, Rational& most, auto split, auto& broken) {
    if (gap <= most) return;
    most = gap;
    broken = split;
  };
  for (std::size_t q = 0; q < open_.size(); ++q) {
    const RelaxedContact& contact = open_[q].contact;
    const ContactId id = contact.contact;
    RelaxedSum::Push& push = sum.pushes[q];
    const auto& [forward, backward] = push.along;
    const Rational a = forward + backward;
    if (contact.is_mixed) {
      const Rational lawful = std::max<Rational>(0, dot(contact.separations, by_generator));
      // The gap is an energy of the spring, as the slip's gap is one of friction.
      const Rational gap = abs(Rational(a - lawful)) * std::max(a, lawful) / contact.stiffness;
      consider(gap, widest, SeparationSplit{id}, sum.broken);
      consider(gap, widest_separation, SeparationSplit{id}, sum.broken_separation);
    }
    if (contact.slip) continue;
    // The edges differ by 2 mu T.
    const Rational slip = (dot(contact.edges[0], sum.x) - dot(contact.edges[1], sum.x)) / 2;
    push.sticks = slip.is_zero();
    consider(a * abs(slip) + (forward - backward) * slip, widest, SlipSplit{id}, sum.broken);
  }
}

}  // namespace stickslip
