// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// PCR and PGR, the potential contact and grasp robustness: how far the best internal forces of
/// a hand keep contacts from breaking a condition, over how much force a load can add.
///
/// For the grasp map G of unit normals and unit tangents, torques divided by a length L, with
/// stiffness K, forces are l with G l = -w. The distances of a contact with the force (l_n,
/// l_t) are those to its three conditions:
///
///     d_i = min( (mu l_n - |l_t|) / sqrt(1 + mu^2),  l_n,  f - l_n ),
///
/// and PCR = max over l of min_i d_i / sigma_max(K G^T (G K G^T)^-1). The hand is taken to make
/// all internal forces, E = ker G. For PGR each contact is in one of three states: it *sticks*,
/// as above; it *slips*, so that l_t = 0 and the first distance is left out; or it is
/// *detached*, so that l = 0 and no distance is left. PGR is the largest value of the 3^m
/// combinations whose G has full rank; a value below 0, where the best forces break a
/// condition, is none. A contact without friction has d_i <= 0 where it sticks.
///
/// K is diagonal, with the stiffness of a contact for its normal and its tangents alike. In
/// space friction is Coulomb's round cone, or a pyramid: forces at a distance of at least d are
/// a cone, the friction cone moved along the normal by d sqrt(1 + mu^2) / mu, and for N edges
/// these forces are only those of the pyramid with N edges that is inscribed in this cone. So
/// the value is at most that of the round cone. The first edge is along a tangent.
///
/// **Bounds.** Write M(s) for the sum over states of N N^T, and T T^T where a contact sticks.
/// Always 1/sigma_max(s)^2 <= lambda_min(M(s)), with equality where all are equally stiff. A
/// node of the search fixes some states and an interval [lo, hi] of the least distance d. For a
/// positive semidefinite Z and a twist y
///
///     tr(Z) lambda_min(M(s)) <= <Z, M(s)> - y.(G l + w) <= psi(Z, y),
///
/// psi being the sum over contacts of the largest that a state and a force at a distance of lo
/// give. So no combination of the node has a value above hi sqrt(psi / tr Z), and none exists
/// if psi < 0 for Z = 0. Linear programs in doubles propose Z and y; psi is computed exactly,
/// with roots rounded up. The value of the combination that is found is confirmed exactly, too.
/// What proves the upper bound is kept as a tree, for a certificate (certificate/FORMAT.md,
/// section 18).
///
/// PGR is NP-hard, so that the search may take long; it ends early at a limit of nodes, and its
/// bounds are right then, too.
///
/// Sources: Bicchi, "On the problem of decomposing grasp and manipulation forces in
/// multiple whole-limb manipulation", Robotics and Autonomous Systems 13, 1994; Pozzi,
/// Malvezzi, Prattichizzo, "On grasp quality measures: grasp robustness and contact force
/// distribution in underactuated and compliant robotic hands", IEEE Robotics and Automation
/// Letters 2(1), 2017.
#pragma once

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/earlier/compliance.hpp"

namespace stickslip {

/// The numbers that the two measures need besides the grasp, and the limits of their search.
struct RobustnessOptions {
  Rational length = 1;  ///< L > 0, by which torques are divided
  /// f > 0, the largest normal force: one for all contacts, or one for each.
  std::vector<Rational> most_forces{1};
  Rational accuracy = {1, 100};     ///< > 0: the search ends at upper <= (1 + accuracy) lower
  std::size_t node_limit = 100000;  ///< the most nodes of the search
  std::size_t edges = 0;  ///< in space, the edges of pyramids in place of cones, >= 3; 0: none
};

/// A combination of states, with the best forces in it.
struct RobustForces {
  std::vector<SpringState> states;    ///< by ContactId
  std::vector<RationalRow> forces{};  ///< on the object, by ContactId; they balance the load
  /// At most every distance d_i of these forces, and above 0. It is the least of these unless a
  /// root was rounded.
  Rational distance{};
  /// At most 1/sigma_max^2 of the combination, and near it.
  Rational inverse_square{};
};

/// A node of the proof of an upper bound that splits the states of a contact, with a child for
/// each of them. A node is a set of combinations, some of the states of each contact, and an
/// interval of the least distance; the root has all of both.
struct StateSplit {
  std::size_t contact;  ///< its index
};
/// A node that splits the distances: a child has those up to a number, another those from it
/// on.
struct DistanceSplit {
  Rational distance;  ///< the number
};
/// A leaf that y and Z refute as above.
struct MixtureLeaf {
  RationalRow twist;                ///< y
  std::vector<RationalRow> matrix;  ///< Z
};
/// A leaf of one combination: y bounds its distance, and z its 1/sigma_max^2 by the quotient
/// z.P z / z.Q z. P = M(s) and Q = 1 if all stiffnesses are the same; else P = A^2 and Q = B
/// for A = G K G^T and B = G K^2 G^T.
struct CombinationLeaf {
  RationalRow twist{};      ///< y
  RationalRow direction{};  ///< z
};
/// The only node of a proof that PGR is 0: no forces have a distance above 0 where each contact
/// with friction sticks and every other slips, as y shows.
struct NoDistanceLeaf {
  RationalRow twist;  ///< y
};
/// A node of a proof.
using RobustnessNode =
    std::variant<StateSplit, DistanceSplit, MixtureLeaf, CombinationLeaf, NoDistanceLeaf>;

/// A measure between two bounds.
struct Robustness {
  Rational lower{0};  ///< at most the measure
  Rational upper{0};  ///< at least the measure
  /// The combination that shows `lower`; nothing if that is 0.
  std::optional<RobustForces> best{};
  /// Whether the load is balanced by forces in all cones that are bounded; if not, there is no
  /// measure, and both bounds are 0.
  bool balances = true;
  bool has_full_rank = true;  ///< whether G has full rank; if not, both bounds are 0
  bool is_complete = true;    ///< whether the bounds are as near as was asked for
  std::size_t nodes = 0;      ///< the nodes of the search
  /// Proves `upper`: nodes in preorder. That of rigid motions has none.
  std::vector<RobustnessNode> proof{};
};

/// The two measures that are proved: PCR and PGR.
enum class RobustnessKind { kContact, kGrasp };

/// Returns PCR of one grasp, in the plane or in space, without uncertain numbers and of one
/// body. Throws InputError ("contacts[i].normal") at a normal of irrational length.
Robustness potential_contact_robustness(const GraspBox& grasp,
                                        const RobustnessOptions& options = {});

/// Returns PGR in the same way.
Robustness potential_grasp_robustness(const GraspBox& grasp,
                                      const RobustnessOptions& options = {});

/// Returns one of the two.
Robustness potential_robustness(RobustnessKind kind, const GraspBox& grasp,
                                const RobustnessOptions& options = {});

/// Returns the largest value of the combinations that a rigid motion y allows, of one grasp in
/// the plane: a contact is detached where N.y > 0, and elsewhere sticks where T.y = 0 and slips
/// where not. For w = 0 it is PCR, and for any load it is from PCR to PGR. There are O(m^2)
/// such combinations: one for each face of the arrangement of the planes N.y = 0 and T.y = 0.
/// Takes O(m^3) operations and as many linear programs as there are combinations. Throws
/// InputError as the others do.
Robustness rigid_motion_robustness(const GraspBox& grasp,
                                   const RobustnessOptions& options = {});

}  // namespace stickslip
