// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Division by zero is refused in one way, for integers and rationals.
#pragma once

#include <stdexcept>

namespace stickslip::core_detail {

[[noreturn]] inline void divide_by_zero() {
  throw std::overflow_error("Division by zero.");
}

}  // namespace stickslip::core_detail
