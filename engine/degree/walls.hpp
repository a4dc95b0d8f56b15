// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Bodies of motions around an equilibrium, whose walls it does not reach.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "independent_rows.hpp"
#include "newton.hpp"
#include "stickslip/engine/force_span.hpp"
#include "stickslip/engine/proof.hpp"

namespace stickslip::degree_detail {

/// K: where its walls are to be, and which way the grasp in the middle pulls, in doubles.
///
/// On the walls across the slip of a sticking contact its friction is against that slip, and a
/// virtual twist that moves nothing else that sticks sees it. The other walls are across forces
/// on virtual twists on which what sticks does no work.
class Walls {
 public:
  /// Of the grasp in the middle of a box, with an equilibrium of that; without a box, which may
  /// be in the plane alone, of the only grasp. All must outlive it. `size` is a part of what
  /// would change a mode.
  Walls(const RoundedGrasp& middle, const ForceSpan& span, const NearEquilibrium& near,
        double size, const Law* box);

  /// Across what smooth forces answer motions with: so large that on them this much force is
  /// left over.
  Walls(const RoundedGrasp& middle, const ForceSpan& span, const NearEquilibrium& near,
        const Eigen::MatrixXd& answer, double force);

  /// Whether they can enclose anything.
  bool is_sound() const { return sound_; }
  /// E up to its lengths.
  const Eigen::MatrixXd& rows() const { return rows_; }
  /// Chooses those walls that are across forces anew, so that these moves need as little room
  /// as may be.
  void turn_to(const std::vector<Reals>& moves);
  /// Leaves room for these moves as well, each for itself.
  void enclose(const std::vector<Reals>& moves);
  /// Moves a wall of the parallelepiped outwards, by a quarter and in larger steps later; of a
  /// simplex all.
  void grow(std::size_t wall, bool is_simplex);

  /// Which A.
  enum class Pull {
    kTwists,  ///< by what the virtual twists see
    kFitted,  ///< what is against the forces on the walls, of few dimensions
    kStiff,   ///< springs, and friction that is left over how far the contact can slip
    kAnswer   ///< how smooth forces answer motions, of such walls alone
  };
  /// d0, E and A in few bits, without trees; not of full rank where that failed.
  DegreeProof proof(Pull pull, bool is_simplex) const;

 private:
  struct Sticking {
    Reals row;     ///< of its slip
    double spare;  ///< friction that is not used
    double room;   ///< that a wall across it needs
    double off;    ///< and beside it, for slips that the box has here
  };

  void add_sticking(const LawContact* contact, const RoundedContact& at, std::size_t index,
                    double width);
  void choose_rows(const IndependentRows& across);
  double room_along(const Reals& way) const;
  void check();
  Eigen::MatrixXd pull_of_twists(const Eigen::MatrixXd& walls) const;
  Eigen::MatrixXd pull_fitted(const Eigen::MatrixXd& walls, const Reals& centre) const;
  Eigen::MatrixXd pull_stiff(const Eigen::MatrixXd& walls) const;
  Reals force_at(const Reals& motion) const;
  RationalRow exact_row(const Eigen::RowVectorXd& row) const;

  const RoundedGrasp& middle_;
  const ForceSpan& span_;
  const NearEquilibrium& near_;
  double size_ = 0;
  std::vector<Sticking> sticking_;
  std::vector<std::size_t> chosen_;  ///< of these, whose slips are the first rows
  Eigen::MatrixXd frame_;            ///< the other virtual twists, by columns
  Eigen::MatrixXd stiffness_;  ///< how forces answer motion, but for friction that sticks,
                               ///< unless it is smooth
  Eigen::MatrixXd rows_;       ///< E, up to the widths
  Eigen::MatrixXd twists_;     ///< one for each row, by columns
  Eigen::VectorXd room_;       ///< least widths
  Eigen::VectorXd below_;      ///< rows (d - motion) go from -below
  Eigen::VectorXd above_;      ///< to above
  std::vector<int> steps_;     ///< by which each wall has grown
  bool sound_ = false;
};

}  // namespace stickslip::degree_detail
