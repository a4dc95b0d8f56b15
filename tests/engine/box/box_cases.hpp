// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Questions about boxes, and single grasps of a box.
#pragma once

#include <string>

#include "both_checkers.hpp"
#include "random_grasps.hpp"
#include "stickslip/engine/box_verdict.hpp"

namespace stickslip::test {

/// A box, as a user asks about it.
struct BoxCase {
  std::string grasp;  ///< the text of the file
  QuestionOptions options{};

  Question question() const;
  /// Requires that it is a box.
  GraspBox box() const { return question().grasp.as_box(); }
  BoxDecision decide() const { return decide_box(box(), options.law); }
};

/// For failure messages.
std::string describe(const BoxCase& box_case);

/// What is uncertain of a random case.
enum class Uncertain {
  kFriction,  ///< by tolerance
  kAll,       ///< by tolerance
  kWrench,    ///< by tolerance
  kInFile,    ///< numbers of every kind, by intervals in the file
  kLengths    ///< lengths of preloaded normals, which are irrational; in half of the cases
              ///< friction too
};

/// A generic_grasp of 3 to 6 contacts with a load of 50 to 120 % of its margin along a random
/// direction (kLengths: any small load).
BoxCase random_box(RandomSource& random, Uncertain uncertain);

/// At the left and the right of a body, with friction of 2/5 to 3/5; in space if the load is.
GraspBox two_pads(const Interval& preload, WrenchBox load);

/// The file of a box with all of its intervals in it.
std::string file_of(const GraspBox& box);

/// A random grasp of the box, in half of the cases at a corner. Preloaded normals whose length
/// is rational are turned so that it stays so, at corners by almost all of the slope.
LoadedGrasp sample(RandomSource& random, const GraspBox& box);

/// Whether the grasp is one of the box.
bool lies_in(const LoadedGrasp& grasp, const GraspBox& box);

/// "stable" or "unstable" by decide(); of a grasp with a preloaded normal of irrational length
/// by decide_box(), which may say "undecided".
std::string verdict_of(const LoadedGrasp& grasp, NormalLaw law);

}  // namespace stickslip::test
