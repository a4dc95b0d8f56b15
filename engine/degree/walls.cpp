// SPDX-License-Identifier: GPL-3.0-or-later
#include "walls.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/motion/dense.hpp"
#include "rounded_box.hpp"

namespace stickslip::degree_detail {
namespace {

/// Returns unit vectors to all vertices but the last of a regular simplex of this dimension
/// around 0, by rows; that to the last is minus their sum.
Eigen::MatrixXd regular_simplex(Eigen::Index n) {
  // v_j.v_k = -1/n: the factor of Cholesky's decomposition of their Gram matrix.
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
  const auto all = static_cast<double>(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto left = static_cast<double>(n - k);
    result(k, k) = std::sqrt((all + 1) * left / (all * (left + 1)));
    result.col(k).tail(n - k - 1).setConstant(-result(k, k) / left);
  }
  return result;
}

/// Returns whether vectors of length 1, by rows, span as many dimensions, not nearly fewer.
bool are_independent(const Eigen::MatrixXd& unit) {
  constexpr double kFlat = 1e-12;
  return unit.allFinite() && singular_values(unit).values.minCoeff() > kFlat;
}

}  // namespace

Walls::Walls(const RoundedGrasp& middle, const ForceSpan& span, const NearEquilibrium& near,
             double size, const Law* box)
    : middle_(middle), span_(span), near_(near), size_(size) {
  const Eigen::Index d = middle.motions();
  // The width is the least change that may end a mode.
  double width = middle.reach;
  for (std::size_t i = 0; i < middle.contacts.size(); ++i) {
    const RoundedContact& c = middle.contacts[i];
    if (c.is_spring) continue;
    const double v = c.separation(near.motion);
    const double stretch = std::fabs(v) / (c.stiffness * c.size);
    if (stretch > 0) width = std::min(width, stretch);
    if (!(v > 0) || near.sticks[i] != 0 || !(c.slope > 0)) continue;
    width = std::min(width, (c.slip * near.motion).norm());
  }
  stiffness_ = Eigen::MatrixXd::Zero(d, d);
  for (std::size_t i = 0; i < middle.contacts.size(); ++i) {
    const RoundedContact& c = middle.contacts[i];
    const double a = near.normal[i];
    if (c.is_spring) stiffness_ += c.stiffness * c.normal * c.normal.transpose();
    if (c.is_spring || !(a > 0)) continue;
    const Eigen::VectorXd friction =
        Eigen::Map<const Eigen::Vector3d>(near.friction[i].data()).head(c.slip.rows());
    stiffness_ +=
        c.stiffness * (c.normal + c.slip.transpose() * friction / a) * c.normal.transpose();
    if (!(c.slope * a > 0)) continue;
    if (near.sticks[i] != 0) {
      add_sticking(box != nullptr ? &box->contacts[i] : nullptr, c, i, width * size);
      continue;
    }
    const Eigen::VectorXd s = c.slip * near.motion;
    const Eigen::MatrixXd across =
        Eigen::MatrixXd::Identity(s.size(), s.size()) - s * s.transpose() / s.squaredNorm();
    stiffness_ += c.slope * a / s.norm() * (c.slip.transpose() * across * c.slip);
  }
  // Sticking contacts with independent slips are chosen, those with most friction to spare
  // first.
  IndependentRows independent(d);
  for (const RationalRow& z : span.free_motions()) {
    Reals motion(d);
    for (Eigen::Index j = 0; j < d; ++j) {
      const auto column = static_cast<std::size_t>(j);
      motion[j] = to_double(z[column]) * middle.unit(column);
    }
    independent.take(motion);
  }
  constexpr double kIndependent = 1e-2;
  while (const auto which = independent.take_best(sticking_, kIndependent)) {
    chosen_.push_back(*which);
  }
  choose_rows(independent);
  check();
}

Walls::Walls(const RoundedGrasp& middle, const ForceSpan& span, const NearEquilibrium& near,
             const Eigen::MatrixXd& answer, const Eigen::MatrixXd& rows,
             const Eigen::VectorXd& room)
    : middle_(middle), span_(span), near_(near), stiffness_(answer), rows_(rows), room_(room) {
  const Eigen::Index rank = rows_.rows();
  steps_.assign(2 * static_cast<std::size_t>(rank), 0);
  above_ = room_;
  below_ = room_;
  sound_ = static_cast<std::size_t>(rank) == span.rank() && room_.minCoeff() > 0 &&
           are_independent(rows_.rowwise().normalized());
}

void Walls::add_sticking(const LawContact* contact, const RoundedContact& at, std::size_t index,
                         double width) {
  const Double3& f = near_.friction[index];
  const double most = at.slope * near_.normal[index];
  const double used = norm_of(f);
  const auto add = [&](const Eigen::VectorXd& along, double spare, double room) {
    double off = 0;  // the largest slip here that the box has
    for (std::size_t n = 0; contact != nullptr && n < contact->corners.size(); ++n) {
      const CornerRow& corner = contact->corners[n];
      double slip = 0;
      for (std::size_t k = 0; k < corner.slip_rounded.size(); ++k) {
        slip += along[static_cast<Eigen::Index>(k)] * corner.slip_rounded[k].dot(near_.motion);
      }
      off = std::max(off, std::fabs(slip));
    }
    sticking_.push_back({at.slip.transpose() * along, spare, room, 1.5 * off});
  };
  if (at.slip.rows() == 1) {
    add(Eigen::VectorXd::Ones(1), most * 1.0000001 - used, width * at.size);
    return;
  }
  const double share = std::min(used / most, 0.999999);
  IndependentRows others(at.slip.rows());
  Eigen::VectorXd along = Eigen::VectorXd::Unit(at.slip.rows(), 0);
  if (share > 1e-3) {
    along = Eigen::Map<const Eigen::Vector3d>(f.data()).head(at.slip.rows()).normalized();
  }
  others.take(along);
  // Slips across the friction are so small that, beside a slip of `width` along it, enough
  // friction is left against that.
  const double aspect = std::min(1.0, 0.5 * std::sqrt(1 / (share * share) - 1));
  add(along, most - used, width);
  const Eigen::MatrixXd across = others.complement();
  for (Eigen::Index k = 0; k < across.cols(); ++k) add(across.col(k), most, width * aspect);
}

/// Chooses the rows: those of sticking contacts and, across forces, the singular vectors of how
/// forces answer motions.
void Walls::choose_rows(const IndependentRows& across) {
  frame_ = across.complement();
  const auto count = static_cast<Eigen::Index>(chosen_.size());
  const Eigen::Index free = frame_.cols();
  const Eigen::Index rank = count + free;
  rows_.setZero(rank, middle_.motions());
  twists_.setZero(middle_.motions(), rank);
  room_.setZero(rank);
  steps_.assign(2 * static_cast<std::size_t>(rank), 0);
  for (Eigen::Index j = 0; j < count; ++j) {
    const Sticking& contact = sticking_[chosen_[static_cast<std::size_t>(j)]];
    rows_.row(j) = contact.row.transpose();
    room_[j] = contact.room + contact.off;
  }
  if (free > 0) {
    const auto [left, strengths, right] =
        singular_values(frame_.transpose() * stiffness_ * frame_);
    const Eigen::MatrixXd ways = frame_ * right;
    for (Eigen::Index k = 0; k < free; ++k) {
      twists_.col(count + k) = frame_ * left.col(k);
      rows_.row(count + k) = (stiffness_.transpose() * twists_.col(count + k)).transpose();
      room_[count + k] =
          size_ * std::min(middle_.force, strengths[k] * room_along(ways.col(k)));
    }
  }
  above_ = room_;
  below_ = room_;
}

/// Returns how far the object can move this way before a contact opens or closes, or slips
/// another way.
double Walls::room_along(const Reals& way) const {
  double room = HUGE_VAL;
  const auto consider = [&](double distance, double speed) {
    if (distance > 0 && speed > 0) room = std::min(room, distance / speed);
  };
  for (std::size_t i = 0; i < middle_.contacts.size(); ++i) {
    const RoundedContact& c = middle_.contacts[i];
    if (c.is_spring) continue;
    const double v = c.separation(near_.motion);
    consider(std::fabs(v), c.stiffness * std::fabs(c.normal.dot(way)));
    if (!(v > 0) || near_.sticks[i] != 0 || !(c.slope > 0)) continue;
    consider((c.slip * near_.motion).norm(), (c.slip * way).norm());
  }
  return room;
}

/// Sets whether rows and twists are independent. The twists of sticking contacts follow from
/// the rows.
void Walls::check() {
  sound_ = false;
  if (rows_.rows() == 0) return;  // nothing holds the object
  if (!are_independent(rows_.rowwise().normalized())) return;
  const Eigen::MatrixXd twists = pseudo_inverse(rows_);
  for (std::size_t j = 0; j < chosen_.size(); ++j) {
    twists_.col(static_cast<Eigen::Index>(j)) = twists.col(static_cast<Eigen::Index>(j));
  }
  twists_.colwise().normalize();
  sound_ = are_independent(twists_.transpose());
}

/// The new walls are dual to the forces at those moves that move the object farthest.
void Walls::turn_to(const std::vector<Reals>& moves) {
  const auto count = static_cast<Eigen::Index>(chosen_.size());
  for (Eigen::Index k = 0; k < count; ++k) {
    const Sticking& contact = sticking_[chosen_[static_cast<std::size_t>(k)]];
    room_[k] = size_ * middle_.reach * contact.row.norm() + contact.off;
  }
  const Eigen::Index free = frame_.cols();
  if (free == 0) return;
  const Eigen::MatrixXd reduced = frame_.transpose() * stiffness_ * frame_;
  const Eigen::MatrixXd compliance = inverse(reduced);
  if (compliance.size() == 0) return;
  std::vector<Eigen::VectorXd> forces;
  std::vector<Eigen::VectorXd> motions;
  for (const Reals& move : moves) {
    motions.emplace_back(frame_.transpose() * move);
    forces.emplace_back(reduced * motions.back());
  }
  constexpr double kLittle = 1e-3;
  for (Eigen::Index k = 0; k < free; ++k) {
    forces.emplace_back(kLittle * middle_.force * Eigen::VectorXd::Unit(free, k));
    motions.emplace_back(compliance * forces.back());
  }
  Eigen::MatrixXd chosen(free, free);
  for (Eigen::Index k = 0; k < free; ++k) {
    std::size_t farthest = 0;
    for (std::size_t g = 1; g < motions.size(); ++g) {
      if (motions[g].norm() > motions[farthest].norm()) farthest = g;
    }
    chosen.col(k) = forces[farthest];
    const Eigen::VectorXd direction = motions[farthest].normalized();
    for (Eigen::VectorXd& motion : motions) motion -= direction.dot(motion) * direction;
  }
  const Eigen::MatrixXd dual = inverse(chosen);
  if (dual.size() == 0) return;
  twists_.rightCols(free) = (frame_ * dual.transpose()).colwise().normalized();
  for (Eigen::Index k = count; k < rows_.rows(); ++k) {
    rows_.row(k) = (stiffness_.transpose() * twists_.col(k)).transpose();
    room_[k] = size_ * middle_.force;
  }
  above_ = room_;
  below_ = room_;
  check();
}

void Walls::enclose(const std::vector<Reals>& moves) {
  for (Eigen::Index row = 0; row < rows_.rows(); ++row) {
    double low = 0;
    double high = 0;
    for (const Reals& move : moves) {
      const double at = rows_.row(row).dot(move);
      low = std::min(low, at);
      high = std::max(high, at);
    }
    const double margin = 0.1 * (high - low);
    above_[row] = high + margin + room_[row];
    below_[row] = -low + margin + room_[row];
  }
}

void Walls::grow(std::size_t wall, bool is_simplex) {
  if (is_simplex) {
    for (std::size_t each = 0; each < steps_.size(); ++each) grow(each, false);
    return;
  }
  constexpr int kSmallSteps = 6;
  (wall % 2 == 0 ? above_ : below_)[static_cast<Eigen::Index>(wall / 2)] *=
      steps_[wall]++ < kSmallSteps ? 1.25 : 1.6;
}

/// Returns a row in the span of all forces, near a row in the law's units.
RationalRow Walls::exact_row(const Eigen::RowVectorXd& row) const {
  constexpr int kBits = 14;
  RationalRow result(static_cast<std::size_t>(middle_.motions()));
  for (std::size_t p = 0; p < span_.rank(); ++p) {
    const std::size_t column = span_.columns()[p];
    const double entry = row[static_cast<Eigen::Index>(column)] * middle_.unit(column);
    if (!std::isfinite(entry)) continue;
    const Rational part = rational_in_bits(entry, kBits);
    for (std::size_t k = 0; k < result.size(); ++k) result[k] += part * span_.rows()[p][k];
  }
  return result;
}

/// Returns the sum of all wrenches on the grasp in the middle, where friction that sticks in
/// the equilibrium answers the least slip.
Reals Walls::force_at(const Reals& motion) const {
  constexpr double kStill = 1e-9;  // relative to a typical motion
  const double travel = std::max(middle_.reach, near_.motion.norm());
  Reals sum = middle_.load;
  for (std::size_t i = 0; i < middle_.contacts.size(); ++i) {
    const RoundedContact& c = middle_.contacts[i];
    const double a = c.separation(motion);
    if (!c.acts(a)) continue;
    const double most = c.slope * near_.normal[i];
    Eigen::VectorXd share = -(c.slip * motion) / (kStill * travel);
    if (most > 0) {
      share +=
          Eigen::Map<const Eigen::Vector3d>(near_.friction[i].data()).head(share.size()) / most;
    }
    share /= std::max(1.0, share.norm());
    sum += a * (c.normal + c.slope * (c.slip.transpose() * share));
  }
  return sum;
}

Eigen::MatrixXd Walls::pull_of_twists(const Eigen::MatrixXd& walls) const {
  return pseudo_inverse(twists_.transpose()) * walls;
}

/// Fits directions by least squares, again and again with more weight where they fit least.
Eigen::MatrixXd Walls::pull_fitted(const Eigen::MatrixXd& walls, const Reals& centre) const {
  const Eigen::Index rank = walls.rows();
  const Eigen::MatrixXd corners = pseudo_inverse(walls);
  struct Sample {
    Eigen::VectorXd place;  ///< a place on the walls, in halves of K
    Reals direction;
    double weight;
  };
  std::vector<Sample> samples;
  const auto add = [&](const Eigen::VectorXd& place) {
    const Reals force = force_at(centre + corners * place);
    if (force.norm() > 0) samples.push_back({place, -force.normalized(), 1});
  };
  constexpr Eigen::Index kFewDimensions = 3;
  if (rank <= kFewDimensions) {
    constexpr int kPlaces = 5;  // along an edge
    const int count = static_cast<int>(std::pow(kPlaces, rank) + 0.5);
    for (int p = 0; p < count; ++p) {
      Eigen::VectorXd place(rank);
      int digits = p;
      for (Eigen::Index j = 0; j < rank; ++j, digits /= kPlaces) {
        place[j] = 2.0 * (digits % kPlaces) / (kPlaces - 1) - 1;
      }
      if (place.lpNorm<Eigen::Infinity>() == 1) add(place);
    }
  } else {
    constexpr int kPlacesOfWall = 200;
    Xorshift random;
    for (Eigen::Index wall = 0; wall < 2 * rank; ++wall) {
      for (int p = 0; p < kPlacesOfWall; ++p) {
        Eigen::VectorXd place(rank);
        for (double& entry : place) entry = random.next();
        place[wall / 2] = wall % 2 == 0 ? 1 : -1;
        add(place);
      }
    }
  }
  Eigen::MatrixXd best = Eigen::MatrixXd::Identity(middle_.motions(), rank);
  double most = -2;
  constexpr int kRounds = 30;
  for (int round = 0; round < kRounds; ++round) {
    Eigen::MatrixXd moments = Eigen::MatrixXd::Zero(rank, rank);
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(middle_.motions(), rank);
    for (const Sample& s : samples) {
      moments += s.weight * s.place * s.place.transpose();
      sums += s.weight * s.direction * s.place.transpose();
    }
    const Eigen::MatrixXd shares = inverse(moments);
    if (shares.size() == 0) break;
    const Eigen::MatrixXd pull = sums * shares;
    double least = 2;
    for (Sample& s : samples) {
      const double along = s.direction.dot((pull * s.place).normalized());
      s.weight *= std::exp(-along);
      least = std::min(least, along);
    }
    if (least > most) {
      most = least;
      best = pull;
    }
  }
  return best * walls;
}

Eigen::MatrixXd Walls::pull_stiff(const Eigen::MatrixXd& walls) const {
  const Eigen::MatrixXd corners = pseudo_inverse(walls);
  Eigen::MatrixXd pull = stiffness_;
  for (const Sticking& contact : sticking_) {
    const double most = (contact.row.transpose() * corners).cwiseAbs().sum();
    if (!(most > 0) || !(contact.spare > 0)) continue;
    pull += contact.spare / most * contact.row * contact.row.transpose();
  }
  return pull;
}

DegreeProof Walls::proof(Pull pull, bool is_simplex) const {
  const Eigen::Index d = middle_.motions();
  const auto motions = static_cast<std::size_t>(d);
  const Eigen::VectorXd halves = (above_ + below_) / 2;
  const Eigen::MatrixXd walls = halves.cwiseInverse().asDiagonal() * rows_;
  const Reals centre = near_.motion + pseudo_inverse(rows_) * (above_ - below_) / 2;
  DegreeProof result{};
  if (!walls.allFinite() || !centre.allFinite()) return result;
  const Eigen::MatrixXd direction = pull == Pull::kTwists   ? pull_of_twists(walls)
                                    : pull == Pull::kFitted ? pull_fitted(walls, centre)
                                    : pull == Pull::kAnswer ? stiffness_
                                                            : pull_stiff(walls);
  if (!direction.allFinite()) return result;
  result.is_simplex = is_simplex;
  const Eigen::MatrixXd shape = is_simplex
                                    ? regular_simplex(walls.rows())
                                    : Eigen::MatrixXd::Identity(walls.rows(), walls.rows());
  for (const auto& row : shape.rowwise()) result.walls.push_back(exact_row(row * walls));
  if (is_simplex) {  // the sum of all is 0
    RationalRow last(motions);
    for (const RationalRow& row : result.walls) {
      for (std::size_t k = 0; k < last.size(); ++k) last[k] -= row[k];
    }
    result.walls.push_back(std::move(last));
  }
  // A takes motions into the span, and sees of them what the span sees.
  result.direction.assign(motions, RationalRow(motions));
  const double largest = direction.cwiseAbs().maxCoeff();
  for (std::size_t p = 0; p < span_.rank(); ++p) {
    const std::size_t column = span_.columns()[p];
    const RationalRow seen = exact_row(direction.row(static_cast<Eigen::Index>(column)) /
                                       largest * middle_.unit(column));
    for (std::size_t j = 0; j < motions; ++j) {
      for (std::size_t k = 0; k < motions; ++k) {
        result.direction[j][k] += span_.rows()[p][j] * seen[k];
      }
    }
  }
  for (Eigen::Index j = 0; j < d; ++j) {
    const double unit = middle_.unit(static_cast<std::size_t>(j));
    const double steepest = walls.col(j).lpNorm<Eigen::Infinity>() * unit;
    const double value = centre[j] / unit;
    if (!(steepest > 0) || !std::isfinite(1 / steepest)) {
      result.twist.push_back(rational_from_double(value));
      continue;
    }
    const double grain = std::ldexp(1.0, std::ilogb(1 / steepest) - 10);
    result.twist.push_back(rational_from_double(std::round(value / grain) * grain));
  }
  return result;
}

}  // namespace stickslip::degree_detail
