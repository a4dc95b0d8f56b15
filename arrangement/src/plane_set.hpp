// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Sets of planes as bits in a fixed number of words.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace stickslip::arrangement_detail {

/// A set of numbers below 64 * words.
template <std::size_t words>
struct PlaneSet {
  std::array<std::uint64_t, words> word{};

  bool get(std::size_t i) const { return (word[i / 64] >> (i % 64) & 1) != 0; }
  void set(std::size_t i) { word[i / 64] |= std::uint64_t{1} << (i % 64); }

  bool any() const {
    std::uint64_t all = 0;
    for (const std::uint64_t w : word) all |= w;
    return all != 0;
  }
  /// Returns whether all of `other` is in this set.
  bool contains(const PlaneSet& other) const {
    std::uint64_t missing = 0;
    for (std::size_t i = 0; i < words; ++i) missing |= other.word[i] & ~word[i];
    return missing == 0;
  }
  int count() const {
    int result = 0;
    for (const std::uint64_t w : word) result += __builtin_popcountll(w);
    return result;
  }
  /// Returns the least number of a set that is not empty.
  std::size_t first() const {
    std::size_t i = 0;
    while (word[i] == 0) ++i;
    return 64 * i + static_cast<std::size_t>(__builtin_ctzll(word[i]));
  }

  PlaneSet& operator|=(const PlaneSet& b) {
    for (std::size_t i = 0; i < words; ++i) word[i] |= b.word[i];
    return *this;
  }
  friend PlaneSet operator|(PlaneSet a, const PlaneSet& b) { return a |= b; }
  friend PlaneSet operator&(PlaneSet a, const PlaneSet& b) {
    for (std::size_t i = 0; i < words; ++i) a.word[i] &= b.word[i];
    return a;
  }
  friend PlaneSet operator-(PlaneSet a, const PlaneSet& b) {
    for (std::size_t i = 0; i < words; ++i) a.word[i] &= ~b.word[i];
    return a;
  }
  friend bool operator==(const PlaneSet& a, const PlaneSet& b) { return a.word == b.word; }
};

/// Calls `use` for each number of a set, from the least.
template <std::size_t words, class Use>
void for_each_bit(const PlaneSet<words>& bits, Use use) {
  for (std::size_t i = 0; i < words; ++i) {
    for (std::uint64_t w = bits.word[i]; w != 0; w &= w - 1) {
      use(64 * i + static_cast<std::size_t>(__builtin_ctzll(w)));
    }
  }
}

}  // namespace stickslip::arrangement_detail
