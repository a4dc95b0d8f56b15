// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Families of loaded grasps for property tests. Everything is determined by the seed, on every
/// platform.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "random_source.hpp"
#include "stickslip/core/grasp.hpp"

namespace stickslip::test {

using bench::RandomSource;

/// What an engine is asked.
struct LoadCase {
  LoadedGrasp loaded;
  NormalLaw law = NormalLaw::kUnilateral;
};

/// The grasp file and the normal law, for failure messages.
std::string describe(const LoadCase& load_case);

/// Positions on the grid {-1, 0, 1}^2 (in half of the grasps {-2, ..., 2}^2), axis normals, mu
/// in {0, 1/2, 1}, k in {1, 2, 1/2}, P in {0, 1}. Coincident contacts, parallel normals and
/// concurrent lines are the rule. In a third of the grasps all contacts share mu, k and P.
Grasp degenerate_grasp(RandomSource& random, std::size_t contacts);

/// Rational positions. Normals are rational unit vectors (Pythagorean parametrisation), some
/// scaled, with preload, or else integer vectors, mostly of irrational length, without preload.
Grasp generic_grasp(RandomSource& random, std::size_t contacts);

/// degenerate_grasp with every coordinate, preload and normal moved by -epsilon, 0 or epsilon
/// (normals are turned by about 2 epsilon and keep length 1).
Grasp near_degenerate_grasp(RandomSource& random, std::size_t contacts,
                            const Rational& epsilon);

/// Components are integers, or halves, in [-2, 2].
Wrench small_wrench(RandomSource& random);

/// A load that is stable by construction: the negative of the contact wrenches under a motion
/// d and friction that the model allows for it. d is 0, a motion on which one or two contacts
/// stick, or any; under the bilateral law one that opens no contact.
Wrench planted_wrench(RandomSource& random, const Grasp& grasp, NormalLaw law);

/// A load that d = 0 resists with friction on an edge of its cone at every contact, plus
/// epsilon times a small_wrench: for many grasps a load on the border of the resistible
/// ones, or just beside it. Means little without preload.
Wrench threshold_wrench(RandomSource& random, const Grasp& grasp, const Rational& epsilon);

}  // namespace stickslip::test
