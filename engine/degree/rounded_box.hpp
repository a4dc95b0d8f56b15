// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The grasps of a box in doubles: proposals come from them.
#pragma once

#include <array>
#include <vector>

#include "stickslip/engine/grasp_law.hpp"

namespace stickslip {

/// S by rows: as many as a slip has coordinates.
using SlipRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, kMostCoordinates>;

/// A contact, in the units of its law.
struct RoundedContact {
  Reals normal;            ///< N
  SlipRows slip;           ///< S
  double slope;            ///< mu L: friction is at most this times a
  double preload;          ///< P'
  double stiffness;        ///< k'
  double size;             ///< of the force of a = 1
  bool is_spring = false;  ///< a is v, of either sign

  /// v at a motion.
  double separation(const Reals& motion) const {
    return preload - stiffness * normal.dot(motion);
  }
  /// Whether there is a force at this v.
  bool acts(double v) const { return v > 0 || is_spring; }
  /// a at a motion.
  double force(const Reals& motion) const {
    const double v = separation(motion);
    return acts(v) ? v : 0;
  }
};

/// One grasp of a box, in the units of its law.
struct RoundedGrasp {
  std::vector<RoundedContact> contacts;  ///< by ContactId
  Reals load;                            ///< w
  double force;                          ///< a typical force
  double reach;                          ///< how far it moves the object
  std::vector<char> rotates;             ///< by coordinate of motions
  double length;                         ///< by which rotations are times

  /// D.
  Eigen::Index motions() const { return load.size(); }
  /// As of its law.
  double unit(std::size_t coordinate) const { return rotates[coordinate] != 0 ? length : 1; }
};

/// All grasps of a box, or of a margin's for all of its multiples.
class RoundedBox {
 public:
  /// Where a grasp lies: a number from -1 to 1 for each uncertain number, from its low end to
  /// its high end; of a margin one more, for the multiple.
  using Place = Eigen::VectorXd;

  /// The law must outlive this. Multiples of a margin have an end.
  explicit RoundedBox(const GraspLaw& law);
  explicit RoundedBox(GraspLaw&&) = delete;

  const GraspLaw& law() const { return law_; }                          ///< of the box
  const std::vector<ParameterId>& numbers() const { return numbers_; }  ///< that are uncertain
  /// Of all numbers; of a ball of loads the load that is nearest to that in its centre.
  Place middle() const;
  /// Where a linear function of places is largest, or of a part of a ball large.
  Place farthest(const Eigen::VectorXd& function) const;
  /// O(contacts).
  RoundedGrasp at(const Place& place) const;
  /// One of its contacts.
  RoundedContact contact_at(std::size_t contact, const Place& place) const;
  /// Its load.
  Reals load_at(const Place& place) const;

 private:
  double multiple_at(const Place& place) const;
  std::array<double, 2> ends_of_part(std::size_t component) const;
  template <class Function>
  Place with_loads(Place place, Function z) const;

  const GraspLaw& law_;
  bool has_multiples_;
  std::vector<ParameterId> numbers_;
  std::vector<std::size_t> first_;  ///< of the numbers of a contact, and last of the load
};

/// The grasp in the middle of a law's box, of a margin with the multiple in the middle; or the
/// one that the law is of.
RoundedGrasp rounded_middle(const Law& law);

/// The grasp of a problem, of a family with the multiple 0.
RoundedGrasp rounded_grasp(const Problem& problem);

}  // namespace stickslip
