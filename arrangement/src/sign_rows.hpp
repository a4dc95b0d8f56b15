// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Many sign vectors over the circles of an arrangement, two bits a sign.
///
/// The digit of a sign is its place in the order '+' < '-' < '0', and the digits of a row
/// stand in its words from the most significant bits down. Rows therefore compare as their
/// texts do by comparing words, and crossing a circle is one exclusive or.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "stickslip/core/sign.hpp"

namespace stickslip {

class SignRows {
 public:
  explicit SignRows(std::size_t circles);

  std::size_t circles() const { return circles_; }
  std::size_t size() const { return size_; }

  /// Appends a row of '+', or a copy of a row; gives its number.
  std::size_t add();
  std::size_t add_copy(std::size_t row);
  /// Appends a copy of packed signs (PackedSigns has the same encoding) over as many circles.
  std::size_t add_copy_of(const std::uint64_t* words);

  Sign get(std::size_t row, std::size_t circle) const {
    constexpr Sign kSignOfDigit[] = {Sign::kPositive, Sign::kNegative, Sign::kZero};
    return kSignOfDigit[(begin(row)[circle / kSignsPerWord] >> shift(circle)) & kDigitMask];
  }
  void set(std::size_t row, std::size_t circle, Sign sign);
  /// Writes the signs of a whole row, faster than by get().
  void unpack(std::size_t row, std::vector<Sign>& signs) const;

  /// Replaces '+' by '-' and '-' by '+' in one place. Requires a sign that is not '0'.
  void flip(std::size_t row, std::size_t circle);
  /// Does the same, in every row, for the marked circles, and leaves each '0' alone.
  void flip_all(const std::vector<bool>& marked_circles);

  /// Whether two rows without '0' differ in `circle` and nowhere else.
  bool differ_exactly_at(std::size_t row, std::size_t other, std::size_t circle) const;

  /// Sorts the rows as their texts sort and drops repetitions.
  void sort_and_unique();

 private:
  using Word = std::uint64_t;
  static constexpr std::size_t kSignsPerWord = 32;
  static constexpr Word kDigitMask = 3;

  static unsigned shift(std::size_t circle) {
    return static_cast<unsigned>(2 * (kSignsPerWord - 1 - circle % kSignsPerWord));
  }
  Word& word(std::size_t row, std::size_t circle) {
    return words_[row * width_ + circle / kSignsPerWord];
  }
  const Word* begin(std::size_t row) const { return words_.data() + row * width_; }

  std::size_t circles_;
  std::size_t width_;  ///< words a row; at least 1, so that a row without circles exists
  std::size_t size_ = 0;
  std::vector<Word> words_;
};

}  // namespace stickslip
