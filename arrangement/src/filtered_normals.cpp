// SPDX-License-Identifier: GPL-3.0-or-later
#include "filtered_normals.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stickslip/core/error.hpp"
#include "stickslip/core/integer_vector.hpp"

namespace stickslip::arrangement_detail {
namespace {

__extension__ typedef __int128 Int128;

// Any first value is right. Small ones would often lie on circles of hand-made grasps, and
// then the next is tried.
constexpr int kFirstS = 7;

constexpr unsigned kInt128ProductBits = 124;

/// Returns the coordinate after c in cyclic order.
constexpr std::size_t after(std::size_t c) {
  return c == 2 ? 0 : c + 1;
}

/// A number mantissa * 2^exponent near a value, with 1/2 <= |mantissa| < 1, truncated to 53
/// bits: within 2^-53.
struct Floating {
  double mantissa = 0;
  long exponent = 0;
};

Floating to_floating(const Integer& value) {
  Floating result;
  if (!value.is_zero()) {
    result.mantissa = mpz_get_d_2exp(&result.exponent, value.gmp());
  }
  return result;
}

Floating to_floating(Int128 value) {
  // One rounding, within 2^-54 of the mantissa.
  int exponent = 0;
  const double mantissa = std::frexp(static_cast<double>(value), &exponent);
  return {mantissa, exponent};
}

/// Scales such that the largest entry has the exponent 0. Smaller entries have smaller errors;
/// those that underflow are off by less than 2^-1073.
std::array<double, 3> scaled(const std::array<Floating, 3>& v) {
  long largest = 0;
  bool found = false;
  for (const Floating& entry : v) {
    if (entry.mantissa == 0) continue;
    largest = found ? std::max(largest, entry.exponent) : entry.exponent;
    found = true;
  }
  std::array<double, 3> result{};
  for (std::size_t c = 0; c < 3; ++c) {
    const long shift = std::max(v[c].exponent - largest, -2000L);
    if (v[c].mantissa != 0) result[c] = std::ldexp(v[c].mantissa, static_cast<int>(shift));
  }
  return result;
}

std::size_t bit_length(const Integer& value) {
  return value.is_zero() ? 0 : mpz_sizeinbase(value.gmp(), 2);
}

Sign sign_of_int128(Int128 value) {
  return value > 0 ? Sign::kPositive : value < 0 ? Sign::kNegative : Sign::kZero;
}

Int128 minor_of(const FilteredNormals::Small& a, const FilteredNormals::Small& b,
                std::size_t coordinate) {
  const std::size_t p = after(coordinate);
  const std::size_t q = after(p);
  return Int128{a[p]} * b[q] - Int128{a[q]} * b[p];
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

IntegerVector3 find_pole(const std::vector<IntegerVector3>& normals) {
  Integer s = kFirstS;
  IntegerVector3 pole;
  const auto is_on_pole = [&pole](const IntegerVector3& n) { return dot(pole, n).is_zero(); };
  do {
    require(s <= kFirstS + 2 * normals.size(), "arrangement: a normal is zero");
    pole = {1, s, s * s};
    ++s;
  } while (std::any_of(normals.begin(), normals.end(), is_on_pole));
  return pole;
}

// Why the search ends. Let M have the rows b x a, b, a with
// a.b = 0, a, b != 0. The rows are orthogonal, so det M != 0. The two requirements become
//   z of Mn           = a.n                             != 0 for every normal n,
//   y of Mn x Mn'     = (row 3 x row 1).(n x n')        != 0 for every two normals,
// the latter because row 2 of the cofactor matrix is row 3 x row 1 = a x (b x a) = |a|^2 b,
// so it says b.(n x n') != 0. Choose a first, then b:
//   a = (1, s, s^2), a pole on no circle (find_pole);
//   b = (s, -1, 0) + t (0, s, -1), a basis of the plane orthogonal to a: b.c is linear in t,
//     and every vertex direction c = n x n' excludes at most one t. It does not exclude all:
//     c orthogonal to both basis vectors would be parallel to a, and a.n = 0.
std::vector<IntegerVector3> in_generic_position(const std::vector<IntegerVector3>& normals) {
  const IntegerVector3 a = find_pole(normals);
  const Integer& s = a[1];
  const std::size_t k = normals.size();
  // Any start is right.
  constexpr int kFirstT = 3;
  Integer t = kFirstT;
  while (!clear_of_meridian({s, s * t - 1, -t}, normals)) {
    ++t;
    require(t <= kFirstT + k * k / 2, "in_generic_position: two normals are parallel");
  }
  const IntegerVector3 b = {s, s * t - 1, -t};
  const IntegerVector3 b_cross_a = cross(b, a);
  std::vector<IntegerVector3> mapped;
  mapped.reserve(k);
  for (const IntegerVector3& n : normals) {
    mapped.push_back({dot(b_cross_a, n), dot(b, n), dot(a, n)});
  }
  return mapped;
}

FilteredNormals::FilteredNormals(std::vector<IntegerVector3> normals)
    : exact_(std::move(normals)) {
  const IntegerVector3 pole = find_pole(exact_);
  reversed_.resize(size());
  for (std::size_t i = 0; i < size(); ++i) {
    reversed_[i] = dot(pole, exact_[i]).sign() < 0;
    if (reversed_[i]) exact_[i] = negated(std::move(exact_[i]));
  }
  small_.resize(size());
  bits_.assign(size(), 0);
  for (auto& coordinate : approximate_) coordinate.resize(size());
  for (std::size_t i = 0; i < size(); ++i) {
    std::array<Floating, 3> floating;
    std::size_t longest = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      floating[c] = to_floating(exact_[i][c]);
      longest = std::max(longest, bit_length(exact_[i][c]));
    }
    const std::array<double, 3> n = scaled(floating);
    for (std::size_t c = 0; c < 3; ++c) approximate_[c][i] = n[c];
    bits_[i] = longest <= 63 ? static_cast<unsigned>(longest) : kTooLong;
    if (bits_[i] == kTooLong) continue;
    for (std::size_t c = 0; c < 3; ++c) small_[i][c] = exact_[i][c].convert_to<std::int64_t>();
  }
}

Sign ExactSigns::determinant(std::size_t i, std::size_t j, std::size_t k) {
  const FilteredNormals& n = *normals_;
  if (n.bits(i) + n.bits(j) + n.bits(k) <= kInt128ProductBits) {
    ++work_.by_int128;
    Int128 sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      sum += minor_of(n.small(i), n.small(j), c) * n.small(k)[c];
    }
    return sign_of_int128(sum);
  }
  ++work_.by_gmp;
  sum_ = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    set_minor(minor_, i, j, c);
    mpz_addmul(sum_.mutable_gmp(), minor_.gmp(), n.exact(k)[c].gmp());
  }
  return sign_of(sum_);
}

Sign ExactSigns::cross_coordinate(std::size_t i, std::size_t j, std::size_t coordinate) {
  const FilteredNormals& n = *normals_;
  if (n.bits(i) != FilteredNormals::kTooLong && n.bits(j) != FilteredNormals::kTooLong) {
    ++work_.by_int128;
    return sign_of_int128(minor_of(n.small(i), n.small(j), coordinate));
  }
  ++work_.by_gmp;
  set_minor(minor_, i, j, coordinate);
  return sign_of(minor_);
}

std::array<double, 3> ExactSigns::cross(std::size_t i, std::size_t j) {
  const FilteredNormals& n = *normals_;
  const bool is_small =
      n.bits(i) != FilteredNormals::kTooLong && n.bits(j) != FilteredNormals::kTooLong;
  std::array<Floating, 3> result;
  for (std::size_t c = 0; c < 3; ++c) {
    if (is_small) {
      result[c] = to_floating(minor_of(n.small(i), n.small(j), c));
    } else {
      set_minor(minor_, i, j, c);
      result[c] = to_floating(minor_);
    }
  }
  return scaled(result);
}

void ExactSigns::set_minor(Integer& result, std::size_t i, std::size_t j,
                           std::size_t coordinate) {
  const IntegerVector3& a = normals_->exact(i);
  const IntegerVector3& b = normals_->exact(j);
  const std::size_t p = after(coordinate);
  const std::size_t q = after(p);
  mpz_mul(product_.mutable_gmp(), a[q].gmp(), b[p].gmp());
  mpz_mul(result.mutable_gmp(), a[p].gmp(), b[q].gmp());
  mpz_sub(result.mutable_gmp(), result.gmp(), product_.gmp());
}

}  // namespace stickslip::arrangement_detail
