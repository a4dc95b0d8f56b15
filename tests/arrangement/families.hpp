// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Families of planes and grasps for the tests of the enumerators. Everything is determined
/// by its arguments on every platform.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "stickslip/arrangement/slip_states.hpp"

namespace stickslip::test {

/// Uniform enough integers; std::uniform_int_distribution differs between libraries.
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  int between(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint32_t>(high - low + 1));
  }
  /// A nonzero vector with entries in [-bound, bound].
  Vector3 vector(int bound);

 private:
  std::mt19937 engine_;
};

/// m planes of which no two coincide and no three are concurrent.
std::vector<Vector3> simple_planes(std::size_t m, std::uint32_t seed);

/// m planes with normals in [-bound, bound]^3: for small bounds, full of coincidences.
std::vector<Vector3> grid_planes(std::size_t m, int bound, std::uint32_t seed);

/// m distinct planes through one axis, m >= 2.
std::vector<Vector3> pencil_planes(std::size_t m, std::uint32_t seed);

/// grid_planes with every entry moved by a random multiple of epsilon, a few left unmoved:
/// every coincidence of the grid becomes near, exact, or something between.
std::vector<Vector3> near_grid_planes(std::size_t m, int bound, const Rational& epsilon,
                                      std::uint32_t seed);

/// The stick planes of m contacts with axis-aligned normals on an object with right angles,
/// coordinates in [-bound, bound]. Contacts on one side share a circle, and all circles of
/// contacts with parallel sides pass through one axis: two pencils that cross in a grid.
std::vector<Vector3> axis_aligned_planes(std::size_t m, int bound, std::uint32_t seed);

/// The grasps of the paper (contacts as in its Figs. 1 and 4).
Grasp fig1_grasp();
Grasp fig4_grasp();

/// Contacts at the given points with normals towards the origin.
Grasp inward_grasp(const std::vector<Vector2>& points);

std::vector<std::string> texts(const std::vector<SlipState>& states);

/// Everything that must hold of any result: Euler, antipodal symmetry, order, no repetition,
/// all-stick. Reports failures to GoogleTest.
void expect_well_formed(const SlipStates& result);

/// The enumerators under test against the oracle: states one by one, counts, rank; of the
/// sweep also its stream of cells and its structure (sweep_checks.hpp).
void expect_equals_oracle(const std::vector<Vector3>& planes);

/// "{(1, 0, 0), (0, 1/2, 1)}", for failure messages.
std::string describe(const std::vector<Vector3>& planes);

}  // namespace stickslip::test
