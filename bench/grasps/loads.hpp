// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Loads for the families of grasps.hpp, and instances whose verdict is known beforehand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "grasps.hpp"
#include "stickslip/engine/question.hpp"

namespace stickslip::bench {

/// -sum (a_i N_i + b_i T_i) for a motion d that may be chosen freely, or on which one or two
/// contacts stick, and forces that the model allows for it: stable by construction. Under the
/// bilateral law d opens no contact.
Wrench planted_load(const Grasp& grasp, NormalLaw law, std::uint64_t seed);

/// A pull out of the open side of kArc, kEdges and kGrid, sideways for others: a force of
/// about 1 with a small torque.
Wrench pulling_load(Layout layout, std::uint64_t seed);

/// The largest load that is resisted along its direction, for kJaws and kDisc with preload.
///
/// *Jaws.* Pairs have equal mu = 1/2, k, P and v = P -+ k f, f = d_x - r p_y. Under a pull
/// (0, s, 0), balance of force x gives both jaws the same total V of normal forces; equal and
/// opposite slips of the two sides give s <= 0; if one side slips alone, its friction mu V is
/// the larger one and turns the body the way the springs do not, unless r = 0; so all f = 0,
/// V = sum P over a jaw and s <= mu sum P over all contacts.
///
/// *Disc.* A torque s does no work on the normals (they are radial) and slips all contacts:
/// s <= mu R sum v_i, and sum v_i = sum P_i while the centre stays. That it stays is
/// confirmed by the engines for every instance that is used.
Wrench threshold_load(Layout layout, const Grasp& grasp);

/// What a verdict must be. kUnknown is for loads that are not constructed to have one.
enum class Expected { kStable, kUnstable, kUnknown };

struct Instance {
  std::string family;  ///< "arc, preload, pulled"
  Question question;
  Expected expected = Expected::kUnknown;
};

/// Says whether a question is stable. Only make_unstable uses it, to place a pull just beyond
/// what a preloaded grasp holds.
using StableOracle = std::function<bool(const Question&)>;

/// The ways to make an instance; each gives a series over seeds.
inline constexpr std::size_t kStableFamilies = 12;
inline constexpr std::size_t kUnstableFamilies = 11;

/// planted loads on kRound, kArc, kEdges, kGrid with and without preload; loads exactly on the
/// threshold of kJaws and kDisc; on kVaried, with and without preload, planted loads in
/// millionths (exact ones have a denominator of a dozen digits a contact).
Instance make_stable(std::size_t family, std::size_t contacts, std::uint64_t seed);

/// Pulls on kArc, kEdges, kGrid without preload; with preload, and on kRound and kVaried under
/// the bilateral law, a few percent beyond what is held; on kJaws and kDisc 1e-12 and 5 %
/// beyond the threshold. (Under the unilateral law contacts all round a body resist nearly any
/// load.)
Instance make_unstable(std::size_t family, std::size_t contacts, std::uint64_t seed,
                       const StableOracle& is_stable);

/// `make` for count instances: all families in turn, seeds counting up.
std::vector<Instance> stable_instances(std::size_t contacts, std::size_t count);
std::vector<Instance> unstable_instances(std::size_t contacts, std::size_t count,
                                         const StableOracle& is_stable);

/// The question as a file would ask it.
Question plain_question(Grasp grasp, const Wrench& wrench,
                        NormalLaw law = NormalLaw::kUnilateral);

}  // namespace stickslip::bench
