// SPDX-License-Identifier: MIT
#include "number.hpp"

namespace stickslip_check {
namespace {

constexpr std::size_t kMaxDecimalLength = 16384;
constexpr std::size_t kMaxFractionLength = 65536;
constexpr unsigned long kMaxExponent = 4096;

/// Reads a text from left to right.
struct Cursor {
  const std::string& text;
  std::size_t at = 0;

  bool done() const { return at == text.size(); }

  bool take(char c) {
    if (done() || text[at] != c) return false;
    ++at;
    return true;
  }

  std::string digits() {
    const std::size_t begin = at;
    while (!done() && text[at] >= '0' && text[at] <= '9') ++at;
    return text.substr(begin, at - begin);
  }
};

Integer power_of_ten(unsigned long exponent) {
  Integer power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, exponent);
  return power;
}

/// The fraction of two digit strings, or nothing.
std::optional<Rational> fraction(const std::string& num, const std::string& den,
                                 bool negative) {
  if (num.empty() || den.empty()) return std::nullopt;
  const Integer divisor(den, 10);
  if (divisor == 0) return std::nullopt;
  Rational value(Integer(num, 10), divisor);
  value.canonicalize();
  return negative ? Rational(-value) : value;
}

}  // namespace

std::optional<Rational> parse_decimal(const std::string& text) {
  if (text.size() > kMaxDecimalLength) return std::nullopt;
  Cursor cursor{text};
  const bool negative = cursor.take('-');
  if (!negative) cursor.take('+');
  std::string digits = cursor.digits();
  if (digits.empty()) return std::nullopt;
  if (cursor.take('/')) {
    const std::string den = cursor.digits();
    return cursor.done() ? fraction(digits, den, negative) : std::nullopt;
  }
  std::string decimals;
  if (cursor.take('.')) {
    decimals = cursor.digits();
    if (decimals.empty()) return std::nullopt;
    digits += decimals;
  }
  Integer exponent = 0;
  if (cursor.take('e') || cursor.take('E')) {
    const bool down = cursor.take('-');
    if (!down) cursor.take('+');
    const std::string spelled = cursor.digits();
    if (spelled.empty()) return std::nullopt;
    exponent = Integer(spelled, 10);
    if (exponent > kMaxExponent) return std::nullopt;
    if (down) exponent = -exponent;
  }
  if (!cursor.done()) return std::nullopt;
  exponent -= static_cast<unsigned long>(decimals.size());
  const Integer size = abs(exponent);
  const Integer scale = power_of_ten(size.get_ui());
  Rational value(Integer(digits, 10));
  if (exponent >= 0) {
    value *= scale;
  } else {
    value /= scale;
  }
  return negative ? Rational(-value) : value;
}

std::optional<Rational> parse_fraction(const std::string& text) {
  if (text.size() > kMaxFractionLength) return std::nullopt;
  Cursor cursor{text};
  const bool negative = cursor.take('-');
  const std::string num = cursor.digits();
  const std::string den = cursor.take('/') ? cursor.digits() : "1";
  return cursor.done() ? fraction(num, den, negative) : std::nullopt;
}

std::optional<Rational> exact_sqrt(const Rational& x) {
  // In lowest terms the root is rational iff both parts are squares.
  if (mpz_perfect_square_p(x.get_num_mpz_t()) == 0 ||
      mpz_perfect_square_p(x.get_den_mpz_t()) == 0) {
    return std::nullopt;
  }
  return Rational(sqrt(x.get_num()), sqrt(x.get_den()));
}

std::string decimal_above_sqrt(const Rational& x) {
  if (x == 0) return "0";
  // sqrt(x) = sqrt(10^(-2e) x) 10^e: lower e until there are three digits, then round up.
  long exponent = static_cast<long>(mpz_sizeinbase(x.get_num_mpz_t(), 10)) -
                  static_cast<long>(mpz_sizeinbase(x.get_den_mpz_t(), 10));
  exponent = exponent / 2 + 1;
  for (;; --exponent) {
    const Integer scale = power_of_ten(2 * static_cast<unsigned long>(labs(exponent)));
    const Rational scaled = exponent < 0 ? Rational(x * scale) : Rational(x / scale);
    Integer digits = sqrt(ceil_shifted(scaled, 0));
    if (digits < 100) continue;
    digits += 1;
    std::string text = digits.get_str();
    exponent += static_cast<long>(text.size()) - 1;
    return text.insert(1, ".") + "e" + std::to_string(exponent);
  }
}

Integer floor_shifted(const Rational& x, std::size_t shift) {
  Integer result;
  mpz_mul_2exp(result.get_mpz_t(), x.get_num_mpz_t(), shift);
  mpz_fdiv_q(result.get_mpz_t(), result.get_mpz_t(), x.get_den_mpz_t());
  return result;
}

Integer ceil_shifted(const Rational& x, std::size_t shift) {
  Integer result;
  mpz_mul_2exp(result.get_mpz_t(), x.get_num_mpz_t(), shift);
  mpz_cdiv_q(result.get_mpz_t(), result.get_mpz_t(), x.get_den_mpz_t());
  return result;
}

Integer floor_shifted(const Rational& x, const Integer& n, std::size_t shift) {
  Integer result = x.get_num() * n;
  mpz_mul_2exp(result.get_mpz_t(), result.get_mpz_t(), shift);
  mpz_fdiv_q(result.get_mpz_t(), result.get_mpz_t(), x.get_den_mpz_t());
  return result;
}

Rational dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Integer dot(const std::array<Integer, 3>& a, const std::array<Integer, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector3 sum(const Vector3& a, const Rational& s, const Vector3& b) {
  return {Rational(a[0] + s * b[0]), Rational(a[1] + s * b[1]), Rational(a[2] + s * b[2])};
}

std::string show(const Rational& x) {
  constexpr std::size_t kMaxShown = 60;
  const std::string text = x.get_str();
  if (text.size() <= kMaxShown) return text;
  return text.substr(0, kMaxShown / 2) + "... (" + std::to_string(text.size()) + " characters)";
}

std::string show(const Vector3& v) {
  return "(" + show(v[0]) + ", " + show(v[1]) + ", " + show(v[2]) + ")";
}

std::string quote(const std::string& text) {
  constexpr std::size_t kMaxShown = 40;
  std::string shown;
  for (const char c : text.substr(0, kMaxShown)) {
    shown += (c < ' ' || c > '~' || c == '"' || c == '\\') ? '?' : c;
  }
  return '"' + shown + (text.size() > kMaxShown ? "...\"" : "\"");
}

}  // namespace stickslip_check
