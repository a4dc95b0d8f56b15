// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The signs of all planes on one cell, two bits a plane: what the streaming enumerator hands
/// out, so that no table of all sign vectors has to exist.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "stickslip/arrangement/slip_states.hpp"
#include "stickslip/core/sign.hpp"

namespace stickslip {

/// A view of packed signs that belong to somebody else.
///
/// Plane p has the digit 0 for '+', 1 for '-', 2 for '0': its sign's place in the order of
/// texts. Digit p stands in word p / 32, the first plane of a word in its most significant
/// bits; unused digits are 0. So two vectors over the same planes compare as their texts do
/// by comparing words from the first to the last, and are equal iff their words are.
class PackedSigns {
 public:
  using Word = std::uint64_t;                       ///< holds the digits
  static constexpr std::size_t kSignsPerWord = 32;  ///< at two bits each

  /// At least one word, also for no plane.
  static constexpr std::size_t words_for(std::size_t planes) {
    return planes == 0 ? 1 : (planes + kSignsPerWord - 1) / kSignsPerWord;
  }
  /// How far left the digit of `plane` stands in its word.
  static constexpr unsigned shift_of(std::size_t plane) {
    return static_cast<unsigned>(2 * (kSignsPerWord - 1 - plane % kSignsPerWord));
  }

  /// Of words_for(planes) words at `words`, which must outlive the view.
  PackedSigns(const Word* words, std::size_t planes) : words_(words), planes_(planes) {}

  std::size_t size() const { return planes_; }  ///< number of planes
  /// The sign of `plane`, which must be below size(). O(1).
  Sign operator[](std::size_t plane) const {
    constexpr Sign kSignOfDigit[] = {Sign::kPositive, Sign::kNegative, Sign::kZero};
    return kSignOfDigit[(words_[plane / kSignsPerWord] >> shift_of(plane)) & 3];
  }

  const Word* words() const { return words_; }                   ///< the digits, word_count()
  std::size_t word_count() const { return words_for(planes_); }  ///< at least 1

  /// A copy that owns its signs. O(size()).
  SlipState unpack() const {
    SlipState state(planes_, Sign::kZero);
    for (std::size_t p = 0; p < planes_; ++p) state[p] = (*this)[p];
    return state;
  }

  /// The same planes and the same signs.
  friend bool operator==(const PackedSigns& a, const PackedSigns& b) {
    return a.planes_ == b.planes_ && std::equal(a.words_, a.words_ + a.word_count(), b.words_);
  }

 private:
  const Word* words_;
  std::size_t planes_;
};

}  // namespace stickslip
