// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// One question put to the passive model and to the earlier methods, and what each says, in
/// words and with its evidence.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stickslip/core/number_text.hpp"
#include "stickslip/equilibrium/problem.hpp"

namespace stickslip {

/// The answer of one method.
struct MethodRow {
  std::string method;           ///< its name
  std::string source;           ///< who proposed it
  bool about_the_load = false;  ///< else it asks about the grasp, whatever the load
  std::string verdict;          ///< in the method's own terms, or kNotComputed
  std::string why;              ///< one line, from the evidence
  Json evidence;                ///< to be finished
  /// Whether it says of the load what the passive model says. Nothing for the passive model
  /// itself, a method that asks about the grasp and not the load, or one without an answer.
  std::optional<bool> agrees;
};

/// The verdict of a method that would take too long, or does not apply.
inline constexpr const char* kNotComputed = "not computed";

/// All methods, the passive model first. `length` is the characteristic length of wrench
/// spaces, and the radius of gyration about the origin for strong stability. Sentences have
/// their numbers from `text`.
std::vector<MethodRow> compare_methods(const Problem& problem, const Rational& length,
                                       NumberText& text);

}  // namespace stickslip
