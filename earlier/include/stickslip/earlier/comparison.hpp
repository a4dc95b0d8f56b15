// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The answers of the passive model and of the earlier methods to one question, in words and
/// with their evidence.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stickslip/core/number_text.hpp"
#include "stickslip/core/time_limit.hpp"
#include "stickslip/earlier/load_classes.hpp"
#include "stickslip/earlier/robustness.hpp"

namespace stickslip {

/// The answer of one method.
struct MethodRow {
  std::string method;           ///< its name
  std::string source;           ///< who proposed it
  bool about_the_load = false;  ///< whether it asks about the load; else it asks about the
                                ///< grasp alone
  /// In the method's own terms, or kNotComputed; of a measure its bounds.
  std::string verdict;
  std::string why;  ///< one line, from the evidence
  Json evidence;    ///< the evidence, to be finished
  /// Whether the method says of the load what the passive model says. Nothing for the passive
  /// model itself, for a method that asks about the grasp and not the load, and for one without
  /// an answer.
  std::optional<bool> agrees;
};

/// The verdict of a method that would take too long, or does not apply.
inline constexpr const char* kNotComputed = "not computed";

/// The methods to ask, and what some of them need.
struct CompareOptions {
  std::vector<std::string> methods{};  ///< some of method_words(); all if empty
  Rational length = 1;                 ///< the characteristic length of wrench spaces
  Inertia inertia{};  ///< the inertia of strong stability, in as many coordinates as the grasp
  const RigidVerdict* verdict = nullptr;  ///< the verdict on the class of the load, if it is
                                          ///< known; it is not sought again
  /// The largest normal force, of PCR and PGR: one for all contacts, or one for each.
  std::vector<Rational> most_forces{1};
  Rational accuracy = {1, 100};   ///< how near the bounds of PCR and PGR are to be
  std::size_t node_limit = 5000;  ///< the most nodes of the search for PGR
  /// In space, the edges of pyramids in place of cones, of PCR, PGR, the volume of the wrench
  /// space, the least normal forces and the margin of internal forces; 0: round cones.
  std::size_t edges = 0;
  TimeLimit time{};  ///< the limit of all methods together
  /// The value of the only method, if that is PCR or PGR and known; it is not sought again.
  const Robustness* robustness = nullptr;

  /// Returns which of PCR and PGR is the only method, if one is.
  std::optional<RobustnessKind> only_robustness() const;
  /// Returns what PCR and PGR need of these.
  RobustnessOptions for_robustness() const;
};

/// The answers of the methods.
struct Comparison {
  std::vector<MethodRow> methods;  ///< the passive model first
  /// "must move", "must hold" or "open" (load_classes.hpp), if weak and strong stability, or
  /// one of them, tell.
  std::optional<std::string> load_class;
  std::optional<Undecided> undecided{};  ///< in space: why there is no class
};

/// Returns the names of all methods as a list without spaces spells them,
/// "grasp-wrench-space-L1", and the short names PCR and PGR.
std::vector<std::string> method_words();

/// Throws InputError ("methods") at a word that is none of these.
void check_methods(const std::vector<std::string>& words);

/// Asks only the methods of `options` about one grasp. Sentences have their numbers from
/// `text`. They say why a method differs from the passive model only if that is asked, too.
/// Throws InputError ("methods") at a word of no method, or in space at one of the plane alone,
/// ("max_force") at another number of largest forces, and ("edges") at edges in the plane,
/// below 3 or above 64; also throws as problem_of() and point_in_space() do.
Comparison compare_methods(const Question& question, const CompareOptions& options,
                           NumberText& text);

/// Returns PCR or PGR of one grasp, to be proved. Throws InputError as compare_methods() does,
/// where that does not compute it, and ("edges") of pyramids.
Robustness robustness_to_prove(const Question& question, RobustnessKind kind,
                               const CompareOptions& options);

}  // namespace stickslip
