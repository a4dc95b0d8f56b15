// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// One question put to the passive model and to the earlier methods.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "numbers.hpp"
#include "stickslip/earlier/grasp_wrench_space.hpp"

namespace stickslip {

struct MethodRow {
  std::string method;
  std::string source;
  std::string verdict;
  /// Whether it says of the load what the passive model says. Nothing for the passive model
  /// itself, a method that asks about the grasp and not the load, or one without an answer.
  std::optional<bool> agrees;
  bool about_the_load = true;
  std::string why;  ///< one line, from the evidence
  Json evidence;
};

inline constexpr const char* kNotComputed = "not computed";

/// Beyond these contacts a grasp wrench space is not computed.
inline constexpr std::size_t kMostContactsForWrenchSpace = 64;

MethodRow form_closure_row(const Problem& problem, NumberText& text);
/// Not computed also when a normal has an irrational length.
MethodRow wrench_space_row(const Problem& problem, ForceBound bound, const Rational& length,
                           NumberText& text);

/// All methods, the passive model first. `length` is the characteristic length of wrench
/// spaces, and the radius of gyration about the origin for strong stability. Sentences have
/// their numbers from `text`.
std::vector<MethodRow> compare_methods(const Question& question, const Rational& length,
                                       NumberText& text);

}  // namespace stickslip
