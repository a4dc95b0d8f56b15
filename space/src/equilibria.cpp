// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibria.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <boost/multiprecision/eigen.hpp>
#include <cmath>
#include <numeric>
#include <utility>

namespace stickslip::space_detail {
namespace {

using Vector3d = Eigen::Vector3d;

constexpr double kLeastSmooth = 1e-10;  // of the reach

/// A number of few bits near x, which is about `size`.
Rational near(double x, double size) {
  if (!(size > 0) || !std::isfinite(size) || !std::isfinite(x)) return 0;
  constexpr int kBits = 30;
  const double unit = std::ldexp(1.0, std::ilogb(size) - kBits);
  return rational_from_double(std::round(x / unit) * unit);
}

}  // namespace

EigenVector6 NewtonMethod::force(const EigenVector6& motion, double smooth,
                                 EigenMatrix6* derivative) const {
  EigenVector6 sum;
  for (Eigen::Index j = 0; j < 6; ++j) sum[j] = model_.load[static_cast<std::size_t>(j)][0];
  if (derivative != nullptr) derivative->setZero();
  for (const LawContact& c : model_.contacts) {
    const CornerRow& row = c.corners.front();
    const EigenVector6 normal = row.normal_rounded;
    const double a = c.preloads[0] - c.stiffnesses[0] * normal.dot(motion);
    if (!(a > 0)) continue;
    EigenVector6 wrench = normal;
    if (c.slopes[0] > 0) {
      const SlipMatrix slip = slip_matrix(row);
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
      const LawContact& c = model_.contacts[i];
      const CornerRow& row = c.corners.front();
      const EigenVector6 normal = row.normal_rounded;
      double a = c.preloads[0] - c.stiffnesses[0] * normal.dot(near.motion);
      constexpr double kTouches = 1e-13;  // rounding lets nothing rub
      if (a < kTouches * model_.force / normal.head<3>().norm()) a = 0;
      near.normal[i] = a;
      if (near.sticks[i] == 0 && !(a > 0)) continue;
      const SlipMatrix slip = slip_matrix(row);
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
        off.head<6>().norm() / model_.force + off.tail(size - 6).norm() / model_.reach;
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
  double smooth = 8 * model_.reach;
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
      system.diagonal().array() -= 1e-9 * model_.force / model_.reach;
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
    if (smooth <= kLeastSmooth * model_.reach) break;
    smooth /= 8;
  }
  if (!converged) {
    // What is left is rounding where slips are very small.
    constexpr double kNearly = 1e-7;
    if (!(force(d, smooth, nullptr).norm() <= kNearly * model_.force)) return std::nullopt;
  }
  NearEquilibrium result{d, {}, {}, {}};
  for (const LawContact& c : model_.contacts) {
    const CornerRow& row = c.corners.front();
    const double a =
        std::max(0.0, c.preloads[0] - c.stiffnesses[0] * row.normal_rounded.dot(d));
    const Vector3d s = slip_matrix(row) * d;
    const double over = std::max(s.norm(), smooth);
    const Vector3d f = -a * c.slopes[0] / over * s;
    result.normal.push_back(a);
    result.friction.push_back({f[0], f[1], f[2]});
    result.sticks.push_back(a > 0 && c.slopes[0] > 0 && s.norm() < smooth ? 1 : 0);
  }
  return result;
}

/// Where friction holds whatever is closed: Newton's method with smooth friction can miss it.
NearEquilibrium NewtonMethod::at_rest() const {
  NearEquilibrium rest{EigenVector6::Zero(), {}, {}, {}};
  for (const LawContact& c : model_.contacts) {
    rest.normal.push_back(c.preloads[0]);
    rest.friction.push_back({});
    rest.sticks.push_back(c.preloads[0] > 0 && c.slopes[0] > 0 ? 1 : 0);
  }
  return rest;
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
  for (std::size_t k = 0; k <= starts; ++k) {
    EigenVector6 start = EigenVector6::Zero();
    const double size = k % 3 == 0 ? 10 : k % 3 == 1 ? 0.3 : 2;
    for (Eigen::Index j = 0; k > 1 && j < 6; ++j) start[j] = size * model_.reach * random();
    std::optional<NearEquilibrium> found = k == 0 ? at_rest() : solve(start);
    if (found) found = polish(std::move(*found));
    if (!found) continue;
    const bool is_known = std::any_of(result.begin(), result.end(), [&](const auto& other) {
      constexpr double kSame = 1e-6;
      return (other.motion - found->motion).norm() <=
             kSame * (model_.reach + found->motion.norm());
    });
    if (!is_known) result.push_back(std::move(*found));
  }
  return result;
}

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

namespace {

using RationalMatrix = Eigen::Matrix<Rational, Eigen::Dynamic, Eigen::Dynamic>;
using RationalVector = Eigen::Matrix<Rational, Eigen::Dynamic, 1>;

/// A basis of the motions with no slip at these contacts, by columns.
RationalMatrix motions_without_slip(const SpaceModel& model,
                                    const std::vector<std::size_t>& sticking) {
  RationalMatrix slips(3 * static_cast<Eigen::Index>(sticking.size()), 6);
  Eigen::Index next = 0;
  for (const std::size_t i : sticking) {
    for (const Row& row : model.contacts[i].corners.front().slip) {
      for (std::size_t j = 0; j < 6; ++j) {
        slips(next, static_cast<Eigen::Index>(j)) = Rational(row[j]);
      }
      ++next;
    }
  }
  if (sticking.empty()) return RationalMatrix::Identity(6, 6);
  Eigen::FullPivLU<RationalMatrix> lu(slips);
  lu.setThreshold(0);  // of rationals, whose zeros are zeros
  if (lu.dimensionOfKernel() == 0) return RationalMatrix(6, 0);
  return lu.kernel();
}

RationalVector as_rationals(const RationalRow& a) {
  RationalVector result(6);
  for (std::size_t j = 0; j < 6; ++j) result[static_cast<Eigen::Index>(j)] = a[j];
  return result;
}

/// The wrench of a unit of an unknown of the balance, and a value that it may be near.
struct BalanceTerm {
  RationalVector wrench;
  Rational value;
  double spare;         ///< how far it may change; motions: at will
  std::size_t contact;  ///< whose friction it is; of a motion none
  RationalVector direction;
};

/// Independent columns carry what the values leave to balance; those with most to spare first.
bool balance(std::vector<BalanceTerm>& terms, const RationalVector& rest) {
  std::vector<std::size_t> order(terms.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return terms[a].spare > terms[b].spare;
  });
  std::vector<std::size_t> chosen;
  RationalMatrix columns(6, 0);
  for (const std::size_t k : order) {
    RationalMatrix longer(6, columns.cols() + 1);
    longer << columns, terms[k].wrench;
    Eigen::FullPivLU<RationalMatrix> lu(longer);
    lu.setThreshold(0);
    if (lu.rank() < longer.cols()) continue;
    columns = std::move(longer);
    chosen.push_back(k);
    if (chosen.size() == 6) break;
  }
  if (chosen.empty()) return rest.isZero(0);
  Eigen::FullPivLU<RationalMatrix> lu(columns);
  lu.setThreshold(0);
  const RationalVector change = lu.solve(rest);
  if (columns * change != rest) return false;
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    terms[chosen[k]].value += change[static_cast<Eigen::Index>(k)];
  }
  return true;
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
  // Unknown: multiples of the motions that leave all of these without slip, and two numbers of
  // friction at each. Of the latter all but a few stay near what they are.
  const RationalMatrix motions = motions_without_slip(model, sticking);
  std::vector<BalanceTerm> terms;
  RationalVector rest(6);  // what the values leave to balance
  for (std::size_t j = 0; j < 6; ++j) {
    rest[static_cast<Eigen::Index>(j)] = -model.wrench[j].low;
  }
  for (Eigen::Index k = 0; k < motions.cols(); ++k) {
    terms.push_back({RationalVector::Zero(6), 0, HUGE_VAL, m, motions.col(k)});
  }
  for (std::size_t i = 0; i < m; ++i) {
    if (!(near_one.normal[i] > 0)) continue;
    const LawContact& c = model.contacts[i];
    const RationalVector normal = as_rationals(c.corners.front().normal);
    rest -= c.preload.low * normal;
    for (Eigen::Index k = 0; k < motions.cols(); ++k) {
      const Rational rise = normal.dot(motions.col(k));
      terms[static_cast<std::size_t>(k)].wrench -= Rational(c.stiffness.low * rise) * normal;
    }
  }
  for (const std::size_t i : sticking) {
    const LawContact& c = model.contacts[i];
    const CornerRow& row = c.corners.front();
    const double most = c.slopes[0] * near_one.normal[i];
    const Double3& f = near_one.friction[i];
    for (const Vector3& t : tangents_of(c.place->normal)) {
      Double3 rounded{};
      for (std::size_t k = 0; k < 3; ++k) rounded[k] = to_double(t[k]);
      const double square = dot(rounded, rounded);
      BalanceTerm term{RationalVector::Zero(6),
                       near(dot(f, rounded) / square, most / std::sqrt(square)),
                       most - std::sqrt(dot(f, f)), i, RationalVector(3)};
      for (std::size_t k = 0; k < 3; ++k) {
        term.direction[static_cast<Eigen::Index>(k)] = t[k];
        for (std::size_t j = 0; j < 6; ++j) {
          term.wrench[static_cast<Eigen::Index>(j)] +=
              t[k] * Rational(row.slip[k][j]) / row.slip_factor;
        }
      }
      rest -= term.value * term.wrench;
      terms.push_back(std::move(term));
    }
  }
  if (!balance(terms, rest)) return std::nullopt;
  SpatialWitness witness{};
  std::vector<Vector3> friction(m);
  for (const BalanceTerm& term : terms) {
    for (Eigen::Index k = 0; k < term.direction.size(); ++k) {
      Rational& sum = term.contact == m ? witness.twist[static_cast<std::size_t>(k)]
                                        : friction[term.contact][static_cast<std::size_t>(k)];
      sum += term.value * term.direction[k];
    }
  }
  // Judged: the modes, and the cones.
  const RationalRow twist(witness.twist.begin(), witness.twist.end());
  for (std::size_t i = 0; i < m; ++i) {
    const LawContact& c = model.contacts[i];
    const Rational v = c.preload.low - c.stiffness.low * dot(c.corners.front().normal, twist);
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
