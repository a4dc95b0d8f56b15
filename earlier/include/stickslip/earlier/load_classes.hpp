// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The classes of loads of Pang and Trinkle, for rigid contacts: no springs, no preload.
///
/// - *Weakly stable*: some forces in the friction cones balance the load.
/// - *Frictionless stable*: some normal forces alone do.
/// - *Strongly stable*: whatever accelerations the rigid-body model allows, there is none.
///
/// So a body at rest *must hold* if its load is strongly stable, *must move* if the load is not
/// weakly stable, and between the model leaves it *open*: forces at rest and an acceleration
/// both satisfy it.
///
/// **The model.** The object is at rest, its contacts touch, M is its mass matrix. An
/// acceleration a and contact forces (c_n, c_t) satisfy
///
///     M a = w + sum (c_n,i N_i + c_t,i T_i),                                             (1)
///     0 <= c_n,i,   0 <= N_i.a,   c_n,i (N_i.a) = 0,                                     (2)
///     |c_t,i| <= mu_i c_n,i,   T_i.a > 0 => c_t,i = -mu_i c_n,i,   T_i.a < 0 => = +.     (3)
///
/// A load is weakly stable iff a solution with a = 0 exists, strongly stable iff every solution
/// has a = 0. A solution always exists (Pang and Trinkle), so strong implies weak. Frictionless
/// implies strong: -w = sum lambda_i N_i, lambda >= 0, gives w.a <= 0 for every a that
/// satisfies (2); and a solution with a != 0 has, by (1) times a,
///
///     0 < a.Ma = w.a - sum mu_i c_n,i |T_i.a| <= w.a.                                    (4)
///
/// **How strong stability is decided.** By (4) a solution is an acceleration iff w.a > 0. Every
/// solution has each contact touching (N.a = 0) or apart (N.a >= 0, c = 0), and slipping one
/// way (T.a >= 0, force on the edge N - mu T), the other, or not (T.a = 0). In such a cell
/// (1)-(3) are linear, and one exact program maximises w.a. An unknown condition of a contact
/// is relaxed to N.a >= 0 and force in the cone, and a cell is split only where the maximiser
/// breaks (2) or (3). The cells are closed, and all points in them are solutions: none is left
/// out, and no border matters. Contacts with one line of action, or of slip, are split
/// together.
///
/// **Why a mass matrix is needed.** Some positive definite M maps a to f iff a.f > 0. So the
/// load is strongly stable *for every M* iff no a with N_i.a >= 0 and forces as in (2), (3) has
/// w.a > sum mu_i c_n,i |T_i.a|. With c = 0 this asks that w.a <= 0 for every virtual motion a
/// that the contacts allow, which by Farkas' lemma is frictionless stability again. The class
/// between the two, which friction enlarges, depends on M.
///
/// **In space** friction is Coulomb's own cone. The rows of a contact are those of
/// certificate/FORMAT.md, section 1: N = (n, p x n), and S a, its slip under the acceleration
/// a. A contact force is a_i N_i + (f_i, p_i x f_i), f_i.n_i = 0, with the laws of friction
///
///     |f_i| <= mu_i |n_i| a_i,     f_i = -mu_i |n_i| a_i s / |s|  if s = S_i a != 0.
///
/// Discs of friction are put between polygons, and exact programs ask of their corners what
/// they ask of edges in the plane: forces in an inner polygon are in the cone, and a twist that
/// no force of an outer polygon opposes is opposed by none in the cone. Polygons are refined
/// where the programs' answers are. Slip is split into sectors of directions: friction is
/// against a slip in the sector. A load on a border whose numbers are irrational, or nearer to
/// one than the polygons, is undecided.
///
/// Source: Pang and Trinkle, "Stability characterizations of rigid body contact problems with
/// Coulomb friction", ZAMM 80(10), 2000; Haas-Heger et al., RSS 2018, Section II.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/core/number_text.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/engine/rigid_force.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// A motion along which the load does positive work, and no admissible contact force does
/// negative work; so none balances the load.
struct UnopposedMotion {
  RationalRow twist;  ///< coprime integers
};

/// The answer whether forces of some class balance the load; either way with evidence. In space
/// undecided within a billionth of the border, unless the load is found to be on it.
using LoadClass = std::variant<RigidForces, UnopposedMotion, Undecided>;

/// Decides weak stability in the plane by one linear program with 3 rows and two variables per
/// contact. Evidence is checked by substitution. Stiffness and preloads play no part.
LoadClass weakly_stable_load(const Problem& problem);
/// Decides the same for a grasp in space without uncertain numbers.
LoadClass weakly_stable_load(const GraspBox& grasp);
/// Decides the same with mu = 0.
LoadClass frictionless_stable_load(const Problem& problem);

/// A mass distribution with mass 1. A body of mass m has 1/m of these accelerations under the
/// same load, and the same forces, so no class depends on m.
struct Inertia {
  RationalRow centre{0, 0};  ///< the centre of mass in the object frame
  /// The tensor of inertia about `centre`, over the mass; symmetric, positive definite. In the
  /// plane one number, the squared radius of gyration.
  std::vector<RationalRow> gyration{{1}};

  /// Returns the inertia about the origin with this radius of gyration, > 0, about every axis.
  static Inertia of_length(const Rational& radius, bool in_space = false);
  /// Returns true if it has three coordinates.
  bool in_space() const { return centre.size() == 3; }
};

/// Returns M a, the wrench about the origin that gives the acceleration a (of the origin, and
/// angular).
RationalRow times_mass(const Inertia& inertia, const RationalRow& a);
/// Returns the inertia with its numbers, to be finished.
Json inertia_json(const Inertia& inertia);
/// Returns the inertia of numbers: the centre and the squared radius of gyration; in space the
/// centre x, y, z and xx, yy, zz of the tensor, and then xy, xz, yz if they are not 0. Throws
/// InputError with that place unless there are so many numbers, and the tensor is positive
/// definite.
Inertia inertia_of(const std::string& place, const RationalRow& numbers, bool in_space);
/// Returns the numbers as inertia_of() reads them.
RationalRow numbers_of(const Inertia& inertia);
/// Returns the numbers of an option, for an inertia in the plane or in space; none if it is
/// empty. Throws InputError at `place` unless their number fits the plane or space.
RationalRow inertia_numbers(const std::string& place, const std::string& value);

/// Returns the one grasp in space that the question is about. Throws InputError if numbers are
/// uncertain.
const GraspBox& point_in_space(const Question& question);

/// A split of a cell of solutions in parts.
///
/// It is about `contact` and all contacts whose N is a positive multiple of its N: touching;
/// apart. With `slip` it is about those whose T is a multiple of its T: T.a >= 0; T.a = 0; T.a
/// <= 0 (for a negative multiple the outer two change places). In space `slip` is about those
/// with the same place and direction, with a direction d: slip in the quarters between d, n x
/// d, -d, -n x d, after the first of which comes slip 0; or, in a sector that is known, slip
/// before d and after it.
struct RigidSplit {
  ContactId contact{0};     ///< the contact with this line of action, or of slip
  bool slip = false;        ///< whether it splits slips; else it splits touching
  RationalRow direction{};  ///< d, in space: in the tangent plane, not 0
};
/// Evidence that no solution of a cell has w.a > 0: with weight >= 0, g of `normal` (>= 0
/// unless the contact touches) and h of `tangent` (with the sign of the slip; in space a vector
/// of the tangent plane with h.s >= 0 for all s of the sector),
///
///     weight w + M twist + sum g_i N_i + sum h_i T_i = 0,
///
/// and twist.w >= 0 (> 0 if the weight is 0), twist.e >= 0 for all edges e that the cell allows
/// forces on. The product with a proves it: 0 >= weight w.a + twist.(w + forces) >= weight w.a.
struct RigidLeaf {
  Rational weight;    ///< the multiple of w
  RationalRow twist;  ///< a twist on which no force of the cell does negative work
  std::vector<std::pair<ContactId, Rational>> normal{};      ///< g where it is not 0
  std::vector<std::pair<ContactId, RationalRow>> tangent{};  ///< h where it is not 0
};
/// A node of a tree in preorder.
using RigidNode = std::variant<RigidSplit, RigidLeaf>;

/// Evidence that the load accelerates nothing.
struct StronglyStable {
  RigidForces rest;               ///< a solution with a = 0
  std::vector<RigidNode> tree{};  ///< in preorder: no solution has w.a > 0

  std::size_t cases() const;  ///< the leaves of the tree
};
/// A solution of (1)-(3) with a != 0.
struct Acceleration {
  RationalRow acceleration;  ///< of the object frame's origin, and angular
  RigidForces forces;        ///< the forces of this solution
};

/// Decides strong stability in the plane. Undecided only at `most_programs` linear programs.
/// Evidence is checked by substitution. Throws ContractError unless the radius of gyration is
/// above 0.
std::variant<StronglyStable, Acceleration, Undecided> strongly_stable_load(
    const Problem& problem, const Inertia& inertia = {}, std::size_t most_programs = 20000);

/// Evidence that the model allows both rest and motion.
struct OpenLoad {
  RigidForces rest;     ///< a solution with a = 0
  Acceleration motion;  ///< a solution with a != 0
};

/// *Must move*, *must hold*, *open*, each with its evidence.
using RigidVerdict = std::variant<UnopposedMotion, StronglyStable, OpenLoad, Undecided>;

/// Returns the class of the load: asks weakly_stable_load() and then, unless the load must
/// move, strongly_stable_load().
RigidVerdict rigid_verdict(const Problem& problem, const Inertia& inertia = {},
                           std::size_t most_programs = 20000);
/// Returns the same for a grasp in space without uncertain numbers.
RigidVerdict rigid_verdict(const GraspBox& grasp, const Inertia& inertia,
                           std::size_t most_programs = 4000);
/// Returns the same for the one grasp that a question is about. Throws InputError as
/// problem_of() and point_in_space() do.
RigidVerdict rigid_verdict(const Question& question, const Inertia& inertia);

/// Returns "must move", "must hold", "open" or "undecided".
std::string name_of(const RigidVerdict& verdict);

}  // namespace stickslip
