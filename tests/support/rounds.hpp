// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How often a random test repeats.
#pragma once

namespace stickslip::test {

/// As many rounds as that; with sanitizers, which look for errors of another kind and make each
/// take twenty times as long, a quarter.
template <class Count>
constexpr Count rounds(Count count) {
#if defined(__SANITIZE_ADDRESS__)
  return (count + 3) / 4;
#else
  return count;
#endif
}

}  // namespace stickslip::test
