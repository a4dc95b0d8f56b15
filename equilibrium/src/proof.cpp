// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/proof.hpp"

#include <algorithm>

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

}  // namespace stickslip
