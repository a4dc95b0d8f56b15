// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The grasps of a box in doubles, from which proposals come.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "stickslip/engine/grasp_law.hpp"

namespace stickslip {

/// The rows of S: as many as a slip has coordinates.
using SlipRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, kMostCoordinates>;

/// A contact, in the units of its law.
struct RoundedContact {
  Reals normal;            ///< N
  SlipRows slip;           ///< S
  double slope;            ///< mu L: friction is at most this times a
  double preload;          ///< P'
  double stiffness;        ///< k'
  double size;             ///< the size of the force of a = 1
  bool is_spring = false;  ///< a is v, of either sign

  /// Returns v at a motion.
  double separation(const Reals& motion) const {
    return preload - stiffness * normal.dot(motion);
  }
  /// Returns whether there is a force at this v.
  bool acts(double v) const { return v > 0 || is_spring; }
  /// Returns a at a motion.
  double force(const Reals& motion) const {
    const double v = separation(motion);
    return acts(v) ? v : 0;
  }
};

/// One grasp of a box, in the units of its law.
struct RoundedGrasp {
  std::vector<RoundedContact> contacts;  ///< contacts by ContactId
  Reals load;                            ///< w
  double force;                          ///< a typical force
  double reach;                          ///< how far that force moves the object
  std::vector<char> rotates;             ///< 1 for rotations, by coordinate of motions
  double length;                         ///< the factor by which rotations are multiplied

  /// Returns D.
  Eigen::Index motions() const { return load.size(); }
  /// Returns the factor of a coordinate of motions, as Law::unit().
  double unit(std::size_t coordinate) const { return rotates[coordinate] != 0 ? length : 1; }
};

/// All grasps of a box; for a margin, at all of its multiples.
class RoundedBox {
 public:
  /// The place of a grasp: a number from -1 to 1 for each uncertain number, from its low end to
  /// its high end. A margin of several multiples has one more, for the multiple.
  using Place = Eigen::VectorXd;

  /// The law must outlive this. The multiples of a margin must have an end.
  explicit RoundedBox(const GraspLaw& law);
  explicit RoundedBox(GraspLaw&&) = delete;

  const GraspLaw& law() const { return law_; }                          ///< the law of the box
  const std::vector<ParameterId>& numbers() const { return numbers_; }  ///< the uncertain ones
  /// Returns the middle of all numbers; of a ball of loads it has the load nearest to that in
  /// the ball's centre.
  Place middle() const;
  /// Returns the place at which a linear function of places is largest, or for a part of a ball
  /// large. Normals in space are turned there by their slopes, each one way.
  Place farthest(const Eigen::VectorXd& function) const;
  /// Returns the grasp at a place. O(contacts).
  RoundedGrasp at(const Place& place) const;
  /// Returns one of its contacts.
  RoundedContact contact_at(std::size_t contact, const Place& place) const;
  /// Returns its load.
  Reals load_at(const Place& place) const;

 private:
  double multiple_at(const Place& place) const;
  std::array<double, 2> ends_of_part(std::size_t component) const;
  template <class Function>
  Place with_loads(Place place, Function z) const;

  const GraspLaw& law_;
  bool has_multiples_;
  std::vector<ParameterId> numbers_;
  std::vector<std::size_t> first_;  ///< the first number of each contact, and last of the load
};

/// Fixed pseudo-random numbers, the same on every machine (G. Marsaglia, "Xorshift RNGs",
/// 2003).
class Xorshift {
 public:
  /// Returns the next one, from -1 to 1.
  double next();

 private:
  std::uint64_t state_ = 88172645463325252ULL;
};

/// Pseudo-random corners of a box, the farthest places along functions drawn at random.
class RandomCorners {
 public:
  /// The box must outlive this.
  explicit RandomCorners(const RoundedBox& box) : box_(box) {}

  RoundedBox::Place next();                   ///< returns the next corner
  double number() { return random_.next(); }  ///< returns the next number, from -1 to 1

 private:
  const RoundedBox& box_;
  Xorshift random_;
};

/// Returns the grasp in the middle of a law's box, for a margin with the multiple in the
/// middle; or the one grasp that the law is of.
RoundedGrasp rounded_middle(const Law& law);

/// Returns the grasp of a problem, for a family with the multiple 0.
RoundedGrasp rounded_grasp(const Problem& problem);

}  // namespace stickslip
