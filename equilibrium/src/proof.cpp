// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/proof.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/multiprecision/eigen.hpp>

namespace stickslip {

std::size_t leaf_count(const Trees& trees) {
  return static_cast<std::size_t>(std::count_if(trees.begin(), trees.end(), [](const auto& n) {
    return std::holds_alternative<TwistLeaf>(n);
  }));
}

bool are_at_rest(const StabilityProof& parts) {
  return std::none_of(parts.begin(), parts.end(), [](const auto& part) {
    return std::holds_alternative<DegreeProof>(part);
  });
}

std::size_t rank_of(const std::vector<RationalRow>& rows) {
  if (rows.empty()) return 0;
  using Matrix = Eigen::Matrix<Rational, Eigen::Dynamic, Eigen::Dynamic>;
  Matrix matrix(static_cast<Eigen::Index>(rows.size()),
                static_cast<Eigen::Index>(rows.front().size()));
  for (std::size_t j = 0; j < rows.size(); ++j) {
    for (std::size_t k = 0; k < rows.front().size(); ++k) {
      matrix(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k)) = rows[j][k];
    }
  }
  Eigen::FullPivLU<Matrix> lu(matrix);
  lu.setThreshold(0);  // of rationals, whose zeros are zeros
  return static_cast<std::size_t>(lu.rank());
}

bool has_rank(const DegreeProof& proof, std::size_t rank) {
  return rank_of(proof.walls) == rank && rank_of(proof.direction) == rank;
}

}  // namespace stickslip
