// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What earlier methods say, as `compare --json` and `margin --class --json` print it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stickslip/core/number_text.hpp"
#include "stickslip/earlier/comparison.hpp"
#include "stickslip/earlier/friction_margin.hpp"
#include "stickslip/engine/question.hpp"

namespace stickslip {

/// The values of options of a comparison; an option that is not given is empty.
struct ComparisonText {
  std::vector<std::string> methods;  ///< words of methods; none are all
  std::string length;                ///< the length by which torques are divided
  std::string inertia;               ///< the numbers of inertia_of()
  std::string max_force = "1";       ///< the largest normal forces
  std::string accuracy = "1%";       ///< the accuracy of PCR and PGR
  std::size_t edges = 0;             ///< the edges of pyramids; 0: round cones
};

/// A comparison, but for the grasp.
struct ComparisonAsked {
  CompareOptions options{};              ///< without the length and the inertia of a grasp
  std::optional<Rational> length{};      ///< the length, if it was given
  std::optional<RationalRow> inertia{};  ///< the numbers of the inertia, if they were given
};

/// Returns the comparison that they ask for. Throws InputError naming the option.
ComparisonAsked comparison_asked(const ComparisonText& text);

/// Returns the options for a grasp. Without a length it has characteristic_length(), and
/// without an inertia its mass about its origin, at that length. Throws InputError
/// ("--inertia") at that of a grasp in another number of coordinates.
CompareOptions options_for(const ComparisonAsked& asked, const Question& question);

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
