// SPDX-License-Identifier: MIT
#include "number.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "work.hpp"

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

void add_dot(Integer& sum, const Form& a, const Form& b) {
  spend(a.size(), words(a), words(b));
  for (std::size_t j = 0; j < a.size(); ++j) {
    mpz_addmul(sum.get_mpz_t(), a[j].get_mpz_t(), b[j].get_mpz_t());
  }
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
  Integer exponent = 0;
  if (cursor.take('.')) {
    const std::string decimals = cursor.digits();
    if (decimals.empty()) return std::nullopt;
    digits += decimals;
    exponent = -static_cast<long>(decimals.size());
  }
  if (cursor.take('e') || cursor.take('E')) {
    const bool down = cursor.take('-');
    if (!down) cursor.take('+');
    const std::string spelled = cursor.digits();
    if (spelled.empty()) return std::nullopt;
    const Integer size(spelled, 10);
    if (size > kMaxExponent) return std::nullopt;
    exponent += down ? Integer(-size) : size;
  }
  if (!cursor.done()) return std::nullopt;
  const Integer size = abs(exponent);
  Integer scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), 10, size.get_ui());
  const Rational value(Integer(digits, 10));
  const Rational scaled = exponent < 0 ? Rational(value / scale) : Rational(value * scale);
  return negative ? Rational(-scaled) : scaled;
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

Bounds root_bounds(const Rational& x, unsigned bits) {
  if (const auto root = exact_sqrt(x)) return *root;
  // j is the integer part of the root of 4^s x.
  const auto integer_part = [&](long s) {
    const Integer power = Integer(1) << static_cast<unsigned long>(2 * std::abs(s));
    const Rational scaled = s < 0 ? Rational(x / power) : Rational(x * power);
    return Integer(sqrt(Integer(scaled.get_num() / scaled.get_den())));
  };
  const auto size = [](const Integer& n) {
    return static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 2));
  };
  long s = static_cast<long>(bits) + (size(x.get_den()) - size(x.get_num())) / 2;
  while (integer_part(s) < Integer(1) << (bits - 1)) ++s;
  while (integer_part(s) >= Integer(1) << bits) --s;
  const Integer j = integer_part(s);
  const Integer power = Integer(1) << static_cast<unsigned long>(std::abs(s));
  const auto over = [&](const Integer& n) {
    return s < 0 ? Rational(n * power) : Rational(Rational(n) / power);
  };
  return {over(j), over(j + 1)};
}

Rational root_above(const Rational& x) {
  constexpr unsigned kRootBits = 64;
  return x >= 0 ? root_bounds(x, kRootBits).high
                : Rational(-root_bounds(Rational(-x), kRootBits).low);
}

Integer make_primitive(Form& x) {
  spend(2 * x.size(), words(x), words(x));
  Integer divisor;
  for (const Integer& coordinate : x) {
    divisor = gcd(divisor, coordinate);
    if (divisor == 1) return divisor;
  }
  if (divisor == 0) return 1;
  for (Integer& coordinate : x) {
    mpz_divexact(coordinate.get_mpz_t(), coordinate.get_mpz_t(), divisor.get_mpz_t());
  }
  return divisor;
}

Form make_form(const Vector& x, Rational* scale) {
  Integer den = 1;
  for (const Rational& coordinate : x) den = lcm(den, coordinate.get_den());
  Form form;
  form.reserve(x.size());
  for (const Rational& coordinate : x) {
    form.emplace_back(coordinate.get_num() * (den / coordinate.get_den()));
  }
  const Integer divisor = make_primitive(form);
  if (scale != nullptr) {
    *scale = Rational(divisor, den);
    scale->canonicalize();
  }
  return form;
}

std::vector<Form> make_forms(const std::vector<Vector>& vectors, Rational* scale) {
  Vector all;
  for (const Vector& v : vectors) all.insert(all.end(), v.begin(), v.end());
  const Form form = make_form(all, scale);
  std::vector<Form> forms;
  auto next = form.begin();
  for (const Vector& v : vectors) {
    const auto end = next + static_cast<std::ptrdiff_t>(v.size());
    forms.emplace_back(next, end);
    next = end;
  }
  return forms;
}

Form negative(Form a) {
  for (Integer& coordinate : a) coordinate = -coordinate;
  return a;
}

Integer dot(const Form& a, const Form& b) {
  Integer sum;
  add_dot(sum, a, b);
  return sum;
}

int sign_of_dot(const Form& a, const Form& b) {
  static thread_local Integer sum;  // most of the time goes here, and its memory is kept
  sum = 0;
  add_dot(sum, a, b);
  return sgn(sum);
}

Rational dot(const Vector& a, const Vector& b) {
  Rational sum;
  for (std::size_t j = 0; j < std::min(a.size(), b.size()); ++j) sum += a[j] * b[j];
  return sum;
}

void add(Vector& sum, const Rational& factor, const Vector& v) {
  for (std::size_t j = 0; j < v.size(); ++j) sum[j] += factor * v[j];
}

Vector cross(const Vector& a, const Vector& b) {
  Vector result;
  for (std::size_t j = 0; j < 3; ++j) {
    const std::size_t k = (j + 1) % 3;
    const std::size_t l = (j + 2) % 3;
    result.emplace_back(a[k] * b[l] - a[l] * b[k]);
  }
  return result;
}

void PairwiseSum::add(Vector v) {
  for (std::size_t bits = count_++; bits % 2 == 1; bits /= 2) {
    for (std::size_t j = 0; j < v.size(); ++j) v[j] += partial_.back()[j];
    partial_.pop_back();
  }
  partial_.push_back(std::move(v));
}

Vector PairwiseSum::total() const {
  Vector sum = partial_.back();
  for (std::size_t k = partial_.size() - 1; k-- > 0;) {
    for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += partial_[k][j];
  }
  return sum;
}

std::string show(const Rational& x) {
  constexpr std::size_t kMaxShown = 60;
  const std::string text = x.get_str();
  if (text.size() <= kMaxShown) return text;
  return text.substr(0, kMaxShown / 2) + "... (" + std::to_string(text.size()) + " characters)";
}

std::string show(const Vector& v) {
  constexpr std::size_t kMaxShown = 8;
  std::string text;
  for (std::size_t j = 0; j < std::min(v.size(), kMaxShown); ++j) {
    text += (j == 0 ? "" : ", ") + show(v[j]);
  }
  return "(" + text + (v.size() > kMaxShown ? ", ...)" : ")");
}

std::string show(const Bounds& bounds) {
  if (bounds.certain()) return show(bounds.low);
  return "[" + show(bounds.low) + ", " + show(bounds.high) + "]";
}

std::string show(const std::vector<Bounds>& v) {
  std::string text;
  for (const Bounds& bounds : v) text += (text.empty() ? "" : ", ") + show(bounds);
  return "(" + text + ")";
}

std::string printable(const std::string& text) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string shown;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c >= ' ' && c <= '~') {
      shown += c;
    } else {
      shown += {'\\', 'x', kDigits[byte >> 4U], kDigits[byte & 15U]};
    }
  }
  return shown;
}

std::string quote(const std::string& text) {
  constexpr std::size_t kMaxShown = 40;
  return '"' + printable(text.substr(0, kMaxShown)) +
         (text.size() > kMaxShown ? "...\"" : "\"");
}

}  // namespace stickslip_check
