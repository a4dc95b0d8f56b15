// SPDX-License-Identifier: GPL-3.0-or-later
#include "degree.hpp"

#include <cmath>
#include <utility>

#include "box_law.hpp"
#include "moving_equilibrium.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/equilibrium/search/independent_rows.hpp"
#include "stickslip/search/tree_search.hpp"

namespace stickslip::box_detail {

using equilibrium_detail::IndependentRows;

namespace {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

/// d rounded to a small part of the parallelepiped.
Vector3 rounded_motion(const Vector3& exact, const std::vector<Vector3>& walls) {
  Vector3 result;
  for (std::size_t k = 0; k < 3; ++k) {
    Rational steepest = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      const Rational size = abs(walls[j][k]);
      if (size > steepest) steepest = size;
    }
    // A power of two of which the walls see less than 1/256.
    const double grain = to_double(steepest);
    if (!(grain > 0) || !std::isfinite(grain)) return exact;
    const int bits = static_cast<int>(std::ceil(std::log2(grain))) + 8;
    const Rational unit = bits >= 0 ? Rational(1, Integer(1) << static_cast<unsigned>(bits))
                                    : Rational(Integer(1) << static_cast<unsigned>(-bits));
    const Rational steps = exact[k] / unit;
    Integer whole = numerator(steps) / denominator(steps);
    result[k] = Rational(whole) * unit;
  }
  return result;
}

/// Where the walls are to be, and which way the middle pulls, in doubles; lengths over
/// Law::length.
class Walls {
 public:
  /// Of the model of the middle, and of the box, around an equilibrium.
  /// They enclose the equilibrium where it goes farthest, or as far as the first order says.
  Walls(const ParameterBox& box, const Law& model, const Law& middle,
        const RoundedEquilibrium& near, bool first_order);

  /// Whether the shape is one: three walls that enclose.
  bool is_sound() const { return sound_; }
  /// Moves a wall outwards: by a quarter of its distance, and in larger steps later.
  void grow(std::size_t wall, int sign) {
    const auto j = static_cast<Eigen::Index>(wall);
    constexpr int kSmallSteps = 6;
    int& steps = steps_[2 * wall + (sign > 0 ? 1 : 0)];
    (sign > 0 ? above_ : below_)[j] *= steps++ < kSmallSteps ? 1.25 : 1.6;
  }

  /// d0, E and A in few bits.
  DegreeProof proof() const;
  /// Another A: the stiffness, and of each contact that sticks what friction it has left over
  /// how far it can slip. It may serve where the force on the walls is not what fits best.
  SquareMatrix<3> stiff_direction() const;

 private:
  struct Sticking {
    Vector row;    ///< T
    double spare;  ///< friction that is not used
    double off;    ///< the largest slip at motion_ that the box has
  };

  SquareMatrix<3> direction_of(const Matrix& direction) const;
  void choose_rows(const std::vector<Vector>& moves);
  std::vector<Vector> extremes();
  void enclose(const std::vector<Vector>& moves);

  double length_;
  double force_;  ///< a typical one
  Vector motion_;
  MovingEquilibrium moving_;
  std::vector<Sticking> sticking_;
  std::vector<std::size_t> chosen_;    ///< of these, whose slips are the first rows
  double scale_ = 1;                   ///< a typical motion
  Matrix stiffness_ = Matrix::Zero();  ///< C
  Matrix rows_ = Matrix::Zero();       ///< E, up to the widths
  Vector below_ = Vector::Ones();      ///< rows_ (d - motion_) goes from -below_
  Vector above_ = Vector::Ones();      ///< to above_
  std::array<int, 6> steps_{};         ///< by which each wall has grown
  bool sound_ = false;
};

Walls::Walls(const ParameterBox& box, const Law& model, const Law& middle,
             const RoundedEquilibrium& near, bool first_order)
    : length_(middle.length),
      force_(middle.force),
      motion_(near.twist[0], near.twist[1], near.twist[2] * middle.length),
      moving_(box, middle, near) {
  double stiffest = 0;
  for (std::size_t i = 0; i < middle.contacts.size(); ++i) {
    const RoundedEquilibrium::Force& force = near.forces[i];
    const LawContact& c = middle.contacts[i];
    const Vector normal = c.corners.front().normal_rounded;
    const Vector tangent = c.corners.front().slip_rounded.front();
    stiffest = std::max(stiffest, c.stiffnesses[0] * normal.squaredNorm());
    if (!(force.normal > 0)) continue;
    stiffness_ += c.stiffnesses[0] * (normal + force.tangential / force.normal * tangent) *
                  normal.transpose();
    const double most = c.slopes[0] * force.normal;
    if (!force.still || !(most > 0)) continue;
    Sticking contact{tangent, most * 1.0000001 - std::fabs(force.tangential), 0};
    for (const CornerRow& corner : model.contacts[i].corners) {
      contact.off = std::max(contact.off, std::fabs(corner.slip_rounded.front().dot(motion_)));
    }
    sticking_.push_back(contact);
  }
  if (stiffest > 0) scale_ = force_ / stiffest;
  std::vector<Vector> moves;
  const Eigen::Matrix3Xd each = moving_.moves(moving_.middle(), moving_.start());
  for (Eigen::Index n = 0; n < each.cols(); ++n) moves.emplace_back(each.col(n));
  choose_rows(moves);
  if (first_order) {
    // All at once, whichever way is farthest.
    for (Eigen::Index row = 0; row < 3; ++row) {
      const Vector all = each * (rows_.row(row) * each).transpose().cwiseSign();
      moves.push_back(all);
      moves.push_back(-all);
    }
  } else {
    moves = extremes();
    choose_rows(moves);
  }
  enclose(moves);
  double product = 1;
  for (Eigen::Index j = 0; j < 3; ++j) product *= rows_.row(j).norm();
  sound_ = product > 0 && std::fabs(rows_.determinant()) > 1e-9 * product;
}

/// Where the equilibrium is when it has gone as far as it can beyond each wall.
std::vector<Vector> Walls::extremes() {
  std::vector<Vector> moves;
  for (int wall = 0; wall < 6; ++wall) {
    const Vector out = (wall % 2 == 0 ? 1 : -1) * rows_.row(wall / 2).transpose();
    MovingEquilibrium::Place place = moving_.middle();
    Equilibrium at = moving_.start();
    constexpr int kRounds = 3;
    for (int round = 0; round < kRounds; ++round) {
      const MovingEquilibrium::Place to =
          (moving_.moves(place, at).transpose() * out).cwiseSign();
      if (to == place) break;
      const EquilibriumPath path = moving_.follow(to);
      for (const Equilibrium& e : path.equilibria) moves.push_back(e.motion - motion_);
      if (path.part < 1) break;
      place = to;
      at = path.equilibria.back();
    }
  }
  return moves;
}

/// Walls that enclose these moves as tightly as three pairs can.
void Walls::choose_rows(const std::vector<Vector>& moves) {
  // Sticking contacts whose slips are independent, those with most friction to spare first.
  constexpr double kIndependent = 1e-3;
  IndependentRows<3> independent;
  chosen_.clear();
  while (const auto which = independent.take_best(sticking_, kIndependent)) {
    chosen_.push_back(*which);
  }
  // Virtual twists on which these contacts' friction does no work.
  Eigen::MatrixXd frame = independent.complement();
  const Eigen::Index count = frame.cols();
  // Dual to the forces at the three that move the object farthest.
  const Eigen::MatrixXd reduced = frame.transpose() * stiffness_ * frame;
  if (count > 0 && std::fabs(reduced.determinant()) > 0) {
    const Eigen::MatrixXd compliance = reduced.inverse();
    std::vector<Eigen::VectorXd> forces;
    std::vector<Eigen::VectorXd> motions;
    for (const Vector& move : moves) {
      motions.push_back(frame.transpose() * move);
      forces.push_back(reduced * motions.back());
    }
    for (Eigen::Index k = 0; k < count; ++k) {
      forces.push_back(1e-3 * force_ * Eigen::VectorXd::Unit(count, k));
      motions.push_back(compliance * forces.back());
    }
    Eigen::MatrixXd chosen_forces(count, count);
    for (Eigen::Index k = 0; k < count; ++k) {
      std::size_t farthest = 0;
      for (std::size_t g = 1; g < motions.size(); ++g) {
        if (motions[g].norm() > motions[farthest].norm()) farthest = g;
      }
      chosen_forces.col(k) = forces[farthest];
      const Eigen::VectorXd direction = motions[farthest].normalized();
      for (Eigen::VectorXd& motion : motions) motion -= direction.dot(motion) * direction;
    }
    if (std::fabs(chosen_forces.determinant()) > 0) {
      frame = (frame * chosen_forces.inverse().transpose()).colwise().normalized();
    }
  }
  Eigen::Index row = 0;
  for (const std::size_t k : chosen_) rows_.row(row++) = sticking_[k].row.transpose();
  for (const auto& y : frame.colwise()) rows_.row(row++) = y.transpose() * stiffness_;
}

/// A little beyond these moves.
void Walls::enclose(const std::vector<Vector>& moves) {
  constexpr double kLeast = 1e-3;
  for (Eigen::Index row = 0; row < 3; ++row) {
    double low = 0;
    double high = 0;
    for (const Vector& move : moves) {
      const double at = rows_.row(row).dot(move);
      low = std::min(low, at);
      high = std::max(high, at);
    }
    double least = kLeast * force_;
    const auto k = static_cast<std::size_t>(row);
    if (k < chosen_.size()) {
      const Sticking& contact = sticking_[chosen_[k]];
      least = 1.5 * contact.off + kLeast * scale_ * contact.row.norm();
    }
    const double margin = 0.1 * (high - low);
    above_[row] = high + margin + least;
    below_[row] = -low + margin + least;
  }
}

/// Of a wall or of A; 0 if the proposal is not finite.
Rational in_few_bits(double entry) {
  constexpr int kWallBits = 12;
  return std::isfinite(entry) ? rational_in_bits(entry, kWallBits) : 0;
}

SquareMatrix<3> Walls::direction_of(const Matrix& direction) const {
  SquareMatrix<3> result;
  for (Eigen::Index j = 0; j < 3; ++j) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double units = (k == 2 ? length_ : 1) * (j == 2 ? length_ : 1);
      result[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)] =
          in_few_bits(direction(j, k) * units);
    }
  }
  return result;
}

SquareMatrix<3> Walls::stiff_direction() const {
  const Matrix corners = rows_.inverse() * ((above_ + below_) / 2).asDiagonal();
  Matrix direction = stiffness_;
  for (const Sticking& contact : sticking_) {
    const double most = (contact.row.transpose() * corners).cwiseAbs().sum();
    if (!(most > 0) || !(contact.spare > 0)) continue;
    direction += contact.spare / most * contact.row * contact.row.transpose();
  }
  return direction_of(direction);
}

DegreeProof Walls::proof() const {
  DegreeProof result;
  const Matrix inverse = rows_.inverse();
  const Vector shift = inverse * (above_ - below_) / 2;
  const Vector halves = (above_ + below_) / 2;
  // A linear function that is against the force on the walls: by least squares of directions,
  // again and again with more weight where it is least so.
  struct Pull {
    Vector place;  ///< on the walls, in halves of K
    Vector direction;
    double weight;
  };
  std::vector<Pull> pulls;
  constexpr int kPlaces = 5;  // along an edge
  for (int p = 0; p < kPlaces * kPlaces * kPlaces; ++p) {
    const Vector place = Vector(p % kPlaces, p / kPlaces % kPlaces, p / (kPlaces * kPlaces)) *
                             2 / (kPlaces - 1) -
                         Vector::Ones();
    if (place.lpNorm<Eigen::Infinity>() < 1) continue;
    const Vector force = moving_.force(motion_ + shift + inverse * place.cwiseProduct(halves));
    if (force.norm() > 0) pulls.push_back({place, -force.normalized(), 1});
  }
  Matrix best = Matrix::Identity();
  double most = -2;
  constexpr int kRounds = 30;
  for (int round = 0; round < kRounds; ++round) {
    Matrix moments = Matrix::Zero();
    Matrix sums = Matrix::Zero();
    for (const Pull& p : pulls) {
      moments += p.weight * p.place * p.place.transpose();
      sums += p.weight * p.direction * p.place.transpose();
    }
    const Matrix pull = sums * moments.inverse();
    double least = 2;
    for (Pull& p : pulls) {
      const double along = p.direction.dot((pull * p.place).normalized());
      p.weight *= std::exp(-along);
      least = std::min(least, along);
    }
    if (least > most) {
      most = least;
      best = pull;
    }
  }
  const Matrix walls = halves.cwiseInverse().asDiagonal() * rows_;
  const Matrix pull = best * walls;
  const Vector centre = motion_ + shift;
  if (!centre.allFinite() || !std::isfinite(centre[2] / length_)) return {};  // no walls at all
  result.walls.resize(3);
  for (Eigen::Index j = 0; j < 3; ++j) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double column = k == 2 ? length_ : 1;
      result.walls[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)] =
          in_few_bits(walls(j, k) * column);
    }
  }
  result.direction = direction_of(pull);
  Vector3 d{rational_from_double(centre[0]), rational_from_double(centre[1]),
            rational_from_double(centre[2] / length_)};
  result.twist = rounded_motion(d, result.walls);
  return result;
}

/// Lets the walls grow until they are refuted.
std::optional<DegreeProof> prove_within(Walls walls, const Law& model, const Law& middle,
                                        std::size_t node_limit, SearchWork& work) {
  // Equilibria that a box moves much farther than the first order says are lost at a fold.
  constexpr std::size_t kMostGrowths = 18;
  constexpr std::size_t kMostPulls = 4;  // growing seldom mends what list 2 refuses
  std::size_t pulls = 0;
  for (std::size_t growth = 0; growth <= kMostGrowths; ++growth) {
    ++work.proofs;
    DegreeProof proof = walls.proof();
    if (!has_full_rank(proof)) return std::nullopt;
    if (model.law == NormalLaw::kBilateral && !all_closed_inside<MotionRegion>(model, proof)) {
      return std::nullopt;
    }
    // The walls that are not refuted.
    const auto refute = [&](bool second) {
      const Law& about = second ? middle : model;
      const PullRule pull{proof.direction, proof.twist};
      std::vector<std::pair<std::size_t, int>> open;
      for (std::size_t wall = 0; wall < 3; ++wall) {
        for (const int sign : {1, -1}) {
          TreeSearch search(about, second ? &pull : nullptr, node_limit, work);
          const bool done = search.refute(
              MotionRegion::wall(about, proof, 2 * wall + (sign > 0 ? 0 : 1)), proof.trees);
          if (!done) open.emplace_back(wall, sign);
        }
      }
      return open;
    };
    std::vector<std::pair<std::size_t, int>> open;
    if (!model.is_point()) open = refute(false);  // of one grasp list 2 is enough
    if (open.empty()) {
      const std::size_t first_list = proof.trees.size();
      open = refute(true);
      if (open.empty()) return proof;
      proof.direction = walls.stiff_direction();
      if (has_full_rank(proof)) {
        proof.trees.erase(proof.trees.begin() + static_cast<std::ptrdiff_t>(first_list),
                          proof.trees.end());
        if (refute(true).empty()) return proof;
      }
      if (++pulls > kMostPulls) return std::nullopt;
    }
    for (const auto& [wall, sign] : open) walls.grow(wall, sign);
  }
  return std::nullopt;
}

}  // namespace

Problem problem_at(const ParameterBox& point) {
  std::vector<ContactRow> rows;
  for (const ParameterContact& c : point.contacts()) {
    const auto at = [&](Parameter parameter) -> const Rational& {
      return c.parameters[static_cast<std::size_t>(parameter)].low;
    };
    const Contact contact{{at(Parameter::kX), at(Parameter::kY)},
                          turned(c.normal, at(Parameter::kTurn))};
    rows.push_back({normal_row(contact), tangent_row(contact), at(Parameter::kFriction),
                    at(Parameter::kPreload), at(Parameter::kStiffness)});
  }
  const WrenchBox& w = point.wrench();
  return Problem(std::move(rows), {w[0].low, w[1].low, w[2].low}, point.law());
}

std::optional<DegreeProof> prove_stable(const ParameterBox& box, const RoundedEquilibrium& near,
                                        std::size_t node_limit, SearchWork& work) {
  const Law model = law_of(box);
  const Law middle = law_of(box.middle());
  for (const bool first_order : {false, true}) {
    Walls walls(box, model, middle, near, first_order);
    if (!walls.is_sound()) continue;
    auto proof = prove_within(std::move(walls), model, middle, node_limit, work);
    if (proof) return proof;
  }
  return std::nullopt;
}

std::optional<DegreeProof> prove_stable_by_degree(const ParameterBox& box,
                                                  std::size_t node_limit, SearchWork& work) {
  constexpr std::size_t kStarts = 12;
  constexpr std::size_t kMostTried = 4;
  std::size_t tried = 0;
  const Problem middle = problem_at(box.middle());
  for (const std::size_t starts : {std::size_t{0}, kStarts}) {
    for (const RoundedEquilibrium& near : find_rounded_equilibria(middle, starts)) {
      if (starts != 0 && tried >= kMostTried) break;
      ++tried;
      if (auto proof = prove_stable(box, near, node_limit, work)) return proof;
    }
  }
  return std::nullopt;
}

}  // namespace stickslip::box_detail
