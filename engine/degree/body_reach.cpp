// SPDX-License-Identifier: GPL-3.0-or-later
#include "body_reach.hpp"

#include <algorithm>

#include "stickslip/lp/exact_system.hpp"

namespace stickslip::degree_detail {

BodyReach::BodyReach(const ConvexBody& body) : is_simplex_(body.is_simplex) {
  const std::size_t rows = body.walls.size();
  for (std::size_t k = 0; k < rows; ++k) {
    RationalRow at(rows);
    std::vector<RationalRow> across = body.walls;
    if (is_simplex_) {
      // At a vertex all rows but one are 1. (Without row k the others are independent.)
      across.erase(across.begin() + static_cast<std::ptrdiff_t>(k));
      at.assign(rows - 1, 1);
    } else {
      at[k] = 1;
    }
    RationalMatrix gram(across.size(), across.size());
    for (std::size_t j = 0; j < across.size(); ++j) {
      for (std::size_t l = 0; l < across.size(); ++l) gram(j, l) = dot(across[j], across[l]);
    }
    const auto u = solve_exactly(gram, at);
    is_sound_ = is_sound_ && u.has_value();
    if (u) ways_.push_back(matrix_of_columns(across, body.twist.size()) * *u);
  }
}

Rational BodyReach::largest(const RationalRow& row) const {
  Rational sum;
  for (std::size_t k = 0; k < ways_.size(); ++k) {
    const Rational along = dot(row, ways_[k]);
    if (is_simplex_) {
      sum = k == 0 ? along : std::max(sum, along);
    } else {
      sum += abs(along);
    }
  }
  return sum;
}

bool is_within(const ConvexBody& body, const RationalRow& bound) {
  if (bound.empty()) return true;
  const BodyReach reach(body);
  if (!reach.is_sound()) return false;
  RationalRow axis(bound.size());
  for (std::size_t j = 0; j < bound.size(); ++j) {
    for (const int sign : {1, -1}) {
      axis[j] = sign;
      if (sign * body.twist[j] + reach.largest(axis) > bound[j]) return false;
    }
    axis[j] = 0;
  }
  return true;
}

}  // namespace stickslip::degree_detail
