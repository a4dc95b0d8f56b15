// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How often a random test repeats, and which are left out under sanitizers, which look for
/// errors of another kind and make each take twenty times as long.
#pragma once

namespace stickslip::test {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// As many rounds as that; with sanitizers a quarter.
template <class Count>
constexpr Count rounds(Count count) {
  return kSanitized ? (count + 3) / 4 : count;
}

}  // namespace stickslip::test
