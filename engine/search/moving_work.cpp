// SPDX-License-Identifier: GPL-3.0-or-later
#include "moving_work.hpp"

#include <algorithm>
#include <cmath>

namespace stickslip::search_detail {
namespace {

/// A bound of the relative error of a sum of some dozens of products of rounded numbers, and of
/// what is computed from few such sums.
constexpr double kError = 1e-13;

/// Returns the root of the sum of squares of the entries of all these rows.
double size_of(const std::vector<Reals>& rows) {
  double square = 0;
  for (const Reals& row : rows) square += row.squaredNorm();
  return std::sqrt(square);
}

}  // namespace

MovingWork::MovingWork(const Law& law, const std::vector<Reals>& points,
                       const std::vector<Separation>& separations)
    : law_(law) {
  const auto count = static_cast<Eigen::Index>(points.size());
  const auto d = static_cast<Eigen::Index>(law.motions);
  Eigen::MatrixXd motions(d, count);
  heights_.resize(count);
  for (Eigen::Index r = 0; r < count; ++r) {
    motions.col(r) = points[static_cast<std::size_t>(r)].head(d);
    heights_[r] = points[static_cast<std::size_t>(r)][d];
  }
  sizes_ = motions.colwise().norm();
  for (std::size_t i = 0; i < law.contacts.size(); ++i) {
    if (separations[i] == Separation::kOpen) continue;
    const LawContact& c = law.contacts[i];
    const auto corners = static_cast<Eigen::Index>(c.corners.size());
    const std::size_t dimension = c.slopes[1] > 0 ? c.slip_dimension() : 0;
    Part part{i, separations[i] == Separation::kClosed, {}, {}, {}, {}, {}, {}, {}, {}};
    part.rises.resize(count, corners);
    part.slips.assign(dimension, Eigen::ArrayXXd(count, corners));
    double size = 0;
    for (Eigen::Index q = 0; q < corners; ++q) {
      const CornerRow& row = c.corners[static_cast<std::size_t>(q)];
      part.rises.col(q) = (motions.transpose() * row.normal_rounded).array();
      for (std::size_t k = 0; k < dimension; ++k) {
        part.slips[k].col(q) = (motions.transpose() * row.slip_rounded[k]).array();
      }
      size = std::max(size, row.normal_rounded.norm());
    }
    part.high.resize(count);
    part.low.resize(count);
    for (Eigen::Index r = 0; r < count; ++r) {
      const double least = part.rises.row(r).minCoeff();
      const double most = part.rises.row(r).maxCoeff();
      const double h = heights_[r];
      part.high[r] = h * c.preloads[1] - c.stiffnesses[least > 0 ? 0 : 1] * least;
      part.low[r] = h * c.preloads[0] - c.stiffnesses[most > 0 ? 1 : 0] * most;
    }
    const double preload = std::max(std::fabs(c.preloads[0]), std::fabs(c.preloads[1]));
    part.v_error = kError * (preload * heights_ + c.stiffnesses[1] * size * sizes_);
    parts_.push_back(std::move(part));
  }
}

void MovingWork::set(const RoundedLeaf& leaf) {
  leaf_ = leaf;
  const Eigen::Index count = heights_.size();
  const Eigen::VectorXd far = std::fabs(leaf.rate) * sizes_ + leaf.twist.norm() * heights_;
  for (Part& part : parts_) {
    const LawContact& c = law_.contacts[part.contact];
    const double rate = leaf.rates[part.contact];
    const Double3& psi = leaf.slips[part.contact];
    const double longer = 1 + c.tilted / 3;  // 1 + delta / 2
    part.most = Eigen::VectorXd::Constant(count, -HUGE_VAL);
    part.corner.assign(static_cast<std::size_t>(count), 0);
    double normal_size = 0;
    double slip_size = 0;
    Eigen::ArrayXd work(count);
    Eigen::ArrayXd along(count);
    Eigen::ArrayXd square(count);
    for (std::size_t corner = 0; corner < c.corners.size(); ++corner) {
      const auto q = static_cast<Eigen::Index>(corner);
      const CornerRow& row = c.corners[corner];
      work =
          leaf.rate * part.rises.col(q) + row.normal_rounded.dot(leaf.twist) * heights_.array();
      normal_size = std::max(normal_size, row.normal_rounded.norm());
      if (!part.slips.empty()) {
        along.setZero();
        square.setZero();
        for (std::size_t k = 0; k < part.slips.size(); ++k) {
          const auto slips = part.slips[k].col(q);
          along += psi[k] * slips;
          square += ((leaf.rate - rate) * slips +
                     row.slip_rounded[k].dot(leaf.twist) * heights_.array())
                        .square();
        }
        along += longer * square.sqrt();
        work += (along * c.slopes[1]).max(along * c.slopes[0]);
        slip_size = std::max(slip_size, size_of(row.slip_rounded));
      }
      for (Eigen::Index r = 0; r < count; ++r) {
        if (!(work[r] > part.most[r])) continue;
        part.most[r] = work[r];
        part.corner[static_cast<std::size_t>(r)] = q;
      }
    }
    const double own = norm_of(psi) + longer * std::fabs(rate);
    part.a_error = kError * ((normal_size + 2 * longer * c.slopes[1] * slip_size) * far +
                             2 * c.slopes[1] * slip_size * own * sizes_);
  }
}

Eigen::MatrixXd MovingWork::bounds(const Eigen::VectorXd& load_work) const {
  Eigen::MatrixXd half = 0.5 * heights_ * load_work.transpose();  // B is half + half^T
  for (const Part& part : parts_) {
    const Eigen::VectorXd above = 0.5 * part.most.cwiseMax(0.0);
    if (!part.closed) {
      half.noalias() += part.high.cwiseMax(0.0) * above.transpose();
      continue;
    }
    const Eigen::VectorXd below = 0.5 * part.most.cwiseMin(0.0);
    half.noalias() += part.high * above.transpose() + part.low * below.transpose();
  }
  return half + half.transpose();
}

Eigen::MatrixXd MovingWork::upper_bounds(const Eigen::VectorXd& load_work) const {
  Eigen::MatrixXd half = 0.5 * heights_ * load_work.transpose();
  Eigen::MatrixXd size = half.cwiseAbs();
  const auto add = [&](const Eigen::MatrixXd& most) {
    half += most / 2;
    size += most.cwiseAbs() / 2;
  };
  for (const Part& part : parts_) {
    const Eigen::RowVectorXd most = (part.most + part.a_error).transpose();
    const Eigen::VectorXd high = part.high + part.v_error;
    if (!part.closed) {
      add(high.cwiseMax(0.0) * most.cwiseMax(0.0));
      continue;
    }
    // (A spring's v may be below 0, so that the least work on it may do most.)
    const Eigen::RowVectorXd least = (part.most - part.a_error).transpose();
    const Eigen::VectorXd low = part.low - part.v_error;
    add((high * most).cwiseMax(low * most).cwiseMax(high * least).cwiseMax(low * least));
  }
  const Eigen::MatrixXd all = half + kError * size;
  return all + all.transpose();
}

MovingWork::Slip MovingWork::slip(const Part& part, Eigen::Index point) const {
  Slip result;
  if (part.slips.empty()) return result;
  const LawContact& c = law_.contacts[part.contact];
  const Eigen::Index q = part.corner[static_cast<std::size_t>(point)];
  const CornerRow& row = c.corners[static_cast<std::size_t>(q)];
  double along = 0;
  for (std::size_t k = 0; k < part.slips.size(); ++k) {
    const double s = part.slips[k](point, q);
    along += leaf_.slips[part.contact][k] * s;
    result.rest[k] = (leaf_.rate - leaf_.rates[part.contact]) * s +
                     row.slip_rounded[k].dot(leaf_.twist) * heights_[point];
  }
  result.size = norm_of(result.rest);
  result.slope = c.slopes[along + (1 + c.tilted / 3) * result.size > 0 ? 1 : 0];
  return result;
}

}  // namespace stickslip::search_detail
