// SPDX-License-Identifier: GPL-3.0-or-later
// Integer and Rational against Boost's own arithmetic, which shares nothing with GMP's, and
// against closed forms.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <type_traits>
#include <vector>

#include "random_numbers.hpp"
#include "rounds.hpp"
#include "stickslip/core/number.hpp"

// GCC 12 sees uninitialised values in these headers when it optimises little.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <boost/multiprecision/cpp_int.hpp>
#pragma GCC diagnostic pop

namespace stickslip {
namespace {

using testing::Random;
using TwinInteger = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                                  boost::multiprecision::et_off>;
using TwinRational = boost::multiprecision::number<boost::multiprecision::cpp_rational_backend,
                                                   boost::multiprecision::et_off>;

static_assert(std::is_same_v<decltype(Integer() + Integer()), Integer>);
static_assert(std::is_same_v<decltype(Rational() * 2), Rational>);
static_assert(std::is_nothrow_move_constructible_v<Rational>);
static_assert(!std::is_convertible_v<double, Rational>);
static_assert(!std::is_convertible_v<double, Integer>);
static_assert(!std::is_convertible_v<Rational, Integer>);

TwinInteger twin(const Integer& value) {
  return TwinInteger(value.str());
}

TwinRational twin(const Rational& value) {
  return {twin(numerator(value)), twin(denominator(value))};
}

/// A number of a length at which what computes changes, with factors to have in common.
Integer any_integer(Random& random) {
  return random.border() * random.integer(1, 6) / random.integer(1, 6);
}

Rational any_rational(Random& random) {
  const Integer denominator = random.integer(0, 2) == 0 ? Integer(1) : any_integer(random);
  return Rational(any_integer(random), denominator.is_zero() ? Integer(1) : denominator);
}

void expect_lowest_terms(const Rational& value) {
  EXPECT_GT(denominator(value), 0);
  EXPECT_EQ(gcd(numerator(value), denominator(value)), 1) << value;
  EXPECT_EQ(value.is_integer(), denominator(value) == 1);
}

template <class Number>
void expect_same_order(const Number& a, const Number& b) {
  const auto p = twin(a);
  const auto q = twin(b);
  EXPECT_EQ(a == b, p == q);
  EXPECT_EQ(a != b, p != q);
  EXPECT_EQ(a < b, p < q);
  EXPECT_EQ(a > b, p > q);
  EXPECT_EQ(a <= b, p <= q);
  EXPECT_EQ(a >= b, p >= q);
  EXPECT_EQ(a.sign(), p.sign());
}

/// All ways to write a sum, a difference and a product: of variables, of temporaries, in place,
/// and of a number with itself.
template <class Number>
void expect_ring(const Number& a, const Number& b) {
  const auto p = twin(a);
  const auto q = twin(b);
  const auto expect_all = [](const auto& twins, std::initializer_list<Number> numbers) {
    for (const Number& number : numbers) EXPECT_EQ(twin(number), twins);
  };
  const auto in_place = [&](auto change) {
    Number value = a;
    change(value);
    return value;
  };
  expect_all(p + q, {a + b, Number(a) + b, a + Number(b), Number(a) + Number(b),
                     in_place([&](Number& x) { x += b; })});
  expect_all(p - q, {a - b, Number(a) - b, a - Number(b), Number(a) - Number(b),
                     in_place([&](Number& x) { x -= b; })});
  expect_all(p * q, {a * b, Number(a) * b, a * Number(b), Number(a) * Number(b),
                     in_place([&](Number& x) { x *= b; })});
  expect_all(p + p, {a + a, in_place([](Number& x) { x += x; })});
  expect_all(p * p, {a * a, in_place([](Number& x) { x *= x; })});
  expect_all(p - p, {a - a, in_place([](Number& x) { x -= x; }), Number()});
  expect_all(-p, {-a, Number() - a, 0 - a});
  EXPECT_EQ(twin(abs(a)), p < 0 ? -p : p);
}

TEST(Integer, AgreesWithAnotherArithmetic) {
  Random random(55);
  for (int i = 0; i < test::rounds(5000); ++i) {
    const Integer a = any_integer(random);
    const Integer b = any_integer(random);
    expect_same_order(a, b);
    expect_ring(a, b);
    EXPECT_EQ(twin(gcd(a, b)), gcd(twin(a), twin(b)));
    EXPECT_EQ(twin(lcm(a, b)), lcm(twin(a), twin(b)));
    if (!b.is_zero()) {
      EXPECT_EQ(twin(a / b), twin(a) / twin(b));
      EXPECT_EQ(twin(a % b), twin(a) % twin(b));
      EXPECT_EQ(a / b * b + a % b, a);
    }
    const auto bits = static_cast<unsigned>(random.integer(0, 130));
    EXPECT_EQ(a << bits, a * pow(Integer(2), bits));
    const Integer down = a >> bits;
    EXPECT_LE(down << bits, a);
    EXPECT_GT((down + 1) << bits, a);
    if (a.sign() > 0) {
      EXPECT_LE(Integer(1) << msb(a), a);
      EXPECT_GT(Integer(1) << (msb(a) + 1), a);
      const Integer root = sqrt(a);
      EXPECT_LE(root * root, a);
      EXPECT_GT((root + 1) * (root + 1), a);
    }
    if (a.sign() >= 0 && b.sign() >= 0) {
      EXPECT_EQ(twin(a & b), twin(a) & twin(b));
    }
  }
}

TEST(Rational, AgreesWithAnotherArithmetic) {
  Random random(56);
  for (int i = 0; i < test::rounds(5000); ++i) {
    const Rational a = any_rational(random);
    const Rational b = any_rational(random);
    expect_lowest_terms(a);
    expect_same_order(a, b);
    expect_ring(a, b);
    for (const Rational& value : {a + b, a - b, a * b}) expect_lowest_terms(value);
    if (!b.is_zero()) {
      EXPECT_EQ(twin(a / b), twin(a) / twin(b));
      EXPECT_EQ(twin(Rational(a) / b), twin(a) / twin(b));
      EXPECT_EQ(b / b, 1);
      Rational quotient = a;
      quotient /= b;
      EXPECT_EQ(quotient * b, a);
      expect_lowest_terms(quotient);
      quotient = b;
      quotient /= quotient;
      EXPECT_EQ(quotient, 1);
    }
    EXPECT_EQ(Integer(a), numerator(a) / denominator(a));
    EXPECT_EQ(Rational(a.str()), a);
    const Integer n = numerator(b);
    EXPECT_EQ(a < n, a < Rational(n));
    EXPECT_EQ(n < a, Rational(n) < a);
    EXPECT_EQ(a == n, a == Rational(n));
    EXPECT_EQ(twin(a * n), twin(a) * TwinRational(twin(n)));
  }
}

template <class Word>
void expect_words() {
  using Limits = std::numeric_limits<Word>;
  const std::vector<Word> words{Limits::min(),
                                static_cast<Word>(Limits::min() + 1),
                                0,
                                1,
                                2,
                                7,
                                static_cast<Word>(Limits::max() - 1),
                                Limits::max()};
  for (const Word a : words) {
    EXPECT_EQ(Integer(a).str(), std::to_string(a));
    EXPECT_EQ(Rational(a).str(), std::to_string(a));
    EXPECT_EQ(Integer(a).convert_to<Word>(), a);
    Integer assigned = 5;
    assigned = a;
    EXPECT_EQ(assigned, a);
    for (const Word b : words) {
      EXPECT_EQ(Integer(a) < b, a < b);
      EXPECT_EQ(a < Integer(b), a < b);
      EXPECT_EQ(Rational(a) < b, a < b);
      EXPECT_EQ(Rational(a) == b, a == b);
      EXPECT_EQ(Rational(2 * Integer(a) + 1, 2) > b, a >= b);
      EXPECT_EQ(twin(Integer(a) + b), twin(Integer(a)) + b);
      EXPECT_EQ(twin(a - Integer(b)), twin(Integer(a)) - b);
      EXPECT_EQ(twin(a * Integer(b)), twin(Integer(a)) * b);
      Integer sum = a;
      sum += b;
      EXPECT_EQ(sum, Integer(a) + Integer(b));
      sum -= b;
      EXPECT_EQ(sum, a);
      sum *= b;
      EXPECT_EQ(sum, Integer(a) * Integer(b));
      if (b != 0) {
        EXPECT_EQ(Rational(a, b), Rational(Integer(a), Integer(b)));
        expect_lowest_terms(Rational(a, b));
      }
    }
  }
}

TEST(Number, TakesAllWordsOfTheMachine) {
  expect_words<int>();
  expect_words<unsigned>();
  expect_words<long>();
  expect_words<unsigned long>();
  expect_words<long long>();
  expect_words<short>();
}

TEST(Number, DividesByNothingButNumbers) {
  EXPECT_THROW(Integer(1) / Integer(0), std::overflow_error);
  EXPECT_THROW(Integer(1) % Integer(0), std::overflow_error);
  EXPECT_THROW(Rational(1) / Rational(0), std::overflow_error);
  EXPECT_THROW(Rational(1, 2) / 0, std::overflow_error);
  EXPECT_THROW(Rational(1, 0), std::overflow_error);
  EXPECT_THROW(Rational(Integer(1), Integer(0)), std::overflow_error);
  Integer n = 1;
  EXPECT_THROW(n /= Integer(0), std::overflow_error);
  EXPECT_THROW(n %= Integer(0), std::overflow_error);
  Rational q(1, 3);
  EXPECT_THROW(q /= 0, std::overflow_error);
  EXPECT_EQ(q, Rational(1, 3));
}

TEST(Number, LeavesZeroBehindWhenItMoves) {
  Rational from(Integer(1) << 200, 3);
  const Rational to = std::move(from);
  EXPECT_EQ(to * 3, Integer(1) << 200);
  EXPECT_EQ(from, 0);
  from += Rational(1, 2);
  EXPECT_EQ(from, Rational(1, 2));
  Integer whole = Integer(1) << 200;
  const Rational taken = std::move(whole);
  EXPECT_EQ(taken, Integer(1) << 200);
  EXPECT_EQ(whole, 0);
  whole = 7;
  EXPECT_EQ(whole, 7);
}

/// A denominator of 1 may own no memory: GMP's functions get one that does.
TEST(Number, IsWrittenByFunctionsOfGmp) {
  Rational q;
  mpq_t half;
  mpq_init(half);
  mpq_set_ui(half, 1, 2);
  mpq_add(q.mutable_gmp(), q.gmp(), half);
  EXPECT_EQ(q, Rational(1, 2));
  q = 3;
  mpq_mul(q.mutable_gmp(), q.gmp(), half);
  EXPECT_EQ(q, Rational(3, 2));
  mpq_clear(half);
}

TEST(Number, IsSpelled) {
  EXPECT_EQ(Integer("-123456789012345678901234567890").str(),
            "-123456789012345678901234567890");
  EXPECT_EQ(Integer("007"), 7);
  EXPECT_EQ(Rational("-6/4").str(), "-3/2");
  EXPECT_EQ(Rational("5").str(), "5");
  std::ostringstream out;
  out << Integer(0) << ' ' << Rational(-1, 7);
  EXPECT_EQ(out.str(), "0 -1/7");
  for (const char* text : {"", "-", "0x10", "1.5", "1-2", " 1", "+1", "x"}) {
    EXPECT_THROW(Integer{std::string(text)}, std::invalid_argument) << text;
  }
  EXPECT_THROW(Rational{"1/"}, std::invalid_argument);
  EXPECT_THROW(Rational{"1/0"}, std::overflow_error);
}

TEST(Number, TellsWhatFitsIntoAWord) {
  EXPECT_EQ(Integer(-128).convert_to<signed char>(), -128);
  EXPECT_THROW(Integer(128).convert_to<signed char>(), std::overflow_error);
  EXPECT_THROW((Integer(1) << 63).convert_to<long>(), std::overflow_error);
  EXPECT_EQ((Integer(1) << 63).convert_to<unsigned long>(), 1UL << 63);
  EXPECT_THROW(Integer(-1).convert_to<std::size_t>(), std::overflow_error);
  EXPECT_EQ(Integer(-2.75), -2);
  EXPECT_EQ(Integer(0x1p100), Integer(1) << 100);
  EXPECT_THROW(Integer(std::numeric_limits<double>::quiet_NaN()), std::overflow_error);
  EXPECT_THROW(Integer(std::numeric_limits<double>::infinity()), std::overflow_error);
}

}  // namespace
}  // namespace stickslip
