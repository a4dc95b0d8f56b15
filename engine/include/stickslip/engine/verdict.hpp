// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Verdicts that own their evidence.
///
/// `find_violation` judges a Witness by substitution. The checkers in certificate/ judge all
/// evidence; their format (certificate/FORMAT.md) says what it means and why it proves the
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

/// The coefficients of the force a n + b t of a contact on the object, with t = (-n_y, n_x). If
/// |n| = 1 they are the normal force c_n and the tangential force c_t of the paper.
struct ContactForce {
  Rational normal;      ///< a
  Rational tangential;  ///< b
};

/// Returns a n + b t in the object frame, for a contact with this normal n of any length.
Vector2 force_vector(const Vector2& normal, const ContactForce& force);

/// An equilibrium.
struct Witness {
  Twist twist;                       ///< the motion d
  std::vector<ContactForce> forces;  ///< the force of each contact, by ContactId
};

/// The part of an equilibrium from which all else follows (certificate/FORMAT.md, section 3).
struct ShortWitness {
  Twist twist;  ///< the motion d
  /// The shares b / (mu a) of contacts with friction that stick under load, by increasing
  /// ContactId. Shares of 0 are left out.
  std::vector<std::pair<ContactId, Rational>> shares;

  /// Compares exactly.
  friend bool operator==(const ShortWitness& a, const ShortWitness& b) {
    return a.twist == b.twist && a.shares == b.shares;
  }
};

/// The part of an equilibrium in space, or of several bodies, from which all forces follow.
struct ShareWitness {
  RationalRow twist;  ///< the motion d; the state z of several bodies
  /// The shares sigma of contacts that stick, whose friction is mu a sigma, by increasing
  /// ContactId. Each has 1 number in the plane, 3 in space, 4 with torsion. Shares of 0 are
  /// left out.
  std::vector<std::pair<ContactId, RationalRow>> shares;
};

/// \{ Returns the short form of an equilibrium, from contacts or their rows. The result does
/// not depend on preloads. Requires an equilibrium.
ShortWitness in_short(const std::vector<ContactRow>& rows, const Witness& witness);
ShortWitness in_short(const Grasp& grasp, const Witness& witness);
/// \}

/// Returns a text for people: which condition of problem.hpp fails first, and at which contact;
/// nothing for an equilibrium. Requires that the problem is no margin's. Takes O(m) rational
/// operations for m contacts.
std::optional<std::string> find_violation(const Problem& problem, const Witness& witness);

/// An equilibrium exists. If the question was about a box, every grasp in it has one.
struct Stable {
  /// An equilibrium of one grasp, or a proof that one exists.
  std::variant<Witness, ShareWitness, StabilityProof> proof;
  /// The motion of an equilibrium, for people. A StabilityProof cuts the box into parts: it is
  /// near an equilibrium of the grasp in the middle of the first part. With a ShareWitness it
  /// is that of the witness; with a Witness it is empty.
  RationalRow motion{};

  /// Returns the witness. Requires that the proof is one, as it is for one exact grasp in the
  /// plane unless an equilibrium would be too long to state.
  const Witness& witness() const { return std::get<Witness>(proof); }
};
/// No equilibrium exists, for any grasp that was asked about.
struct Unstable {
  Trees tree;  ///< the proof
};
/// Two grasps of the box have opposite verdicts. Their certificates are had by deciding each.
struct Fragile {
  GraspBox stable;    ///< a grasp of the box that is stable
  GraspBox unstable;  ///< a grasp of the box that is not
};
/// Neither stability nor instability was proved.
struct Undecided {
  std::string limit;             ///< the cause, a sentence without its full stop, for people
  std::string reason = "limit";  ///< the same in one word, for programs (docs/space.md)
  std::string remedy{};          ///< the remedy in words; may be empty
  /// A motion, from doubles, at which the laws seem to hold, though that was not proved; may be
  /// empty.
  std::vector<Rational> near{};
};

/// The answer, which owns its evidence. One grasp is never Fragile.
using Verdict = std::variant<Stable, Unstable, Fragile, Undecided>;

/// Returns "stable", "unstable", "fragile" or "undecided".
const char* name_of(const Verdict& verdict);
/// Returns the word for what is_stable() says: "stable", "unstable", or "undecided" for
/// nothing.
const char* verdict_name(std::optional<bool> stable);
/// Returns true if all that was asked about is stable, false if all is unstable, and nothing if
/// neither is proved.
std::optional<bool> is_stable(const Verdict& verdict);

/// Returns "<limit>; <remedy>", for people.
std::string in_words(const Undecided& undecided);

}  // namespace stickslip
