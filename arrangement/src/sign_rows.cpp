// SPDX-License-Identifier: GPL-3.0-or-later
#include "sign_rows.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace stickslip {
namespace {

constexpr std::uint64_t digit_of(Sign sign) {
  return sign == Sign::kPositive ? 0 : sign == Sign::kNegative ? 1 : 2;
}

using FourSigns = std::array<Sign, 4>;

/// The signs that each byte of digits spells. Some bytes have a digit 3, and are never met.
std::array<FourSigns, 256> signs_of_bytes() {
  constexpr Sign kSignOfDigit[] = {Sign::kPositive, Sign::kNegative, Sign::kZero, Sign::kZero};
  std::array<FourSigns, 256> result{};
  for (std::size_t byte = 0; byte < 256; ++byte) {
    for (std::size_t i = 0; i < 4; ++i)
      result[byte][i] = kSignOfDigit[(byte >> (6 - 2 * i)) & 3];
  }
  return result;
}

}  // namespace

SignRows::SignRows(std::size_t circles)
    : circles_(circles),
      width_(std::max<std::size_t>(1, (circles + kSignsPerWord - 1) / kSignsPerWord)) {}

std::size_t SignRows::add() {
  words_.resize(words_.size() + width_, 0);
  return size_++;
}

std::size_t SignRows::add_copy(std::size_t row) {
  const std::size_t result = add();
  std::copy_n(begin(row), width_,
              words_.begin() + static_cast<std::ptrdiff_t>(result * width_));
  return result;
}

std::size_t SignRows::add_copy_of(const std::uint64_t* words) {
  words_.insert(words_.end(), words, words + width_);
  return size_++;
}

void SignRows::set(std::size_t row, std::size_t circle, Sign sign) {
  Word& w = word(row, circle);
  w = (w & ~(kDigitMask << shift(circle))) | (digit_of(sign) << shift(circle));
}

void SignRows::unpack(std::size_t row, std::vector<Sign>& signs) const {
  static const std::array<FourSigns, 256> kSignsOfByte = signs_of_bytes();
  constexpr unsigned kFirstByte = 2 * kSignsPerWord - 8;
  signs.resize(circles_);
  std::size_t c = 0;
  for (const Word* word = begin(row); c < circles_; ++word) {
    Word rest = *word;
    const std::size_t end = std::min(circles_, c + kSignsPerWord);
    for (; c + 4 <= end; c += 4, rest <<= 8) {
      std::copy_n(kSignsOfByte[rest >> kFirstByte].begin(), 4, signs.data() + c);
    }
    std::copy_n(kSignsOfByte[rest >> kFirstByte].begin(), end - c, signs.data() + c);
    c = end;
  }
}

void SignRows::flip(std::size_t row, std::size_t circle) {
  word(row, circle) ^= Word{1} << shift(circle);
}

void SignRows::flip_all(const std::vector<bool>& marked_circles) {
  std::vector<Word> mask(width_, 0);
  for (std::size_t c = 0; c < circles_; ++c) {
    if (marked_circles[c]) mask[c / kSignsPerWord] |= Word{1} << shift(c);
  }
  for (std::size_t i = 0; i < words_.size(); ++i) {
    // The upper bit of a digit is set for '0' only: there the mask is cleared.
    words_[i] ^= mask[i % width_] & ~(words_[i] >> 1);
  }
}

bool SignRows::differ_exactly_at(std::size_t row, std::size_t other, std::size_t circle) const {
  for (std::size_t w = 0; w < width_; ++w) {
    const Word expected = w == circle / kSignsPerWord ? Word{1} << shift(circle) : 0;
    if ((begin(row)[w] ^ begin(other)[w]) != expected) return false;
  }
  return true;
}

void SignRows::sort_and_unique() {
  std::vector<std::size_t> order(size_);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto less = [this](std::size_t a, std::size_t b) {
    return std::lexicographical_compare(begin(a), begin(a) + width_, begin(b),
                                        begin(b) + width_);
  };
  const auto equal = [this](std::size_t a, std::size_t b) {
    return std::equal(begin(a), begin(a) + width_, begin(b));
  };
  std::sort(order.begin(), order.end(), less);
  order.erase(std::unique(order.begin(), order.end(), equal), order.end());

  std::vector<Word> sorted;
  sorted.reserve(order.size() * width_);
  for (const std::size_t row : order) {
    sorted.insert(sorted.end(), begin(row), begin(row) + width_);
  }
  words_ = std::move(sorted);
  size_ = order.size();
}

}  // namespace stickslip
