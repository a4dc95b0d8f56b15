// SPDX-License-Identifier: GPL-3.0-or-later
#include "moving_twists.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "engine/motion/dense.hpp"

namespace stickslip::search_detail {
namespace {

/// kappa and psi count this much less than c in the norm of a leaf.
constexpr double kOwnScale = 3;
constexpr std::size_t kMostCuts = 8;

/// The point of least norm among the sums of a convex combination of some vectors and of
/// nonnegative multiples of others. (Lawson and Hanson, Solving Least Squares Problems, 1974,
/// chapter 23, with one more equation for the sum of the weights.)
class LeastSum {
 public:
  explicit LeastSum(Eigen::Index size) : columns_(size + 1, 64), products_(64, 64) {}

  /// Adds a vector that is part of the convex combination, or else of the multiples, and
  /// returns its place.
  std::size_t add(const Eigen::VectorXd& vector, bool is_convex) {
    const auto n = static_cast<Eigen::Index>(norms_.size());
    if (n == columns_.cols()) {
      columns_.conservativeResize(Eigen::NoChange, 2 * n);
      products_.conservativeResize(2 * n, 2 * n);
    }
    columns_.col(n).head(vector.size()) = vector;
    columns_(vector.size(), n) = is_convex ? kSum : 0;
    products_.col(n).head(n + 1) = columns_.leftCols(n + 1).transpose() * columns_.col(n);
    norms_.push_back(vector.norm());
    in_use_.push_back(0);
    weights_.push_back(0);
    return weights_.size() - 1;
  }

  /// Finds the weights, from the last ones on.
  void solve() {
    constexpr int kMostSteps = 300;
    improve();
    for (int step = 0; step < kMostSteps; ++step) {
      const auto n = static_cast<Eigen::Index>(norms_.size());
      const Eigen::VectorXd along = columns_.leftCols(n).transpose() * rest();
      std::size_t best = norms_.size();
      double most = 1e-9;
      for (std::size_t k = 0; k < norms_.size(); ++k) {
        const double part = along[static_cast<Eigen::Index>(k)] / (norms_[k] + 1e-9);
        if (in_use_[k] != 0 || !(part > most)) continue;
        most = part;
        best = k;
      }
      if (best == norms_.size()) return;
      in_use_[best] = 1;
      improve();
    }
  }

  /// Returns the weights.
  const std::vector<double>& weights() const { return weights_; }
  /// Returns the point.
  Eigen::VectorXd point() const {
    Eigen::VectorXd sum = -rest();
    const Eigen::Index last = sum.size() - 1;
    const double share = (kSum + sum[last]) / kSum;
    sum.conservativeResize(last);
    return share > 0 ? Eigen::VectorXd(sum / share) : sum;
  }

 private:
  static constexpr double kSum = 10;

  /// Returns what the weights leave of the target, 0 with the sum 1.
  Eigen::VectorXd rest() const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(columns_.rows());
    result[columns_.rows() - 1] = kSum;
    for (std::size_t k = 0; k < weights_.size(); ++k) {
      if (weights_[k] > 0) result -= weights_[k] * columns_.col(static_cast<Eigen::Index>(k));
    }
    return result;
  }

  /// Moves the weights in use towards those that leave least, as far as they stay above 0.
  void improve() {
    constexpr int kMostSteps = 200;
    constexpr double kNothing = 1e-12;
    for (int step = 0; step < kMostSteps; ++step) {
      std::vector<Eigen::Index> used;
      for (std::size_t k = 0; k < in_use_.size(); ++k) {
        if (in_use_[k] != 0) used.push_back(static_cast<Eigen::Index>(k));
      }
      if (used.empty()) return;
      const auto count = static_cast<Eigen::Index>(used.size());
      Eigen::MatrixXd gram(count, count);
      Eigen::VectorXd sums(count);
      for (Eigen::Index b = 0; b < count; ++b) {
        const Eigen::Index column = used[static_cast<std::size_t>(b)];
        for (Eigen::Index a = 0; a <= b; ++a) {
          gram(b, a) = products_(used[static_cast<std::size_t>(a)], column);
        }
        constexpr double kRegular = 1e-13;
        gram(b, b) += kRegular;
        sums[b] = kSum * columns_(columns_.rows() - 1, column);
      }
      const Eigen::VectorXd wanted = symmetric_solution(gram, sums);
      double part = 1;
      bool all = true;
      for (Eigen::Index a = 0; a < count; ++a) {
        const double now =
            weights_[static_cast<std::size_t>(used[static_cast<std::size_t>(a)])];
        if (wanted[a] > kNothing) continue;
        all = false;
        part = std::min(part, now / (now - wanted[a] + 1e-300));
      }
      for (Eigen::Index a = 0; a < count; ++a) {
        const auto k = static_cast<std::size_t>(used[static_cast<std::size_t>(a)]);
        weights_[k] = all ? wanted[a] : weights_[k] + part * (wanted[a] - weights_[k]);
        if (all || weights_[k] > kNothing) continue;
        weights_[k] = 0;
        in_use_[k] = 0;
      }
      if (all) return;
    }
  }

  Eigen::MatrixXd columns_;
  Eigen::MatrixXd
      products_;  ///< of each column with those before it and itself, above the diagonal
  std::vector<double> norms_;
  std::vector<char> in_use_;
  std::vector<double> weights_;
};

/// The directions of a cube's corners, edges and faces in so many dimensions, of length 1.
std::vector<Eigen::VectorXd> directions(Eigen::Index dimensions) {
  std::vector<Eigen::VectorXd> result;
  const int count = static_cast<int>(std::lround(std::pow(3, dimensions)));
  for (int code = 0; code < count; ++code) {
    Eigen::VectorXd direction(dimensions);
    int digits = code;
    for (Eigen::Index k = 0; k < dimensions; ++k, digits /= 3) direction[k] = digits % 3 - 1;
    if (direction.norm() > 0) result.push_back(direction.normalized());
  }
  return result;
}

}  // namespace

MovingTwists::MovingTwists(const Law& law, MovingSubject about)
    : law_(law), about_(std::move(about)), work_(law, about_.points, about_.separations) {
  const auto d = static_cast<Eigen::Index>(law.motions);
  for (const Reals& x : about_.points) {
    ways_.emplace_back(x.head(d) - about_.centre);
    reach_ = std::max(reach_, ways_.back().lpNorm<Eigen::Infinity>());
  }
  if (!(reach_ > 0)) reach_ = law.reach;
  size_ = 1 + d;
  for (std::size_t i = 0; i < law.contacts.size(); ++i) {
    const LawContact& c = law.contacts[i];
    if (!(c.slopes[1] > 0)) continue;
    rubbing_.push_back({i, size_});
    size_ += 1 + static_cast<Eigen::Index>(c.slip_dimension());
  }
  double most = 0;
  for (const Reals& pull : about_.pulls) most = std::max(most, pull.norm());
  for (Reals& pull : about_.pulls) pull /= most > 0 ? most : 1;
  const auto count = static_cast<Eigen::Index>(about_.pulls.size());
  pulling_.resize(count, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    for (Eigen::Index l = 0; l < count; ++l) {
      pulling_(k, l) =
          ways_[static_cast<std::size_t>(k)].dot(about_.pulls[static_cast<std::size_t>(l)]);
    }
  }
  pulling_ = (pulling_ + pulling_.transpose()).eval();
}

RoundedLeaf MovingTwists::rounded(const Coordinates& at) const {
  const auto d = static_cast<Eigen::Index>(law_.motions);
  RoundedLeaf leaf{Reals(at.segment(1, d)), at[0] / reach_,
                   std::vector<double>(law_.contacts.size()),
                   std::vector<Double3>(law_.contacts.size())};
  leaf.twist -= leaf.rate * about_.centre;
  for (const auto& [contact, first] : rubbing_) {
    leaf.rates[contact] = kOwnScale * at[first] / reach_;
    for (std::size_t k = 0; k < law_.contacts[contact].slip_dimension(); ++k) {
      leaf.slips[contact][k] =
          kOwnScale * at[first + 1 + static_cast<Eigen::Index>(k)] / reach_;
    }
  }
  return leaf;
}

/// Computes all values, and returns the largest of them.
double MovingTwists::evaluate(const Coordinates& at) {
  const auto d = static_cast<Eigen::Index>(law_.motions);
  const RoundedLeaf leaf = rounded(at);
  work_.set(leaf);
  const auto count = static_cast<Eigen::Index>(about_.points.size());
  Eigen::VectorXd load_work(count);
  loads_.clear();
  for (Eigen::Index r = 0; r < count; ++r) {
    const Reals y = leaf.rate * ways_[static_cast<std::size_t>(r)] + at.segment(1, d);
    loads_.push_back(law_.load_at(1, 0, y));
    load_work[r] = loads_.back().dot(y);
  }
  bounds_ = work_.bounds(load_work) / law_.force;
  gradients_.assign(work_.parts().size(),
                    std::vector<std::optional<Eigen::VectorXd>>(about_.points.size()));
  double most = bounds_.maxCoeff();
  if (!about_.pulls.empty()) {
    Eigen::VectorXd along(count);
    for (Eigen::Index r = 0; r < count; ++r) {
      along[r] = at.segment(1, d).dot(about_.pulls[static_cast<std::size_t>(r)]);
    }
    against_ = -(leaf.rate * pulling_ + along * Eigen::RowVectorXd::Ones(count) +
                 Eigen::VectorXd::Ones(count) * along.transpose()) /
               2;
    most = std::max(most, against_.maxCoeff());
  }
  return most;
}

/// Returns the derivative of A_i at a point.
Eigen::VectorXd MovingTwists::gradient(std::size_t which, Eigen::Index point) const {
  const MovingWork::Part& part = work_.parts()[which];
  const LawContact& c = law_.contacts[part.contact];
  const auto d = static_cast<Eigen::Index>(law_.motions);
  const Eigen::Index q = part.corner[static_cast<std::size_t>(point)];
  const CornerRow& row = c.corners[static_cast<std::size_t>(q)];
  Eigen::VectorXd result = Eigen::VectorXd::Zero(size_);
  Reals on_twist = row.normal_rounded;
  const auto rubs = std::find_if(rubbing_.begin(), rubbing_.end(),
                                 [&](const Rubbing& r) { return r.contact == part.contact; });
  if (rubs != rubbing_.end()) {
    const MovingWork::Slip slip = work_.slip(part, point);
    const double slope = slip.slope * (1 + c.tilted / 3);
    const double scale = kOwnScale / reach_;
    for (std::size_t k = 0; k < part.slips.size(); ++k) {
      const double unit = slip.size > 0 ? slip.rest[k] / slip.size : 0;
      const double s = part.slips[k](point, q);
      on_twist += slope * unit * row.slip_rounded[k];
      result[rubs->first] -= scale * slope * unit * s;
      result[rubs->first + 1 + static_cast<Eigen::Index>(k)] = scale * slip.slope * s;
    }
  }
  result[0] = on_twist.dot(ways_[static_cast<std::size_t>(point)]) / reach_;
  result.segment(1, d) = on_twist;
  return result / law_.force;
}

Eigen::VectorXd MovingTwists::load_gradient(Eigen::Index point) const {
  const auto r = static_cast<std::size_t>(point);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(size_);
  result[0] = loads_[r].dot(ways_[r]) / reach_;
  result.segment(1, static_cast<Eigen::Index>(law_.motions)) = loads_[r];
  return result / law_.force;
}

/// Returns the derivative of the bound of a pair, or of minus its side of `leaf-direction`.
MovingTwists::Cut MovingTwists::cut(Eigen::Index first, Eigen::Index other, bool is_pull) {
  Cut cut{Eigen::VectorXd::Zero(size_), first, other, 0};
  if (is_pull) {
    cut.gradient[0] = -pulling_(first, other) / 2 / reach_;
    cut.gradient.segment(1, static_cast<Eigen::Index>(law_.motions)) =
        -(about_.pulls[static_cast<std::size_t>(first)] +
          about_.pulls[static_cast<std::size_t>(other)]) /
        2;
    return cut;
  }
  cut.gradient = (load_gradient(first) + load_gradient(other)) / 2;
  for (std::size_t k = 0; k < work_.parts().size(); ++k) {
    const MovingWork::Part& part = work_.parts()[k];
    const auto add = [&](Eigen::Index of, Eigen::Index work) {
      const double most = part.most[work];
      const double v = part.closed ? most > 0 ? part.high[of] : part.low[of]
                       : most > 0 ? std::max(part.high[of], 0.0)
                                   : 0;
      if (v == 0) return;
      auto& known = gradients_[k][static_cast<std::size_t>(work)];
      if (!known) known = gradient(k, work);
      cut.gradient += v / 2 * *known;
    };
    add(first, other);
    add(other, first);
  }
  return cut;
}

/// Returns a vector with which no leaf may have a product above 0: that of |psi| <= kappa along
/// a direction of length 1.
Eigen::VectorXd MovingTwists::constraint(const Rubbing& rubs,
                                         const Eigen::VectorXd& direction) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(size_);
  result[rubs.first] = -std::sqrt(0.5);
  result.segment(rubs.first + 1, direction.size()) = std::sqrt(0.5) * direction;
  return result;
}

MovingTwists::Found MovingTwists::find(const Coordinates& guess, int rounds,
                                       const std::function<bool(const Coordinates&)>& accept) {
  const auto d = static_cast<Eigen::Index>(law_.motions);
  constexpr double kHolds = -1e-10;
  constexpr double kNone = 1e-5;  // the norm of a sum at which no leaf holds, to speak of
  Found best;
  Coordinates at = guess;
  if (at.size() == 0) {
    at = Coordinates::Zero(size_);
    at[0] = 1;
    for (const Rubbing& rubs : rubbing_) at[rubs.first] = 1 / kOwnScale;
    at.segment(1, d) = -1e-3 * law_.load_at(1, 0, Reals::Zero(d)) / law_.force;
  }
  double tried = kHolds;
  const auto take = [&](double value) {
    const double bound = value / std::max(1e-9, at.norm());
    if (best.coordinates.size() == 0 || bound < best.bound) {
      best.coordinates = at;
      best.bound = bound;
    }
    if (!accept || !(value < tried)) return false;
    tried = 2 * value;
    best.coordinates = at;
    return best.accepted = accept(at);
  };
  if (take(evaluate(at))) return best;
  const auto psi_of = [&](const Rubbing& rubs) {
    return at.segment(rubs.first + 1,
                      static_cast<Eigen::Index>(law_.contacts[rubs.contact].slip_dimension()));
  };
  LeastSum sum(size_);
  for (const Rubbing& rubs : rubbing_) {
    for (const Eigen::VectorXd& direction : directions(psi_of(rubs).size())) {
      sum.add(constraint(rubs, direction), false);
    }
  }
  std::vector<Cut> cuts;
  const auto add_cuts = [&](const Eigen::MatrixXd& values, bool is_pull) {
    struct Value {
      double value;
      Eigen::Index first;
      Eigen::Index other;
    };
    std::vector<Value> order;
    for (Eigen::Index k = 0; k < values.rows(); ++k) {
      for (Eigen::Index l = 0; l <= k; ++l) order.push_back({values(k, l), k, l});
    }
    const std::size_t most = std::min(kMostCuts, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(most),
                      order.end(),
                      [](const Value& a, const Value& b) { return a.value > b.value; });
    const double least = order.front().value - 0.5 * std::fabs(order.front().value);
    for (std::size_t k = 0; k < most && order[k].value >= least; ++k) {
      cuts.push_back(cut(order[k].first, order[k].other, is_pull));
      cuts.back().column = sum.add(cuts.back().gradient, true);
    }
  };
  for (int round = 0; round < rounds; ++round) {
    add_cuts(bounds_, false);
    if (!about_.pulls.empty()) add_cuts(against_, true);
    sum.solve();
    const Eigen::VectorXd point = sum.point();
    const double size = point.norm();
    if (!(size > kNone) || round + 1 == rounds) break;
    at = -point / size;
    for (const Rubbing& rubs : rubbing_) {
      const double own = psi_of(rubs).norm();
      if (!(own > at[rubs.first])) continue;
      sum.add(constraint(rubs, psi_of(rubs) / own), false);
      at[rubs.first] = own;
    }
    const double value = evaluate(at);
    if (take(value)) return best;
    constexpr double kBest = 0.98;
    if (!accept && -value > kBest * size) return best;
  }
  double all = 0;
  for (const Cut& cut : cuts) {
    const double weight = sum.weights()[cut.column];
    if (!(weight > 0)) continue;
    best.pairs.push_back({weight, cut.first, cut.other});
    all += weight;
  }
  for (Pair& pair : best.pairs) pair.weight /= all;
  return best;
}

MovingLeaf MovingTwists::leaf(const Coordinates& coordinates, int bits) const {
  const RoundedLeaf near = rounded(coordinates);
  double size = 0;  // of a typical entry of y
  for (Eigen::Index j = 0; j <= static_cast<Eigen::Index>(law_.motions); ++j) {
    size = std::max(size, std::fabs(coordinates[j]));
  }
  const auto grain = [&](double of) { return std::ilogb(of) - bits; };
  const int rate_grain = grain(size / reach_);
  int least = rate_grain;
  for (std::size_t j = 0; j < law_.motions; ++j) {
    least = std::min(least, grain(size / law_.unit(j)));
  }
  const auto whole = [&](double value, int own) {
    Integer result = std::llround(std::ldexp(value, -own));
    result <<= static_cast<unsigned>(own - least);
    return result;
  };
  MovingLeaf leaf;
  leaf.rate = whole(near.rate, rate_grain);
  Integer common = abs(leaf.rate);
  const double rate = std::ldexp(to_double(Rational(leaf.rate)), least);
  for (std::size_t j = 0; j < law_.motions; ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    const double y = coordinates[1 + row] - rate * about_.centre[row];
    leaf.twist.push_back(whole(y / law_.unit(j), grain(size / law_.unit(j))));
    common = gcd(common, leaf.twist.back());
  }
  for (const auto& [contact, first] : rubbing_) {
    const LawContact& c = law_.contacts[contact];
    MovingLeaf::OwnSlip own{
        ContactId(contact), whole(std::max(near.rates[contact], 0.0), rate_grain), {}};
    IntegerVector<4> psi{};
    for (std::size_t j = 0; j < c.slip_numbers(); ++j) {
      double entry = 0;
      for (std::size_t k = 0; k < c.slip_dimension(); ++k) {
        entry += near.slips[contact][k] * c.unit_directions[k][j];
      }
      if (j == 3) entry /= to_double(c.spin_weight);
      psi[j] = whole(entry, rate_grain);
      own.slip.push_back(psi[j]);
    }
    Integer step = 1;
    step <<= static_cast<unsigned>(rate_grain - least);
    while (c.product(psi, psi) > own.rate * own.rate * denominator(c.spin_weight)) {
      own.rate += step;
    }
    if (own.rate.is_zero()) continue;
    common = gcd(common, own.rate);
    for (const Integer& entry : own.slip) common = gcd(common, entry);
    leaf.own.push_back(std::move(own));
  }
  if (common.is_zero()) return leaf;
  leaf.rate /= common;
  for (Integer& entry : leaf.twist) entry /= common;
  for (MovingLeaf::OwnSlip& own : leaf.own) {
    own.rate /= common;
    for (Integer& entry : own.slip) entry /= common;
  }
  return leaf;
}

}  // namespace stickslip::search_detail
