// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_refuter.hpp"

#include <utility>

#include "stickslip/motion/pull_rule.hpp"

namespace stickslip::degree_detail {
namespace {

/// row.(d - h d0)
Vector5 seen(const RationalRow& row, const RationalRow& twist) {
  return {row[0], row[1], row[2], -dot(row, twist), 0};
}

}  // namespace

bool LawRefuter::refute(DegreeProof& proof, std::size_t wall, bool second,
                        std::size_t node_limit) {
  const Law& about = second ? middle_ : box_;
  const PullRule pull(proof.direction, proof.twist);
  TreeSearch search(about, second ? &pull : nullptr, node_limit, work_);
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

Region CrowdRefuter::region(const DegreeProof& proof, std::size_t wall) const {
  const std::size_t row = proof.is_simplex ? wall : wall / 2;
  std::vector<Region::Cut> cuts{{{0, 0, 0, 1, 0}, Side::kPositive, true},
                                {{0, 0, 0, 0, 1}, Side::kZero}};
  const auto cut = [&](std::size_t j, int height, Side side) {
    Vector5 plane = seen(proof.walls[j], proof.twist);
    plane[3] -= height;
    cuts.push_back({primitive_multiple(plane), side});
  };
  cut(row, proof.is_simplex || wall % 2 == 0 ? 1 : -1, Side::kZero);
  for (std::size_t j = 0; j < proof.walls.size(); ++j) {
    if (j == row) continue;
    cut(j, 1, Side::kNegative);
    if (!proof.is_simplex) cut(j, -1, Side::kPositive);
  }
  return Region::between(walls_.problem(), cuts);
}

bool CrowdRefuter::refute(DegreeProof& proof, std::size_t wall, bool second,
                          std::size_t node_limit) {
  const PullRule pull(proof.direction, proof.twist);
  const ConeWork before = walls_.work();
  const bool done =
      walls_.refute(region(proof, wall), second ? &pull : nullptr, node_limit, proof.trees);
  const ConeWork& after = walls_.work();
  work_.nodes += after.nodes - before.nodes;
  work_.leaves += after.leaves - before.leaves;
  work_.filter_hits += after.filter_hits - before.filter_hits;
  work_.exact_checks += after.filter_misses - before.filter_misses;
  return done;
}

bool CrowdRefuter::all_are_closed(const DegreeProof& proof) const {
  for (std::size_t wall = 0; wall < proof.wall_count(); ++wall) {
    if (!walls_.all_are_closed(region(proof, wall))) return false;
  }
  return true;
}

}  // namespace stickslip::degree_detail
