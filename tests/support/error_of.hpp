// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "stickslip/core/error.hpp"

namespace stickslip::test {

/// The error that `act` throws, or one that says there was none.
template <class Act>
InputError error_of(const Act& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error;
  }
  return InputError("", "", "no error", "");
}

}  // namespace stickslip::test
