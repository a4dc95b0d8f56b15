// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/row.hpp"

#include <algorithm>
#include <utility>

namespace stickslip {

Integer dot(const Row& a, const Row& b) {
  Integer sum;
  const std::size_t n = std::min(a.size(), b.size());
  for (std::size_t j = 0; j < n; ++j) {
    mpz_addmul(sum.mutable_gmp(), a[j].gmp(), b[j].gmp());
  }
  return sum;
}

Rational dot(const RationalRow& a, const RationalRow& b) {
  Rational sum = 0;
  const std::size_t n = std::min(a.size(), b.size());
  for (std::size_t j = 0; j < n; ++j) sum += a[j] * b[j];
  return sum;
}

SparseRow sparse(const RationalRow& row) {
  SparseRow result;
  for (std::size_t j = 0; j < row.size(); ++j) {
    if (!row[j].is_zero()) result.emplace_back(j, row[j]);
  }
  return result;
}

Rational dot(const SparseRow& a, const RationalRow& b) {
  Rational sum = 0;
  for (const auto& [index, entry] : a) sum += entry * b[index];
  return sum;
}

void add_multiple(RationalRow& to, const Rational& factor, const SparseRow& row) {
  for (const auto& [index, entry] : row) to[index] += factor * entry;
}

Rational dot(const Row& a, const RationalRow& b) {
  Rational sum = 0;
  const std::size_t n = std::min(a.size(), b.size());
  for (std::size_t j = 0; j < n; ++j) sum += Rational(a[j]) * b[j];
  return sum;
}

bool is_zero(const Row& a) {
  return std::all_of(a.begin(), a.end(), [](const Integer& entry) { return entry.is_zero(); });
}

Row negated(Row a) {
  for (Integer& entry : a) entry = -entry;
  return a;
}

Row primitive(Row a) {
  core_detail::make_primitive(a.data(), a.size());
  return a;
}

Row primitive_multiple(const RationalRow& a) {
  Row result(a.size());
  core_detail::primitive_multiple(a.data(), result.data(), a.size());
  return result;
}

}  // namespace stickslip
