// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// One question put to the passive model and to the earlier methods, and what each says, in
/// words and with its evidence.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stickslip/core/number_text.hpp"
#include "stickslip/earlier/load_classes.hpp"
#include "stickslip/earlier/spatial_classes.hpp"

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

/// Which methods are asked, and what some of them need.
struct CompareOptions {
  std::vector<std::string> methods{};  ///< some of method_words(); all if empty
  Rational length = 1;                 ///< characteristic, of wrench spaces
  Inertia inertia{};                   ///< for strong stability
};

/// What the methods say.
struct Comparison {
  std::vector<MethodRow> methods;  ///< the passive model first
  /// "must move", "must hold" or "open" (load_classes.hpp), if weak and strong stability, or
  /// one of them, tell.
  std::optional<std::string> load_class;
  std::optional<Undecided> undecided{};  ///< in space: why there is no class
};

/// The names of all methods as a list without spaces spells them: "grasp-wrench-space-L1".
std::vector<std::string> method_words();

/// Asks the methods and no other. Sentences have their numbers from `text`; those on why a
/// method differs from the passive model need it asked. Throws InputError ("methods").
Comparison compare_methods(const Problem& problem, const CompareOptions& options,
                           NumberText& text);

/// The same of a point in space, but for the methods of the plane alone: throws InputError
/// ("methods") naming one that is asked for. Of the options the inertia is that given beside
/// them. `verdict`, if it is known, is not sought again.
Comparison compare_methods(const GraspBox& grasp, NormalLaw law, const CompareOptions& options,
                           const SpatialInertia& inertia, NumberText& text,
                           const SpatialRigidVerdict* verdict = nullptr);

}  // namespace stickslip
