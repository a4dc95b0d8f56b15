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

/// The part of an equilibrium of one body in the plane from which all its forces follow
/// (certificate/FORMAT.md, section 3).
struct ShortWitness {
  Twist twist;  ///< the motion d
  /// The shares b / (mu a), in [-1, 1], of contacts that stick under load: the part that each
  /// uses of the largest friction it may have. They are in the order of ContactId; shares of 0
  /// are left out.
  std::vector<std::pair<ContactId, Rational>> shares;

  /// Compares exactly.
  friend bool operator==(const ShortWitness& a, const ShortWitness& b) {
    return a.twist == b.twist && a.shares == b.shares;
  }
};

/// The part of an equilibrium in space, or of several bodies, from which all forces follow.
struct ShareWitness {
  RationalRow twist;  ///< the motion d; the state z of several bodies
  /// The shares sigma of contacts that stick, whose friction force is f = mu a sigma. Each has
  /// 1 number in the plane, 3 in space, 4 with torsion. They are in the order of ContactId;
  /// shares of 0 are left out.
  std::vector<std::pair<ContactId, RationalRow>> shares;
};

/// \{ Returns the short form of an equilibrium. Only the tangents and friction coefficients of
/// the contacts, or of their rows, are read. Requires an equilibrium.
ShortWitness in_short(const std::vector<ContactRow>& rows, const Witness& witness);
ShortWitness in_short(const Grasp& grasp, const Witness& witness);
/// \}

/// Checks by substitution that the witness is an equilibrium of the problem. Returns nothing if
/// it is; else a text for people, which condition of problem.hpp fails first, and at which
/// contact. Throws ContractError if the problem is a family. Takes O(m) rational operations for
/// m contacts.
std::optional<std::string> find_violation(const Problem& problem, const Witness& witness);

/// An equilibrium exists. If the question was about a box, every grasp in it has one.
struct Stable {
  /// An equilibrium of one grasp, or a proof that one exists.
  std::variant<Witness, ShareWitness, StabilityProof> proof;
  /// The motion of an equilibrium, for people. With a StabilityProof, which may cut the box
  /// into parts, it is near the motion of an equilibrium of the grasp in the middle of the
  /// first part. With a ShareWitness it is that of the witness; with a Witness it is empty.
  RationalRow motion{};

  /// Returns the witness. Requires that the proof is one, as it is for one exact grasp in the
  /// plane unless an equilibrium would be too long to state.
  const Witness& witness() const { return std::get<Witness>(proof); }
};
/// No equilibrium exists, for any grasp that was asked about.
struct Unstable {
  Trees tree;  ///< the proof
};
/// Two grasps of the box have opposite verdicts. For their certificates decide each of the two.
struct Fragile {
  GraspBox stable;    ///< a grasp of the box that is stable
  GraspBox unstable;  ///< a grasp of the box that is not
};
/// Neither stability nor instability was proved.
struct Undecided {
  std::string limit;             ///< the cause, for people: a sentence without its full stop
  std::string reason = "limit";  ///< the same in one word, for programs (docs/space.md)
  std::string remedy{};          ///< what may help, for people; may be empty
  /// A motion, from doubles, at which the laws seem to hold, though that was not proved; may be
  /// empty.
  std::vector<Rational> near{};
};

/// The answer, which owns its evidence. One grasp is never Fragile.
using Verdict = std::variant<Stable, Unstable, Fragile, Undecided>;

/// Returns "stable", "unstable", "fragile" or "undecided".
const char* name_of(const Verdict& verdict);
/// Returns the word for a result of is_stable(): "stable" for true, "unstable" for false, and
/// "undecided" for nothing.
const char* verdict_name(std::optional<bool> stable);
/// Returns true if all that was asked about is stable, false if all is unstable, and nothing
/// for Fragile and Undecided.
std::optional<bool> is_stable(const Verdict& verdict);

/// Returns "<limit>; <remedy>", for people.
std::string in_words(const Undecided& undecided);

}  // namespace stickslip
