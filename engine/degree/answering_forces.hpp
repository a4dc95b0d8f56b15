// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The forces with which contacts answer the wrenches that a proof at rest, or by sticking,
/// leaves over; and exact bounds of what they do over a box.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <utility>
#include <vector>

#include "stickslip/engine/grasp_law.hpp"
#include "stickslip/engine/near_equilibrium.hpp"
#include "stickslip/engine/proof.hpp"

namespace stickslip::degree_detail {

using WrenchRange = std::vector<Interval>;
using Rows = std::vector<RationalRow>;

/// Returns P' at this multiple, over the box.
Interval preload_at(const LawContact& c, const Rational& multiple);

/// Returns the loads at this multiple, over the box, by component.
WrenchRange loads_at(const GraspLaw& box, const Rational& multiple);

/// Adds the ends, over all corners, of the wrenches a N + S^T f with a in `normal`.
void add_wrenches(WrenchRange& sum, const LawContact& c, const RationalRow& friction,
                  const std::vector<Rational>& normal);

/// Returns the largest magnitude in an interval.
Rational largest(const Interval& interval);

/// Returns the bound of |f| that the format computes with: not below |f|, of 64 bits.
Rational length_above(const LawContact& contact, const RationalRow& f);

/// The search for forces that answer, beside an equilibrium of the middle of a box. Both must
/// outlive it.
class AnswerSearch {
 public:
  AnswerSearch(const GraspLaw& box, const NearEquilibrium& middle);

 protected:
  static constexpr double kFlat = 1e-9;      ///< the part below which nothing is independent
  static constexpr int kForceBits = 24;      ///< the bits of forces that are stated
  static constexpr unsigned kRootBits = 64;  ///< those of roots, which are the format's

  /// A contact that answers, with the friction or normal force that it has to spare.
  struct Bearing {
    std::size_t contact;
    double spare;
  };

  const LawContact& contact(ContactId id) const { return box_.contacts[id.index()]; }
  /// \{ Returns N or S in the middle of the box, in doubles.
  Eigen::MatrixXd normal_of(std::size_t contact) const;
  Eigen::MatrixXd slip_of(std::size_t contact) const;
  /// \}
  /// Keeps those with most to spare, of rows `rows_of(contact)`: of many, a few answer as well,
  /// and with less to be written. They are 8, or more until the rank is full, but `most` at
  /// most.
  void keep_best(std::vector<Bearing>& bearing, std::size_t most,
                 const std::function<Eigen::MatrixXd(std::size_t)>& rows_of) const;
  /// Returns a right inverse of `wrenches`, in which forces of more weight answer more.
  static Eigen::MatrixXd right_inverse(const Eigen::MatrixXd& wrenches,
                                       const Eigen::VectorXd& weights);
  /// States the friction that the middle has, of a contact that rubs, if it is not 0.
  void state_friction(std::size_t contact);
  /// States the answer of a contact: `forces` has its friction in rows from `first` on.
  void state_answer(std::size_t contact, const Eigen::MatrixXd& forces, Eigen::Index first);
  /// Measures max |W|, and max |M - 1| by rows. The normal forces of a contact, by the index of
  /// a multiple, are in `normal(at, contact)`.
  void measure(const std::function<Interval(std::size_t, std::size_t)>& normal);
  /// Returns whether max |W| + max |M - 1| Z is within Z, or within it with some to spare.
  bool is_reached(const RationalRow& reach, bool strictly) const;
  /// Returns phi by contact: the most friction that it may need.
  std::vector<Rational> friction_needed(const RationalRow& reach) const;
  /// Returns the least mu L of a contact, rounded down.
  static Rational least_slope(const LawContact& c);

  const GraspLaw& box_;
  const NearEquilibrium& middle_;
  Eigen::Index motions_;
  std::vector<Rational> multiples_;                          ///< 0, or the ends of a margin
  std::vector<std::pair<ContactId, RationalRow>> friction_;  ///< f0 by contact, increasing
  std::vector<StickingProof::Press> presses_;                ///< H, by increasing contact
  std::vector<RestProof::Answer> answers_;                   ///< G, by increasing contact
  Rows off_;                                                 ///< max |M - 1|, by rows
  RationalRow rest_;                                         ///< max |W|
};

}  // namespace stickslip::degree_detail
