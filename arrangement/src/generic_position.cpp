// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search and why it ends. Let M have the rows b x a, b, a with a.b = 0, a, b != 0. The
// rows are orthogonal, so det M != 0. The two requirements become
//   z of Mn           = a.n                             != 0 for every normal n,
//   y of Mn x Mn'     = (row 3 x row 1).(n x n')        != 0 for every two normals,
// the latter because row 2 of the cofactor matrix is row 3 x row 1 = a x (b x a) = |a|^2 b,
// so it says b.(n x n') != 0. Choose a first, then b:
//   a = (1, s, s^2): a.n is a nonzero polynomial of degree 2 in s, so every normal excludes
//     at most two s;
//   b = (s, -1, 0) + t (0, s, -1), a basis of the plane orthogonal to a: b.c is linear in t,
//     and every vertex direction c = n x n' excludes at most one t. It does not exclude all:
//     c orthogonal to both basis vectors would be parallel to a, and a.n = 0.
#include "generic_position.hpp"

#include "stickslip/core/error.hpp"
#include "stickslip/core/integer_vector.hpp"

namespace stickslip {
namespace {

// Any start is right. Small numbers first would collide often with the small integers of
// hand-made grasps.
constexpr int kFirstS = 7;
constexpr int kFirstT = 3;

bool clear_of_poles(const IntegerVector3& a, const std::vector<IntegerVector3>& normals) {
  for (const IntegerVector3& n : normals) {
    if (dot(a, n).is_zero()) return false;
  }
  return true;
}

bool clear_of_meridian(const IntegerVector3& b, const std::vector<IntegerVector3>& normals) {
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const IntegerVector3 b_cross_n = cross(b, normals[i]);
    for (std::size_t j = i + 1; j < normals.size(); ++j) {
      if (dot(b_cross_n, normals[j]).is_zero()) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<IntegerVector3> in_generic_position(const std::vector<IntegerVector3>& normals) {
  const std::size_t k = normals.size();
  Integer s = kFirstS;
  while (!clear_of_poles({1, s, s * s}, normals)) {
    ++s;
    require(s <= kFirstS + 2 * k, "in_generic_position: a normal is zero");
  }
  const IntegerVector3 a = {1, s, s * s};

  Integer t = kFirstT;
  while (!clear_of_meridian({s, s * t - 1, -t}, normals)) {
    ++t;
    require(t <= kFirstT + k * k / 2, "in_generic_position: two normals are parallel");
  }
  const IntegerVector3 b = {s, s * t - 1, -t};

  const IntegerVector3 b_cross_a = cross(b, a);
  std::vector<IntegerVector3> mapped;
  mapped.reserve(normals.size());
  for (const IntegerVector3& n : normals) {
    mapped.push_back({dot(b_cross_a, n), dot(b, n), dot(a, n)});
  }
  return mapped;
}

}  // namespace stickslip
