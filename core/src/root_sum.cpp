// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/root_sum.hpp"

#include <algorithm>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

constexpr unsigned kFirstBits = 96;

}  // namespace

RootSum::RootSum(const Rational& value) {
  if (!value.is_zero()) terms_.push_back({value, 1});
}

RootSum RootSum::root(const Rational& factor, const Rational& radicand) {
  if (const auto length = exact_sqrt(radicand)) return factor * *length;
  RootSum result;
  if (!factor.is_zero()) result.terms_.push_back({factor, radicand});
  return result;
}

std::optional<Rational> RootSum::rational() const {
  if (terms_.empty()) return Rational(0);
  if (terms_.size() == 1 && terms_[0].radicand == 1) return terms_[0].factor;
  return std::nullopt;
}

std::optional<Rational> RootSum::rational_square() const {
  if (terms_.empty()) return Rational(0);
  // A sum of two or three terms has an irrational square: the roots of the products in pairs
  // are irrational, and so are their quotients, so that they do not cancel.
  require(terms_.size() <= 3, "rational_square of more than three roots");
  if (terms_.size() > 1) return std::nullopt;
  return terms_[0].factor * terms_[0].factor * terms_[0].radicand;
}

RootSum& RootSum::operator+=(const RootSum& other) {
  for (const Term& added : other.terms_) {
    bool is_added = false;
    for (std::size_t i = 0; i < terms_.size() && !is_added; ++i) {
      const auto quotient = exact_sqrt(added.radicand / terms_[i].radicand);
      if (!quotient) continue;
      is_added = true;
      terms_[i].factor += added.factor * *quotient;
      if (terms_[i].factor.is_zero()) {
        terms_.erase(terms_.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
    if (!is_added) terms_.push_back(added);
  }
  return *this;
}

RootSum RootSum::operator-() const {
  RootSum result = *this;
  for (Term& term : result.terms_) term.factor = -term.factor;
  return result;
}

std::pair<Rational, Rational> RootSum::between(unsigned bits) const {
  std::pair<Rational, Rational> sum;
  for (const auto& [factor, radicand] : terms_) {
    const ShortRoot root = short_sqrt(radicand, bits);
    const bool is_negative = factor.sign() < 0;
    sum.first += factor * (is_negative ? root.upper : root.lower);
    sum.second += factor * (is_negative ? root.lower : root.upper);
  }
  return sum;
}

int RootSum::sign() const {
  if (terms_.empty()) return 0;
  const int first = terms_.front().factor.sign();
  if (std::all_of(terms_.begin(), terms_.end(),
                  [first](const Term& term) { return term.factor.sign() == first; })) {
    return first;
  }
  // The loop ends, as the sum is not 0.
  for (unsigned bits = kFirstBits;; bits *= 2) {
    const auto [low, high] = between(bits);
    if (low.sign() > 0) return 1;
    if (high.sign() < 0) return -1;
  }
}

RootSum magnitude(const RootSum& value) {
  return value.sign() < 0 ? -value : value;
}

DecimalEnclosure enclose(const RootSum& value, int digits) {
  if (value.terms().empty()) return {"0", "0"};
  if (value.terms().size() == 1) {
    return enclose_sqrt(value.terms()[0].factor, value.terms()[0].radicand, digits);
  }
  // The sum is irrational, so it is strictly between two neighbouring decimals, and so are both
  // bounds once they are close enough.
  for (unsigned bits = kFirstBits;; bits *= 2) {
    const auto [low, high] = value.between(bits);
    if (low.sign() != high.sign()) continue;
    DecimalEnclosure below = enclose_sqrt(low, 1, digits);
    const DecimalEnclosure above = enclose_sqrt(high, 1, digits);
    if (below.lower == above.lower && below.upper == above.upper) return below;
  }
}

std::string to_readable_string(const RootSum& value) {
  if (const auto rational = value.rational()) return to_readable_string(*rational);
  if (value.terms().size() == 1) {
    return to_readable_string(value.terms()[0].factor, value.terms()[0].radicand);
  }
  // The sum is irrational. Once both bounds are close enough they round as it does, and then
  // neither is a number of few digits.
  for (unsigned bits = kFirstBits;; bits *= 2) {
    const auto [low, high] = value.between(bits);
    std::string text = to_readable_string(low);
    if (text.front() == kRounded && text == to_readable_string(high)) return text;
  }
}

}  // namespace stickslip
