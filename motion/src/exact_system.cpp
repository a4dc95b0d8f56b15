// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/motion/exact_system.hpp"

#include <Eigen/LU>

namespace stickslip {

namespace {

Eigen::FullPivLU<RationalMatrix> eliminated(const RationalMatrix& a) {
  Eigen::FullPivLU<RationalMatrix> result(a);
  result.setThreshold(0);  // of rationals, whose zeros are zeros
  return result;
}

}  // namespace

std::size_t rank_of(const RationalMatrix& a) {
  if (a.size() == 0) return 0;
  return static_cast<std::size_t>(eliminated(a).rank());
}

RationalMatrix matrix_of(const std::vector<RationalRow>& rows, std::size_t columns) {
  RationalMatrix a(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns));
  for (std::size_t j = 0; j < rows.size(); ++j) {
    for (std::size_t k = 0; k < columns; ++k) {
      a(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k)) = rows[j][k];
    }
  }
  return a;
}

std::size_t rank_of(const std::vector<RationalRow>& rows) {
  return rows.empty() ? 0 : rank_of(matrix_of(rows, rows.front().size()));
}

bool has_rank(const DegreeProof& proof, std::size_t rank) {
  return rank_of(proof.walls) == rank && rank_of(proof.direction) == rank;
}

RationalMatrix null_space(const RationalMatrix& a) {
  if (a.rows() == 0) return RationalMatrix::Identity(a.cols(), a.cols());
  const Eigen::FullPivLU<RationalMatrix> lu = eliminated(a);
  if (lu.dimensionOfKernel() == 0) return RationalMatrix(a.cols(), 0);
  return lu.kernel();
}

std::optional<RationalVector> solve_exactly(const RationalMatrix& a, const RationalVector& b,
                                            bool only_one) {
  const Eigen::FullPivLU<RationalMatrix> lu = eliminated(a);
  if (only_one && lu.rank() < a.cols()) return std::nullopt;
  RationalVector x = lu.solve(b);
  if (a * x != b) return std::nullopt;
  return x;
}

}  // namespace stickslip
