// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Bodies of motions around an equilibrium, with walls that it does not reach.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "independent_rows.hpp"
#include "newton.hpp"
#include "stickslip/engine/force_span.hpp"
#include "stickslip/engine/proof.hpp"

namespace stickslip::degree_detail {

/// A body K in doubles: the places of its walls, and the way the grasp in the middle pulls.
///
/// The friction of a sticking contact is against its slip on the walls across that slip, and a
/// virtual twist that moves no other contact that sticks sees it. The other walls are across
/// forces on virtual twists on which sticking contacts do no work.
class Walls {
 public:
  /// Chooses walls for the grasp in the middle of a box, around an equilibrium of it. Without a
  /// box, which is possible in the plane only, they are for the only grasp. All must outlive
  /// this. `size` is a part of what would change a mode.
  Walls(const RoundedGrasp& middle, const ForceSpan& span, const NearEquilibrium& near,
        double size, const Law* box);

  /// Takes walls across these rows, at the distances `room`. `answer` is how smooth forces
  /// answer motions.
  Walls(const RoundedGrasp& middle, const ForceSpan& span, const NearEquilibrium& near,
        const Eigen::MatrixXd& answer, const Eigen::MatrixXd& rows,
        const Eigen::VectorXd& room);

  /// Returns whether they can enclose anything.
  bool is_sound() const { return sound_; }
  /// Returns E up to its lengths.
  const Eigen::MatrixXd& rows() const { return rows_; }
  /// Chooses the walls that are across forces anew, so that these moves need as little room as
  /// may be.
  void turn_to(const std::vector<Reals>& moves);
  /// Makes room for each of these moves.
  void enclose(const std::vector<Reals>& moves);
  /// Moves a wall of the parallelepiped outwards, by a quarter and in larger steps later; moves
  /// all walls of a simplex.
  void grow(std::size_t wall, bool is_simplex);

  /// The choice of A.
  enum class Pull {
    kTwists,  ///< forces that the virtual twists see
    kFitted,  ///< a fit against the forces on the walls
    kStiff,   ///< springs, and spare friction over how far the contact can slip
    kAnswer   ///< how smooth forces answer motions; for such walls alone
  };
  /// Returns d0, E and A in few bits, without trees; not of full rank if that failed.
  DegreeProof proof(Pull pull, bool is_simplex) const;

 private:
  struct Sticking {
    Reals row;     ///< the row of its slip
    double spare;  ///< friction that is not used
    double room;   ///< the width that a wall across it needs
    double off;    ///< more of it, for slips that the box has here
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
  std::vector<std::size_t> chosen_;  ///< indices in sticking_, whose slips are the first rows
  Eigen::MatrixXd frame_;            ///< the other virtual twists, by columns
  Eigen::MatrixXd stiffness_;  ///< how forces answer motion, but for friction that sticks,
                               ///< unless it is smooth
  Eigen::MatrixXd rows_;       ///< E, up to the widths
  Eigen::MatrixXd twists_;     ///< one for each row, by columns
  Eigen::VectorXd room_;       ///< least widths
  Eigen::VectorXd below_;      ///< rows (d - motion) are at least -below
  Eigen::VectorXd above_;      ///< and at most above
  std::vector<int> steps_;     ///< how often each wall has grown
  bool sound_ = false;
};

}  // namespace stickslip::degree_detail
