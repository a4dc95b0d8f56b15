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
  std::vector<std::string> methods{};     ///< some of method_words(); all if empty
  Rational length = 1;                    ///< characteristic, of wrench spaces
  Inertia inertia{};                      ///< for strong stability, in as many coordinates
  const RigidVerdict* verdict = nullptr;  ///< if it is known it is not sought again
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

/// Asks the methods and no other of one grasp. Sentences have their numbers from `text`; those
/// on why a method differs from the passive model need it asked. Throws InputError ("methods"),
/// in space also for a method of the plane alone that is asked for; and as problem_of() and
/// point_in_space().
Comparison compare_methods(const Question& question, const CompareOptions& options,
                           NumberText& text);

}  // namespace stickslip
