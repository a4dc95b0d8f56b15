// SPDX-License-Identifier: GPL-3.0-or-later
#include "crowd_walls.hpp"

#include <utility>

#include "crowd_forces.hpp"
#include "witness_search.hpp"

namespace stickslip {

CrowdWalls::CrowdWalls(const Problem& problem)
    : problem_(problem), model_(std::make_unique<const DoubleModel>(problem)) {}

CrowdWalls::~CrowdWalls() = default;

std::vector<NearEquilibrium> CrowdWalls::newton_equilibria(std::size_t starts,
                                                           double length) const {
  return stickslip::newton_equilibria(*model_, starts, length);
}

bool CrowdWalls::all_are_closed(const Region& wall) const {
  const ConeSigns signs(wall.cone());
  for (std::size_t i = 0; i < problem_.size(); ++i) {
    if (Region::separation(problem_, ContactId(i), signs) != Separation::kClosed) return false;
  }
  return true;
}

bool CrowdWalls::refute(Region wall, const PullRule* pull, std::size_t node_limit,
                        Trees& trees) {
  TreeSearch search(planar_detail::CrowdForces(problem_, *model_, pull, false, work_),
                    node_limit);
  return search.refute(std::move(wall), trees);
}

}  // namespace stickslip
