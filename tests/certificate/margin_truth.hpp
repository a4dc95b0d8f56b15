// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Whether the intervals of a margin certificate are true, by `decide` at single loads.
#pragma once

#include <string>

#include "both_checkers.hpp"

namespace stickslip::test {

/// Empty if the verdicts at the ends of all intervals, close to them on either side, between
/// them and far above are as the certificate claims; else which load it is wrong about. Throws
/// what reading a malformed certificate throws.
std::string lie_of(const CheckerInput& margin);

}  // namespace stickslip::test
