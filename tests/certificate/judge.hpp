// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A third opinion on certificates, by substitution and by tests/support/naive_region.hpp:
/// every rule of certificate/FORMAT.md but `question-normals`, in the slow and literal way.
#pragma once

#include <optional>

#include "both_checkers.hpp"

namespace stickslip::test {

/// Accepted or rejected, with rule and node but without the path. Nothing where it has no
/// opinion: certificates that are malformed, that hold JSON integers beyond 64 bits, that
/// replace normals other than as `ask` does; and questions that cannot be asked.
std::optional<CheckerAnswer> third_opinion(const CheckerInput& input);

}  // namespace stickslip::test
