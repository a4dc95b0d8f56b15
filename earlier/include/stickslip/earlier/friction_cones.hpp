// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Friction cones alone: the passive model without maximum dissipation.
///
/// Some motion d and forces satisfy balance, the normal law and the friction cones (Haas-Heger
/// et al., RSS 2018, Eqs. 1-4; Section III and Fig. 4): every condition of problem.hpp but the
/// last. Friction need not oppose slip, so a solver may rotate the object to load its contacts
/// and let friction push along.
///
/// Passively stable implies accepted here, which implies weakly stable.
///
/// **Method.** Branch and bound over separations. A contact whose v_i = P_i - k_i N_i.d has one
/// sign on the region of motions is closed, a_i = v_i, or open, a_i = 0; others are relaxed to
/// a_i >= max(0, v_i). The contact whose a_i exceeds max(0, v_i) most is split by v_i = 0. If
/// there are no such forces but a virtual twist alone does not show it (FORMAT.md, section 4),
/// the contact whose a_i >= v_i the contradiction uses most is split. These planes cut the
/// region, so there are at most as many regions as cells in their arrangement, O(m^3). Under
/// the bilateral law all are closed: one linear program.
#pragma once

#include <variant>

#include "stickslip/core/box.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// The motion and forces found, or a tree of separation splits and virtual twists that refutes
/// all motions. The tree's twists bound the work of *all* forces in the friction cones; the
/// multipliers that prove it were verified. So the tree is also a refutation of the passive
/// model, which certificate/ can check.
using ConesVerdict = std::variant<Witness, Trees, Undecided>;

/// Searches for such a motion. Undecided only at `most_programs` linear programs. A witness is
/// checked by substitution.
ConesVerdict friction_cones_alone(const Problem& problem, std::size_t most_programs = 20000);

/// A motion and forces of a grasp in space, with normal forces by their law and friction in
/// Coulomb's cones.
struct SpatialConesWitness {
  RationalRow motion;           ///< d
  std::vector<Vector3> forces;  ///< by ContactId
};

/// Evidence that all motions are refuted. For each region of a search over which contacts are
/// closed an exact linear program has no solution, with polygons around the discs of friction.
struct NoSpatialCones {
  std::size_t regions = 0;  ///< regions that were refuted
};

/// Searches for the same in space, for a grasp without uncertain numbers. Discs are put between
/// polygons, which are refined where the answers are. Undecided at `most_programs`, and if
/// forces are so near the border of a cone that polygons as fine as doubles do not tell. Throws
/// InputError ("contacts[i].normal") at a preloaded contact with a normal of irrational length.
std::variant<SpatialConesWitness, NoSpatialCones, Undecided> friction_cones_alone(
    const GraspBox& grasp, NormalLaw law, std::size_t most_programs = 2000);

}  // namespace stickslip
