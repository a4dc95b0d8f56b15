// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle.hpp"

#include <set>

#include "stickslip/core/sign.hpp"

namespace stickslip::test {
namespace {

Vector3 cross_product(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Rational dot_product(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

bool is_zero(const Vector3& v) {
  return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

int rank_of(const std::vector<Vector3>& vectors) {
  if (vectors.empty()) return 0;
  Vector3 axis = {0, 0, 0};
  for (const Vector3& v : vectors) {
    if (is_zero(axis)) axis = cross_product(vectors.front(), v);
  }
  if (is_zero(axis)) return 1;
  for (const Vector3& v : vectors) {
    if (dot_product(axis, v) != 0) return 3;
  }
  return 2;
}

/// A vector along each one-dimensional flat of R^3 modulo the lineality space; the same flat
/// may come more than once.
std::vector<Vector3> flat_directions(const std::vector<Vector3>& planes, int rank) {
  std::vector<Vector3> crosses;
  for (const Vector3& a : planes) {
    for (const Vector3& b : planes) {
      const Vector3 c = cross_product(a, b);
      if (!is_zero(c)) crosses.push_back(c);
    }
  }
  if (rank == 3) return crosses;
  if (rank == 0) return {};
  if (rank == 1) return {planes.front()};
  std::vector<Vector3> result;
  for (const Vector3& n : planes) result.push_back(cross_product(n, crosses.front()));
  return result;
}

std::string composition(std::string x, const std::string& y) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] == '0') x[i] = y[i];
  }
  return x;
}

std::set<std::string> signs_of_flats(const std::vector<Vector3>& planes, int rank) {
  std::set<std::string> result;
  for (const Vector3& direction : flat_directions(planes, rank)) {
    std::string plus;
    std::string minus;
    for (const Vector3& n : planes) {
      const Sign sign = sign_of(dot_product(n, direction));
      plus.push_back(to_char(sign));
      minus.push_back(to_char(-sign));
    }
    result.insert(plus);
    result.insert(minus);
  }
  return result;
}

}  // namespace

OracleResult enumerate_by_composition(const std::vector<Vector3>& planes) {
  OracleResult result;
  result.rank = rank_of(planes);

  const std::set<std::string> flats = signs_of_flats(planes, result.rank);
  std::set<std::string> states = {std::string(planes.size(), '0')};
  std::vector<std::string> pending(states.begin(), states.end());
  while (!pending.empty()) {
    const std::string state = pending.back();
    pending.pop_back();
    for (const std::string& flat : flats) {
      std::string next = composition(state, flat);
      if (states.insert(next).second) pending.push_back(std::move(next));
    }
  }

  for (const std::string& state : states) {
    std::vector<Vector3> zero_set;
    for (std::size_t i = 0; i < planes.size(); ++i) {
      if (state[i] == '0') zero_set.push_back(planes[i]);
    }
    const int zero_rank = rank_of(zero_set);
    if (zero_rank == 3) continue;
    const bool is_lineality = zero_rank == result.rank;
    if (zero_rank == 2) result.vertices += is_lineality ? 2 : 1;
    if (zero_rank == 1) result.edges += 1;
    if (zero_rank == 0) result.faces += 1;
  }
  result.states.assign(states.begin(), states.end());
  return result;
}

}  // namespace stickslip::test
