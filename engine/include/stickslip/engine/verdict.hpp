// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Verdicts that own their evidence.
///
/// A Witness is judged by substitution, by `find_violation`; all evidence by the checkers in
/// certificate/, whose format (certificate/FORMAT.md) says what it means and why it proves the
/// verdict.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/engine/problem.hpp"
#include "stickslip/engine/proof.hpp"

namespace stickslip {

/// The coefficients of one contact's force a n + b t. For a unit normal these are (c_n, c_t).
struct ContactForce {
  Rational normal;      ///< a
  Rational tangential;  ///< b
};

/// a n + b t in the object frame, for a contact with this normal n (any length).
Vector2 force_vector(const Vector2& normal, const ContactForce& force);

/// An equilibrium.
struct Witness {
  Twist twist;                       ///< the motion d
  std::vector<ContactForce> forces;  ///< by ContactId
};

/// What has to be said of an equilibrium: all else follows from it (certificate/FORMAT.md,
/// section 3).
struct ShortWitness {
  Twist twist;  ///< the motion d
  /// b / (mu a) of contacts that stick under load, with friction; increasing. 0 is left out.
  std::vector<std::pair<ContactId, Rational>> shares;

  /// Exact.
  friend bool operator==(const ShortWitness& a, const ShortWitness& b) {
    return a.twist == b.twist && a.shares == b.shares;
  }
};

/// An equilibrium of one grasp in space, or of several bodies: all other forces follow from it.
struct ShareWitness {
  RationalRow twist;  ///< the motion d; of several bodies the state z
  /// sigma, with the friction mu a sigma, of contacts that stick; increasing. As many numbers
  /// as a slip has. 0 is left out.
  std::vector<std::pair<ContactId, RationalRow>> shares;
};

/// \{ What has to be said of this one, by contacts or their rows; preloads do not matter.
ShortWitness in_short(const std::vector<ContactRow>& rows, const Witness& witness);
ShortWitness in_short(const Grasp& grasp, const Witness& witness);
/// \}

/// Which condition of problem.hpp fails first, and where; nothing for an equilibrium. Not of a
/// family.
/// O(m) rational operations.
std::optional<std::string> find_violation(const Problem& problem, const Witness& witness);

/// An equilibrium exists: of every grasp of the box, if that is what was asked about.
struct Stable {
  /// One of them, which proves one grasp; or that there is one.
  std::variant<Witness, ShareWitness, StabilityProof> proof;
  /// Of a StabilityProof near an equilibrium of the grasp in the middle, of which the proof is
  /// about the first part or the only one; for people. Of a ShareWitness its own.
  RationalRow motion{};

  /// Of a grasp that was decided without degree, and in the plane.
  const Witness& witness() const { return std::get<Witness>(proof); }
};
/// No equilibrium exists, for any grasp.
struct Unstable {
  Trees tree;  ///< the proof
};
/// Two grasps of the box have opposite verdicts, and certificates of their own.
struct Fragile {
  GraspBox stable;    ///< one grasp of the box
  GraspBox unstable;  ///< another one
};
/// Neither was proved.
struct Undecided {
  std::string limit;             ///< why, a sentence without its end, for people
  std::string reason = "limit";  ///< the same in one word, for programs (docs/space.md)
  std::string remedy{};          ///< what to do, in words; may be empty
  /// A motion, from doubles, at which the laws seem to hold, though that was not proved; or
  /// empty.
  std::vector<Rational> near{};
};

/// The answer, which owns its evidence. One grasp is never Fragile.
using Verdict = std::variant<Stable, Unstable, Fragile, Undecided>;

/// "stable", "unstable", "fragile", "undecided".
const char* name_of(const Verdict& verdict);
/// The same of what is_stable() says; nothing is "undecided".
const char* verdict_name(std::optional<bool> stable);
/// Whether what was asked about is stable, or unstable; nothing if neither is proved.
std::optional<bool> is_stable(const Verdict& verdict);

/// For people: "<limit>; <remedy>".
std::string in_words(const Undecided& undecided);

}  // namespace stickslip
