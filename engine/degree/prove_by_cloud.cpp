// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove_by_cloud.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "body_reach.hpp"
#include "equilibrium_cloud.hpp"
#include "moving_equilibrium.hpp"
#include "moving_refuter.hpp"
#include "walls.hpp"

namespace stickslip::degree_detail {
namespace {

using Pull = Walls::Pull;

/// \{ The largest rank: walls of a parallelepiped have 2^(rank - 1) vertices each. Balls of
/// loads, as of a hand of four joints, are proved so where simplices prove nothing.
constexpr std::size_t kMostRank = 6;
constexpr std::size_t kMostRankOfBalls = 7;
/// \}

/// The search for walls around one cloud, and for their trees.
class CloudSearch {
 public:
  CloudSearch(const DegreeSubject& about, const NearEquilibrium& near, bool is_close,
              std::size_t most_pieces, SearchWork& work)
      : about_(about),
        near_(near),
        is_close_(is_close),
        most_pieces_(most_pieces),
        work_(work),
        refuter_(*about.box, *about.middle, work),
        moves_(MovingEquilibrium(RoundedBox(*about.box), near).cloud(is_close ? 400 : 100)),
        cloud_(about.grasp, about.span, near, moves_) {}

  std::optional<DegreeProof> prove();

 private:
  Walls walls_with(const Eigen::VectorXd& room) const;
  bool may_be_proof(const DegreeProof& proof);
  bool refute_walls(DegreeProof& proof, bool second);
  bool find_trees(const Walls& walls, DegreeProof& proof);
  double growth(const DegreeProof& proof) const;

  const DegreeSubject& about_;
  const NearEquilibrium& near_;
  bool is_close_;
  std::size_t most_pieces_;
  SearchWork& work_;
  MovingRefuter refuter_;
  std::vector<Reals> moves_;
  CloudCoordinates cloud_;
  std::optional<std::size_t> lost_;  ///< the wall of the last body that was not refuted
};

/// Returns walls with so much room. If they are to be close, they have little around the cloud.
Walls CloudSearch::walls_with(const Eigen::VectorXd& room) const {
  const Eigen::MatrixXd answer =
      Newton(about_.grasp).answer(near_.motion, median_of({room.begin(), room.end()}));
  Walls walls(about_.grasp, about_.span, near_, answer, cloud_.rows, room);
  if (is_close_ && walls.is_sound()) walls.enclose(moves_);
  return walls;
}

/// Returns whether nothing but trees is missing.
bool CloudSearch::may_be_proof(const DegreeProof& proof) {
  return has_rank(proof, about_.span.rank()) && is_within(proof, about_.box->max_motion) &&
         (about_.law != NormalLaw::kBilateral || refuter_.all_are_closed(proof));
}

/// Appends the trees of a list, up to a wall that is not refuted.
bool CloudSearch::refute_walls(DegreeProof& proof, bool second) {
  for (std::size_t wall = 0; wall < proof.wall_count(); ++wall) {
    const std::size_t left = most_pieces_ > work_.pieces ? most_pieces_ - work_.pieces : 0;
    if (refuter_.refute(proof, wall, second, left)) continue;
    lost_ = wall;
    return false;
  }
  return true;
}

/// Finds all trees.
bool CloudSearch::find_trees(const Walls& walls, DegreeProof& proof) {
  lost_.reset();
  if (!refute_walls(proof, false)) return false;
  // Springs answer as A does near them; far off a fit to the forces on the walls is better.
  const std::array<Pull, 2> pulls = is_close_ ? std::array{Pull::kFitted, Pull::kAnswer}
                                              : std::array{Pull::kAnswer, Pull::kFitted};
  const auto of_list_1 = static_cast<std::ptrdiff_t>(proof.trees.size());
  for (const Pull pull : pulls) {
    proof.trees.erase(proof.trees.begin() + of_list_1, proof.trees.end());
    proof.direction = walls.proof(pull, false).direction;
    if (has_rank(proof, about_.span.rank()) && refute_walls(proof, true)) return true;
  }
  return false;
}

/// Returns by how much to move the wall that was not refuted, so that doubles see a reason at
/// the point at which that failed; 0 if they see none.
double CloudSearch::growth(const DegreeProof& proof) const {
  double best = 0;
  double farther = 0;
  for (const double part : {0.5, 0.7, 1.0, 1.4, 2.0, 2.8}) {
    const double bound = refuter_.bound_at(proof, part * refuter_.lost_at()) / part;
    if (!(bound < best)) continue;
    best = bound;
    farther = part;
  }
  constexpr double kClear = 1e-6;
  if (best < 0 && best > -kClear) return 1.4;
  return farther == 1 ? 1.25 : farther;
}

std::optional<DegreeProof> CloudSearch::prove() {
  if (!(cloud_.press > 0)) return std::nullopt;
  // Room in parts of how far contacts are pressed in, and of the cloud. What moves little needs
  // more of the first if a wall is lost.
  constexpr double kLittleRoom = 0.12;
  constexpr double kMoreRoom = 0.3;
  constexpr double kRoomOfExtent = 10;
  Eigen::VectorXd room = Eigen::VectorXd::Zero(cloud_.extent.size());
  if (!is_close_) room = kRoomOfExtent * cloud_.extent;
  room = room.cwiseMax(kLittleRoom * cloud_.press);
  std::optional<Walls> walls = walls_with(room);
  constexpr int kMostGrowths = 6;
  for (int growths = 0; growths <= kMostGrowths; ++growths) {
    ++work_.proofs;
    if (!walls->is_sound()) return std::nullopt;
    DegreeProof proof = walls->proof(Pull::kAnswer, false);
    if (!may_be_proof(proof)) return std::nullopt;
    if (find_trees(*walls, proof)) return proof;
    if (!lost_ || refuter_.lost_at().size() == 0 || work_.pieces >= most_pieces_) break;
    if (is_close_) {
      walls->grow(*lost_, false);
      continue;
    }
    const double farther = growth(proof);
    if (farther == 0) break;
    const auto row = static_cast<Eigen::Index>(*lost_ / 2);
    const double moved = farther * room[row];
    room = room.cwiseMax(kMoreRoom * cloud_.press);
    room[row] = moved;
    walls.emplace(walls_with(room));
  }
  return std::nullopt;
}

}  // namespace

std::optional<DegreeProof> prove_by_cloud(const DegreeSubject& about,
                                          const NearEquilibrium& near, SearchWork& work) {
  const GraspLaw& box = *about.box;
  const bool is_close = std::all_of(box.contacts.begin(), box.contacts.end(),
                                    [](const auto& c) { return c.geometry_is_certain(); });
  const std::size_t most_rank = is_close && box.ball ? kMostRankOfBalls : kMostRank;
  if (box.is_family || box.hull || about.span.rank() > most_rank) return std::nullopt;
  // A proof takes a few hundred, of a hand up to twice as many; one in ten takes thousands
  // where geometry is uncertain.
  constexpr std::size_t kMostOfTolerances = 6000;
  const std::size_t most_of_loads = about.span.rank() > kMostRank ? 2000 : 1000;
  const std::size_t most_pieces = is_close ? most_of_loads : kMostOfTolerances;
  if (work.pieces > most_pieces) return std::nullopt;
  return CloudSearch(about, near, is_close, most_pieces, work).prove();
}

}  // namespace stickslip::degree_detail
