// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibria.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

namespace stickslip::space_detail {
namespace {

using Vector3d = Eigen::Vector3d;
using Slip = Eigen::Matrix<double, 3, 6>;

EigenVector6 as_vector(const Double6& a) {
  return EigenVector6(a.data());
}

Slip slip_matrix(const CornerRow& row) {
  Slip s;
  for (int k = 0; k < 3; ++k)
    s.row(k) = as_vector(row.slip_rounded[static_cast<std::size_t>(k)]);
  return s;
}

constexpr double kLeastSmooth = 1e-10;  // of the reach

/// A number of few bits near x, which is about `size`.
Rational near(double x, double size) {
  if (!(size > 0) || !std::isfinite(size) || !std::isfinite(x)) return 0;
  constexpr int kBits = 30;
  const double unit = std::ldexp(1.0, std::ilogb(size) - kBits);
  return rational_from_double(std::round(x / unit) * unit);
}

}  // namespace

NewtonMethod::NewtonMethod(const SpaceModel& model) : model_(model) {
  double stiffest = 0;
  for (const SpaceContact& c : model.contacts) {
    stiffest = std::max(stiffest, c.stiffnesses[1] * to_double(c.squared_length));
  }
  if (stiffest > 0) reach_ = model.force / stiffest;
}

EigenVector6 NewtonMethod::force(const EigenVector6& motion, double smooth,
                                 EigenMatrix6* derivative) const {
  EigenVector6 sum;
  for (Eigen::Index j = 0; j < 6; ++j) sum[j] = model_.load[static_cast<std::size_t>(j)][0];
  if (derivative != nullptr) derivative->setZero();
  for (const SpaceContact& c : model_.contacts) {
    const CornerRow& row = c.corners.front();
    const EigenVector6 normal = as_vector(row.normal_rounded);
    const double a = c.preloads[0] - c.stiffnesses[0] * normal.dot(motion);
    if (!(a > 0)) continue;
    EigenVector6 wrench = normal;
    if (c.slopes[0] > 0) {
      const Slip slip = slip_matrix(row);
      const Vector3d s = slip * motion;
      const double size = s.norm();
      const double over = std::max(size, smooth);
      if (over > 0) {
        wrench -= c.slopes[0] / over * (slip.transpose() * s);
        if (derivative != nullptr) {
          Eigen::Matrix3d change = Eigen::Matrix3d::Identity() / over;
          if (size >= smooth) change -= s * s.transpose() / (size * size * size);
          *derivative -= a * c.slopes[0] * (slip.transpose() * change * slip);
        }
      }
    }
    sum += a * wrench;
    if (derivative != nullptr) *derivative -= c.stiffnesses[0] * wrench * normal.transpose();
  }
  return sum;
}

std::optional<NearEquilibrium> NewtonMethod::polish(NearEquilibrium near) const {
  const std::size_t m = model_.contacts.size();
  std::vector<std::size_t> sticking;
  for (std::size_t i = 0; i < m; ++i) {
    if (near.sticks[i] != 0) sticking.push_back(i);
  }
  const auto size = static_cast<Eigen::Index>(6 + 3 * sticking.size());
  double last = HUGE_VAL;
  constexpr int kMostSteps = 40;
  for (int step = 0; step < kMostSteps; ++step) {
    // Balance, and no slip where it sticks; of motion and friction there.
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd off = Eigen::VectorXd::Zero(size);
    for (Eigen::Index j = 0; j < 6; ++j) off[j] = model_.load[static_cast<std::size_t>(j)][0];
    Eigen::Index next = 6;
    for (std::size_t i = 0; i < m; ++i) {
      const SpaceContact& c = model_.contacts[i];
      const CornerRow& row = c.corners.front();
      const EigenVector6 normal = as_vector(row.normal_rounded);
      const double a = c.preloads[0] - c.stiffnesses[0] * normal.dot(near.motion);
      near.normal[i] = std::max(a, 0.0);
      if (near.sticks[i] == 0 && !(a > 0)) continue;
      const Slip slip = slip_matrix(row);
      const Vector3d s = slip * near.motion;
      EigenVector6 wrench = normal;
      if (near.sticks[i] != 0) {
        const Vector3d f(near.friction[i].data());
        off.head<6>() += slip.transpose() * f;
        off.segment<3>(next) = s;
        system.block<6, 3>(0, next) = slip.transpose();
        system.block<3, 6>(next, 0) = slip;
        next += 3;
      } else if (c.slopes[0] > 0 && s.norm() > 0) {
        const Vector3d along = s.normalized();
        wrench -= c.slopes[0] * (slip.transpose() * along);
        system.topLeftCorner<6, 6>() -=
            a * c.slopes[0] / s.norm() *
            (slip.transpose() * (Eigen::Matrix3d::Identity() - along * along.transpose()) *
             slip);
        for (std::size_t k = 0; k < 3; ++k) {
          near.friction[i][k] = -a * c.slopes[0] * along[static_cast<Eigen::Index>(k)];
        }
      }
      off.head<6>() += a * wrench;
      system.topLeftCorner<6, 6>() -= c.stiffnesses[0] * wrench * normal.transpose();
    }
    const double error =
        off.head<6>().norm() / model_.force + off.tail(size - 6).norm() / reach_;
    constexpr double kBalanced = 1e-13;
    constexpr double kStalled = 1e-9;
    if (error <= kBalanced || (error <= kStalled && error > last / 2)) {
      share_out(near);
      for (const std::size_t i : sticking) {
        const Double3& f = near.friction[i];
        const double most = model_.contacts[i].slopes[0] * near.normal[i];
        if (std::sqrt(dot(f, f)) > most * (1 + 1e-9)) return std::nullopt;
      }
      return near;
    }
    last = error;
    const Eigen::VectorXd move = system.completeOrthogonalDecomposition().solve(off);
    if (!move.allFinite()) return std::nullopt;
    near.motion -= move.head<6>();
    next = 6;
    for (const std::size_t i : sticking) {
      for (std::size_t k = 0; k < 3; ++k) near.friction[i][k] -= move[next++];
    }
  }
  return std::nullopt;
}

/// By least squares, again and again with more weight where the share is large.
void NewtonMethod::share_out(NearEquilibrium& near) const {
  std::vector<std::size_t> sticking;
  std::vector<double> most;
  for (std::size_t i = 0; i < near.sticks.size(); ++i) {
    if (near.sticks[i] == 0) continue;
    sticking.push_back(i);
    most.push_back(model_.contacts[i].slopes[0] * near.normal[i]);
  }
  const auto count = static_cast<Eigen::Index>(sticking.size());
  if (count == 0) return;
  Eigen::MatrixXd wrenches(6, 3 * count);  // of unit shares
  Eigen::VectorXd shares(3 * count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    wrenches.block<6, 3>(0, 3 * k) =
        most[at] * slip_matrix(model_.contacts[sticking[at]].corners.front()).transpose();
    shares.segment<3>(3 * k) = Eigen::Vector3d(near.friction[sticking[at]].data()) / most[at];
  }
  const EigenVector6 sum = wrenches * shares;
  const auto largest = [&](const Eigen::VectorXd& of) {
    double result = 0;
    for (Eigen::Index k = 0; k < count; ++k) {
      result = std::max(result, of.segment<3>(3 * k).norm());
    }
    return result;
  };
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(3 * count);
  Eigen::VectorXd best = shares;
  constexpr int kRounds = 20;
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::MatrixXd weighted = wrenches * weights.asDiagonal();
    const Eigen::VectorXd next =
        weights.asDiagonal() * weighted.completeOrthogonalDecomposition().solve(sum).eval();
    // What is off by rounding is not to be kept.
    constexpr double kBalanced = 1e-12;
    if (!next.allFinite() || !((wrenches * next - sum).norm() <= kBalanced * model_.force))
      break;
    if (largest(next) < largest(best)) best = next;
    for (Eigen::Index k = 0; k < count; ++k) {
      weights.segment<3>(3 * k) /= 0.3 + next.segment<3>(3 * k).norm() / largest(next);
    }
  }
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    for (std::size_t j = 0; j < 3; ++j) {
      near.friction[sticking[at]][j] = most[at] * best[3 * k + static_cast<Eigen::Index>(j)];
    }
  }
}

std::optional<NearEquilibrium> NewtonMethod::solve(const EigenVector6& start) const {
  EigenVector6 d = start;
  EigenMatrix6 derivative;
  double smooth = 8 * reach_;
  bool converged = false;
  while (true) {
    constexpr int kMostSteps = 30;
    converged = false;
    EigenVector6 f = force(d, smooth, &derivative);
    for (int step = 0; step < kMostSteps; ++step) {
      constexpr double kBalanced = 1e-11;
      if (f.norm() <= kBalanced * model_.force) {
        converged = true;
        break;
      }
      // Where nothing holds the object, a weak spring does.
      EigenMatrix6 system = derivative;
      system.diagonal().array() -= 1e-9 * model_.force / reach_;
      const EigenVector6 move = -system.partialPivLu().solve(f);
      if (!move.allFinite()) return std::nullopt;
      double part = 1;
      EigenVector6 next = d + move;
      EigenVector6 there = force(next, smooth, nullptr);
      while (there.norm() > (1 - 1e-4 * part) * f.norm() && part > 1e-4) {
        part /= 2;
        next = d + part * move;
        there = force(next, smooth, nullptr);
      }
      d = next;
      f = force(d, smooth, &derivative);
    }
    if (smooth <= kLeastSmooth * reach_) break;
    smooth /= 8;
  }
  if (!converged) {
    // What is left is rounding where slips are very small.
    constexpr double kNearly = 1e-7;
    if (!(force(d, smooth, nullptr).norm() <= kNearly * model_.force)) return std::nullopt;
  }
  NearEquilibrium result{d, {}, {}, {}};
  for (const SpaceContact& c : model_.contacts) {
    const CornerRow& row = c.corners.front();
    const double a =
        std::max(0.0, c.preloads[0] - c.stiffnesses[0] * as_vector(row.normal_rounded).dot(d));
    const Vector3d s = slip_matrix(row) * d;
    const double over = std::max(s.norm(), smooth);
    const Vector3d f = -a * c.slopes[0] / over * s;
    result.normal.push_back(a);
    result.friction.push_back({f[0], f[1], f[2]});
    result.sticks.push_back(a > 0 && s.norm() < smooth ? 1 : 0);
  }
  return result;
}

std::vector<NearEquilibrium> NewtonMethod::solve_from(std::size_t starts) const {
  std::vector<NearEquilibrium> result;
  std::uint64_t state = 88172645463325252ULL;
  const auto random = [&] {  // xorshift: from -1 to 1
    state ^= state << 13U;
    state ^= state >> 7U;
    state ^= state << 17U;
    return static_cast<double>(state >> 11U) / static_cast<double>(1ULL << 52U) - 1;
  };
  for (std::size_t k = 0; k < starts; ++k) {
    EigenVector6 start = EigenVector6::Zero();
    const double size = k % 3 == 0 ? 0.3 : k % 3 == 1 ? 2 : 10;
    for (Eigen::Index j = 0; k > 0 && j < 6; ++j) start[j] = size * reach_ * random();
    auto found = solve(start);
    if (found) found = polish(std::move(*found));
    if (!found) continue;
    const bool is_known = std::any_of(result.begin(), result.end(), [&](const auto& other) {
      constexpr double kSame = 1e-6;
      return (other.motion - found->motion).norm() <= kSame * (reach_ + found->motion.norm());
    });
    if (!is_known) result.push_back(std::move(*found));
  }
  return result;
}

namespace {

using RationalMatrix = Eigen::Matrix<Rational, Eigen::Dynamic, Eigen::Dynamic>;

/// Directions across n: two of its rational tangents.
std::array<Vector3, 2> tangents_of(const Vector3& n) {
  std::size_t least = 0;
  for (std::size_t j = 1; j < 3; ++j) {
    if (abs(n[j]) < abs(n[least])) least = j;
  }
  Vector3 unit{};
  unit[least] = 1;
  const Vector3 first = cross(n, unit);
  return {first, cross(n, first)};
}

/// Basic columns of the rows that are 0 at d: a basis of the motions with no slip there.
std::vector<Vector6> motions_without_slip(const SpaceModel& model,
                                          const std::vector<std::size_t>& sticking) {
  std::vector<Vector6> rows;
  for (const std::size_t i : sticking) {
    for (const IntegerVector<6>& row : model.contacts[i].corners.front().slip) {
      Vector6 r;
      for (std::size_t j = 0; j < 6; ++j) r[j] = Rational(row[j]);
      rows.push_back(std::move(r));
    }
  }
  // Gauss-Jordan.
  std::vector<std::size_t> pivots;
  std::size_t rank = 0;
  for (std::size_t column = 0; column < 6 && rank < rows.size(); ++column) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && rows[pivot][column].is_zero()) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[rank], rows[pivot]);
    const Rational lead = rows[rank][column];
    for (Rational& entry : rows[rank]) entry /= lead;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (r == rank || rows[r][column].is_zero()) continue;
      const Rational factor = rows[r][column];
      for (std::size_t j = 0; j < 6; ++j) rows[r][j] -= factor * rows[rank][j];
    }
    pivots.push_back(column);
    ++rank;
  }
  std::vector<Vector6> basis;
  for (std::size_t column = 0; column < 6; ++column) {
    if (std::find(pivots.begin(), pivots.end(), column) != pivots.end()) continue;
    Vector6 d{};
    d[column] = 1;
    for (std::size_t r = 0; r < rank; ++r) d[pivots[r]] = -rows[r][column];
    basis.push_back(d);
  }
  return basis;
}

}  // namespace

std::optional<SpatialWitness> exact_witness(const SpaceModel& model,
                                            const NearEquilibrium& near_one) {
  const std::size_t m = model.contacts.size();
  std::vector<std::size_t> sticking;
  for (std::size_t i = 0; i < m; ++i) {
    const bool rubs = near_one.normal[i] > 0 && !model.contacts[i].friction.high.is_zero();
    if (rubs && near_one.sticks[i] == 0) return std::nullopt;
    if (rubs) sticking.push_back(i);
  }
  // Unknown: z, of d = basis z, and two numbers of friction for each sticking contact. Of the
  // latter all but a few stay near what they are.
  const std::vector<Vector6> basis = motions_without_slip(model, sticking);
  struct Column {
    Vector6 wrench;
    double spare;  ///< how far it may change; motions: at will
    Rational value;
    std::size_t contact;
    Vector3 direction;
  };
  std::vector<Column> columns;
  Vector6 sum;  // what is left to balance, with the values
  for (std::size_t j = 0; j < 6; ++j) sum[j] = model.wrench[j].low;
  for (std::size_t i = 0; i < m; ++i) {
    if (!(near_one.normal[i] > 0)) continue;
    const SpaceContact& c = model.contacts[i];
    for (std::size_t j = 0; j < 6; ++j) {
      sum[j] += c.preload.low * c.corners.front().normal[j];
    }
  }
  for (const Vector6& d : basis) {
    Column column{{}, HUGE_VAL, 0, m, {}};
    for (std::size_t i = 0; i < m; ++i) {
      if (!(near_one.normal[i] > 0)) continue;
      const SpaceContact& c = model.contacts[i];
      const Rational rise = c.stiffness.low * dot(c.corners.front().normal, d);
      for (std::size_t j = 0; j < 6; ++j) {
        column.wrench[j] -= rise * c.corners.front().normal[j];
      }
    }
    columns.push_back(column);
  }
  for (const std::size_t i : sticking) {
    const SpaceContact& c = model.contacts[i];
    const double most = c.slopes[0] * near_one.normal[i];
    const Double3& f = near_one.friction[i];
    for (const Vector3& t : tangents_of(c.normal)) {
      Double3 rounded_t{};
      for (std::size_t k = 0; k < 3; ++k) rounded_t[k] = to_double(t[k]);
      const double size = std::sqrt(dot(rounded_t, rounded_t));
      Column column{{}, most - std::sqrt(dot(f, f)), 0, i, t};
      column.value = near(dot(f, rounded_t) / (size * size), most / size);
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t j = 0; j < 6; ++j) {
          column.wrench[j] +=
              t[k] * Rational(c.corners.front().slip[k][j]) / c.corners.front().slip_factor;
        }
      }
      for (std::size_t j = 0; j < 6; ++j) sum[j] += column.value * column.wrench[j];
      columns.push_back(std::move(column));
    }
  }
  std::stable_sort(columns.begin(), columns.end(),
                   [](const Column& a, const Column& b) { return a.spare > b.spare; });
  // Independent columns, in this order, carry what is left.
  std::vector<std::size_t> chosen;
  std::vector<Vector6> reduced;
  std::vector<std::size_t> pivots;
  for (std::size_t k = 0; k < columns.size() && chosen.size() < 6; ++k) {
    Vector6 rest = columns[k].wrench;
    for (std::size_t r = 0; r < reduced.size(); ++r) {
      const Rational factor = rest[pivots[r]];
      for (std::size_t j = 0; j < 6; ++j) rest[j] -= factor * reduced[r][j];
    }
    std::size_t pivot = 0;
    while (pivot < 6 && rest[pivot].is_zero()) ++pivot;
    if (pivot == 6) continue;
    const Rational lead = rest[pivot];
    for (Rational& entry : rest) entry /= lead;
    chosen.push_back(k);
    reduced.push_back(std::move(rest));
    pivots.push_back(pivot);
  }
  const auto rank = static_cast<Eigen::Index>(chosen.size());
  RationalMatrix system = RationalMatrix::Constant(6, rank + 1, Rational(0));
  for (Eigen::Index j = 0; j < 6; ++j) {
    for (Eigen::Index k = 0; k < rank; ++k) {
      system(j, k) =
          columns[chosen[static_cast<std::size_t>(k)]].wrench[static_cast<std::size_t>(j)];
    }
    system(j, rank) = -sum[static_cast<std::size_t>(j)];
  }
  // Gauss-Jordan; the columns are independent.
  for (Eigen::Index k = 0; k < rank; ++k) {
    Eigen::Index pivot = k;
    while (pivot < 6 && system(pivot, k).is_zero()) ++pivot;
    if (pivot == 6) return std::nullopt;
    system.row(k).swap(system.row(pivot));
    const Rational lead = system(k, k);
    for (Eigen::Index j = k; j <= rank; ++j) system(k, j) /= lead;
    for (Eigen::Index r = 0; r < 6; ++r) {
      if (r == k || system(r, k).is_zero()) continue;
      const Rational factor = system(r, k);
      for (Eigen::Index j = k; j <= rank; ++j) system(r, j) -= factor * system(k, j);
    }
  }
  for (Eigen::Index r = rank; r < 6; ++r) {
    if (!system(r, rank).is_zero()) return std::nullopt;
  }
  for (Eigen::Index k = 0; k < rank; ++k) {
    columns[chosen[static_cast<std::size_t>(k)]].value += system(k, rank);
  }
  SpatialWitness witness{};
  std::vector<Vector3> friction(m);
  std::size_t motion = 0;
  for (const Column& column : columns) {
    if (column.contact == m) {
      for (std::size_t j = 0; j < 6; ++j) witness.twist[j] += column.value * basis[motion][j];
      ++motion;  // stable_sort keeps their order
    } else {
      for (std::size_t k = 0; k < 3; ++k) {
        friction[column.contact][k] += column.value * column.direction[k];
      }
    }
  }
  // Judged: the modes, and the cones.
  for (std::size_t i = 0; i < m; ++i) {
    const SpaceContact& c = model.contacts[i];
    const Rational v =
        c.preload.low - c.stiffness.low * dot(c.corners.front().normal, witness.twist);
    const bool closed = near_one.normal[i] > 0;
    if (closed ? v.sign() < 0 : v.sign() > 0) return std::nullopt;
    if (model.law == NormalLaw::kBilateral && v.sign() < 0) return std::nullopt;
    if (dot(friction[i], friction[i]).is_zero()) continue;
    const Rational scale = c.friction.low * v;
    if (scale.is_zero()) return std::nullopt;
    for (Rational& entry : friction[i]) entry /= scale;
    if (dot(friction[i], friction[i]) > c.squared_length) return std::nullopt;
    witness.shares.emplace_back(ContactId(i), friction[i]);
  }
  return witness;
}

}  // namespace stickslip::space_detail
