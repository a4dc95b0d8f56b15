// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Verdicts on boxes, in words; and two grasps of a box with opposite verdicts: how answers
/// show and write them.
#pragma once

#include <string>
#include <vector>

#include "box_numbers.hpp"
#include "stickslip/box/box_verdict.hpp"
#include "stickslip/certificate/proved_files.hpp"

namespace stickslip {

/// What a verdict means. `is_wide`: some number is an interval.
struct Meaning {
  bool is_wide;  ///< of the question

  std::string operator()(const StableThroughout& stable) const;      ///< with how it is proved
  std::string operator()(const UnstableThroughout& unstable) const;  ///< likewise
  std::string operator()(const Undecided& undecided) const;          ///< and what to do
  /// Whatever fragile_text() says.
  std::string operator()(const Fragile& /*fragile*/) const { return ""; }
};

/// What a fragile box is, and a table. `examples`: the folder to which both grasps are written;
/// may be empty.
std::string fragile_text(const std::vector<Difference>& differences, NumberText& text,
                         const std::string& examples);

/// Says on standard error that there are none: what was asked about, a box or one grasp, has
/// this verdict.
void say_no_examples(bool is_box, const std::string& verdict);

/// stable.json and unstable.json, each with its certificate, for --examples; or
/// say_no_examples().
void write_two_examples(const std::string& folder, const GraspBox& box, NormalLaw law,
                        const BoxVerdict& verdict, const std::string& producer);

}  // namespace stickslip
