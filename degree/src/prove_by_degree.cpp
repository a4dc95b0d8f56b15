// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>
#include <vector>

#include "stickslip/degree/moving_equilibrium.hpp"
#include "stickslip/degree/prove_stable.hpp"
#include "walls.hpp"

namespace stickslip {

using degree_detail::Walls;

namespace {

/// In so many, forces on all walls tell which A is best.
constexpr std::size_t kFewDimensions = 3;

/// One proposal of walls, grown until they are refuted.
struct Attempt {
  double size;               ///< as of Walls
  std::size_t node_limit;    ///< of a tree
  std::size_t most_growths;  ///< equilibria that go much farther are lost at a fold
  std::size_t most_nodes;    ///< nothing is tried once there were so many in all
  bool is_simplex = false;
};

class BoxDegreeSearch {
 public:
  BoxDegreeSearch(const GraspLaw& box, const GraspLaw& middle, const DegreeLimits& limits,
                  SearchWork& work)
      : box_(box), middle_(middle), limits_(limits), work_(work), span_(box) {}

  std::optional<DegreeProof> prove(const NearEquilibrium& near) {
    if (!span_.has_loads_of(box_)) return std::nullopt;
    return span_.rank() <= kFewDimensions ? prove_by_moves(near) : prove_by_size(near);
  }

 private:
  std::optional<DegreeProof> prove_by_size(const NearEquilibrium& near);
  std::optional<DegreeProof> prove_by_moves(const NearEquilibrium& near);
  std::optional<DegreeProof> prove_with(Walls walls, const Attempt& attempt);
  std::vector<std::size_t> open_walls(DegreeProof& proof, bool second, const Attempt& attempt);

  const GraspLaw& box_;
  const GraspLaw& middle_;
  const DegreeLimits& limits_;
  SearchWork& work_;
  ForceSpan span_;
};

/// All that matters is the size, where the equilibrium moves little.
std::optional<DegreeProof> BoxDegreeSearch::prove_by_size(const NearEquilibrium& near) {
  const RoundedGrasp grasp = rounded_middle(middle_);
  constexpr std::size_t kFew = 40;
  constexpr double kLeastQuick = 1e-3;
  const std::size_t limit = limits_.node_limit;
  const std::size_t growths = limits_.is_wide ? 12 : 0;
  const std::size_t most = limits_.most_nodes;
  std::optional<std::vector<Reals>> moves;
  for (const Attempt& attempt : {Attempt{3e-2, kFew, 0, most},
                                 {3e-3, kFew, 0, most},
                                 {3e-4, kFew, 0, most},
                                 {3e-5, kFew, 0, most},
                                 {3e-2, limit, growths, most},
                                 {1e-3, limit, growths, most},
                                 {3e-1, limit, growths, most},
                                 {3e-2, limit, growths, most, true}}) {
    if (attempt.node_limit == 0 || (limit == 0 && attempt.size < kLeastQuick)) break;
    Walls walls(box_, grasp, span_, near, attempt.size);
    if (!walls.is_sound()) return std::nullopt;
    if (limits_.is_wide && !moves) {
      const RoundedBox rounded(box_);
      moves = MovingEquilibrium(rounded, near).extremes(walls.rows());
    }
    if (moves) walls.enclose(*moves);
    if (auto proof = prove_with(std::move(walls), attempt)) return proof;
  }
  return std::nullopt;
}

/// Walls that fit the moves: where the equilibrium goes farthest, or as far as the first order
/// says.
std::optional<DegreeProof> BoxDegreeSearch::prove_by_moves(const NearEquilibrium& near) {
  const RoundedBox rounded(box_);
  const RoundedGrasp grasp = rounded.at(rounded.middle());
  const MovingEquilibrium moving(rounded, near);
  const Eigen::MatrixXd each = moving.moves(rounded.middle(), near);
  std::vector<Reals> first;
  for (const auto& column : each.colwise()) first.emplace_back(column);
  const Attempt attempt{1e-3, limits_.node_limit, 18, SIZE_MAX};
  for (const bool first_order : {false, true}) {
    Walls walls(box_, grasp, span_, near, attempt.size);
    if (!walls.is_sound()) return std::nullopt;
    walls.turn_to(first);
    std::vector<Reals> moves = first;
    if (first_order) {
      // All at once, whichever way is farthest.
      for (const auto& row : walls.rows().rowwise()) {
        const Reals all = each * (row * each).transpose().cwiseSign();
        moves.push_back(all);
        moves.push_back(-all);
      }
    } else {
      moves = moving.extremes(walls.rows());
      walls.turn_to(moves);
    }
    if (!walls.is_sound()) continue;
    walls.enclose(moves);
    if (auto proof = prove_with(std::move(walls), attempt)) return proof;
  }
  return std::nullopt;
}

/// The walls that are not refuted; without growing, the first of them.
std::vector<std::size_t> BoxDegreeSearch::open_walls(DegreeProof& proof, bool second,
                                                     const Attempt& attempt) {
  const Law& about = second ? middle_ : box_;
  const PullRule pull(proof.direction, proof.twist);
  std::vector<std::size_t> open;
  for (std::size_t wall = 0; wall < proof.wall_count(); ++wall) {
    TreeSearch search(about, second ? &pull : nullptr, attempt.node_limit, work_);
    if (search.refute(MotionRegion::wall(about, proof, wall), proof.trees)) continue;
    open.push_back(wall);
    if (attempt.most_growths == 0) break;
  }
  return open;
}

std::optional<DegreeProof> BoxDegreeSearch::prove_with(Walls walls, const Attempt& attempt) {
  constexpr std::size_t kMostPulls = 4;  // growing seldom mends what list 2 refuses
  using Pull = Walls::Pull;
  std::vector<Pull> directions{Pull::kTwists};
  if (span_.rank() <= kFewDimensions) directions = {Pull::kFitted, Pull::kStiff};
  std::size_t pulls = 0;
  for (std::size_t growth = 0; growth <= attempt.most_growths; ++growth) {
    if (work_.nodes > attempt.most_nodes) return std::nullopt;
    ++work_.proofs;
    DegreeProof proof = walls.proof(directions.front(), attempt.is_simplex);
    if (!has_rank(proof, span_.rank())) return std::nullopt;
    if (box_.law == NormalLaw::kBilateral && !all_closed_inside<MotionRegion>(box_, proof)) {
      return std::nullopt;
    }
    std::vector<std::size_t> open;
    if (!box_.is_point()) open = open_walls(proof, false, attempt);  // else list 2 is enough
    if (open.empty()) {
      const auto second_list = static_cast<std::ptrdiff_t>(proof.trees.size());
      for (const Pull direction : directions) {
        if (direction != directions.front()) {
          proof.direction = walls.proof(direction, attempt.is_simplex).direction;
          proof.trees.erase(proof.trees.begin() + second_list, proof.trees.end());
          if (rank_of(proof.direction) != span_.rank()) continue;
        }
        std::vector<std::size_t> refused = open_walls(proof, true, attempt);
        if (refused.empty()) return proof;
        if (open.empty()) open = std::move(refused);
      }
      if (++pulls > kMostPulls) return std::nullopt;
    }
    for (const std::size_t wall : open) walls.grow(wall, attempt.is_simplex);
  }
  return std::nullopt;
}

}  // namespace

std::optional<DegreeProof> prove_by_degree(const GraspLaw& box, const GraspLaw& middle,
                                           const NearEquilibrium& near,
                                           const DegreeLimits& limits, SearchWork& work) {
  return BoxDegreeSearch(box, middle, limits, work).prove(near);
}

bool are_at_rest(const StabilityProof& parts) {
  return std::none_of(parts.begin(), parts.end(), [](const auto& part) {
    return std::holds_alternative<DegreeProof>(part);
  });
}

}  // namespace stickslip
