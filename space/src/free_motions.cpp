// SPDX-License-Identifier: GPL-3.0-or-later
#include "free_motions.hpp"

#include <algorithm>

namespace stickslip::space_detail {
namespace {

template <class Numbers>
Vector6 as_vector(const Numbers& row) {
  Vector6 result;
  for (std::size_t j = 0; j < 6; ++j) result[j] = Rational(row[j]);
  return result;
}

}  // namespace

ForceSpan::ForceSpan(const SpaceModel& box) {
  for (const LawContact& c : box.contacts) {
    for (const CornerRow& corner : c.corners) {
      if (rank() == 6) return;
      add(as_vector(corner.normal));
      if (c.friction.high.is_zero()) continue;
      for (const Row& slip : corner.slip) {
        add(as_vector(slip));
      }
    }
  }
}

void ForceSpan::add(Vector6 row) {
  const auto subtract = [](Vector6& from, const Vector6& other, std::size_t column) {
    const Rational factor = from[column];
    if (factor.is_zero()) return;
    for (std::size_t j = 0; j < 6; ++j) from[j] -= factor * other[j];
  };
  for (std::size_t k = 0; k < rank(); ++k) subtract(row, rows_[k], columns_[k]);
  std::size_t column = 0;
  while (column < 6 && row[column].is_zero()) ++column;
  if (column == 6) return;
  const Rational first = row[column];
  for (Rational& entry : row) entry /= first;
  for (Vector6& other : rows_) subtract(other, row, column);
  rows_.push_back(std::move(row));
  columns_.push_back(column);
}

std::vector<Vector6> ForceSpan::free_motions() const {
  std::vector<Vector6> motions;
  for (std::size_t j = 0; j < 6; ++j) {
    if (std::find(columns_.begin(), columns_.end(), j) != columns_.end()) continue;
    Vector6& z = motions.emplace_back();
    z[j] = 1;
    for (std::size_t k = 0; k < rank(); ++k) z[columns_[k]] = -rows_[k][j];
  }
  return motions;
}

std::optional<Row> ForceSpan::unopposed(const SpaceModel& box) const {
  Vector6 y{};
  for (const Vector6& z : free_motions()) {
    Rational work = 0;
    for (std::size_t j = 0; j < 6; ++j) work += z[j] * box.wrench[j].middle();
    for (std::size_t j = 0; j < 6; ++j) y[j] -= work * z[j];
  }
  Row twist = primitive_multiple(RationalRow(y.begin(), y.end()));
  if (is_zero(twist)) return std::nullopt;
  return twist;
}

bool ForceSpan::has_loads_of(const SpaceModel& box) const {
  for (const Vector6& z : free_motions()) {
    Rational work = 0;
    for (std::size_t j = 0; j < 6; ++j) {
      if (!box.wrench[j].is_point() && !z[j].is_zero()) return false;
      work += z[j] * box.wrench[j].low;
    }
    if (!work.is_zero() || !dot(z, as_vector(box.growth)).is_zero()) return false;
  }
  return true;
}

}  // namespace stickslip::space_detail
