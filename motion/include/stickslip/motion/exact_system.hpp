// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Linear systems over the rationals, by Gaussian elimination. O(n^3) operations on numbers
/// that grow to n times their length.
#pragma once

#include <Eigen/Core>
#include <boost/multiprecision/eigen.hpp>
#include <optional>
#include <vector>

#include "stickslip/equilibrium/proof.hpp"

namespace stickslip {

/// \{ Of any size.
using RationalMatrix = Eigen::Matrix<Rational, Eigen::Dynamic, Eigen::Dynamic>;
using RationalVector = Eigen::Matrix<Rational, Eigen::Dynamic, 1>;
/// \}

/// The matrix with these rows, each of so many entries.
RationalMatrix matrix_of(const std::vector<RationalRow>& rows, std::size_t columns);

/// \{ The rank of a matrix, which may be given by rows of one length.
std::size_t rank_of(const RationalMatrix& a);
std::size_t rank_of(const std::vector<RationalRow>& rows);
/// \}
/// `degree-walls` and `degree-direction`: both have this rank, that of all forces.
bool has_rank(const DegreeProof& proof, std::size_t rank);

/// A basis of the x with a x = 0, by columns; all x where a has no rows.
RationalMatrix null_space(const RationalMatrix& a);

/// A solution of a x = b; nothing if there is none or, with `only_one`, several.
std::optional<RationalVector> solve_exactly(const RationalMatrix& a, const RationalVector& b,
                                            bool only_one = false);

}  // namespace stickslip
