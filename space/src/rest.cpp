// SPDX-License-Identifier: GPL-3.0-or-later
#include "rest.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace stickslip::space_detail {
namespace {

using Intervals6 = std::array<Interval, 6>;

/// Friction of a few bits near this one, which is across the normal.
Vector3 friction_near(const LawContact& contact, const Eigen::Vector3d& f, int bits) {
  Vector3 result{};
  for (const Vector3& t : tangents_of(contact.place->normal)) {
    Eigen::Vector3d rounded;
    for (std::size_t k = 0; k < 3; ++k) rounded[static_cast<Eigen::Index>(k)] = to_double(t[k]);
    const Rational part = rational_in_bits(f.dot(rounded) / rounded.squaredNorm(), bits);
    for (std::size_t k = 0; k < 3; ++k) result[k] += part * t[k];
  }
  return result;
}

/// P' at this multiple, over the box.
Interval preload_at(const LawContact& c, const Rational& multiple) {
  return {c.preload.low + multiple * c.rate.low, c.preload.high + multiple * c.rate.high};
}

/// Adds the ends of (F, p x F) over the corners, for all of these forces F.
void add_wrenches(Intervals6& sum, const LawContact& c, const std::vector<Vector3>& forces) {
  std::optional<Intervals6> ends;
  for (const Vector3& f : forces) {
    for_each_corner(c.place->position, [&](const Vector3& p) {
      const Vector3 moment = cross(p, f);
      const Vector6 wrench{f[0], f[1], f[2], moment[0], moment[1], moment[2]};
      if (!ends) {
        ends.emplace();
        for (std::size_t k = 0; k < 6; ++k) (*ends)[k] = point_interval(wrench[k]);
      }
      for (std::size_t k = 0; k < 6; ++k) {
        (*ends)[k].low = std::min((*ends)[k].low, wrench[k]);
        (*ends)[k].high = std::max((*ends)[k].high, wrench[k]);
      }
    });
  }
  for (std::size_t k = 0; k < 6; ++k) {
    sum[k].low += (*ends)[k].low;
    sum[k].high += (*ends)[k].high;
  }
}

Rational largest(const Interval& interval) {
  return std::max<Rational>(-interval.low, interval.high);
}

/// The least number of the format that is surely not below |f|, and not above.
Rational length_above(const Vector3& f) {
  constexpr unsigned kBits = 64;
  return short_sqrt(dot(f, f), kBits).upper;
}

class RestSearch {
 public:
  RestSearch(const SpaceModel& box, const NearEquilibrium& middle)
      : box_(box), middle_(middle) {
    multiples_ = {0};
    if (box.is_family) {
      multiples_ = {box.multiples.low};
      if (box.multiples.high && *box.multiples.high != box.multiples.low) {
        multiples_.push_back(*box.multiples.high);
      }
    }
  }

  std::optional<RestProof> find() {
    if (!(middle_.motion.norm() <= kStill * box_.reach)) return std::nullopt;
    for (std::size_t i = 0; i < box_.contacts.size(); ++i) {
      const LawContact& c = box_.contacts[i];
      if (middle_.sticks[i] == 0) continue;
      const Double3& f = middle_.friction[i];
      const double spare = c.slopes[0] * middle_.normal[i] - std::sqrt(dot(f, f));
      if (spare > 0) bearing_.push_back({i, spare});
    }
    take_those_with_most_to_spare();
    if (!choose_answers()) return std::nullopt;
    state_friction();
    Matrix6 off;
    Vector6 rest{};
    measure(off, rest);
    if (!choose_reach(off, rest) || !holds(off, rest)) return std::nullopt;
    return std::move(proof_);
  }

 private:
  using Matrix6 = std::array<Vector6, 6>;
  struct Bearing {
    std::size_t contact;
    double spare;
  };

  static constexpr double kStill = 1e-9;
  static constexpr double kFlat = 1e-9;  ///< of what is independent
  static constexpr int kBits = 24;

  /// Of many contacts a few answer as well, and with less to be written.
  void take_those_with_most_to_spare() {
    constexpr std::size_t kMany = 8;
    std::stable_sort(bearing_.begin(), bearing_.end(),
                     [](const Bearing& a, const Bearing& b) { return a.spare > b.spare; });
    IndependentBasis basis;
    std::size_t taken = 0;
    while (taken < bearing_.size() && (taken < kMany || basis.rank() < 6)) {
      basis.add(slip_matrix(box_.contacts[bearing_[taken++].contact].corners.front()));
    }
    bearing_.resize(taken);
    std::sort(bearing_.begin(), bearing_.end(),
              [](const Bearing& a, const Bearing& b) { return a.contact < b.contact; });
  }

  /// The span of some slips, in doubles.
  class IndependentBasis {
   public:
    void add(const SlipMatrix& rows) { sum_ += rows.transpose() * rows; }
    Eigen::Index rank() const {
      return Eigen::FullPivLU<EigenMatrix6>(sum_).setThreshold(kFlat).rank();
    }

   private:
    EigenMatrix6 sum_ = EigenMatrix6::Zero();
  };

  /// G: a right inverse, in which those with more to spare answer more.
  bool choose_answers() {
    const auto count = static_cast<Eigen::Index>(bearing_.size());
    Eigen::MatrixXd wrenches(6, 3 * count);
    Eigen::VectorXd weights(3 * count);
    for (Eigen::Index k = 0; k < count; ++k) {
      const auto& [contact, spare] = bearing_[static_cast<std::size_t>(k)];
      wrenches.block<6, 3>(0, 3 * k) =
          slip_matrix(box_.contacts[contact].corners.front()).transpose();
      weights.segment<3>(3 * k).setConstant(spare * spare);
    }
    const EigenMatrix6 gram = wrenches * weights.asDiagonal() * wrenches.transpose();
    Eigen::CompleteOrthogonalDecomposition<EigenMatrix6> decomposition;
    decomposition.setThreshold(kFlat);
    decomposition.compute(gram);
    Eigen::MatrixXd answers =
        weights.asDiagonal() * wrenches.transpose() * decomposition.pseudoInverse();
    if (count == 0 || !answers.allFinite()) return false;
    // What friction does not answer, as along the normal of all contacts, has to balance by
    // itself.
    const EigenMatrix6 off = EigenMatrix6(wrenches * answers) - EigenMatrix6::Identity();
    for (Eigen::Index l = 0; l < 6; ++l) {
      if (off.col(l).norm() > kFlat) answers.col(l).setZero();
    }
    for (Eigen::Index k = 0; k < count; ++k) {
      const std::size_t i = bearing_[static_cast<std::size_t>(k)].contact;
      RestProof::Answer answer{ContactId(i), {}};
      for (Eigen::Index l = 0; l < 6; ++l) {
        const double unit = l < 3 ? 1 : 1 / box_.length;
        answer.forces[static_cast<std::size_t>(l)] =
            friction_near(box_.contacts[i], answers.block<3, 1>(3 * k, l) * unit, kBits);
      }
      proof_.answers.push_back(std::move(answer));
    }
    return true;
  }

  void state_friction() {
    for (std::size_t i = 0; i < box_.contacts.size(); ++i) {
      const Eigen::Vector3d f(middle_.friction[i].data());
      if (middle_.sticks[i] == 0 || f.isZero(0)) continue;
      proof_.friction.emplace_back(ContactId(i), friction_near(box_.contacts[i], f, kBits));
    }
  }

  /// max |W|, and max |M - 1| by rows.
  void measure(Matrix6& off, Vector6& rest) const {
    rest = {};
    for (const Rational& multiple : multiples_) {
      Intervals6 sum;
      std::copy_n(box_.wrench.begin(), 6, sum.begin());
      for (std::size_t k = 0; k < 6; ++k) {
        sum[k].low += multiple * box_.growth[k];
        sum[k].high += multiple * box_.growth[k];
      }
      auto next = proof_.friction.begin();
      for (std::size_t i = 0; i < box_.contacts.size(); ++i) {
        const LawContact& c = box_.contacts[i];
        Vector3 f{};
        if (next != proof_.friction.end() && next->first.index() == i) f = (next++)->second;
        const Interval preload = preload_at(c, multiple);
        std::vector<Vector3> forces;
        for (const Rational& a : {preload.low, preload.high}) {
          forces.push_back(f);
          for (std::size_t k = 0; k < 3; ++k) forces.back()[k] += a * c.place->normal[k];
          if (preload.is_point()) break;
        }
        add_wrenches(sum, c, forces);
      }
      for (std::size_t k = 0; k < 6; ++k) rest[k] = std::max(rest[k], largest(sum[k]));
    }
    for (std::size_t l = 0; l < 6; ++l) {
      Intervals6 column{};
      column[l] = point_interval(-1);
      for (const RestProof::Answer& answer : proof_.answers) {
        add_wrenches(column, box_.contacts[answer.contact.index()], {answer.forces[l]});
      }
      for (std::size_t k = 0; k < 6; ++k) off[k][l] = largest(column[k]);
    }
  }

  /// Z, a little above the solution of Z = |W| + |M - 1| Z, in few bits.
  bool choose_reach(const Matrix6& off, const Vector6& rest) {
    EigenMatrix6 system = EigenMatrix6::Identity();
    EigenVector6 right;
    for (std::size_t k = 0; k < 6; ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      right[row] = to_double(rest[k]);
      for (std::size_t l = 0; l < 6; ++l) {
        system(row, static_cast<Eigen::Index>(l)) -= to_double(off[k][l]);
      }
    }
    // What is 0 must stay above what the others bring, if anything answers it.
    constexpr double kLeast = 1e-12;
    const double least = kLeast * right.maxCoeff();
    for (Eigen::Index k = 0; k < 6; ++k) {
      if (system.row(k).isZero(0))
        system(k, k) = 1;
      else
        right[k] += least;
    }
    const EigenVector6 reach = system.partialPivLu().solve(right) * 1.0001;
    for (std::size_t k = 0; k < 6; ++k) {
      const double z = reach[static_cast<Eigen::Index>(k)];
      if (!std::isfinite(z) || z < 0) return false;
      proof_.reach[k] = rational_in_bits(z * 1.0001, kBits);
    }
    return true;
  }

  /// `rest-reach` and `rest-cone`.
  bool holds(const Matrix6& off, const Vector6& rest) const {
    for (std::size_t k = 0; k < 6; ++k) {
      if (rest[k] + dot(off[k], proof_.reach) > proof_.reach[k]) return false;
    }
    std::vector<Rational> needed(box_.contacts.size());
    for (const auto& [contact, f] : proof_.friction) needed[contact.index()] = length_above(f);
    for (const RestProof::Answer& answer : proof_.answers) {
      for (std::size_t l = 0; l < 6; ++l) {
        needed[answer.contact.index()] += length_above(answer.forces[l]) * proof_.reach[l];
      }
    }
    constexpr unsigned kRootBits = 64;
    for (std::size_t i = 0; i < needed.size(); ++i) {
      if (needed[i].is_zero()) continue;
      const LawContact& c = box_.contacts[i];
      const Rational slope = c.friction.low * short_sqrt(c.squared_length, kRootBits).lower;
      for (const Rational& multiple : multiples_) {
        if (needed[i] > slope * preload_at(c, multiple).low) return false;
      }
    }
    return true;
  }

  const SpaceModel& box_;
  const NearEquilibrium& middle_;
  std::vector<Rational> multiples_;  ///< of a margin its ends
  std::vector<Bearing> bearing_;     ///< whose friction answers
  RestProof proof_;
};

}  // namespace

std::optional<RestProof> prove_at_rest(const SpaceModel& box, const NearEquilibrium& middle) {
  return RestSearch(box, middle).find();
}

}  // namespace stickslip::space_detail
