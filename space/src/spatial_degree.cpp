// SPDX-License-Identifier: GPL-3.0-or-later
#include "spatial_degree.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <utility>

#include "space_search.hpp"
#include "stickslip/equilibrium/search/independent_rows.hpp"

namespace stickslip::space_detail {

using equilibrium_detail::IndependentRows;

namespace {

/// Where the walls are to be, and which way the grasp in the middle pulls, in doubles.
///
/// On the walls E_j.(d - d0) = +-1 of the slip of a sticking contact its friction is against
/// that slip, and a virtual twist Y_j that moves nothing else that sticks sees it. The other
/// rows are forces on virtual twists on which what sticks does no work. A is such that
/// Y_j.A(d - d0) is E_j.(d - d0).
class SpatialWalls {
 public:
  SpatialWalls(const SpaceModel& middle, const NearEquilibrium& equilibrium, double size);

  bool is_sound() const { return sound_; }
  /// Moves walls outwards until these moves, one after another, stay well within.
  void enclose(const std::vector<EigenVector6>& moves) {
    constexpr double kWithin = 0.7;
    for (Eigen::Index j = 0; j < 6; ++j) {
      double up = 0;
      double down = 0;
      for (const EigenVector6& move : moves) {
        const double far = rows_.row(j).dot(move);
        (far > 0 ? up : down) += std::fabs(far);
      }
      rows_.row(j) /= std::max({1.0, up / kWithin, down / kWithin});
    }
  }
  /// Moves two walls outwards by a quarter of their distance.
  void grow(std::size_t wall) { rows_.row(static_cast<Eigen::Index>(wall)) /= 1.25; }
  /// d0, E and A in few bits.
  SpatialDegreeProof proof() const;

 private:
  double room(const NearEquilibrium& equilibrium, const EigenVector6& way) const;

  const SpaceModel& model_;
  EigenVector6 motion_;
  EigenMatrix6 rows_ = EigenMatrix6::Zero();    ///< E
  EigenMatrix6 twists_ = EigenMatrix6::Zero();  ///< Y, by columns
  bool sound_ = false;
};

SpatialWalls::SpatialWalls(const SpaceModel& middle, const NearEquilibrium& equilibrium,
                           double size)
    : model_(middle), motion_(equilibrium.motion) {
  // Small beside what would change a mode.
  double width = middle.reach;
  for (std::size_t i = 0; i < middle.contacts.size(); ++i) {
    const SpaceContact& c = middle.contacts[i];
    const CornerRow& row = c.corners.front();
    const double v =
        c.preloads[0] - c.stiffnesses[0] * as_vector(row.normal_rounded).dot(motion_);
    const double stretch =
        std::fabs(v) / (c.stiffnesses[0] * std::sqrt(to_double(c.squared_length)));
    if (stretch > 0) width = std::min(width, stretch);
    if (!(v > 0) || equilibrium.sticks[i] != 0 || !(c.slopes[0] > 0)) continue;
    width = std::min(width, (slip_matrix(row) * motion_).norm());
  }
  width *= size;
  // How forces answer motion, but for sticking friction.
  EigenMatrix6 stiffness = EigenMatrix6::Zero();
  struct Candidate {
    EigenVector6 row;
    double spare;
    double width;
  };
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < middle.contacts.size(); ++i) {
    const SpaceContact& c = middle.contacts[i];
    const CornerRow& row = c.corners.front();
    const double a = equilibrium.normal[i];
    if (!(a > 0)) continue;
    const SlipMatrix slip = slip_matrix(row);
    const Eigen::Vector3d friction(equilibrium.friction[i].data());
    const EigenVector6 normal = as_vector(row.normal_rounded);
    stiffness +=
        c.stiffnesses[0] * (normal + slip.transpose() * friction / a) * normal.transpose();
    const double most = c.slopes[0] * a;
    if (!(most > 0)) continue;
    if (equilibrium.sticks[i] == 0) {
      const Eigen::Vector3d s = slip * motion_;
      const double speed = s.norm();
      stiffness += most / speed *
                   (slip.transpose() *
                    (Eigen::Matrix3d::Identity() - s * s.transpose() / (speed * speed)) * slip);
      continue;
    }
    const Eigen::Vector3d first(c.tangents[0].data());
    const Eigen::Vector3d second(c.tangents[1].data());
    const double share = std::min(friction.norm() / most, 0.999999);
    const Eigen::Vector3d along = share > 1e-3 ? friction.normalized() : first;
    const Eigen::Vector3d across = first.cross(second).cross(along).normalized();
    // Beside a slip of `width` along the friction one across it that leaves enough against it.
    const double aspect = std::min(1.0, 0.5 * std::sqrt(1 / (share * share) - 1));
    candidates.push_back({slip.transpose() * along, most - friction.norm(), width});
    candidates.push_back({slip.transpose() * across, most, width * aspect});
  }
  // Sticking contacts whose slips are independent, those with most friction to spare first.
  constexpr double kIndependent = 1e-2;
  IndependentRows<6> independent;
  Eigen::Index count = 0;
  while (const auto chosen = independent.take_best(candidates, kIndependent)) {
    rows_.row(count++) = candidates[*chosen].row / candidates[*chosen].width;
  }
  const Eigen::Index sticking = count;
  // Virtual twists on which these contacts' friction does no work; of these those whose forces
  // answer the motions across one another (a singular value decomposition).
  const Eigen::MatrixXd frame = independent.complement();
  const Eigen::Index free = frame.cols();
  Eigen::JacobiSVD<Eigen::MatrixXd> answers;
  if (free > 0) {
    answers.compute(frame.transpose() * stiffness * frame,
                    Eigen::ComputeFullU | Eigen::ComputeFullV);
  }
  for (Eigen::Index k = 0; k < free; ++k) {
    const double strength = answers.singularValues()[k];
    if (!(strength > 0)) return;
    twists_.col(count) = frame * answers.matrixU().col(k);
    const EigenVector6 way = frame * answers.matrixV().col(k);
    const double far = size * std::min(middle.force / strength, room(equilibrium, way));
    rows_.row(count) = stiffness.transpose() * twists_.col(count) / (strength * far);
    ++count;
  }
  double product = 1;
  for (Eigen::Index j = 0; j < 6; ++j) product *= rows_.row(j).norm();
  constexpr double kFlat = 1e-12;
  if (!(product > 0) || !(std::fabs(rows_.determinant()) > kFlat * product)) return;
  const EigenMatrix6 inverse = rows_.inverse();
  for (Eigen::Index j = 0; j < sticking; ++j) twists_.col(j) = inverse.col(j).normalized();
  for (Eigen::Index j = 0; j < 6; ++j) twists_.col(j).normalize();
  sound_ = std::fabs(twists_.determinant()) > kFlat;
}

/// How far the object can move this way before a contact opens or closes, or slips another way.
double SpatialWalls::room(const NearEquilibrium& equilibrium, const EigenVector6& way) const {
  double room = HUGE_VAL;
  const auto consider = [&](double distance, double speed) {
    if (distance > 0 && speed > 0) room = std::min(room, distance / speed);
  };
  for (std::size_t i = 0; i < model_.contacts.size(); ++i) {
    const SpaceContact& c = model_.contacts[i];
    const CornerRow& row = c.corners.front();
    const EigenVector6 normal = as_vector(row.normal_rounded);
    const double v = c.preloads[0] - c.stiffnesses[0] * normal.dot(motion_);
    consider(std::fabs(v), c.stiffnesses[0] * std::fabs(normal.dot(way)));
    if (!(v > 0) || equilibrium.sticks[i] != 0 || !(c.slopes[0] > 0)) continue;
    consider((slip_matrix(row) * motion_).norm(), (slip_matrix(row) * way).norm());
  }
  return room;
}

SpatialDegreeProof SpatialWalls::proof() const {
  constexpr int kBits = 14;
  SpatialDegreeProof result{};
  const EigenMatrix6 pull = twists_.transpose().inverse() * rows_;
  if (!rows_.allFinite() || !pull.allFinite() || !motion_.allFinite()) return result;
  const double finest = 1 / rows_.cwiseAbs().maxCoeff();
  const double largest = pull.cwiseAbs().maxCoeff();
  for (Eigen::Index j = 0; j < 6; ++j) {
    for (Eigen::Index k = 0; k < 6; ++k) {
      const double column = k < 3 ? 1 : model_.length;
      const auto row = static_cast<std::size_t>(j);
      const auto entry = static_cast<std::size_t>(k);
      result.walls[row][entry] = rational_in_bits(rows_(j, k) * column, kBits);
      result.direction[row][entry] =
          rational_in_bits(pull(j, k) / largest * column * (j < 3 ? 1 : model_.length), kBits);
    }
    const double scale = j < 3 ? 1 : model_.length;
    const double grain = std::ldexp(1.0, std::ilogb(finest / scale) - 10);
    result.twist[static_cast<std::size_t>(j)] =
        rational_from_double(std::round(motion_[j] / scale / grain) * grain);
  }
  return result;
}

}  // namespace

std::optional<SpatialDegreeProof> prove_stable(const SpaceModel& model,
                                               const SpaceModel& middle,
                                               const NearEquilibrium& equilibrium,
                                               std::size_t node_limit, SpatialWork& work,
                                               const std::vector<EigenVector6>& moves) {
  const bool is_point = model.is_point();
  struct Attempt {
    double size;
    std::size_t limit;
  };
  constexpr std::size_t kFew = 40;
  constexpr double kLeastQuick = 1e-3;
  for (const auto& [size, limit] : {Attempt{3e-2, kFew},
                                    {3e-3, kFew},
                                    {3e-4, kFew},
                                    {3e-5, kFew},
                                    {3e-2, node_limit},
                                    {1e-3, node_limit},
                                    {3e-1, node_limit}}) {
    if (limit == 0 || (node_limit == 0 && size < kLeastQuick)) break;
    SpatialWalls walls(middle, equilibrium, size);
    if (!walls.is_sound()) return std::nullopt;
    walls.enclose(moves);
    // Walls that fail are moved outwards, where the box is wide.
    constexpr std::size_t kMostGrowths = 12;
    const std::size_t growths = limit == node_limit && !moves.empty() ? kMostGrowths : 0;
    for (std::size_t growth = 0; growth <= growths; ++growth) {
      ++work.proofs;
      SpatialDegreeProof proof = walls.proof();
      if (!is_invertible(proof.walls) || !is_invertible(proof.direction)) break;
      if (model.law == NormalLaw::kBilateral && !all_closed_inside<SpaceRegion>(model, proof))
        break;
      const Direction<6> direction{proof.direction, proof.twist};
      const auto refute_all = [&](bool second) {
        const SpaceModel& about = second ? middle : model;
        bool all = true;
        for (std::size_t wall = 0; wall < 6; ++wall) {
          for (const int sign : {1, -1}) {
            SpaceSearch search(about, second ? &direction : nullptr, limit, work);
            if (search.refute(SpaceRegion::wall(about, proof.walls, proof.twist, wall, sign),
                              proof.trees)) {
              continue;
            }
            all = false;
            if (growths == 0) return false;
            walls.grow(wall);
            break;
          }
        }
        return all;
      };
      if ((is_point || refute_all(false)) && refute_all(true)) return proof;
    }
  }
  return std::nullopt;
}

}  // namespace stickslip::space_detail
