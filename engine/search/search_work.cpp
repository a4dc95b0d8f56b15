// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/search_work.hpp"

#include <algorithm>

namespace stickslip {

std::vector<std::pair<std::string, std::size_t>> counters(const SearchWork& work) {
  return {{"nodes", work.nodes},
          {"pieces", work.pieces},
          {"leaves", work.leaves},
          {"rays", work.rays},
          {"most_rays", work.most_rays},
          {"pairs", work.pairs},
          {"ray_bits", work.ray_bits},
          {"twist_bits", work.twist_bits},
          {"filter_hits", work.filter_hits},
          {"exact_checks", work.exact_checks},
          {"proofs", work.proofs},
          {"examples", work.examples},
          {"parts", work.parts}};
}

SearchWork& SearchWork::operator+=(const SearchWork& part) {
  nodes += part.nodes;
  pieces += part.pieces;
  leaves += part.leaves;
  rays += part.rays;
  most_rays = std::max(most_rays, part.most_rays);
  ray_bits = std::max(ray_bits, part.ray_bits);
  twist_bits = std::max(twist_bits, part.twist_bits);
  pairs += part.pairs;
  filter_hits += part.filter_hits;
  exact_checks += part.exact_checks;
  proofs += part.proofs;
  examples += part.examples;
  parts += part.parts;
  return *this;
}

}  // namespace stickslip
