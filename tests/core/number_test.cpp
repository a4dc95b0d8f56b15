// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/number.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstring>
#include <limits>

#include "random_numbers.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using ::testing::HasSubstr;
using testing::Random;

Rational ten_to(int exponent) {
  const Rational power(stickslip::pow(Integer(10), static_cast<unsigned>(std::abs(exponent))));
  return exponent >= 0 ? power : Rational(1 / power);
}

TEST(ParseRational, ReadsEverySpellingExactly) {
  const struct {
    const char* text;
    Rational value;
  } kCases[] = {
      {"0", 0},
      {"-0", 0},
      {"+0", 0},
      {"0.0", 0},
      {"0e5", 0},
      {"-0/5", 0},
      {"7", 7},
      {"+7", 7},
      {"-7", -7},
      {"010", 10},     // not octal
      {"-0010", -10},  // not octal
      {"08", 8},       // not an error in octal
      {"010/08", Rational(5, 4)},
      {"0.10", Rational(1, 10)},
      {"0.010", Rational(1, 100)},
      {"-0.25", Rational(-1, 4)},
      {"12.50", Rational(25, 2)},
      {"1e-3", Rational(1, 1000)},
      {"1E3", 1000},
      {"1e+3", 1000},
      {"1e010", ten_to(10)},
      {"1.5e-1", Rational(3, 20)},
      {"-2.5e2", -250},
      {"1e4096", ten_to(4096)},
      {"1e-4096", ten_to(-4096)},
      {"1e00000000000000000000000000000000000000000000001", 10},
      {"3/5", Rational(3, 5)},
      {"-6/4", Rational(-3, 2)},
      {"+6/4", Rational(3, 2)},
      {"0/9", 0},
      {"123456789012345678901234567890/10", Integer("12345678901234567890123456789")},
      {"0.3333333333333333333333333333333333",
       Rational(Integer("3333333333333333333333333333333333"),
                Integer("10000000000000000000000000000000000"))},
  };
  for (const auto& c : kCases) EXPECT_EQ(parse_rational(c.text), c.value) << c.text;
}

/// In machine words and beyond: the text is taken apart here, and put together by powers.
TEST(ParseRational, ReadsNumbersOfAnyLength) {
  Random random(8);
  const auto digits = [&](int least) {
    std::string text(static_cast<std::size_t>(random.integer(least, 22)), '0');
    const bool nines = random.integer(0, 3) == 0;
    for (char& c : text) c = nines ? '9' : static_cast<char>('0' + random.integer(0, 9));
    return text;
  };
  const auto value_of = [](const std::string& text) {
    Integer value = 0;
    for (const char c : text) value = 10 * value + (c - '0');
    return Rational(value);
  };
  for (int i = 0; i < 20000; ++i) {
    const std::string whole = digits(1);
    const std::string decimals = digits(0);
    const int exponent = random.integer(-25, 25);
    const std::string sign = random.integer(0, 1) == 0 ? "" : "-";
    const Rational factor = sign.empty() ? 1 : -1;
    const std::string point = decimals.empty() ? "" : "." + decimals;
    const Rational decimal =
        factor * value_of(whole + decimals) * ten_to(-static_cast<int>(decimals.size()));
    EXPECT_EQ(parse_rational(sign + whole + point), decimal);
    EXPECT_EQ(parse_rational(sign + whole + point + "e" + std::to_string(exponent)),
              decimal * ten_to(exponent));
    const std::string below = digits(0) + "1";
    EXPECT_EQ(parse_rational(sign + whole + "/" + below),
              factor * value_of(whole) / value_of(below));
  }
}

TEST(ParseRational, RejectsEverythingElse) {
  for (const char* text :
       {"",     "+",     "-",    ".",     "1.",    ".5",    "-.5",   "e3",    "1e",
        "1e+",  "1e3.5", "1.e3", "--1",   "+-1",   "1-",    " 1",    "1 ",    "1 2",
        "1,5",  "1_000", "0x10", "1f",    "nan",   "NaN",   "inf",   "-inf",  "Infinity",
        "1/",   "/2",    "1/-2", "1/+2",  "1/2/3", "1.5/2", "1/2.5", "1e2/3", "1/2e3",
        "1/2 ", "3 / 5", "one",  "1e3e3", "١",     "−1",    "1\n"}) {
    EXPECT_THROW(parse_rational(text), NumberError) << '"' << text << '"';
  }
  EXPECT_THROW(parse_rational(std::string_view("1\0", 2)), NumberError);
  EXPECT_THROW(parse_rational(std::string_view("\0", 1)), NumberError);
}

TEST(ParseRational, SaysWhyInBoundedLength) {
  const auto message = [](const std::string& text) -> std::string {
    try {
      parse_rational(text);
    } catch (const NumberError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(message("1/0"), HasSubstr("\"1/0\" divides by zero"));
  EXPECT_THAT(message("1/000"), HasSubstr("divides by zero"));
  EXPECT_THAT(message("abc"), HasSubstr("\"abc\" is not a number such as"));
  EXPECT_THAT(message("1e999999999"), HasSubstr("exceeds 4096"));
  EXPECT_THAT(message("1e-4097"), HasSubstr("exceeds 4096"));
  EXPECT_THAT(message("1e" + std::string(9000, '9')), HasSubstr("exceeds 4096"));
  EXPECT_THAT(message(std::string(kMaxNumberLength + 1, '1')), HasSubstr("16385 characters"));
  EXPECT_EQ(message(std::string("a\0b", 3)),
            std::string("\"a\\x00b\" is not a number such as 2, -0.25, 1e-3 or 3/5"));
  EXPECT_LT(message(std::string(16000, 'x')).size(), 200U);
  EXPECT_LT(message(std::string(16000, '1') + "/0").size(), 200U);
}

TEST(ParseRational, TakesTheLongestNumberAllowed) {
  const std::string longest(kMaxNumberLength, '9');
  EXPECT_EQ(parse_rational(longest) + 1, ten_to(static_cast<int>(kMaxNumberLength)));
  const std::string decimals = "0." + std::string(kMaxNumberLength - 8, '0') + "1e4096";
  EXPECT_EQ(parse_rational(decimals), ten_to(4096 - (static_cast<int>(kMaxNumberLength) - 7)));
}

TEST(ToString, IsInLowestTermsAndReadsBack) {
  EXPECT_EQ(to_string(Rational(6, 4)), "3/2");
  EXPECT_EQ(to_string(Rational(-6, 3)), "-2");
  EXPECT_EQ(to_string(Rational(0)), "0");
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Rational value = random.big(60);
    EXPECT_EQ(parse_rational(to_string(value)), value);
  }
}

TEST(RationalFromDouble, IsExact) {
  EXPECT_EQ(rational_from_double(0.0), 0);
  EXPECT_EQ(rational_from_double(-0.0), 0);
  EXPECT_EQ(rational_from_double(-1.5), Rational(-3, 2));
  EXPECT_EQ(rational_from_double(0.1), Rational(Integer("3602879701896397"), Integer(1) << 55));
  EXPECT_EQ(rational_from_double(std::numeric_limits<double>::denorm_min()),
            Rational(1, Integer(1) << 1074));
  EXPECT_EQ(rational_from_double(std::numeric_limits<double>::max()),
            Rational(((Integer(1) << 53) - 1) << 971));
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(rational_from_double(bad), NumberError);
  }
}

TEST(ToDouble, RoundTripsEveryKindOfDouble) {
  Random random(2);
  std::uniform_int_distribution<std::uint64_t> bits;
  for (int i = 0; i < 5000; ++i) {
    const std::uint64_t pattern = bits(random.engine());
    double value = 0;
    std::memcpy(&value, &pattern, sizeof value);
    if (!std::isfinite(value)) continue;
    EXPECT_EQ(to_double(rational_from_double(value)), value);
  }
  for (const double value :
       {std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::min(),
        std::numeric_limits<double>::max(), 0.0}) {
    EXPECT_EQ(to_double(rational_from_double(value)), value);
    EXPECT_EQ(to_double(rational_from_double(-value)), -value);
  }
}

TEST(ToDouble, LeavesTheRangeGracefully) {
  EXPECT_EQ(to_double(ten_to(400)), std::numeric_limits<double>::infinity());
  EXPECT_EQ(to_double(-ten_to(400)), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(to_double(ten_to(-400)), 0.0);
  EXPECT_EQ(to_double(Rational(1, 3)), 1.0 / 3.0);
}

/// Beside the middle of two doubles, where rounding twice goes wrong.
TEST(ToDouble, IsTheNearest) {
  Random random(7);
  std::uniform_int_distribution<std::uint64_t> bits;
  for (int i = 0; i < 5000; ++i) {
    std::uint64_t pattern = bits(random.engine()) >> 1U;
    if (i % 2 == 0) pattern >>= static_cast<unsigned>(random.integer(11, 62));  // subnormal
    double value = 0;
    std::memcpy(&value, &pattern, sizeof value);
    const double above = std::nextafter(value, std::numeric_limits<double>::infinity());
    if (!std::isfinite(above)) continue;
    const Rational low = rational_from_double(value);
    const Rational middle = (low + rational_from_double(above)) / 2;
    const Rational little = ten_to(-1200);
    const bool is_even = pattern % 2 == 0;
    EXPECT_EQ(to_double(middle - little), value);
    EXPECT_EQ(to_double(middle + little), above);
    EXPECT_EQ(to_double(middle), is_even ? value : above);
    EXPECT_EQ(to_double(-middle - little), -above);
  }
}

/// Where the machine divides, and where it cannot.
TEST(ToDouble, OfShortFractionsIsTheNearest) {
  Random random(9);
  for (int i = 0; i < 20000; ++i) {
    const Rational value = i % 2 == 0 ? random.extreme() : random.big(18);
    const double nearest = to_double(value);
    if (value.is_zero()) {
      EXPECT_EQ(nearest, 0.0);
      continue;
    }
    const Rational error = abs(value - rational_from_double(nearest));
    for (const double end : {-HUGE_VAL, HUGE_VAL}) {
      const Rational other = rational_from_double(std::nextafter(nearest, end));
      EXPECT_LE(error, abs(value - other)) << value;
    }
  }
}

TEST(ExactSqrt, FindsExactlyTheRationalRoots) {
  EXPECT_EQ(exact_sqrt(0), Rational(0));
  EXPECT_EQ(exact_sqrt(1), Rational(1));
  EXPECT_EQ(exact_sqrt(Rational(9, 4)), Rational(3, 2));
  EXPECT_EQ(exact_sqrt(Rational(18, 8)), Rational(3, 2));
  for (const Rational& value : {Rational(2), Rational(1, 2), Rational(4, 3), Rational(3, 4)}) {
    EXPECT_EQ(exact_sqrt(value), std::nullopt) << value;
  }
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const Rational root = abs(random.big(40));
    const Rational square = root * root;
    EXPECT_EQ(exact_sqrt(square), root);
    if (!root.is_zero()) {
      EXPECT_EQ(exact_sqrt(square * 2), std::nullopt);
    }
  }
  EXPECT_THROW(exact_sqrt(-1), ContractError);
}

/// lower <= factor sqrt(radicand) <= upper, decided by squaring, and at most two units in
/// the last of `digits` digits apart.
void expect_encloses(const Rational& factor, const Rational& radicand, int digits) {
  const DecimalEnclosure e = enclose_sqrt(factor, radicand, digits);
  SCOPED_TRACE(to_string(factor) + " sqrt " + to_string(radicand) + ": " + e.lower + ", " +
               e.upper);
  const Rational low = parse_rational(e.lower);
  const Rational high = parse_rational(e.upper);
  const Rational square = factor * factor * radicand;
  const auto signed_square = [](const Rational& v) { return Rational(v * abs(v)); };
  const Rational value = factor.sign() < 0 ? Rational(-square) : square;
  EXPECT_LE(signed_square(low), value);
  EXPECT_GE(signed_square(high), value);
  const Rational larger = abs(low) > abs(high) ? Rational(abs(low)) : Rational(abs(high));
  EXPECT_LE((high - low), larger * 2 * ten_to(1 - digits));
}

TEST(EncloseSqrt, ContainsTheValueAndIsTight) {
  expect_encloses(1, 2, 17);
  expect_encloses(-1, 2, 17);
  expect_encloses(Rational(-3, 7), 5, 3);
  expect_encloses(0, 2, 17);
  expect_encloses(1, 0, 17);
  expect_encloses(ten_to(300), 2, 17);
  expect_encloses(ten_to(-900), 3, 50);
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    expect_encloses(random.big(30), abs(random.big(30)), random.integer(1, 40));
  }
  EXPECT_THROW(enclose_sqrt(1, -1), ContractError);
}

TEST(Enclose, DecimalsAreAroundTheNumbersAndNear) {
  Random random(71);
  for (int round = 0; round < 2000; ++round) {
    const Rational low(random.integer(0, 1000), random.integer(1, 1000));
    const Rational width(random.integer(1, 50), Integer(1) << random.integer(0, 60));
    const Rational high = low + width;
    const DecimalEnclosure e = enclose(low, high);
    const Rational lower = parse_rational(e.lower);
    const Rational upper = parse_rational(e.upper);
    EXPECT_TRUE(low - width < lower && lower <= low) << e.lower << ' ' << low;
    EXPECT_TRUE(high <= upper && upper < high + width) << e.upper << ' ' << high;
  }
  const DecimalEnclosure exact = enclose(0, Rational(1, 4));
  EXPECT_EQ(exact.lower, "0");
  EXPECT_EQ(exact.upper, "0.3");
  EXPECT_THROW(enclose(1, 1), ContractError);
  EXPECT_THROW(enclose(-1, 1), ContractError);
}

TEST(EncloseSqrt, OfARationalRootIsThatRoot) {
  const DecimalEnclosure e = enclose_sqrt(Rational(1, 2), Rational(9, 4), 5);
  EXPECT_EQ(e.lower, "0.75");
  EXPECT_EQ(e.upper, "0.75");
}

/// A program around the library may have set a locale with a decimal comma.
TEST(EncloseSqrt, IgnoresTheLocale) {
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  if (std::setlocale(LC_NUMERIC, "de_DE.UTF-8") == nullptr) GTEST_SKIP() << "no de_DE locale";
  const std::string lower = enclose_sqrt(1, 2, 4).lower;
  std::setlocale(LC_NUMERIC, before.c_str());
  EXPECT_EQ(lower, "1.414");
}

TEST(Division, ByZeroThrows) {
  EXPECT_THROW(Rational(1) / Rational(0), std::overflow_error);
}

/// x as [~][-]digits[.digits][e[-]digits] means it, whatever its size.
Rational meant(std::string text) {
  if (text.front() == kRounded) text.erase(0, 1);
  const std::size_t e = text.find('e');
  const Rational mantissa = parse_rational(text.substr(0, e));
  return e == std::string::npos ? mantissa
                                : Rational(mantissa * ten_to(std::stoi(text.substr(e + 1))));
}

TEST(ReadableString, SpellsShortNumbersInFullAndRoundsOthers) {
  const struct {
    Rational value;
    const char* text;
  } kCases[] = {
      {0, "0"},
      {-2, "-2"},
      {123456789, "123456789"},
      {-123456789, "-123456789"},
      {1234567890, "~1.23457e9"},
      {1000000000, "1e9"},
      {Rational(11, 10), "11/10"},
      {Rational(-3, 7), "-3/7"},
      {Rational(99, 98), "99/98"},
      {Rational(1, 100), "0.01"},
      {Rational(100, 3), "~33.3333"},
      {Rational(-1, 300), "~-0.00333333"},
      {Rational(10767, 500), "21.534"},
      {Rational(981, 100), "9.81"},
      {Rational(1, 128), "0.0078125"},
      {Rational(1, 1024), "~0.000976563"},  // 0.0009765625
      {Rational(1, 10000), "0.0001"},
      {Rational(1, 100000), "1e-5"},
      {Rational(-1, 80000), "-1.25e-5"},
      {Rational(1999999, 2), "~1e6"},  // 999999.5
      {Rational(1999998, 10), "~200000"},
      {Rational(1999999, 10), "~200000"},
      {Rational(9999994, 10000000), "~0.999999"},
      {Rational(9999995, 10000000), "~1"},
      {Rational(1234565, 1000000), "~1.23457"},    // a tie
      {Rational(-1234565, 1000000), "~-1.23457"},  // a tie
      {Rational(1000001, 2), "~500001"},           // a tie
      {ten_to(400), "1e400"},
      {Rational(-1) / ten_to(400), "-1e-400"},
      {Rational(ten_to(400) + 1), "~1e400"},
      {Rational(2 * ten_to(5000) / 3), "~6.66667e4999"},
      {Rational(2) / (3 * ten_to(5000)), "~6.66667e-5001"},
  };
  for (const auto& [value, text] : kCases) EXPECT_EQ(to_readable_string(value), text) << value;
}

TEST(Number, SharesAreDecimalsOfPercent) {
  EXPECT_EQ(to_percent_string({3, 8}), "37.5 %");
  EXPECT_EQ(to_percent_string({5, 16}), "31.25 %");
  EXPECT_EQ(to_percent_string(0), "0 %");
  EXPECT_EQ(to_percent_string(1), "100 %");
  EXPECT_EQ(to_percent_string({1, 3}), "~33.3333 %");
  EXPECT_EQ(to_percent_string({99999999, 100000000}), "~100 %");
}

TEST(ReadableString, IsExactWithoutTheMarkAndNearestWithIt) {
  Random random(5);
  int exact = 0;
  for (int i = 0; i < 3000; ++i) {
    const int length = random.integer(1, 40);
    Rational value = random.big(length) * ten_to(random.integer(-20, 20));
    // Many that are short decimals, or beside the middle of two.
    if (i % 3 == 0) value = Rational(random.digits(7), 2) * ten_to(random.integer(-9, 3));
    if (i % 6 == 0) value += random.integer(-1, 1) * ten_to(-60);
    const std::string text = to_readable_string(value);
    SCOPED_TRACE(to_string(value) + " as " + text);
    EXPECT_LE(text.size(), std::strlen("~-0.000123456") + 1);
    EXPECT_EQ(to_readable_string(value, 1), text);
    EXPECT_EQ(to_readable_string(Rational(value / 3), 9), text);
    const Rational shown = meant(text);
    if (text.front() != kRounded) {
      ++exact;
      EXPECT_EQ(shown, value);
      continue;
    }
    EXPECT_NE(shown, value);
    // The naive twin: the unit of the sixth digit, by trying one power of ten after the other.
    Rational unit = ten_to(-70);
    while (abs(value) >= 1000000 * unit) unit *= 10;
    EXPECT_LE(2 * abs(Rational(shown - value)), unit);
    EXPECT_EQ(denominator(Rational(shown / unit)), 1);
    if (2 * abs(Rational(shown - value)) == unit) {
      EXPECT_GT(abs(shown), abs(value));
    }
  }
  EXPECT_GT(exact, 100);
}

TEST(ReadableString, OfARootIsTheNearestDecimal) {
  EXPECT_EQ(to_readable_string(1, 2), "~1.41421");
  EXPECT_EQ(to_readable_string(Rational(-1, 2), 2), "~-0.707107");
  EXPECT_EQ(to_readable_string(0, 2), "0");
  EXPECT_EQ(to_readable_string(5, 0), "0");
  EXPECT_EQ(to_readable_string(Rational(1, 2), Rational(121, 25)), "11/10");
  EXPECT_EQ(to_readable_string(ten_to(-500), 2), "~1.41421e-500");
  EXPECT_THROW(to_readable_string(1, -1), ContractError);
  Random random(6);
  for (int i = 0; i < 1000; ++i) {
    const Rational factor = random.big(30);
    const Rational radicand = abs(random.big(30));
    const std::string text = to_readable_string(factor, radicand);
    if (text.front() != kRounded || exact_sqrt(radicand)) continue;
    const Rational square = factor * factor * radicand;
    Rational unit = ten_to(-70);
    while (square >= ten_to(12) * unit * unit) unit *= 10;
    const Rational shown = abs(meant(text));
    const Rational low = shown - unit / 2;
    const Rational high = shown + unit / 2;
    EXPECT_LE(low * low, square) << text;
    EXPECT_GE(high * high, square) << text;
  }
}

}  // namespace
}  // namespace stickslip
