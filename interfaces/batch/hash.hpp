// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A hash that tells texts apart. It proves nothing.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace stickslip::batch_detail {

/// The hash FNV-1a, 64 bits.
class Hash {
 public:
  void add(char c) { hash_ = (hash_ ^ static_cast<unsigned char>(c)) * 1099511628211ULL; }
  void add(std::string_view text) {
    for (const char c : text) add(c);
  }

  /// Returns 16 digits.
  std::string digits() const {
    constexpr const char* kDigits = "0123456789abcdef";
    std::string text;
    for (int shift = 60; shift >= 0; shift -= 4) text += kDigits[(hash_ >> shift) & 15U];
    return text;
  }

 private:
  std::uint64_t hash_ = 14695981039346656037ULL;
};

}  // namespace stickslip::batch_detail
