// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The work of forces on virtual twists that move with the point, in doubles
/// (certificate/FORMAT.md, section 4, "Leaf whose twist moves"). It proposes, and with its
/// error bounds tells where exact numbers are not needed.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "stickslip/engine/law.hpp"
#include "stickslip/engine/strict_cone.hpp"

namespace stickslip::search_detail {

/// A moving leaf in doubles, in the law's units.
struct RoundedLeaf {
  Reals twist;                 ///< y
  double rate = 0;             ///< c
  std::vector<double> rates;   ///< kappa, by contact
  std::vector<Double3> slips;  ///< the coordinates of psi, by contact
};

/// The bounds A_i(r) and B(r, r') on some points of a law that is no margin and has no hull.
class MovingWork {
 public:
  /// Takes points (d, h, l) in the law's units. `separations` says of each contact whether it
  /// is closed, open or mixed on their cone. The law must outlive this.
  MovingWork(const Law& law, const std::vector<Reals>& points,
             const std::vector<Separation>& separations);

  /// Computes the bounds of a leaf.
  void set(const RoundedLeaf& leaf);
  /// Returns B for all pairs of points. `load_work` has the most work Lambda(y(r)) of loads.
  Eigen::MatrixXd bounds(const Eigen::VectorXd& load_work) const;
  /// Returns for all pairs of points a number that B is certainly not above, if the numbers of
  /// the law are moderate and `load_work` is rounded to nearest.
  Eigen::MatrixXd upper_bounds(const Eigen::VectorXd& load_work) const;

  /// The values of a contact that is not open.
  struct Part {
    std::size_t contact;                 ///< the contact
    bool closed;                         ///< whether it is closed; else it is mixed
    Eigen::ArrayXXd rises;               ///< N.d, by point and corner
    std::vector<Eigen::ArrayXXd> slips;  ///< the coordinates of S d, by point and corner each
    Eigen::VectorXd high;                ///< the largest v, by point
    Eigen::VectorXd low;                 ///< the least v
    Eigen::VectorXd most;                ///< A_i
    std::vector<Eigen::Index> corner;    ///< a corner at which it is attained
    Eigen::VectorXd v_error;             ///< a bound of the error of `high` and `low`
    Eigen::VectorXd a_error;             ///< a bound of the error of `most`
  };
  const std::vector<Part>& parts() const { return parts_; }  ///< the contacts that are not open
  /// The friction in A_i.
  struct Slip {
    Double3 rest{};    ///< S (y(r) - kappa d), in coordinates
    double size = 0;   ///< its length
    double slope = 0;  ///< mu L, at the end that counts
  };
  /// Returns the friction in A_i of a part at a point, at the corner where A_i is attained.
  Slip slip(const Part& part, Eigen::Index point) const;

 private:
  const Law& law_;
  Eigen::VectorXd heights_;
  Eigen::VectorXd sizes_;  ///< |d|
  std::vector<Part> parts_;
  RoundedLeaf leaf_;
};

}  // namespace stickslip::search_detail
