// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "equilibria.hpp"
#include "space_search.hpp"
#include "spatial_degree.hpp"
#include "stickslip/space/spatial_verdict.hpp"

namespace stickslip {

using namespace space_detail;

const char* name_of(const SpatialVerdict& verdict) {
  constexpr const char* kNames[] = {"stable", "unstable", "undecided"};
  return kNames[verdict.index()];
}

std::size_t leaf_count(const SpatialTrees& trees) {
  return static_cast<std::size_t>(std::count_if(
      trees.begin(), trees.end(),
      [](const SpatialNode& node) { return std::holds_alternative<LeafIn<6>>(node); }));
}

std::vector<std::pair<std::string, std::size_t>> counters(const SpatialWork& work) {
  return {{"nodes", work.nodes},
          {"leaves", work.leaves},
          {"rays", work.rays},
          {"most_rays", work.most_rays},
          {"ray_bits", work.ray_bits},
          {"twist_bits", work.twist_bits},
          {"exact_checks", work.exact_checks},
          {"proofs", work.proofs}};
}

SpatialWork& SpatialWork::operator+=(const SpatialWork& part) {
  nodes += part.nodes;
  leaves += part.leaves;
  rays += part.rays;
  most_rays = std::max(most_rays, part.most_rays);
  ray_bits = std::max(ray_bits, part.ray_bits);
  twist_bits = std::max(twist_bits, part.twist_bits);
  exact_checks += part.exact_checks;
  proofs += part.proofs;
  return *this;
}

namespace {

/// Without what is rounding alone.
Vector6 motion_of(const SpaceModel& model, const NearEquilibrium& equilibrium) {
  Vector6 motion{};
  for (std::size_t j = 0; j < 6; ++j) {
    const double d = equilibrium.motion[static_cast<Eigen::Index>(j)];
    constexpr double kNone = 1e-12;
    if (std::fabs(d) > kNone * model.reach) {
      motion[j] = rational_from_double(d / (j < 3 ? 1 : model.length));
    }
  }
  return motion;
}

}  // namespace

SpatialDecision decide(const SpatialQuestion& question, const SpatialSearchOptions& options) {
  SpatialDecision decision{Undecided{}, {}, options.bits};
  const SpaceModel model(question, options.bits);
  const SpaceModel middle = model.at(0);
  constexpr std::size_t kDefaultLimit = 20000;
  const std::size_t limit = options.node_limit != 0 ? options.node_limit : kDefaultLimit;
  const NewtonMethod newton(middle);
  std::vector<EigenVector6> tried;
  const auto prove = [&](const NearEquilibrium& near) {
    constexpr double kSame = 1e-6;
    for (const EigenVector6& motion : tried) {
      if ((motion - near.motion).norm() <= kSame * near.motion.norm()) return false;
    }
    tried.push_back(near.motion);
    if (!question.is_box) {
      if (auto witness = exact_witness(model, near)) {
        const Vector6 motion = witness->twist;
        decision.verdict = SpatiallyStable{std::move(*witness), motion};
        return true;
      }
    }
    const std::size_t wall_limit = std::max<std::size_t>(limit / 24, 1);
    auto proof = prove_stable(model, middle, near, wall_limit, decision.work);
    if (proof) decision.verdict = SpatiallyStable{std::move(*proof), motion_of(model, near)};
    return proof.has_value();
  };
  constexpr std::size_t kStarts = 3;
  for (const NearEquilibrium& near : newton.solve_from(kStarts)) {
    if (prove(near)) return decision;
  }
  SpatialTrees tree;
  SpaceSearch search(model, nullptr, limit, decision.work);
  search.on_candidate([&](const NearEquilibrium& relaxed, double) {
    const auto near = newton.polish(relaxed);
    return near && prove(*near);
  });
  if (search.refute(SpaceRegion::root(model), tree)) {
    decision.verdict = SpatiallyUnstable{std::move(tree)};
    return decision;
  }
  if (std::holds_alternative<SpatiallyStable>(decision.verdict)) return decision;
  decision.verdict = Undecided{search.is_spent() ? "no proof was found within " +
                                                       std::to_string(limit) + " nodes a tree"
                                                 : "no proof was found"};
  return decision;
}

}  // namespace stickslip
