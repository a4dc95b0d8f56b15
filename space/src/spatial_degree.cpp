// SPDX-License-Identifier: GPL-3.0-or-later
#include "spatial_degree.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <utility>

#include "stickslip/equilibrium/search/independent_rows.hpp"
#include "stickslip/search/force_span.hpp"
#include "stickslip/search/tree_search.hpp"

namespace stickslip::space_detail {

using equilibrium_detail::IndependentRows;

namespace {

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix) {
  return matrix.completeOrthogonalDecomposition().pseudoInverse();
}

/// Unit vectors to all vertices but the last of a regular simplex of this dimension around 0,
/// by rows; that to the last is minus their sum.
Eigen::MatrixXd regular_simplex(Eigen::Index n) {
  // v_j.v_k = -1/n: the factor of Cholesky's decomposition of their Gram matrix.
  Eigen::MatrixXd gram = Eigen::MatrixXd::Constant(n, n, -1.0 / static_cast<double>(n));
  gram.diagonal().setOnes();
  return gram.llt().matrixL();
}

/// Where the walls are to be, and which way the grasp in the middle pulls, in doubles.
///
/// On the walls E_j.(d - d0) = +-1 of the slip of a sticking contact its friction is against
/// that slip, and a virtual twist Y_j that moves nothing else that sticks sees it. The other
/// rows are forces on virtual twists on which what sticks does no work. A is such that
/// Y_j.A(d - d0) is E_j.(d - d0).
class SpatialWalls {
 public:
  SpatialWalls(const SpaceModel& middle, const ForceSpan& span,
               const NearEquilibrium& equilibrium, double size);

  bool is_sound() const { return sound_; }
  /// Moves walls outwards until these moves, one after another, stay well within.
  void enclose(const std::vector<EigenVector6>& moves) {
    constexpr double kWithin = 0.7;
    for (Eigen::Index j = 0; j < rows_.rows(); ++j) {
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
  void grow(std::size_t row) { rows_.row(static_cast<Eigen::Index>(row)) /= 1.25; }
  /// d0, E and A in few bits; a simplex in place of the parallelepiped, of which it has the
  /// size.
  SpatialDegreeProof proof(bool is_simplex) const;

 private:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 6, 0, 6, 6>;

  double room(const NearEquilibrium& equilibrium, const EigenVector6& way) const;
  Vector6 exact_row(const Eigen::Matrix<double, 1, 6>& row) const;

  const SpaceModel& model_;
  const ForceSpan& span_;
  EigenVector6 motion_;
  Rows rows_;                                        ///< E
  Eigen::Matrix<double, 6, Eigen::Dynamic> twists_;  ///< Y, by columns
  bool sound_ = false;
};

SpatialWalls::SpatialWalls(const SpaceModel& middle, const ForceSpan& span,
                           const NearEquilibrium& equilibrium, double size)
    : model_(middle), span_(span), motion_(equilibrium.motion) {
  const auto rank = static_cast<Eigen::Index>(span.rank());
  rows_ = Rows::Zero(rank, 6);
  twists_.setZero(6, rank);
  if (rank == 0) return;
  // Small beside what would change a mode.
  double width = middle.reach;
  for (std::size_t i = 0; i < middle.contacts.size(); ++i) {
    const LawContact& c = middle.contacts[i];
    const CornerRow& row = c.corners.front();
    const double v = c.preloads[0] - c.stiffnesses[0] * row.normal_rounded.dot(motion_);
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
    const LawContact& c = middle.contacts[i];
    const CornerRow& row = c.corners.front();
    const double a = equilibrium.normal[i];
    if (!(a > 0)) continue;
    const SlipMatrix slip = slip_matrix(row);
    const Eigen::Vector3d friction(equilibrium.friction[i].data());
    const EigenVector6 normal = row.normal_rounded;
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
  for (const RationalRow& z : span.free_motions()) {
    EigenVector6 motion;
    for (std::size_t j = 0; j < 6; ++j) {
      motion[static_cast<Eigen::Index>(j)] = to_double(z[j]) * (j < 3 ? 1 : middle.length);
    }
    independent.take(motion);
  }
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
  // Which rows are independent does not depend on their lengths.
  const Rows unit = rows_.rowwise().normalized();
  constexpr double kFlat = 1e-12;
  if (!unit.allFinite() ||
      !(Eigen::JacobiSVD<Eigen::MatrixXd>(unit).singularValues().minCoeff() > kFlat))
    return;
  const Eigen::MatrixXd inverse = pseudo_inverse(rows_);
  for (Eigen::Index j = 0; j < sticking; ++j) twists_.col(j) = inverse.col(j);
  for (Eigen::Index j = 0; j < rank; ++j) twists_.col(j).normalize();
  sound_ = twists_.allFinite() &&
           Eigen::JacobiSVD<Eigen::MatrixXd>(twists_).singularValues().minCoeff() > kFlat;
}

/// How far the object can move this way before a contact opens or closes, or slips another way.
double SpatialWalls::room(const NearEquilibrium& equilibrium, const EigenVector6& way) const {
  double room = HUGE_VAL;
  const auto consider = [&](double distance, double speed) {
    if (distance > 0 && speed > 0) room = std::min(room, distance / speed);
  };
  for (std::size_t i = 0; i < model_.contacts.size(); ++i) {
    const LawContact& c = model_.contacts[i];
    const CornerRow& row = c.corners.front();
    const EigenVector6 normal = row.normal_rounded;
    const double v = c.preloads[0] - c.stiffnesses[0] * normal.dot(motion_);
    consider(std::fabs(v), c.stiffnesses[0] * std::fabs(normal.dot(way)));
    if (!(v > 0) || equilibrium.sticks[i] != 0 || !(c.slopes[0] > 0)) continue;
    consider((slip_matrix(row) * motion_).norm(), (slip_matrix(row) * way).norm());
  }
  return room;
}

/// In the span, near a row in the model's units.
Vector6 SpatialWalls::exact_row(const Eigen::Matrix<double, 1, 6>& row) const {
  constexpr int kBits = 14;
  Vector6 result{};
  for (std::size_t p = 0; p < span_.rank(); ++p) {
    const std::size_t column = span_.columns()[p];
    const double unit = column < 3 ? 1 : model_.length;
    const Rational part =
        rational_in_bits(row[static_cast<Eigen::Index>(column)] * unit, kBits);
    for (std::size_t k = 0; k < 6; ++k) result[k] += part * span_.rows()[p][k];
  }
  return result;
}

SpatialDegreeProof SpatialWalls::proof(bool is_simplex) const {
  SpatialDegreeProof result{};
  const Eigen::Matrix<double, 6, 6> pull = pseudo_inverse(twists_.transpose()) * rows_;
  if (!rows_.allFinite() || !pull.allFinite() || !motion_.allFinite()) return result;
  result.is_simplex = is_simplex;
  const Eigen::MatrixXd directions =
      is_simplex ? regular_simplex(rows_.rows())
                 : Eigen::MatrixXd::Identity(rows_.rows(), rows_.rows());
  for (Eigen::Index j = 0; j < rows_.rows(); ++j) {
    result.walls.push_back(exact_row(directions.row(j) * rows_));
  }
  if (is_simplex) {  // the sum of all is 0
    Vector6& last = result.walls.emplace_back();
    for (Eigen::Index j = 0; j < rows_.rows(); ++j) {
      for (std::size_t k = 0; k < 6; ++k)
        last[k] -= result.walls[static_cast<std::size_t>(j)][k];
    }
  }
  // A takes motions into the span, and sees of them what the span sees.
  const double largest = pull.cwiseAbs().maxCoeff();
  for (std::size_t p = 0; p < span_.rank(); ++p) {
    const auto row = static_cast<Eigen::Index>(span_.columns()[p]);
    const double unit = row < 3 ? 1 : model_.length;
    const Vector6 seen = exact_row(pull.row(row) / largest * unit);
    for (std::size_t j = 0; j < 6; ++j) {
      for (std::size_t k = 0; k < 6; ++k)
        result.direction[j][k] += span_.rows()[p][j] * seen[k];
    }
  }
  const double finest = 1 / rows_.cwiseAbs().maxCoeff();
  for (std::size_t j = 0; j < 6; ++j) {
    const double scale = j < 3 ? 1 : model_.length;
    const double grain = std::ldexp(1.0, std::ilogb(finest / scale) - 10);
    result.twist[j] = rational_from_double(
        std::round(motion_[static_cast<Eigen::Index>(j)] / scale / grain) * grain);
  }
  return result;
}

}  // namespace

std::optional<SpatialDegreeProof> prove_stable(const SpaceModel& model,
                                               const SpaceModel& middle,
                                               const NearEquilibrium& equilibrium,
                                               std::size_t node_limit, std::size_t most_nodes,
                                               SearchWork& work,
                                               const std::vector<EigenVector6>& moves) {
  const bool is_point = model.is_point();
  const ForceSpan span(model);
  if (!span.has_loads_of(model)) return std::nullopt;
  struct Attempt {
    double size;
    std::size_t limit;
    bool is_simplex = false;
  };
  constexpr std::size_t kFew = 40;
  constexpr double kLeastQuick = 1e-3;
  for (const auto& [size, limit, is_simplex] : {Attempt{3e-2, kFew},
                                                {3e-3, kFew},
                                                {3e-4, kFew},
                                                {3e-5, kFew},
                                                {3e-2, node_limit},
                                                {1e-3, node_limit},
                                                {3e-1, node_limit},
                                                {3e-2, node_limit, true}}) {
    if (limit == 0 || (node_limit == 0 && size < kLeastQuick)) break;
    SpatialWalls walls(middle, span, equilibrium, size);
    if (!walls.is_sound()) return std::nullopt;
    walls.enclose(moves);
    // Walls that fail are moved outwards, where the box is wide.
    constexpr std::size_t kMostGrowths = 12;
    const std::size_t growths = limit == node_limit && !moves.empty() ? kMostGrowths : 0;
    for (std::size_t growth = 0; growth <= growths; ++growth) {
      if (work.nodes > most_nodes) return std::nullopt;
      ++work.proofs;
      SpatialDegreeProof proof = walls.proof(is_simplex);
      if (rank_of<6>(proof.walls) != span.rank() ||
          rank_of<6>({proof.direction.begin(), proof.direction.end()}) != span.rank()) {
        break;
      }
      if (model.law == NormalLaw::kBilateral && !all_closed_inside<MotionRegion>(model, proof))
        break;
      const PullRule pull{proof.direction, proof.twist};
      const auto refute_all = [&](bool second) {
        const SpaceModel& about = second ? middle : model;
        bool all = true;
        for (std::size_t wall = 0; wall < proof.wall_count(); ++wall) {
          TreeSearch search(about, second ? &pull : nullptr, limit, work);
          if (search.refute(MotionRegion::wall(about, proof, wall), proof.trees)) continue;
          all = false;
          if (growths == 0) return false;
          if (is_simplex) {
            for (std::size_t row = 0; row < span.rank(); ++row) walls.grow(row);
            return false;
          }
          walls.grow(wall / 2);
        }
        return all;
      };
      if ((is_point || refute_all(false)) && refute_all(true)) return proof;
    }
  }
  return std::nullopt;
}

}  // namespace stickslip::space_detail
