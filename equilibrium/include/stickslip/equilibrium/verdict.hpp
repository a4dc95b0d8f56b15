// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Verdicts that own their evidence.
///
/// Both kinds of evidence are judged by substitution: a Witness by `find_violation`, a
/// Refutation by the checkers in certificate/, whose format (certificate/FORMAT.md) says
/// what each node means and why a tree of them proves that no equilibrium exists.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/equilibrium/problem.hpp"

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

/// An equilibrium of one grasp in space: all other forces follow from it.
struct SpatialWitness {
  Vector6 twist;  ///< the motion d
  /// sigma, with the friction mu a sigma, of contacts that stick; increasing. 0 is left out.
  std::vector<std::pair<ContactId, Vector3>> shares;
};

/// \{ What has to be said of this one, by contacts or their rows; preloads do not matter.
ShortWitness in_short(const std::vector<ContactRow>& rows, const Witness& witness);
ShortWitness in_short(const Grasp& grasp, const Witness& witness);
/// \}

/// Which condition of problem.hpp fails first, and where; nothing for an equilibrium. Not of a
/// family.
/// O(m) rational operations.
std::optional<std::string> find_violation(const Problem& problem, const Witness& witness);

/// Three children: slip +, 0, - at a contact.
struct SlipSplit {
  ContactId contact;  ///< split by tau_i
};
/// Two children: closed, open.
struct SeparationSplit {
  ContactId contact;  ///< split by v_i
};
/// Two children: plane.x >= 0, plane.x <= 0.
struct PlaneSplit {
  IntegerVector5 plane;  ///< nonzero
};
/// A virtual twist on which no force of the region makes up for the load. It is 0 where the
/// region is void: no solution can lie there, or another child covers it.
struct VirtualWorkLeaf {
  IntegerVector3 twist;  ///< y, in coordinates (x, y, r)
};

/// Three kinds of split, and a leaf.
using RefutationNode = std::variant<SlipSplit, SeparationSplit, PlaneSplit, VirtualWorkLeaf>;

/// A tree in preorder, as in certificate/FORMAT.md, section 4.
using Refutation = std::vector<RefutationNode>;

/// An equilibrium exists.
struct Stable {
  Witness witness;  ///< one of them
};
/// No equilibrium exists.
struct Unstable {
  Refutation refutation;  ///< the proof
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

/// The answer, which owns its evidence.
using Verdict = std::variant<Stable, Unstable, Undecided>;

/// "stable", "unstable", "undecided".
const char* name_of(const Verdict& verdict);

/// For people: "<limit>; <remedy>".
std::string in_words(const Undecided& undecided);

}  // namespace stickslip
