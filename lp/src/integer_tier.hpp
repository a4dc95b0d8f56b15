// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The three kinds of integer that exact elimination runs on, behind one set of operations:
///
///   fused(a, b, c, d, e, out)   out = (a b - c d) / e, where e divides; false on overflow
///   compare_products(a, b, c, d)   sign of a b - c d
///   ratio(a, b)                    a / b in lowest terms, b != 0
///
/// `fused` is the one step of fraction-free elimination (Bareiss 1968, Eq. 7). In the
/// fixed-width tiers the division is exact and so needs no division instruction: shift out
/// the power of two of e, then multiply by the inverse of its odd part modulo 2^w (Jebelean,
/// "An algorithm for exact division", J. Symb. Comp. 15, 1993). Multiplying back in double
/// width, where nothing can overflow, detects every quotient that does not fit.
///
/// Fixed-width values stay in the symmetric range |v| < 2^(w-1), so negation is safe.
#pragma once

#include <cstdint>
#include <limits>
#include <numeric>

#include "small_integer.hpp"
#include "stickslip/core/number.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::lp_detail {

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 UInt128;

/// A signed 256-bit integer, as much of it as the 128-bit tier needs.
struct Int256 {
  UInt128 low;
  Int128 high;
};

inline Int256 multiply(Int128 a, Int128 b) {
  const auto ua = static_cast<UInt128>(a);
  const auto ub = static_cast<UInt128>(b);
  const UInt128 mask = std::numeric_limits<std::uint64_t>::max();
  const UInt128 a0 = ua & mask;
  const UInt128 a1 = ua >> 64;
  const UInt128 b0 = ub & mask;
  const UInt128 b1 = ub >> 64;
  const UInt128 p00 = a0 * b0;
  const UInt128 p01 = a0 * b1;
  const UInt128 p10 = a1 * b0;
  const UInt128 middle = (p00 >> 64) + (p01 & mask) + (p10 & mask);
  UInt128 high = a1 * b1 + (p01 >> 64) + (p10 >> 64) + (middle >> 64);
  // This turns the product of the two's complements into the product of the numbers.
  if (a < 0) high -= ub;
  if (b < 0) high -= ua;
  return {(middle << 64) | (p00 & mask), static_cast<Int128>(high)};
}

inline Int256 subtract(Int256 a, Int256 b) {
  const UInt128 low = a.low - b.low;
  const UInt128 borrow = a.low < b.low ? 1U : 0U;
  return {low, static_cast<Int128>(static_cast<UInt128>(a.high) - static_cast<UInt128>(b.high) -
                                   borrow)};
}

inline int trailing_zeros(std::uint64_t value) {
  return __builtin_ctzll(value);
}
inline int bit_length(std::uint64_t value) {
  return value == 0 ? 0 : 64 - __builtin_clzll(value);
}

struct Int64Tier {
  using Value = std::int64_t;
  static constexpr LpTier kTier = LpTier::kInt64;

  class Divisor {
   public:
    explicit Divisor(Value e) : value(e), shift(trailing_zeros(static_cast<std::uint64_t>(e))) {
      // Newton: x = e^-1 mod 8 for odd e; each step doubles the number of right bits.
      const auto odd = static_cast<std::uint64_t>(e >> shift);
      std::uint64_t x = odd;
      for (int bits = 3; bits < 64; bits *= 2) x *= 2 - odd * x;
      inverse = x;
    }
    Value value;
    int shift;
    std::uint64_t inverse;
  };

  class BitMeter {
   public:
    void note(Value v) { seen_ |= static_cast<std::uint64_t>(v < 0 ? -v : v); }
    long bits() const { return bit_length(seen_); }

   private:
    std::uint64_t seen_ = 0;
  };

  static bool load(std::int64_t from, Value& to) {
    to = from;
    return from != std::numeric_limits<std::int64_t>::min();
  }
  static bool load(const Integer& from, Value& to) { return read_small(from.gmp(), to); }

  static bool fused(Value a, Value b, Value c, Value d, const Divisor& e, Value& out) {
    const Int128 numerator = static_cast<Int128>(a) * b - static_cast<Int128>(c) * d;
    const auto quotient =
        static_cast<Value>(static_cast<std::uint64_t>(numerator >> e.shift) * e.inverse);
    out = quotient;
    return static_cast<Int128>(quotient) * e.value == numerator &&
           quotient != std::numeric_limits<Value>::min();
  }
  static int compare_products(Value a, Value b, Value c, Value d) {
    const Int128 left = static_cast<Int128>(a) * b;
    const Int128 right = static_cast<Int128>(c) * d;
    return left < right ? -1 : left > right ? 1 : 0;
  }
  static int sign(Value v) { return v < 0 ? -1 : v > 0 ? 1 : 0; }
  static void negate(Value& v) { v = -v; }
  static Integer to_integer(Value v) { return Integer(v); }
  static Rational ratio(Value a, Value b) {
    const Value divisor = std::gcd(a, b);
    const Value signed_divisor = b < 0 ? -divisor : divisor;
    Rational out;
    mpq_set_si(out.mutable_gmp(), a / signed_divisor,
               static_cast<unsigned long>(b / signed_divisor));
    return out;
  }
};

struct Int128Tier {
  using Value = Int128;
  static constexpr LpTier kTier = LpTier::kInt128;

  class Divisor {
   public:
    explicit Divisor(Value e) : value(e) {
      const auto low = static_cast<std::uint64_t>(e);
      shift = low != 0 ? trailing_zeros(low)
                       : 64 + trailing_zeros(static_cast<std::uint64_t>(e >> 64));
      const auto odd = static_cast<UInt128>(e >> shift);
      UInt128 x = odd;
      for (int bits = 3; bits < 128; bits *= 2) x *= 2 - odd * x;
      inverse = x;
    }
    Value value;
    int shift;
    UInt128 inverse;
  };

  class BitMeter {
   public:
    void note(Value v) { seen_ |= static_cast<UInt128>(v < 0 ? -v : v); }
    long bits() const {
      const auto high = static_cast<std::uint64_t>(seen_ >> 64);
      return high != 0 ? 64 + bit_length(high) : bit_length(static_cast<std::uint64_t>(seen_));
    }

   private:
    UInt128 seen_ = 0;
  };

  static bool load(std::int64_t from, Value& to) {
    to = from;
    return true;
  }
  static bool load(const Integer& from, Value& to) {
    const __mpz_struct* z = from.gmp();
    if (mpz_sizeinbase(z, 2) > 127) return false;
    auto magnitude = static_cast<UInt128>(mpz_getlimbn(z, 0));
    magnitude |= static_cast<UInt128>(mpz_getlimbn(z, 1)) << 64;
    to = mpz_sgn(z) < 0 ? -static_cast<Int128>(magnitude) : static_cast<Int128>(magnitude);
    return true;
  }

  static bool fused(Value a, Value b, Value c, Value d, const Divisor& e, Value& out) {
    const Int256 numerator = subtract(multiply(a, b), multiply(c, d));
    UInt128 shifted = numerator.low;
    if (e.shift != 0) {
      shifted = (numerator.low >> e.shift) |
                (static_cast<UInt128>(numerator.high) << (128 - e.shift));
    }
    const auto quotient = static_cast<Value>(shifted * e.inverse);
    out = quotient;
    const Int256 back = multiply(quotient, e.value);
    constexpr auto kMin = static_cast<Value>(static_cast<UInt128>(1) << 127);
    return back.low == numerator.low && back.high == numerator.high && quotient != kMin;
  }
  static int compare_products(Value a, Value b, Value c, Value d) {
    const Int256 difference = subtract(multiply(a, b), multiply(c, d));
    if (difference.high < 0) return -1;
    return difference.high > 0 || difference.low > 0 ? 1 : 0;
  }
  static int sign(Value v) { return v < 0 ? -1 : v > 0 ? 1 : 0; }
  static void negate(Value& v) { v = -v; }
  static Integer to_integer(Value v) {
    const auto magnitude = static_cast<UInt128>(v < 0 ? -v : v);
    Integer out(static_cast<std::uint64_t>(magnitude >> 64));
    out <<= 64;
    out += static_cast<std::uint64_t>(magnitude);
    return v < 0 ? Integer(-out) : out;
  }
  static Rational ratio(Value a, Value b) { return {to_integer(a), to_integer(b)}; }
};

struct GmpTier {
  using Value = Integer;
  static constexpr LpTier kTier = LpTier::kGmp;

  class Divisor {
   public:
    explicit Divisor(const Value& e) : value(e) {}
    Value value;
    mutable Value scratch;
  };

  class BitMeter {
   public:
    void note(const Value& v) {
      const auto bits = static_cast<long>(mpz_sizeinbase(v.gmp(), 2));
      if (bits > bits_ && !v.is_zero()) bits_ = bits;
    }
    long bits() const { return bits_; }

   private:
    long bits_ = 0;
  };

  static bool load(std::int64_t from, Value& to) {
    to = from;
    return true;
  }
  static bool load(const Integer& from, Value& to) {
    to = from;
    return true;
  }

  /// Computes (a b - c d) / e. `out` may be one of the operands.
  static bool fused(const Value& a, const Value& b, const Value& c, const Value& d,
                    const Divisor& e, Value& out) {
    mpz_ptr scratch = e.scratch.mutable_gmp();
    mpz_mul(scratch, a.gmp(), b.gmp());
    mpz_submul(scratch, c.gmp(), d.gmp());
    mpz_divexact(out.mutable_gmp(), scratch, e.value.gmp());
    return true;
  }
  static int compare_products(const Value& a, const Value& b, const Value& c, const Value& d) {
    return Value(a * b).compare(Value(c * d));
  }
  static int sign(const Value& v) { return v.sign(); }
  static void negate(Value& v) { v.negate(); }
  static Integer to_integer(const Value& v) { return v; }
  static Rational ratio(const Value& a, const Value& b) { return {a, b}; }
};

}  // namespace stickslip::lp_detail
