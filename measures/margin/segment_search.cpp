// SPDX-License-Identifier: GPL-3.0-or-later
#include "segment_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/motion/dense.hpp"
#include "stickslip/engine/pull_rule.hpp"
#include "stickslip/lp/exact_system.hpp"

namespace stickslip::margin_detail {
namespace {

using Function = Vector5;  ///< a function of points

Function sum(Function a, const Rational& factor, const Function& b) {
  for (std::size_t j = 0; j < 5; ++j) a[j] += factor * b[j];
  return a;
}

/// K and its multiples as functions of points.
class Cell {
 public:
  Cell(const MarginInterval& range, const SegmentByDegree& shape) : shape_(shape) {
    if (const auto& [low, high] = range; high) {
      const Rational length = *high - low;
      s_ = {0, 0, 0, *high / length, -1 / length};
      t_ = {0, 0, 0, -low / length, 1 / length};
    } else {
      s_ = {0, 0, 0, 1, 0};
      t_ = {0, 0, 0, -1, 1 / low};
    }
  }

  /// Returns row.e, e the motion relative to the centre of K.
  Function of_motion(const RationalRow& row) const {
    Function f{row[0], row[1], row[2], 0, 0};
    f = sum(std::move(f), -dot(row, shape_.twist), s_);
    return sum(std::move(f), -dot(row, shape_.end_twist), t_);
  }

  Region wall(const Problem& problem, std::size_t wall, int sign, bool middle) const {
    std::vector<Region::Cut> cuts;
    const Function size = sum(s_, 1, t_);
    const auto cut = [&](const Function& f, Side side, bool strict = false) {
      cuts.push_back({primitive_multiple(f), side, strict});
    };
    cut(s_, Side::kPositive);
    cut(t_, Side::kPositive);
    cut(size, Side::kPositive, true);
    if (middle) cut(sum(s_, -1, t_), Side::kZero);
    for (std::size_t j = 0; j < 3; ++j) {
      const Function f = of_motion(shape_.walls[j]);
      if (j == wall) {
        cut(sum(f, -sign, size), Side::kZero);
      } else {
        cut(sum(f, -1, size), Side::kNegative);
        cut(sum(f, 1, size), Side::kPositive);
      }
    }
    return Region::between(problem, cuts);
  }

 private:
  const SegmentByDegree& shape_;
  Function s_, t_;
};

/// Rounds to a part in 256 of the width of K; `steepest` is the largest entry of the walls'
/// column.
Rational rounded(double value, double steepest) {
  if (!(steepest > 0) || !std::isfinite(steepest)) return rational_from_double(value);
  const double grain = std::ldexp(1.0, -static_cast<int>(std::ceil(std::log2(steepest))) - 8);
  return rational_from_double(std::round(value / grain) * grain);
}

/// Returns K and A in few bits, with the middle of K going from one motion to another; all 0 if
/// something is not finite.
SegmentByDegree in_few_bits(const Eigen::Matrix3d& walls, const Eigen::Matrix3d& direction,
                            const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  SegmentByDegree shape;
  shape.twist.resize(3);
  shape.end_twist.resize(3);
  shape.walls.assign(3, RationalRow(3));
  shape.direction = shape.walls;
  if (!walls.allFinite() || !direction.allFinite() || !from.allFinite() || !to.allFinite()) {
    return shape;
  }
  constexpr int kBits = 12;
  for (std::size_t j = 0; j < 3; ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    const double steepest = walls.col(row).lpNorm<Eigen::Infinity>();
    shape.twist[j] = rounded(from[row], steepest);
    shape.end_twist[j] = rounded(to[row], steepest);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      shape.walls[j][k] = rational_in_bits(walls(row, column), kBits);
      shape.direction[j][k] = rational_in_bits(direction(row, column), kBits);
    }
  }
  return shape;
}

/// A size of K to try.
struct CellSize {
  double force;  ///< the force left over on the walls, over all normal forces
  double slip;   ///< the slip over which friction is smooth, beside what that force moves
};
constexpr std::array<CellSize, 10> kSizes{{{0.3, 1},
                                           {0.3, 0.1},
                                           {0.1, 1},
                                           {0.1, 0.1},
                                           {0.3, 0.01},
                                           {0.03, 1},
                                           {0.03, 0.1},
                                           {0.1, 10},
                                           {0.1, 0.01},
                                           {0.01, 1}}};

}  // namespace

SegmentSearch::SegmentSearch(const Problem& problem)
    : problem_(problem), crowd_(problem), model_(crowd_.model()), balance_(model_) {}

/// Returns about the size of the load and preloads of the member with h and l.
double SegmentSearch::force_of(double h, double l) const {
  const auto size = [&](const Double3& w) {
    return std::hypot(w[0], w[1]) + std::fabs(w[2]) / model_.length;
  };
  double force = h * size(model_.load) + l * size(model_.growth);
  for (const ContactDoubles& c : model_.contacts) {
    force += (h * c.separation[3] + l * c.separation[4]) * std::hypot(c.normal[0], c.normal[1]);
  }
  return force;
}

/// Returns the motion under the load if springs neither open nor slip.
SegmentSearch::Motion SegmentSearch::sprung(double h, double l) const {
  const Motion load = h * Motion(model_.load.data()) + l * Motion(model_.growth.data());
  const Motion d = solution(spring_stiffness(model_), load);
  return d.allFinite() ? d : Motion::Zero();
}

/// Returns an equilibrium of the member with h and l, in doubles, with friction less and less
/// smooth, as far as that goes.
std::optional<SegmentSearch::Motion> SegmentSearch::settle(double h, double l,
                                                           const Motion* near) {
  const double force = force_of(h, l);
  if (!(model_.stiffness > 0) || !(force > 0)) return std::nullopt;
  balance_.set_member(h, l);
  const double travel = force / model_.stiffness;
  constexpr double kFinest = 1e-7;
  constexpr double kNear = 1e-2;
  constexpr double kFar = 10;
  constexpr int kSteps = 15;
  std::optional<Motion> best;
  const auto relax = [&](Motion d, double shrink) {
    for (; shrink > kFinest; shrink *= 0.1) {
      balance_.set_epsilon(shrink * travel);
      if (balance_.solve(d, kSteps, 1e-9 * force) <= 1e-8 * force) best = d;
    }
    return best.has_value();
  };
  // Contacts without preload do not resist at rest, so springs are tried as well.
  if (near == nullptr || !relax(*near, kNear)) {
    if (!relax(Motion::Zero(), kFar)) relax(sprung(h, l), kFar);
  }
  return best;
}

std::optional<SegmentByDegree> SegmentSearch::prove_segment(const MarginInterval& range,
                                                            const Motion& from,
                                                            const Motion& to, bool is_short) {
  const double alpha = to_double(range.low);
  const double h = range.high ? 1 : 0.5;
  const double l = range.high ? (alpha + to_double(*range.high)) / 2 : alpha;
  const Motion middle = (from + to) / 2;
  const std::optional<Motion> there = settle(h, l, &middle);
  if (!there) return std::nullopt;
  // Half of the multiples are easier, until few are left; so a long range gets few tries.
  return prove_around(*there, range, from, to, is_short ? kSizes.size() : 4);
}

/// `there` is an equilibrium of the member of balance_.
std::optional<SegmentByDegree> SegmentSearch::prove_around(const Motion& there,
                                                           const MarginInterval& range,
                                                           const Motion& from, const Motion& to,
                                                           std::size_t tries) {
  if (problem_.law() == NormalLaw::kBilateral && balance_.opens(there)) return std::nullopt;
  double force = 0;
  const Double5 x = balance_.point(there);
  for (const ContactDoubles& c : model_.contacts) {
    force += std::max(0.0, dot(c.separation, x)) * std::hypot(c.normal[0], c.normal[1]);
  }
  if (!(force > 0)) return std::nullopt;
  constexpr double kWithin = 0.7;
  const Motion middle = (from + to) / 2;
  for (std::size_t attempt = 0; attempt < tries; ++attempt) {
    // The size that served last comes first.
    const CellSize& size = kSizes[attempt == 0            ? last_size_
                                  : attempt <= last_size_ ? attempt - 1
                                                          : attempt];
    const double left = size.force * force;
    balance_.set_epsilon(size.slip * left / model_.stiffness);
    Eigen::Matrix3d answer;
    balance_.residual(there, answer);
    Eigen::Matrix3d walls = -answer / left;
    walls.row(2) /= model_.length;
    if (!walls.allFinite()) return std::nullopt;
    if ((walls * (there - middle)).lpNorm<Eigen::Infinity>() > kWithin) continue;
    ++proofs_;
    if (auto proof = prove_with(range, in_few_bits(walls, -answer, from, to))) {
      last_size_ = static_cast<std::size_t>(&size - kSizes.data());
      return proof;
    }
  }
  return std::nullopt;
}

std::optional<SegmentByDegree> SegmentSearch::prove_with(const MarginInterval& range,
                                                         SegmentByDegree shape) {
  if (!has_rank(shape, 3)) return std::nullopt;
  const Cell cell(range, shape);
  std::vector<RationalRow> rows;
  for (const RationalRow& row : shape.direction) {
    const Function f = cell.of_motion(row);
    rows.emplace_back(f.begin(), f.end());
  }
  const PullRule pull(rows);
  constexpr std::size_t kMostNodes = 100;  // one that is hard can be cut
  // List 2 is the shorter one, and fails as often.
  Trees second_list;
  for (const bool second : {true, false}) {
    Trees& trees = second ? second_list : shape.trees;
    for (std::size_t wall = 0; wall < 3; ++wall) {
      for (const int sign : {1, -1}) {
        Region region = cell.wall(problem_, wall, sign, second);
        if (!second && problem_.law() == NormalLaw::kBilateral) {
          if (!crowd_.all_are_closed(region)) return std::nullopt;
        }
        if (!crowd_.refute(std::move(region), second ? &pull : nullptr, kMostNodes, trees)) {
          return std::nullopt;
        }
      }
    }
  }
  shape.trees.insert(shape.trees.end(), second_list.begin(), second_list.end());
  return shape;
}

}  // namespace stickslip::margin_detail
