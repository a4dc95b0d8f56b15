// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Arithmetic of integers of two words.
#pragma once

#include <cstdint>
#include <utility>

#include "stickslip/arrangement/faces.hpp"

namespace stickslip::arrangement_detail {

/// An integer of two words without a sign.
__extension__ using UnsignedLongWord = unsigned __int128;

/// Returns the absolute value; requires that it is one.
inline LongWord size_of(LongWord value) {
  return value < 0 ? -value : value;
}

/// Returns the number of zeros below the lowest 1 of a number that is not 0.
inline int low_zeros(UnsignedLongWord value) {
  const auto low = static_cast<std::uint64_t>(value);
  return low != 0 ? __builtin_ctzll(low)
                  : 64 + __builtin_ctzll(static_cast<std::uint64_t>(value >> 64));
}

/// Returns the greatest common divisor of numbers without a sign; that with 0 is the other.
template <class Unsigned>
Unsigned binary_divisor(Unsigned a, Unsigned b) {
  if (a == 0 || b == 0) return a | b;
  const int twos = low_zeros(a | b);
  a >>= low_zeros(a);
  while (b != 0) {
    b >>= low_zeros(b);
    if (a > b) std::swap(a, b);
    b -= a;
    if constexpr (sizeof(Unsigned) > sizeof(std::uint64_t)) {
      // Both are short from here on if the greater was; a is odd, so that no 2 is lost.
      if (((a | b) >> 64) == 0) {
        return Unsigned{
                   binary_divisor(static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(b))}
               << twos;
      }
    }
  }
  return a << twos;
}

/// Returns the greatest common divisor, at least 0.
inline LongWord common_divisor(LongWord a, LongWord b) {
  auto x = static_cast<UnsignedLongWord>(size_of(a));
  auto y = static_cast<UnsignedLongWord>(size_of(b));
  // One division leaves little to do where one is far below the other.
  if (x < y) std::swap(x, y);
  if (y == 0) return static_cast<LongWord>(x);
  if ((y >> 64) == 0) x %= y;
  return static_cast<LongWord>(binary_divisor(x, y));
}

/// Returns the same number.
inline Integer integer_of(LongWord value) {
  const auto size = static_cast<UnsignedLongWord>(size_of(value));
  Integer result;
  mp_limb_t* const limbs = mpz_limbs_write(result.mutable_gmp(), 2);
  limbs[0] = static_cast<mp_limb_t>(size);
  limbs[1] = static_cast<mp_limb_t>(size >> 64);
  mpz_limbs_finish(result.mutable_gmp(), value < 0 ? -2 : 2);
  return result;
}

/// Returns the same number, which has to be below 2^127.
inline LongWord long_word_of(const Integer& value) {
  const auto limb = [&](mp_size_t i) {
    return static_cast<UnsignedLongWord>(mpz_getlimbn(value.gmp(), i));
  };
  const auto size = static_cast<LongWord>(limb(1) << 64 | limb(0));
  return value.sign() < 0 ? -size : size;
}

}  // namespace stickslip::arrangement_detail
