// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What earlier methods say, as `compare --json` and `margin --class --json` print it.
#pragma once

#include <vector>

#include "stickslip/core/number_text.hpp"
#include "stickslip/earlier/comparison.hpp"
#include "stickslip/earlier/friction_margin.hpp"
#include "stickslip/engine/question.hpp"

namespace stickslip {

/// Returns the answers of the methods, with their evidence, before finished().
Json comparison_json(const Question& question, const Rational& length, const Inertia& inertia,
                     const Comparison& comparison);

/// \{ Return the classes of the multiples of a load, or of the factors of all friction, before
/// finished().
Json classes_json(const Question& question, const Inertia& inertia,
                  const std::vector<ClassRange>& ranges);
Json classes_json(const Question& question, const Inertia& inertia,
                  const std::vector<FactorRange>& ranges);
/// \}

}  // namespace stickslip
