// SPDX-License-Identifier: GPL-3.0-or-later
#include "sparse_newton.hpp"

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>

namespace stickslip::large_detail {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

/// An element in doubles, with lengths of rotations as in StaticsModel::rounded().
struct SmoothElement {
  DoubleColumn normal;
  std::vector<DoubleColumn> slips;  ///< so that friction is at most a for each unit of them
  double preload = 0;
  double stiffness = 0;
  double slip_unit = 1;  ///< the factor from slips to those
  bool is_spring = false;
};

double product(const DoubleColumn& column, const Vector& d) {
  double sum = 0;
  for (const auto& [j, entry] : column) sum += entry * d[static_cast<Eigen::Index>(j)];
  return sum;
}

void add(Vector& to, double factor, const DoubleColumn& column) {
  for (const auto& [j, entry] : column) to[static_cast<Eigen::Index>(j)] += factor * entry;
}

double size_of(const DoubleColumn& column) {
  double square = 0;
  for (const auto& [j, entry] : column) square += entry * entry;
  return std::sqrt(square);
}

/// A number, and how it changes with v and with `smooth`.
struct SmoothForce {
  double value = 0;
  double by_separation = 0;
  double by_smooth = 0;
};

/// The normal force of one element, and that by which its friction is bounded.
struct SmoothNormal {
  SmoothForce force;
  SmoothForce pressing;
};

/// SmoothFriction over a, and the slip, of one contact.
struct SmoothFriction {
  double norm = 0;            ///< of the slip
  double over = 0;            ///< what it is divided by
  std::vector<double> ratio;  ///< the slip over that
};

class SmoothGrasp {
 public:
  SmoothGrasp(const LargeGrasp& grasp, Smoothing smoothing) : smoothing_(smoothing) {
    const statics_detail::StaticsModel& model = grasp.model;
    ConePair pair = model.rounded(model.load());
    load_ =
        Eigen::Map<const Vector>(pair.load.data(), static_cast<Eigen::Index>(pair.load.size()));
    std::vector<double> answers;
    const auto add_element = [&](SmoothElement element, const SpringLaw& law) {
      element.preload = to_double(law.preload);
      element.stiffness = to_double(law.stiffness);
      const double size = size_of(element.normal);
      force_ = std::max(force_, element.preload * size);
      answers.push_back(element.stiffness * size * size);
      elements_.push_back(std::move(element));
    };
    force_ = load_.norm();
    for (std::size_t i = 0; i < pair.cones.size(); ++i) {
      std::vector<DoubleColumn>& columns = pair.cones[i];
      SmoothElement element;
      element.normal = std::move(columns.front());
      element.slips.assign(columns.begin() + 1, columns.end());
      if (!element.slips.empty()) element.slip_unit = model.scale(model.cones()[i], 1);
      add_element(std::move(element), grasp.cone_law[i]);
    }
    for (std::size_t s = 0; s < grasp.springs.size(); ++s) {
      SmoothElement element;
      for (const auto& [j, entry] : grasp.springs[s]) {
        element.normal.emplace_back(j, to_double(entry) / model.arms()[j]);
      }
      element.is_spring = true;
      add_element(std::move(element), grasp.spring_law[s]);
    }
    if (!(force_ > 0)) force_ = 1;
    auto middle = answers.begin() + static_cast<std::ptrdiff_t>(answers.size() / 2);
    std::nth_element(answers.begin(), middle, answers.end());
    reach_ = middle != answers.end() && *middle > 0 ? force_ / *middle : 1;
  }

  const std::vector<SmoothElement>& elements() const { return elements_; }
  double force() const { return force_; }
  double reach() const { return reach_; }
  Vector rest() const { return Vector::Zero(load_.size()); }

  /// Returns v of a spring, and of a contact max(0, v) with its edge rounded, as `smoothing_`
  /// says.
  SmoothNormal normal(const SmoothElement& e, const Vector& d, double smooth) const {
    if (e.is_spring) return {{separation(e, d), 1, 0}, {}};
    const bool is_pressed = smoothing_ == Smoothing::kPressed;
    const double more = e.stiffness * smooth;
    const double v = separation(e, d) + (is_pressed ? more : 0);
    constexpr double kOpening = 0.5;
    const double width = kOpening * more;
    const double root = std::hypot(v, 2 * width);
    // One of these sums would cancel.
    const double push = v > 0 ? (v + root) / 2 : 2 * width * width / (root - v);
    const double pull = v < 0 ? (root - v) / 2 : 2 * width * width / (root + v);
    const double side = v / root;
    const double edge_by_smooth = 2 * width * kOpening * e.stiffness / root;
    SmoothNormal result;
    result.pressing = {push, (1 + side) / 2, edge_by_smooth};
    if (is_pressed) {
      result.pressing.by_smooth += e.stiffness * (1 + side) / 2;
      result.force = result.pressing;
      return result;
    }
    result.pressing.value += more;
    result.pressing.by_smooth += e.stiffness;
    const double part = smooth / (smooth + reach_);
    result.force = {push - part * pull, (1 + side + part * (1 - side)) / 2,
                    (1 - part) * edge_by_smooth - (1 - part) / (smooth + reach_) * pull};
    return result;
  }
  static double separation(const SmoothElement& e, const Vector& d) {
    return e.preload - e.stiffness * product(e.normal, d);
  }
  static SmoothFriction friction(const SmoothElement& e, const Vector& d, double smooth) {
    SmoothFriction result;
    for (const DoubleColumn& slip : e.slips) {
      result.ratio.push_back(product(slip, d));
      result.norm = std::hypot(result.norm, result.ratio.back());
    }
    result.over = std::hypot(result.norm, smooth * e.slip_unit);
    for (double& entry : result.ratio) entry /= result.over;
    return result;
  }

  /// Returns the load and all forces; sets the derivative, and how they change with `smooth`.
  Vector sum(const Vector& d, double smooth, Sparse* derivative = nullptr,
             Vector* change = nullptr) const {
    Vector result = load_;
    if (change != nullptr) change->setZero(d.size());
    std::vector<Eigen::Triplet<double>> entries;
    const auto put = [&](double factor, const DoubleColumn& rows, const DoubleColumn& columns) {
      for (const auto& [row, left] : rows) {
        for (const auto& [column, right] : columns) {
          entries.emplace_back(row, column, factor * left * right);
        }
      }
    };
    for (const SmoothElement& e : elements_) {
      const SmoothNormal normal = this->normal(e, d, smooth);
      add(result, normal.force.value, e.normal);
      if (change != nullptr) add(*change, normal.force.by_smooth, e.normal);
      if (derivative != nullptr) {
        put(-e.stiffness * normal.force.by_separation, e.normal, e.normal);
      }
      if (e.slips.empty()) continue;
      const double a = normal.pressing.value;
      const SmoothFriction f = friction(e, d, smooth);
      const double part = smooth * e.slip_unit / f.over;  // of `over`, by `smooth`
      for (std::size_t k = 0; k < e.slips.size(); ++k) {
        add(result, -a * f.ratio[k], e.slips[k]);
        if (change != nullptr) {
          add(*change, (a / smooth * part * part - normal.pressing.by_smooth) * f.ratio[k],
              e.slips[k]);
        }
        if (derivative == nullptr) continue;
        put(e.stiffness * normal.pressing.by_separation * f.ratio[k], e.slips[k], e.normal);
        put(-a / f.over, e.slips[k], e.slips[k]);
        for (std::size_t l = 0; l < e.slips.size(); ++l) {
          put(a / f.over * f.ratio[k] * f.ratio[l], e.slips[k], e.slips[l]);
        }
      }
    }
    if (derivative != nullptr) {
      // A weak spring holds what nothing else does.
      constexpr double kWeak = 1e-9;
      for (Eigen::Index j = 0; j < d.size(); ++j) {
        entries.emplace_back(j, j, -kWeak * force_ / reach_);
      }
      derivative->resize(d.size(), d.size());
      derivative->setFromTriplets(entries.begin(), entries.end());
    }
    return result;
  }

 private:
  Smoothing smoothing_;
  Vector load_;
  std::vector<SmoothElement> elements_;
  double force_ = 0;  ///< a typical force
  double reach_ = 1;  ///< how far it moves a body
};

/// A point of the curve of equilibria: a motion, and the logarithm of the size of slips over
/// which friction is smooth.
struct CurvePoint {
  Vector d;
  double level = 0;
};

/// The equilibria as friction becomes less and less smooth. They are one curve that begins
/// where friction is nearly viscous, and has no end before sizes of 0. It may turn back to
/// larger sizes for a while, so it is followed by its length (Keller, "Numerical solution of
/// bifurcation and nonlinear eigenvalue problems", 1977).
class EquilibriumCurve {
 public:
  explicit EquilibriumCurve(const SmoothGrasp& grasp) : grasp_(grasp) {}

  /// Moves d to where all forces balance, at this level; returns whether it could.
  bool balance(Vector& d, double level) {
    constexpr int kMostSteps = 30;
    const double smooth = std::exp(level);
    Vector f = grasp_.sum(d, smooth, &derivative_);
    for (int step = 0; step < kMostSteps; ++step) {
      if (is_balanced(f, {d, level})) return true;
      if (!factor()) return false;
      const Vector move = -solver_.solve(f);
      if (!move.allFinite()) return false;
      double part = 1;
      Vector next = d + move;
      Vector there = grasp_.sum(next, smooth);
      while (there.norm() > (1 - 1e-4 * part) * f.norm() && part > 1e-4) {
        part /= 2;
        next = d + part * move;
        there = grasp_.sum(next, smooth);
      }
      d = next;
      f = grasp_.sum(d, smooth, &derivative_);
    }
    return false;
  }

  /// Follows the curve from a point of it down to sizes of slips that are as good as 0. Returns
  /// whether it got there.
  bool follow(CurvePoint& at) {
    constexpr int kMostSteps = 1000;
    constexpr double kLongest = 2;
    constexpr double kShortest = 1e-5;
    constexpr double kDrifts = 0.5;  // a body that nothing holds moves as 1 over the size
    constexpr double kLeastOfReach = 1e-7;
    constexpr double kLeastOfMotion = 1e-10;  // what is rounded is small beside such slips
    CurvePoint way = direction(at);
    if (way.level == 0) return false;
    if (way.level > 0) way = {-way.d, -way.level};
    double length = 1;
    for (int step = 0; step < kMostSteps; ++step) {
      const double least =
          std::max(kLeastOfReach * grasp_.reach(), kLeastOfMotion * at.d.norm());
      if (std::exp(at.level) <= least) {
        drifts_ = way.d.norm() > kDrifts * -way.level * at.d.norm();
        return true;
      }
      CurvePoint next{at.d + length * way.d, at.level + length * way.level};
      CurvePoint ahead;
      if (correct(next, way, length)) ahead = direction(next);
      if (ahead.level == 0) {
        length /= 2;
        if (length < kShortest) return false;
        continue;
      }
      if (product(ahead, way) < 0) ahead = {-ahead.d, -ahead.level};
      at = std::move(next);
      way = std::move(ahead);
      length = std::min(kLongest, 1.5 * length);
    }
    return false;
  }

  /// Returns whether bodies drifted away to the last.
  bool drifts() const { return drifts_; }

 private:
  bool is_balanced(const Vector& f, const CurvePoint& at) const {
    constexpr double kBalanced = 1e-10;
    constexpr double kRounding = 1e-14;  // part of slips, and so of friction over their size
    const double rounding = kRounding * at.d.norm() / std::exp(at.level);
    return f.norm() <= (kBalanced + rounding) * grasp_.force();
  }

  /// Returns the product by which lengths are measured: a motion as large as typical ones is as
  /// long as a factor of e in the sizes of slips.
  double product(const CurvePoint& a, const CurvePoint& b) const {
    return a.d.dot(b.d) / (unit_ * unit_) + a.level * b.level;
  }

  /// Returns the direction of the curve, of length 1, one way or the other; 0 if rounding hides
  /// it.
  CurvePoint direction(const CurvePoint& at) {
    Vector change;
    const double smooth = std::exp(at.level);
    grasp_.sum(at.d, smooth, &derivative_, &change);
    unit_ = std::max(at.d.norm(), 1e-3 * grasp_.reach());
    if (!factor()) return {};
    CurvePoint way{-solver_.solve(smooth * change), 1};
    if (!way.d.allFinite()) return {};
    const double norm = std::sqrt(product(way, way));
    return {way.d / norm, 1 / norm};
  }

  /// Moves a point to the curve, across this direction and by less than this length; returns
  /// whether it could.
  bool correct(CurvePoint& at, const CurvePoint& way, double length) {
    const CurvePoint start = at;
    constexpr int kMostSteps = 8;
    double before = HUGE_VAL;
    for (int step = 0; step <= kMostSteps; ++step) {
      const double smooth = std::exp(at.level);
      Vector change;
      const Vector f = grasp_.sum(at.d, smooth, &derivative_, &change);
      if (is_balanced(f, at)) return true;
      if (!(f.norm() < before) || step == kMostSteps || !factor()) return false;
      before = step == 0 ? HUGE_VAL : f.norm();
      const Vector straight = -solver_.solve(f);
      const Vector along = -solver_.solve(smooth * change);
      const double level = -product({straight, 0}, way) / product({along, 1}, way);
      at.d += straight + level * along;
      at.level += level;
      const CurvePoint moved{at.d - start.d, at.level - start.level};
      if (!(product(moved, moved) < length * length)) return false;
    }
    return false;
  }

  bool factor() {
    solver_.compute(derivative_);
    return solver_.info() == Eigen::Success;
  }

  const SmoothGrasp& grasp_;
  double unit_ = 1;      ///< the length of motions here
  bool drifts_ = false;  ///< whether motions grow as sizes get smaller
  Sparse derivative_;
  Eigen::SparseLU<Sparse> solver_;
};

}  // namespace

std::optional<LargeProposal> propose(const LargeGrasp& large, Smoothing smoothing) {
  const SmoothGrasp grasp(large, smoothing);
  EquilibriumCurve curve(grasp);
  CurvePoint at;
  bool has_begun = false;
  for (const double size : {1e2, 1e4, 1e6, 1e8}) {  // the larger, the nearer to linear
    at = {grasp.rest(), std::log(size * grasp.reach())};
    has_begun = curve.balance(at.d, at.level);
    if (has_begun) break;
  }
  if (!has_begun || !curve.follow(at)) return std::nullopt;
  const Vector& d = at.d;
  const double smooth = std::exp(at.level);
  LargeProposal result;
  result.drifts = curve.drifts();
  const auto& cones = large.model.cones();
  for (std::size_t i = 0; i < cones.size(); ++i) {
    const SmoothElement& e = grasp.elements()[i];
    const double a = std::max(0.0, SmoothGrasp::separation(e, d));
    const SmoothFriction f = SmoothGrasp::friction(e, d, smooth);
    constexpr double kSticks = 30;  // sizes of slips: friction is then short of all by 1/1800
    const bool sticks = f.norm <= kSticks * smooth * e.slip_unit;
    result.modes.push_back(!(a > 0) ? LargeMode::kOpen
                           : sticks ? LargeMode::kSticks
                                    : LargeMode::kSlips);
    result.most.push_back(a * e.slip_unit);
    result.spare.push_back(sticks ? a * (1 - f.norm / f.over) * e.slip_unit : 0);
    auto& friction = result.friction.emplace_back();
    for (std::size_t k = 0; k < f.ratio.size(); ++k) {
      friction.push_back(-a * f.ratio[k] * large.model.scale(cones[i], k + 1));
    }
  }
  return result;
}

}  // namespace stickslip::large_detail
