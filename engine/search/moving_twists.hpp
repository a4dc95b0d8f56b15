// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The search for virtual twists that move with the point, in doubles: proposals for leaves
/// (certificate/FORMAT.md, section 4, "Leaf whose twist moves").
///
/// **Method.** With y(x) = c (d - h d0) + h y0 the bound of each pair of points is convex in
/// (c, y0, kappa, psi). The leaf whose largest bound is least, of all leaves of norm 1, is
/// sought by cutting planes: minus the point of least norm of the hull of all gradients seen so
/// far is the leaf to try next.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "moving_work.hpp"
#include "stickslip/engine/proof.hpp"

namespace stickslip::search_detail {

/// The region that a moving leaf is about.
struct MovingSubject {
  Reals centre;                         ///< d0, in the law's units
  std::vector<Reals> points;            ///< (d, h, l) with h = 1, in these units
  std::vector<Separation> separations;  ///< on their cone, by contact
  /// A(d - h d0) at each point, as twists in the law's units see it, times one number, if the
  /// leaf is for list 2; else empty.
  std::vector<Reals> pulls{};
};

/// Proposes moving leaves for one set of points.
class MovingTwists {
 public:
  /// The coordinates of a leaf: c, y0, and kappa and psi of each contact that rubs, scaled.
  using Coordinates = Eigen::VectorXd;

  /// A pair of points whose bound is among the largest.
  struct Pair {
    double weight;       ///< its weight; all weights have the sum 1
    Eigen::Index first;  ///< a point
    Eigen::Index other;  ///< another, or the same
  };
  /// The result of a search.
  struct Found {
    bool accepted = false;      ///< whether a leaf was accepted
    Coordinates coordinates{};  ///< that leaf, or the best
    double bound = 0;           ///< its largest bound over its norm and a typical force
    std::vector<Pair> pairs{};  ///< those that let no leaf be better, if none was accepted
  };

  /// The law must outlive this.
  MovingTwists(const Law& law, MovingSubject about);

  /// Seeks a leaf in so many rounds, from `guess` on if it is not empty. `accept` judges those
  /// that doubles take for good; without it the search goes on to the best one.
  Found find(const Coordinates& guess, int rounds,
             const std::function<bool(const Coordinates&)>& accept = {});
  /// Returns a leaf near these coordinates, in so many bits.
  MovingLeaf leaf(const Coordinates& coordinates, int bits) const;

 private:
  struct Rubbing {
    std::size_t contact;
    Eigen::Index first;  ///< the coordinate that is kappa; those of psi follow
  };
  struct Cut {
    Eigen::VectorXd gradient;
    Eigen::Index first;
    Eigen::Index other;
    std::size_t column;  ///< its place among all vectors
  };

  RoundedLeaf rounded(const Coordinates& coordinates) const;
  double evaluate(const Coordinates& coordinates);
  Eigen::VectorXd gradient(std::size_t part, Eigen::Index point) const;
  Eigen::VectorXd load_gradient(Eigen::Index point) const;
  Cut cut(Eigen::Index first, Eigen::Index other, bool is_pull);
  Eigen::VectorXd constraint(const Rubbing& rubs, const Eigen::VectorXd& direction) const;

  const Law& law_;
  MovingSubject about_;
  MovingWork work_;
  std::vector<Rubbing> rubbing_;
  Eigen::Index size_ = 0;    ///< the number of coordinates
  std::vector<Reals> ways_;  ///< d - h d0
  double reach_ = 0;         ///< the largest entry of these
  Eigen::MatrixXd pulling_;  ///< (d - h d0) . A (d' - h' d0), by pairs, symmetric

  /// \{ The values at the last coordinates.
  std::vector<Reals> loads_;
  Eigen::MatrixXd bounds_;
  Eigen::MatrixXd against_;  ///< minus the sides of `leaf-direction`
  std::vector<std::vector<std::optional<Eigen::VectorXd>>> gradients_;
  /// \}
};

}  // namespace stickslip::search_detail
