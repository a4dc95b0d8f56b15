// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium_cloud.hpp"

#include <algorithm>
#include <cmath>

#include "engine/motion/dense.hpp"
#include "independent_rows.hpp"

namespace stickslip::degree_detail {

double median_of(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

CloudCoordinates::CloudCoordinates(const RoundedGrasp& middle, const ForceSpan& span,
                                   const NearEquilibrium& near,
                                   const std::vector<Reals>& cloud) {
  const Eigen::Index d = middle.motions();
  std::vector<Eigen::RowVectorXd> slips;
  std::vector<double> presses;
  Eigen::MatrixXd springs = Eigen::MatrixXd::Zero(d, d);
  for (std::size_t i = 0; i < middle.contacts.size(); ++i) {
    const RoundedContact& c = middle.contacts[i];
    const double a = near.normal[i];
    if (c.is_spring || a > 0) springs += c.stiffness * c.normal * c.normal.transpose();
    if (c.is_spring || !(a > 0)) continue;
    presses.push_back(a / (c.stiffness * c.size));
    if (!(c.slope > 0)) continue;
    // A contact that slips little here may stick in other grasps, or slip another way.
    constexpr double kLittle = 0.3;  // of how far it is pressed in
    const bool may_stick =
        near.sticks[i] != 0 || (c.slip * near.motion).norm() < kLittle * presses.back();
    if (!may_stick) continue;
    for (const auto& row : c.slip.rowwise()) slips.emplace_back(std::sqrt(c.slope * a) * row);
  }
  press = median_of(presses);
  IndependentRows known(d);
  Eigen::Index sticking = 0;
  rows.resize(0, d);
  if (!slips.empty()) {
    Eigen::MatrixXd all(static_cast<Eigen::Index>(slips.size()), d);
    for (Eigen::Index k = 0; k < all.rows(); ++k)
      all.row(k) = slips[static_cast<std::size_t>(k)];
    const SingularValues values = singular_values(all);
    constexpr double kNothing = 1e-3;
    while (sticking < values.values.size() &&
           values.values[sticking] > kNothing * values.values[0]) {
      known.take(values.right.col(sticking++));
    }
    rows = values.right.leftCols(sticking).transpose();
  }
  for (const RationalRow& z : span.free_motions()) {
    Reals motion(d);
    for (Eigen::Index j = 0; j < d; ++j) {
      const auto column = static_cast<std::size_t>(j);
      motion[j] = to_double(z[column]) * middle.unit(column);
    }
    known.take(motion);
  }
  const Eigen::MatrixXd others = known.complement();
  const auto with = [&](Eigen::MatrixXd more) {
    more.rowwise().normalize();
    Eigen::MatrixXd result(sticking + more.rows(), d);
    result << rows, more;
    return result;
  };
  constexpr double kSoft = 1e-6;
  const Eigen::MatrixXd forces =
      others.transpose() * (springs + kSoft * springs.norm() * Eigen::MatrixXd::Identity(d, d));
  constexpr double kFlat = 1e-4;
  Eigen::MatrixXd chosen = with(forces);
  if (!chosen.allFinite() || singular_values(chosen).values.minCoeff() < kFlat) {
    chosen = with(others.transpose());
  }
  rows = chosen;
  constexpr std::size_t kFew = 20;
  if (cloud.size() > kFew) {
    const auto turn = [&](Eigen::Index first, Eigen::Index count) {
      if (count < 2) return;
      Eigen::MatrixXd moments = Eigen::MatrixXd::Zero(count, count);
      for (const Reals& move : cloud) {
        const Eigen::VectorXd at = rows.middleRows(first, count) * move;
        moments += at * at.transpose();
      }
      if (!(moments.norm() > 0)) return;
      rows.middleRows(first, count) =
          (singular_values(moments).right.transpose() * rows.middleRows(first, count)).eval();
    };
    turn(0, sticking);
    turn(sticking, rows.rows() - sticking);
  }
  extent = Eigen::VectorXd::Zero(rows.rows());
  for (const Reals& move : cloud) extent = extent.cwiseMax((rows * move).cwiseAbs());
}

}  // namespace stickslip::degree_detail
