// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/proof.hpp"

#include <algorithm>

#include "stickslip/lp/exact_system.hpp"

namespace stickslip {

bool has_rank(const DegreeProof& proof, std::size_t rank) {
  return rank_of(proof.walls) == rank && rank_of(proof.direction) == rank;
}

std::size_t leaf_count(const Trees& trees) {
  return static_cast<std::size_t>(std::count_if(trees.begin(), trees.end(), [](const auto& n) {
    return std::holds_alternative<TwistLeaf>(n) || std::holds_alternative<MovingLeaf>(n);
  }));
}

namespace {

template <class Proof>
bool are_all(const StabilityProof& parts) {
  return std::all_of(parts.begin(), parts.end(), [](const auto& part) {
    return std::holds_alternative<PartSplit>(part) || std::holds_alternative<Proof>(part);
  });
}

}  // namespace

bool are_at_rest(const StabilityProof& parts) {
  return are_all<RestProof>(parts);
}

bool are_sticking(const StabilityProof& parts) {
  return are_all<StickingProof>(parts);
}

bool are_untouched(const StabilityProof& parts) {
  return std::all_of(parts.begin(), parts.end(), [](const auto& part) {
    const auto* by_degree = std::get_if<DegreeProof>(&part);
    return by_degree != nullptr && by_degree->walls.empty();
  });
}

}  // namespace stickslip
