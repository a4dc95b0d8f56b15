// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_refuter.hpp"

#include <utility>

#include "stickslip/engine/pull_rule.hpp"

namespace stickslip::degree_detail {
bool LawRefuter::refute(DegreeProof& proof, std::size_t wall, bool second,
                        std::size_t node_limit) {
  const Law& about = second ? middle_ : box_;
  const PullRule pull(proof.direction, proof.twist);
  LawSearch search(about, second ? &pull : nullptr, node_limit, work_);
  return search.refute(MotionRegion::wall(about, proof, wall), proof.trees);
}

bool LawRefuter::all_are_closed(const DegreeProof& proof) const {
  for (std::size_t wall = 0; wall < proof.wall_count(); ++wall) {
    const MotionRegion region = MotionRegion::wall(box_, proof, wall);
    for (std::size_t i = 0; i < box_.contacts.size(); ++i) {
      if (region.separation(i) != Separation::kClosed) return false;
    }
  }
  return true;
}

bool CrowdRefuter::refute(DegreeProof& proof, std::size_t wall, bool second,
                          std::size_t node_limit) {
  const PullRule pull(proof.direction, proof.twist);
  const BranchWork before = walls_.work();
  const bool done = walls_.refute(Region::wall(walls_.problem(), proof, wall),
                                  second ? &pull : nullptr, node_limit, proof.trees);
  const BranchWork& after = walls_.work();
  work_.nodes += after.nodes - before.nodes;
  work_.leaves += after.leaves - before.leaves;
  work_.filter_hits += after.filter_hits - before.filter_hits;
  work_.exact_checks += after.filter_misses - before.filter_misses;
  return done;
}

bool CrowdRefuter::all_are_closed(const DegreeProof& proof) const {
  for (std::size_t wall = 0; wall < proof.wall_count(); ++wall) {
    if (!walls_.all_are_closed(Region::wall(walls_.problem(), proof, wall))) return false;
  }
  return true;
}

}  // namespace stickslip::degree_detail
