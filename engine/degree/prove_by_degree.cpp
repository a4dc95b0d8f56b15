// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>
#include <vector>

#include "body_reach.hpp"
#include "moving_equilibrium.hpp"
#include "prove_by_cloud.hpp"
#include "prove_stable.hpp"
#include "stickslip/lp/exact_system.hpp"
#include "wall_refuter.hpp"
#include "walls.hpp"

namespace stickslip {

using namespace degree_detail;

namespace {

using Pull = Walls::Pull;

/// Forces on all walls tell which A is best in so many dimensions or fewer.
constexpr std::size_t kFewDimensions = 3;
/// The largest rank for parallelepipeds: a wall of one has 2^(rank - 1) vertices, one of a
/// simplex rank.
constexpr std::size_t kMostOfParallelepipeds = 6;
/// \{ The most nodes of a tree that is worth a try.
constexpr std::size_t kFewNodes = 40;
constexpr std::size_t kSomeNodes = 300;
/// \}

/// One proposal of walls, grown until they are refuted.
struct Attempt {
  double size;               ///< the size for Walls
  std::size_t node_limit;    ///< the limit of a tree
  std::size_t most_growths;  ///< equilibria that go much farther are lost at a fold
  std::size_t most_nodes;    ///< nothing is tried once there were so many in all
  bool is_simplex = false;
};

class DegreeSearch {
 public:
  DegreeSearch(const DegreeSubject& about, WallRefuter& refuter, const DegreeLimits& limits,
               SearchWork& work)
      : about_(about), refuter_(refuter), limits_(limits), work_(work) {}

  /// Proves every grasp of a box.
  std::optional<DegreeProof> prove_box(const NearEquilibrium& near) {
    return about_.span.rank() <= kFewDimensions ? prove_by_moves(near) : prove_by_size(near);
  }
  /// Proves one grasp, near what may be an equilibrium.
  std::optional<DegreeProof> prove_quickly(const NearEquilibrium& proposed);
  /// Proves one grasp near an equilibrium, where prove_quickly() failed.
  std::optional<DegreeProof> prove_one(const NearEquilibrium& near);

 private:
  std::optional<DegreeProof> prove_by_size(const NearEquilibrium& near);
  std::optional<DegreeProof> prove_by_moves(const NearEquilibrium& near);
  std::optional<DegreeProof> prove_in_mode(const NearEquilibrium& near, double size,
                                           std::size_t node_limit);
  std::optional<DegreeProof> prove_smoothly(const NearEquilibrium& near,
                                            std::size_t node_limit);
  std::optional<DegreeProof> prove_smoothly(const NearEquilibrium& near, double part,
                                            double slip, std::size_t node_limit);
  std::optional<DegreeProof> prove_with(Walls walls, const Attempt& attempt,
                                        const std::vector<Pull>& pulls);
  std::vector<std::size_t> open_walls(DegreeProof& proof, bool second, const Attempt& attempt);

  const DegreeSubject& about_;
  WallRefuter& refuter_;
  const DegreeLimits& limits_;
  SearchWork& work_;
};

/// Tries one size after another: if the equilibrium moves little, that is all that matters.
/// If it moves far in a box, walls around a cloud come before those that take many nodes.
std::optional<DegreeProof> DegreeSearch::prove_by_size(const NearEquilibrium& near) {
  constexpr double kLeastQuick = 1e-3;
  const std::size_t limit = limits_.node_limit;
  const std::size_t growths = limits_.is_wide ? 12 : 0;
  const std::size_t most = limits_.most_nodes;
  std::optional<std::vector<Reals>> moves;
  const bool is_high = about_.span.rank() > kMostOfParallelepipeds;
  const auto quick = [&](double size) { return Attempt{size, kFewNodes, 0, most}; };
  const auto thorough = [&](double size) { return Attempt{size, limit, growths, most}; };
  std::vector<Attempt> attempts =
      limits_.is_wide || is_high
          ? std::vector{quick(3e-2), quick(3e-3), quick(3e-4), quick(3e-5), thorough(3e-2)}
          // The walls around one grasp may be closer, and are seldom to be very close.
          : std::vector{quick(3e-3), quick(3e-2), quick(3e-4), thorough(3e-2), quick(3e-5)};
  attempts.insert(attempts.end(), {thorough(1e-3), thorough(3e-1)});
  if (!is_high) {
    attempts.push_back({3e-2, limit, growths, most, true});
  } else {
    if (!limits_.is_wide) {
      // The walls of a simplex go far in some directions: many take a hundred nodes.
      attempts.insert(attempts.begin() + 4,
                      {{3e-3, kSomeNodes, 0, most}, {3e-5, kSomeNodes, 0, most}});
    }
    for (Attempt& attempt : attempts) attempt.is_simplex = true;
  }
  const bool is_box = limits_.is_wide && limit > 0;
  std::size_t before_cloud = 4;  // so many are quick
  if (is_box && about_.box->ball && !attempts.front().is_simplex) {
    // Walls that need few nodes are cheaper than a cloud.
    constexpr std::size_t kMostBefore = 1000;
    attempts.insert(attempts.begin() + 4, {3e-2, limit, growths, work_.nodes + kMostBefore});
    before_cloud = 5;
  }
  std::size_t tried = 0;
  for (const Attempt& attempt : attempts) {
    if (tried++ == before_cloud && is_box) {
      if (auto proof = prove_by_cloud(about_, near, work_)) return proof;
    }
    if (attempt.node_limit == 0 || (limit == 0 && attempt.size < kLeastQuick)) break;
    Walls walls(about_.grasp, about_.span, near, attempt.size, about_.box);
    if (!walls.is_sound()) return std::nullopt;
    if (limits_.is_wide && !moves) {
      const RoundedBox rounded(*about_.box);
      moves = MovingEquilibrium(rounded, near).extremes(walls.rows());
    }
    if (moves) walls.enclose(*moves);
    if (auto proof = prove_with(std::move(walls), attempt, {Pull::kTwists})) return proof;
  }
  return limits_.is_wide ? std::nullopt : prove_smoothly(near, std::min(limit, kSomeNodes));
}

/// Tries walls across smooth forces, of one size after another.
std::optional<DegreeProof> DegreeSearch::prove_smoothly(const NearEquilibrium& near,
                                                        std::size_t node_limit) {
  if (node_limit == 0) return std::nullopt;
  for (const auto& [force, slip] : {std::pair{0.03, 0.1},
                                    {0.3, 1.0},
                                    {0.3, 0.1},
                                    {0.1, 1.0},
                                    {0.1, 0.1},
                                    {0.3, 0.01},
                                    {0.03, 1.0},
                                    {0.1, 10.0},
                                    {0.1, 0.01},
                                    {0.01, 1.0}}) {
    if (auto proof = prove_smoothly(near, force, slip, node_limit)) return proof;
  }
  return std::nullopt;
}

/// Tries walls in the mode, then across smooth forces. The latter are best if a mode ends near
/// the equilibrium, as with many contacts, and the proposal need not be exact for them.
std::optional<DegreeProof> DegreeSearch::prove_quickly(const NearEquilibrium& proposed) {
  const auto polished = Newton(about_.grasp).polish(proposed);
  if (polished) {
    if (auto proof = prove_in_mode(*polished, 3e-1, kFewNodes)) return proof;
  }
  return prove_smoothly(polished ? *polished : proposed, 0.03, 0.1, kSomeNodes);
}

std::optional<DegreeProof> DegreeSearch::prove_one(const NearEquilibrium& near) {
  const std::size_t limit = limits_.node_limit;
  for (const double size : {3e-1, 3e-2, 3e-3, 3e-4, 3e-5}) {
    if (auto proof = prove_in_mode(near, size, kFewNodes)) return proof;
  }
  if (auto proof = prove_in_mode(near, 3e-1, limit)) return proof;
  if (auto proof = prove_smoothly(near, limit)) return proof;
  for (const double size : {3e-2, 1e-3}) {
    if (auto proof = prove_in_mode(near, size, limit)) return proof;
  }
  return std::nullopt;
}

std::optional<DegreeProof> DegreeSearch::prove_in_mode(const NearEquilibrium& near, double size,
                                                       std::size_t node_limit) {
  Walls walls(about_.grasp, about_.span, near, size, about_.box);
  if (!walls.is_sound()) return std::nullopt;
  return prove_with(std::move(walls), {size, node_limit, 0, limits_.most_nodes},
                    {Pull::kTwists, Pull::kStiff});
}

/// Tries walls on which the part `part` of all normal forces is left over; friction is smooth
/// over the part `slip` of how far that moves springs.
std::optional<DegreeProof> DegreeSearch::prove_smoothly(const NearEquilibrium& near,
                                                        double part, double slip,
                                                        std::size_t node_limit) {
  double force = 0;
  double stiffness = 0;
  for (std::size_t i = 0; i < about_.grasp.contacts.size(); ++i) {
    const RoundedContact& c = about_.grasp.contacts[i];
    force += std::fabs(near.normal[i]) * c.size;
    stiffness += c.stiffness * c.size * c.size;
  }
  const double left = part * force;
  const Eigen::MatrixXd answer =
      Newton(about_.grasp).answer(near.motion, slip * left / stiffness);
  Walls walls(about_.grasp, about_.span, near, answer, answer,
              Eigen::VectorXd::Constant(answer.rows(), left));
  if (!walls.is_sound()) return std::nullopt;
  return prove_with(
      std::move(walls),
      {0, node_limit, 0, limits_.most_nodes, about_.span.rank() > kMostOfParallelepipeds},
      {Pull::kAnswer});
}

/// Tries walls that fit the moves: where the equilibrium goes farthest, or as far as the first
/// order says.
std::optional<DegreeProof> DegreeSearch::prove_by_moves(const NearEquilibrium& near) {
  const RoundedBox rounded(*about_.box);
  const RoundedGrasp grasp = rounded.at(rounded.middle());
  const MovingEquilibrium moving(rounded, near);
  const Eigen::MatrixXd each = moving.moves(rounded.middle(), near);
  std::vector<Reals> first;
  for (const auto& column : each.colwise()) first.emplace_back(column);
  const Attempt attempt{1e-3, limits_.node_limit, 18, SIZE_MAX};
  for (const bool first_order : {false, true}) {
    Walls walls(grasp, about_.span, near, attempt.size, about_.box);
    if (!walls.is_sound()) return std::nullopt;
    walls.turn_to(first);
    std::vector<Reals> moves = first;
    if (first_order) {
      // All numbers move at once, whichever way is farthest.
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
    auto proof = prove_with(std::move(walls), attempt, {Pull::kFitted, Pull::kStiff});
    if (proof) return proof;
  }
  return std::nullopt;
}

/// Returns the walls that are not refuted; without growing, the first of them.
std::vector<std::size_t> DegreeSearch::open_walls(DegreeProof& proof, bool second,
                                                  const Attempt& attempt) {
  std::vector<std::size_t> open;
  for (std::size_t wall = 0; wall < proof.wall_count(); ++wall) {
    if (refuter_.refute(proof, wall, second, attempt.node_limit)) continue;
    open.push_back(wall);
    if (attempt.most_growths == 0) break;
  }
  return open;
}

std::optional<DegreeProof> DegreeSearch::prove_with(Walls walls, const Attempt& attempt,
                                                    const std::vector<Pull>& pulls) {
  constexpr std::size_t kMostPulled = 4;  // growing seldom mends what list 2 refuses
  const bool is_one = about_.box == nullptr || about_.box->is_point();
  std::size_t pulled = 0;
  for (std::size_t growth = 0; growth <= attempt.most_growths; ++growth) {
    if (work_.nodes > attempt.most_nodes) return std::nullopt;
    ++work_.proofs;
    DegreeProof proof = walls.proof(pulls.front(), attempt.is_simplex);
    if (!has_rank(proof, about_.span.rank())) return std::nullopt;
    if (about_.box != nullptr && !is_within(proof, about_.box->max_motion)) return std::nullopt;
    if (about_.law == NormalLaw::kBilateral && !refuter_.all_are_closed(proof)) {
      return std::nullopt;
    }
    std::vector<std::size_t> open;
    if (!is_one) open = open_walls(proof, false, attempt);  // list 2 is enough for one grasp
    if (open.empty()) {
      const auto second_list = static_cast<std::ptrdiff_t>(proof.trees.size());
      for (const Pull pull : pulls) {
        if (pull != pulls.front()) {
          proof.direction = walls.proof(pull, attempt.is_simplex).direction;
          proof.trees.erase(proof.trees.begin() + second_list, proof.trees.end());
          if (rank_of(proof.direction) != about_.span.rank()) continue;
        }
        std::vector<std::size_t> refused = open_walls(proof, true, attempt);
        if (refused.empty()) return proof;
        if (open.empty()) open = std::move(refused);
      }
      if (++pulled > kMostPulled) return std::nullopt;
    }
    for (const std::size_t wall : open) walls.grow(wall, attempt.is_simplex);
  }
  return std::nullopt;
}

}  // namespace

std::optional<DegreeProof> prove_by_degree(const GraspLaw& box, const GraspLaw& middle,
                                           const NearEquilibrium& near,
                                           const DegreeLimits& limits, SearchWork& work) {
  const DegreeSubject about{rounded_middle(middle), ForceSpan(box), box.normal_law, &box,
                            &middle};
  if (!about.span.has_loads_of(box)) return std::nullopt;
  LawRefuter refuter(box, middle, work);
  return DegreeSearch(about, refuter, limits, work).prove_box(near);
}

std::optional<DegreeProof> prove_by_degree(const Problem& problem, SearchWork& work) {
  const DegreeSubject about{rounded_grasp(problem), ForceSpan(problem), problem.law(), nullptr,
                            nullptr};
  if (!about.span.has_load_of(problem)) return std::nullopt;
  CrowdWalls walls(problem);
  CrowdRefuter refuter(walls, work);
  constexpr std::size_t kMostNodes = 1000;
  const DegreeLimits limits{kMostNodes, SIZE_MAX, false};
  DegreeSearch search(about, refuter, limits, work);
  const Newton newton(about.grasp);
  std::vector<Reals> tried;
  for (const std::size_t starts : {0, 1}) {
    for (const NearEquilibrium& proposed :
         walls.newton_equilibria(starts, about.grasp.length)) {
      if (starts == 0) {
        if (auto proof = search.prove_quickly(proposed)) return proof;
      }
      const auto followed = newton.follow(proposed);
      const NearEquilibrium found = followed ? *followed : newton.settle(proposed);
      const bool is_known = std::any_of(tried.begin(), tried.end(), [&](const Reals& motion) {
        constexpr double kSame = 1e-6;
        return (motion - found.motion).norm() <= kSame * motion.norm();
      });
      if (is_known) continue;
      if (auto proof = search.prove_one(found)) return proof;
      tried.push_back(found.motion);
    }
  }
  return std::nullopt;
}

}  // namespace stickslip
