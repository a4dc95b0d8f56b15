// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "body_reach.hpp"
#include "equilibrium_cloud.hpp"
#include "moving_equilibrium.hpp"
#include "moving_refuter.hpp"
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
/// The same of walls around the cloud of a ball of loads, as of a hand of four joints: they
/// prove what simplices do not.
constexpr std::size_t kMostOfClouds = 7;
/// \{ The most nodes of a tree that is worth a try.
constexpr std::size_t kFewNodes = 40;
constexpr std::size_t kSomeNodes = 300;
/// \}

/// Returns whether all of the body, up to free motions, is within the bound: rule
/// `degree-bound`, of verdicts.
bool is_within(const DegreeProof& proof, const RationalRow& bound) {
  if (bound.empty()) return true;
  const BodyReach reach(proof);
  if (!reach.is_sound()) return false;
  RationalRow axis(bound.size());
  for (std::size_t j = 0; j < bound.size(); ++j) {
    for (const int sign : {1, -1}) {
      axis[j] = sign;
      if (sign * proof.twist[j] + reach.largest(axis) > bound[j]) return false;
    }
    axis[j] = 0;
  }
  return true;
}

/// One proposal of walls, grown until they are refuted.
struct Attempt {
  double size;               ///< the size for Walls
  std::size_t node_limit;    ///< the limit of a tree
  std::size_t most_growths;  ///< equilibria that go much farther are lost at a fold
  std::size_t most_nodes;    ///< nothing is tried once there were so many in all
  bool is_simplex = false;
};

/// The grasps that are to be proved stable.
struct DegreeSubject {
  RoundedGrasp grasp;      ///< the grasp in the middle, or the only one
  ForceSpan span;          ///< the span of all grasps' forces
  NormalLaw law;           ///< the law of all contacts
  const GraspLaw* box;     ///< nullptr: one grasp in the plane
  const GraspLaw* middle;  ///< the law of the grasp in the middle of the box; nullptr as before
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
  std::optional<DegreeProof> prove_by_cloud(const NearEquilibrium& near);
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
  std::vector<Attempt> attempts{
      {3e-2, kFewNodes, 0, most},   {3e-3, kFewNodes, 0, most},
      {3e-4, kFewNodes, 0, most},   {3e-5, kFewNodes, 0, most},
      {3e-2, limit, growths, most}, {1e-3, limit, growths, most},
      {3e-1, limit, growths, most}, {3e-2, limit, growths, most, true}};
  if (about_.span.rank() > kMostOfParallelepipeds) {
    attempts.pop_back();
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
      if (auto proof = prove_by_cloud(near)) return proof;
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

/// Tries walls around a cloud of equilibria of grasps of the box, with leaves whose twists
/// move. If geometry is uncertain there is room around the cloud, so that what slips there
/// slips one way; a wall that is not refuted moves to where doubles see a reason at the point
/// at which it failed. Else the walls are close to a cloud of more places.
std::optional<DegreeProof> DegreeSearch::prove_by_cloud(const NearEquilibrium& near) {
  const bool is_verdict = !about_.box->is_family && !about_.box->hull;
  const auto& contacts = about_.box->contacts;
  const bool is_close = std::all_of(contacts.begin(), contacts.end(),
                                    [](const auto& c) { return c.geometry_is_certain(); });
  const std::size_t most_rank =
      is_close && about_.box->ball ? kMostOfClouds : kMostOfParallelepipeds;
  if (!is_verdict || about_.span.rank() > most_rank) return std::nullopt;
  const std::size_t places = is_close ? 400 : 100;
  // A proof takes a few hundred, of a hand up to twice as many.
  const std::size_t most_pieces = about_.span.rank() > kMostOfParallelepipeds ? 2000 : 1000;
  if (work_.pieces > most_pieces) return std::nullopt;
  const RoundedBox rounded(*about_.box);
  const std::vector<Reals> moves = MovingEquilibrium(rounded, near).cloud(places);
  const CloudCoordinates cloud(about_.grasp, about_.span, near, moves);
  if (!(cloud.press > 0)) return std::nullopt;
  MovingRefuter refuter(*about_.box, *about_.middle, work_);
  const double room_of_extent = is_close ? 1 : 10;
  constexpr double kLeastRoom = 0.12;
  const double least = kLeastRoom * cloud.press;
  Eigen::VectorXd room = (room_of_extent * cloud.extent).cwiseMax(least);
  // Springs answer as A does near them; far off a fit to the forces on the walls is better.
  const std::array<Pull, 2> pulls = is_close ? std::array{Pull::kFitted, Pull::kAnswer}
                                             : std::array{Pull::kAnswer, Pull::kFitted};
  constexpr int kMostGrowths = 6;
  std::optional<Walls> walls;
  for (int growth = 0; growth <= kMostGrowths && work_.pieces <= most_pieces; ++growth) {
    ++work_.proofs;
    if (!walls) {
      const Eigen::MatrixXd answer =
          Newton(about_.grasp).answer(near.motion, median_of({room.begin(), room.end()}));
      if (is_close) room.setConstant(least);
      walls.emplace(about_.grasp, about_.span, near, answer, cloud.rows, room);
      if (!walls->is_sound()) return std::nullopt;
      if (is_close) walls->enclose(moves);
    }
    DegreeProof proof = walls->proof(Pull::kAnswer, false);
    if (!has_rank(proof, about_.span.rank()) || !is_within(proof, about_.box->max_motion)) {
      return std::nullopt;
    }
    if (about_.law == NormalLaw::kBilateral && !refuter.all_are_closed(proof)) {
      return std::nullopt;
    }
    const auto first_open = [&](bool second) -> std::optional<std::size_t> {
      for (std::size_t wall = 0; wall < proof.wall_count(); ++wall) {
        const std::size_t left = most_pieces > work_.pieces ? most_pieces - work_.pieces : 0;
        if (!refuter.refute(proof, wall, second, left)) return wall;
      }
      return std::nullopt;
    };
    std::optional<std::size_t> open = first_open(false);
    if (!open) {
      const auto of_list_1 = static_cast<std::ptrdiff_t>(proof.trees.size());
      for (const Pull pull : pulls) {
        proof.trees.erase(proof.trees.begin() + of_list_1, proof.trees.end());
        proof.direction = walls->proof(pull, false).direction;
        if (!has_rank(proof, about_.span.rank())) continue;
        open = first_open(true);
        if (!open) return proof;
      }
    }
    if (!open || refuter.lost_at().size() == 0) return std::nullopt;
    if (is_close) {
      walls->grow(*open, false);
      continue;
    }
    double best = 0;
    double farther = 1;
    for (const double part : {0.5, 0.7, 1.0, 1.4, 2.0, 2.8}) {
      const double bound = refuter.bound_at(proof, part * refuter.lost_at()) / part;
      if (bound < best) {
        best = bound;
        farther = part;
      }
    }
    if (!(best < 0)) return std::nullopt;
    constexpr double kClear = 1e-6;
    if (best > -kClear) farther = 1.4;
    if (farther == 1) farther = 1.25;
    room[static_cast<Eigen::Index>(*open / 2)] *= farther;
    walls.reset();
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
