// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What must hold of the sweep, its streams and its structure on any planes.
#pragma once

#include <cstdint>
#include <vector>

#include "oracle.hpp"
#include "stickslip/arrangement/arrangement_structure.hpp"
#include "stickslip/arrangement/sweep.hpp"

namespace stickslip::test {

/// Every form of the sweep against the oracle: counts, states one by one, the stream of cells,
/// and the structure. Reports failures to GoogleTest.
void expect_sweep_equals(const std::vector<Vector3>& planes, const OracleResult& expected);

/// Incidences against signs and against one another. Takes O(m) for each cell.
void expect_valid_structure(const ArrangementStructure& structure);

/// m >= 3 planes with the normals (1, t, t^2), t = 0, 1, ...: by Vandermonde no two coincide
/// and no three are concurrent, though for large t they nearly do.
std::vector<Vector3> moment_planes(std::size_t m);

/// Independent of the order of its terms.
std::uint64_t checksum(const SlipState& state);

}  // namespace stickslip::test
