// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/lp/cone_program.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stickslip {
namespace lp_detail {

/// The most columns of a cone.
constexpr int kMostColumns = 4;

/// A vector of a cone, and a matrix of its columns; they own no memory elsewhere.
template <class Real>
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1, 0, kMostColumns, 1>;
template <class Real>
using Matrix =
    Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, 0, kMostColumns, kMostColumns>;

/// Returns u_0^2 - |u_1..|^2.
template <class Real>
Real cone_square(const Vector<Real>& u) {
  const Real tail = u.tail(u.size() - 1).norm();
  return (u[0] - tail) * (u[0] + tail);
}

/// Returns the product of the cone's algebra, (u.v, u_0 v_1.. + v_0 u_1..).
template <class Real>
Vector<Real> product(const Vector<Real>& u, const Vector<Real>& v) {
  Vector<Real> result = u[0] * v + v[0] * u;
  result[0] = u.dot(v);
  return result;
}

/// Returns the x with product(u, x) = d. Requires that u is inside the cone.
template <class Real>
Vector<Real> quotient(const Vector<Real>& u, const Vector<Real>& d) {
  const auto k = u.size() - 1;
  Vector<Real> x(u.size());
  x[0] = (u[0] * d[0] - u.tail(k).dot(d.tail(k))) / cone_square(u);
  x.tail(k) = (d.tail(k) - x[0] * u.tail(k)) / u[0];
  return x;
}

/// Returns how far u may go along d within the cone, at most `most`.
template <class Real>
Real longest_step(const Vector<Real>& u, const Vector<Real>& d, Real most) {
  const auto k = u.size() - 1;
  const Real a = cone_square(d);
  const Real b = u[0] * d[0] - u.tail(k).dot(d.tail(k));
  const Real c = cone_square(u);
  if (d[0] < 0) most = std::min(most, -u[0] / d[0]);
  // The first positive root of a t^2 + 2 b t + c, where c > 0.
  const Real discriminant = b * b - a * c;
  if (discriminant < 0) return most;
  const Real root = std::sqrt(discriminant);
  if (b < 0) return std::min(most, c / (root - b));
  return a < 0 ? std::min(most, (-b - root) / a) : most;
}

/// The scaling W of a cone, W z = W^-1 s = scaled, with W and its inverse as matrices.
template <class Real>
struct Scaling {
  Matrix<Real> w, inverse;
  Vector<Real> scaled;
};

template <class Real>
Scaling<Real> scaling_of(const Vector<Real>& s, const Vector<Real>& z) {
  const auto k = s.size() - 1;
  const Real s_size = std::sqrt(cone_square(s));
  const Real z_size = std::sqrt(cone_square(z));
  const Real gamma = std::sqrt((1 + s.dot(z) / (s_size * z_size)) / 2);
  Vector<Real> middle = s / s_size;
  middle[0] += z[0] / z_size;
  middle.tail(k) -= z.tail(k) / z_size;
  middle /= 2 * gamma;
  Matrix<Real> w = Matrix<Real>::Identity(k + 1, k + 1);
  w.bottomRightCorner(k, k) += middle.tail(k) * middle.tail(k).transpose() / (1 + middle[0]);
  w.row(0) = middle.transpose();
  w.col(0) = middle;
  Matrix<Real> inverse = w;
  inverse.row(0).tail(k) *= -1;
  inverse.col(0).tail(k) *= -1;
  const Real eta = std::sqrt(s_size / z_size);
  Scaling<Real> result{eta * w, inverse / eta, {}};
  result.scaled = result.w * z;
  return result;
}

/// A vector by cone.
template <class Real>
using Parts = std::vector<Vector<Real>>;

/// A direction in which all variables go.
template <class Real>
struct Direction {
  Eigen::Matrix<Real, Eigen::Dynamic, 1> x;
  Parts<Real> s, z;
  Real tau = 0;
  Real kappa = 0;
};

/// The path, in numbers of any length.
class ConePath {
 public:
  virtual ~ConePath() = default;
  virtual void run() = 0;
  virtual std::vector<std::vector<double>> changes(const std::vector<double>& load) const = 0;

  const ConeProposal& proposal() const { return proposal_; }

 protected:
  ConeProposal proposal_;  // NOLINT(misc-non-private-member-variables-in-classes)
};

template <class Real>
class InteriorPoint final : public ConePath {
  using Part = lp_detail::Vector<Real>;
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  using Columns =
      Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, 0, Eigen::Dynamic, kMostColumns>;
  using Parts = lp_detail::Parts<Real>;
  using Scaling = lp_detail::Scaling<Real>;
  using Direction = lp_detail::Direction<Real>;
  using Sparse = Eigen::SparseMatrix<Real>;

 public:
  explicit InteriorPoint(const ConePair& pair)
      : rows_(static_cast<Eigen::Index>(pair.load.size())) {
    // Both systems keep their solutions if columns of a cone are scaled together.
    w_ = Eigen::Map<const Eigen::VectorXd>(pair.load.data(), rows_).template cast<Real>();
    load_size_ =
        std::max(w_.template lpNorm<Eigen::Infinity>(), std::numeric_limits<Real>::min());
    w_ /= load_size_;
    for (const auto& columns : pair.cones) {
      Block& block = blocks_.emplace_back();
      for (const DoubleColumn& column : columns) {
        for (const auto& [row, entry] : column) {
          block.size = std::max<Real>(block.size, std::fabs(entry));
          const auto at = static_cast<Eigen::Index>(row);
          if (std::find(block.rows.begin(), block.rows.end(), at) == block.rows.end()) {
            block.rows.push_back(at);
          }
        }
      }
      if (block.size == 0) block.size = 1;
      block.matrix = Columns::Zero(static_cast<Eigen::Index>(block.rows.size()),
                                   static_cast<Eigen::Index>(columns.size()));
      for (std::size_t k = 0; k < columns.size(); ++k) {
        for (const auto& [row, entry] : columns[k]) {
          const auto at =
              std::find(block.rows.begin(), block.rows.end(), static_cast<Eigen::Index>(row)) -
              block.rows.begin();
          block.matrix(at, static_cast<Eigen::Index>(k)) = Real(entry) / block.size;
        }
      }
      Part unit = Part::Zero(static_cast<Eigen::Index>(columns.size()));
      unit[0] = 1;
      s_.push_back(unit);
      z_.push_back(unit);
    }
    x_ = Vector::Zero(rows_);
  }

  /// Goes on where the path of the same pair in shorter numbers has come to.
  template <class Other>
  void begin_at(const InteriorPoint<Other>& other) {
    x_ = other.x_.template cast<Real>();
    tau_ = other.tau_;
    kappa_ = other.kappa_;
    for (std::size_t i = 0; i < s_.size(); ++i) {
      s_[i] = other.s_[i].template cast<Real>();
      z_[i] = other.z_[i].template cast<Real>();
    }
  }

  /// Ends the path where products are smaller than what the ends are by this factor.
  void end_at(Real close) { close_ = close; }

  void run() override {
    constexpr int kMostSteps = 100;
    for (; this->proposal_.steps < kMostSteps && !is_done(); ++this->proposal_.steps) {
      if (!step()) break;
    }
    finish(this->proposal_);
  }

  std::vector<std::vector<double>> changes(const std::vector<double>& load) const override {
    Vector x;
    Parts z;
    solve(-Eigen::Map<const Eigen::VectorXd>(load.data(), rows_).template cast<Real>(), zeros(),
          x, z);
    std::vector<std::vector<double>> result;
    for (std::size_t i = 0; i < z.size(); ++i) {
      const Eigen::VectorXd change = (z[i] / blocks_[i].size).template cast<double>();
      result.emplace_back(change.begin(), change.end());
    }
    return result;
  }

 private:
  template <class Other>
  friend class InteriorPoint;

  struct Block {
    std::vector<Eigen::Index> rows{};
    Columns matrix{};
    std::vector<Real*> places{};  ///< of the entries of A A^T in the sum, by columns
    Real size = 0;
  };

  /// Returns A^T x of a cone.
  static Part seen(const Block& block, const Vector& x) {
    Part result = Part::Zero(block.matrix.cols());
    for (Eigen::Index j = 0; j < block.matrix.rows(); ++j) {
      result += x[block.rows[static_cast<std::size_t>(j)]] * block.matrix.row(j).transpose();
    }
    return result;
  }
  /// Adds A z of a cone.
  static void add(const Block& block, const Part& z, Vector& sum) {
    for (Eigen::Index j = 0; j < block.matrix.rows(); ++j) {
      sum[block.rows[static_cast<std::size_t>(j)]] += block.matrix.row(j).dot(z);
    }
  }

  Parts zeros() const {
    Parts result;
    for (const Part& s : s_) result.push_back(Part::Zero(s.size()));
    return result;
  }
  Real degree() const { return static_cast<Real>(blocks_.size() + 1); }
  Real mean_product() const {
    Real sum = tau_ * kappa_;
    for (std::size_t i = 0; i < blocks_.size(); ++i) sum += s_[i].dot(z_[i]);
    return sum / degree();
  }

  /// Returns w tau + A z, which is to be 0.
  Vector imbalance() const {
    Vector sum = tau_ * w_;
    for (std::size_t i = 0; i < blocks_.size(); ++i) add(blocks_[i], z_[i], sum);
    return sum;
  }
  /// Returns s - A^T x of a cone, which is to be 0.
  Part mismatch(std::size_t i) const { return s_[i] - seen(blocks_[i], x_); }

  /// Returns whether one of tau and kappa is as good as 0, as what is off goes to 0 with
  /// products; or whether x solves (2) well inside of all cones.
  bool is_done() const {
    const Real most = std::max(tau_, kappa_);
    if (mean_product() <= close_ * most * most) return true;
    if (kappa_ < tau_ || !(w_.dot(x_) > kappa_ / 2)) return false;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      if (depth(seen(blocks_[i], x_)) < depth(s_[i]) / 2) return false;
    }
    return true;
  }
  static Real depth(const Part& part) { return part[0] - part.tail(part.size() - 1).norm(); }


  /// Finds the places of the entries of sum A W^-2 A^T.
  void find_places() {
    std::vector<Eigen::Triplet<Real>> entries;
    for (const Block& block : blocks_) {
      for (const Eigen::Index row : block.rows) {
        for (const Eigen::Index column : block.rows) entries.emplace_back(row, column, Real(0));
      }
    }
    for (Eigen::Index j = 0; j < rows_; ++j) entries.emplace_back(j, j, Real(0));
    matrix_.resize(rows_, rows_);
    matrix_.setFromTriplets(entries.begin(), entries.end());
    for (Block& block : blocks_) {
      for (const Eigen::Index column : block.rows) {
        for (const Eigen::Index row : block.rows) {
          block.places.push_back(&matrix_.coeffRef(row, column));
        }
      }
    }
    solver_.analyzePattern(matrix_);
  }

  /// Factors sum A W^-2 A^T, to whose diagonal little is added.
  bool factor() {
    if (matrix_.size() == 0) find_places();
    std::fill(matrix_.valuePtr(), matrix_.valuePtr() + matrix_.nonZeros(), Real(0));
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      const Block& block = blocks_[i];
      const Columns half = block.matrix * scalings_[i].inverse;
      auto place = block.places.begin();
      for (Eigen::Index column = 0; column < half.rows(); ++column) {
        for (Eigen::Index row = 0; row < half.rows(); ++row) {
          **place++ += half.row(row).dot(half.row(column));
        }
      }
    }
    Sparse regular = matrix_;
    constexpr Real kLittle = 45 * std::numeric_limits<Real>::epsilon();
    // There are no rows where nothing moves, and Eigen has no maximum of nothing.
    const Real most = rows_ > 0 ? Real(matrix_.diagonal().cwiseAbs().maxCoeff()) : Real(0);
    for (Eigen::Index j = 0; j < rows_; ++j) {
      Real& entry = regular.coeffRef(j, j);
      entry += kLittle * std::max<Real>(entry, Real(1e-6) * most);
    }
    solver_.factorize(regular);
    return solver_.info() == Eigen::Success;
  }

  Vector solved(const Vector& right) const {
    Vector x = solver_.solve(right);
    for (int round = 0; round < 2; ++round) x += solver_.solve(right - matrix_ * x);
    return x;
  }

  /// Solves A z = right_x, -A^T x - W^2 z = right_z (which has a part for each cone).
  void solve(const Vector& right_x, const Parts& right_z, Vector& x, Parts& z) const {
    // G = -A^T: z = -W^-2 (A^T x + right_z), and sum A W^-2 A^T x = -right_x - sum A W^-2
    // right_z.
    Vector right = -right_x;
    const auto unscaled = [&](std::size_t i, const Part& u) -> Part {
      return scalings_[i].inverse * (scalings_[i].inverse * u);
    };
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      add(blocks_[i], -unscaled(i, right_z[i]), right);
    }
    x = solved(right);
    z.resize(blocks_.size());
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      z[i] = -unscaled(i, seen(blocks_[i], x) + right_z[i]);
    }
  }

  /// Returns the direction towards products of `centre` in all cones, with the share `keep` of
  /// what is off; products of an earlier direction are subtracted.
  Direction direction(Real centre, Real keep, const Direction* earlier) const {
    Direction to;
    Parts right_z(blocks_.size());
    Parts goal(blocks_.size());
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      const Scaling& w = scalings_[i];
      goal[i] = -product<Real>(w.scaled, w.scaled);
      if (earlier) goal[i] -= product<Real>(w.inverse * earlier->s[i], w.w * earlier->z[i]);
      goal[i][0] += centre;
      right_z[i] = -keep * mismatch(i) - w.w * quotient<Real>(w.scaled, goal[i]);
    }
    Real goal_tau = centre - tau_ * kappa_;
    if (earlier) goal_tau -= earlier->tau * earlier->kappa;
    Vector x2;
    Parts z2;
    solve(-keep * imbalance(), right_z, x2, z2);
    const Real off = kappa_ - w_.dot(x_);
    to.tau = (-keep * off - goal_tau / tau_ + w_.dot(x2)) / (-kappa_ / tau_ - w_.dot(x1_));
    to.x = x2 + to.tau * x1_;
    to.z.resize(blocks_.size());
    to.s.resize(blocks_.size());
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      to.z[i] = z2[i] + to.tau * z1_[i];
      to.s[i] = seen(blocks_[i], to.x) - keep * mismatch(i);
    }
    to.kappa = (goal_tau - kappa_ * to.tau) / tau_;
    return to;
  }

  Real longest(const Direction& to) const {
    Real step = 1 / kShort;
    if (to.tau < 0) step = std::min<Real>(step, -tau_ / to.tau);
    if (to.kappa < 0) step = std::min<Real>(step, -kappa_ / to.kappa);
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      step = longest_step<Real>(s_[i], to.s[i], step);
      step = longest_step<Real>(z_[i], to.z[i], step);
    }
    return step;
  }
  static constexpr Real kShort = Real(0.98);

  bool step() {
    scalings_.clear();
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      scalings_.push_back(scaling_of<Real>(s_[i], z_[i]));
      if (!scalings_.back().scaled.allFinite()) return false;
    }
    if (!factor()) return false;
    solve(-w_, zeros(), x1_, z1_);  // A z = -w
    const Real mean = mean_product();
    const Direction affine = direction(0, 1, nullptr);
    const Real reach = std::min<Real>(1, longest(affine));
    const Real share = (1 - reach) * (1 - reach) * (1 - reach);
    const Direction to = direction(share * mean, 1 - share, &affine);
    const Real length = std::min<Real>(1, kShort * longest(to));
    if (!(length > Real(1e-10)) || !to.x.allFinite()) return false;
    x_ += length * to.x;
    tau_ += length * to.tau;
    kappa_ += length * to.kappa;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      s_[i] += length * to.s[i];
      z_[i] += length * to.z[i];
    }
    // All of it may be scaled.
    const Real most = std::max(tau_, kappa_);
    if (!(most > 0)) return false;
    x_ /= most;
    tau_ /= most;
    kappa_ /= most;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      s_[i] /= most;
      z_[i] /= most;
    }
    return true;
  }

  void finish(ConeProposal& result) const {
    constexpr Real kLeast = std::numeric_limits<Real>::min();
    result.rests = kappa_ < tau_;
    const Real reach = std::max(x_.template lpNorm<Eigen::Infinity>(), kLeast);
    const Real size = load_size_ / std::max(tau_, kLeast);
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      const Eigen::VectorXd force = (z_[i] * (size / blocks_[i].size)).template cast<double>();
      result.forces.emplace_back(force.begin(), force.end());
      result.gaps.push_back(static_cast<double>(depth(s_[i]) / reach));
    }
    const Eigen::VectorXd x = (x_ / reach).template cast<double>();
    result.motion.assign(x.begin(), x.end());
  }

  Eigen::Index rows_;
  Vector w_;
  Real load_size_ = 1;
  std::vector<Block> blocks_;
  Vector x_;
  Parts s_, z_;
  Real tau_ = 1;
  Real kappa_ = 1;
  std::vector<Scaling> scalings_;
  Sparse matrix_;
  Eigen::SimplicialLDLT<Sparse> solver_;
  Vector x1_;
  Parts z1_;
  Real close_ = 450 * std::numeric_limits<Real>::epsilon();
};

}  // namespace lp_detail

ConeSearch::ConeSearch(const ConePair& pair, bool is_long) {
  if (is_long) {
    lp_detail::InteriorPoint<double> rough(pair);
    constexpr double kRough = 1e-9;
    rough.end_at(kRough);
    rough.run();
    auto path = std::make_unique<lp_detail::InteriorPoint<long double>>(pair);
    path->begin_at(rough);
    path_ = std::move(path);
  } else {
    path_ = std::make_unique<lp_detail::InteriorPoint<double>>(pair);
  }
  path_->run();
}

ConeSearch::~ConeSearch() = default;

const ConeProposal& ConeSearch::proposal() const {
  return path_->proposal();
}

std::vector<std::vector<double>> ConeSearch::changes(const std::vector<double>& load) const {
  return path_->changes(load);
}

}  // namespace stickslip
