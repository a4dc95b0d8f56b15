// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/force_span.hpp"

#include <algorithm>

namespace stickslip {

ForceSpan::ForceSpan(const Law& law) : motions_(law.motions) {
  for (const LawContact& c : law.contacts) {
    for (const CornerRow& corner : c.corners) {
      if (rank() == motions_) return;
      add(corner.normal);
      if (c.friction.high.is_zero()) continue;
      for (const Row& slip : corner.slip) add(RationalRow(slip.begin(), slip.end()));
    }
  }
}

ForceSpan::ForceSpan(std::size_t motions, const std::vector<RationalRow>& wrenches)
    : motions_(motions) {
  for (const RationalRow& wrench : wrenches) add(wrench);
}

ForceSpan::ForceSpan(const Problem& problem) : motions_(3) {
  for (const ContactRow& row : problem.rows()) {
    if (rank() == motions_) return;
    for (const Wrench* w : {&row.normal, &row.tangent}) {
      if (w == &row.normal || !row.friction.is_zero()) add({w->x, w->y, w->torque});
    }
  }
}

bool ForceSpan::has_load_of(const Problem& problem) const {
  const Wrench& w = problem.wrench();
  const std::vector<RationalRow> free = free_motions();
  return std::all_of(free.begin(), free.end(), [&](const RationalRow& z) {
    return dot(z, RationalRow{w.x, w.y, w.torque}).is_zero();
  });
}

void ForceSpan::add(RationalRow row) {
  const auto subtract = [](RationalRow& from, const RationalRow& other, std::size_t column) {
    const Rational factor = from[column];
    if (factor.is_zero()) return;
    for (std::size_t j = 0; j < from.size(); ++j) from[j] -= factor * other[j];
  };
  for (std::size_t k = 0; k < rank(); ++k) subtract(row, rows_[k], columns_[k]);
  std::size_t column = 0;
  while (column < motions_ && row[column].is_zero()) ++column;
  if (column == motions_) return;
  const Rational first = row[column];
  for (Rational& entry : row) entry /= first;
  for (RationalRow& other : rows_) subtract(other, row, column);
  rows_.push_back(std::move(row));
  columns_.push_back(column);
}

std::vector<RationalRow> ForceSpan::free_motions() const {
  std::vector<RationalRow> motions;
  for (std::size_t j = 0; j < motions_; ++j) {
    if (std::find(columns_.begin(), columns_.end(), j) != columns_.end()) continue;
    RationalRow& z = motions.emplace_back(motions_);
    z[j] = 1;
    for (std::size_t k = 0; k < rank(); ++k) z[columns_[k]] = -rows_[k][j];
  }
  return motions;
}

bool ForceSpan::has_loads_of(const Law& law) const {
  for (const RationalRow& z : free_motions()) {
    if (law.is_family && !dot(z, law.growth).is_zero()) return false;
    const Row there = primitive_multiple(z);
    for (const Row& way : {there, negated(there)}) {
      if (!law.most_load_work(way).is_zero()) return false;
      if (law.hull && law.hull->is_unbounded(way)) return false;
    }
  }
  return true;
}

RationalRow opposed_part(const ForceSpan& span, const Law& law, const RationalRow& load,
                         const Rational& length) {
  // The part that is taken away is a sum of loads G z; |G z|^2 = z.G z with G = 1 or length^2.
  const auto weighted = [&](RationalRow z) {
    for (std::size_t j = 0; j < z.size(); ++j) {
      if (law.rotates[j] != 0) z[j] *= length * length;
    }
    return z;
  };
  RationalRow left = load;
  std::vector<RationalRow> across;  // free motions at right angles
  for (RationalRow z : span.free_motions()) {
    for (const RationalRow& other : across) {
      const RationalRow of_other = weighted(other);
      const Rational part = dot(z, of_other) / dot(other, of_other);
      for (std::size_t j = 0; j < z.size(); ++j) z[j] -= part * other[j];
    }
    const RationalRow way = weighted(z);
    const Rational part = dot(left, z) / dot(way, z);
    for (std::size_t j = 0; j < z.size(); ++j) left[j] -= part * way[j];
    across.push_back(std::move(z));
  }
  return left;
}

std::optional<Row> unopposed_twist(const Law& law) {
  RationalRow y(law.motions);
  for (const RationalRow& z : ForceSpan(law).free_motions()) {
    Rational work = 0;
    for (std::size_t j = 0; j < y.size(); ++j) work += z[j] * law.wrench[j].middle();
    for (std::size_t j = 0; j < y.size(); ++j) y[j] -= work * z[j];
  }
  Row twist = primitive_multiple(y);
  if (is_zero(twist) || !MotionRegion::root(law).is_refuted(twist, nullptr))
    return std::nullopt;
  return twist;
}

}  // namespace stickslip
