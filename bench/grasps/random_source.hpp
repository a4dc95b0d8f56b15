// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The same numbers on every platform: std::mt19937_64 is specified to the bit, the
/// distributions of <random> are not.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

namespace stickslip::bench {

class RandomSource {
 public:
  explicit RandomSource(std::uint64_t seed) : engine_(seed) {}

  /// Uniform enough in [low, high].
  int between(int low, int high) {
    const auto count = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<int>(engine_() % count);
  }
  bool one_in(int n) { return between(1, n) == 1; }

  template <class T>
  const T& pick(const std::vector<T>& from) {
    return from[static_cast<std::size_t>(engine_() % from.size())];
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace stickslip::bench
