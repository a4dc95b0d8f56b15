// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The law of a box of grasps, in the plane or in space: the enlarged box of
/// certificate/FORMAT.md, section 6, with its *parameters*, intervals in which N, S, v and
/// the work of a force are multilinear.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/engine/law.hpp"
#include "stickslip/engine/part.hpp"
#include "stickslip/engine/question.hpp"

namespace stickslip {

/// The growth of load and preloads per unit of a margin's multiple.
struct GrowthRates {
  RationalRow load{};                ///< u; empty: 0
  std::vector<Rational> preloads{};  ///< P^u by element, contacts first; empty: none grows
};

/// Returns all parameters of such grasps: those of each contact, then those of each spring, and
/// then those of the wrench, or of the ball of loads if there is one.
std::vector<ParameterId> parameters_of(const GraspBox& box);

/// The law of every grasp in a box, or in a part of it.
class GraspLaw : public Law {
 public:
  /// Makes the law of a box. Where 1/|n| is irrational and the preload may be above 0, or
  /// grows, it is enclosed in `bits` bits. A `margin` requires that the box is one grasp.
  GraspLaw(const GraspBox& box, NormalLaw law, unsigned bits = kDefaultBits,
           const std::optional<GrowthRates>& margin = {});

  /// Returns the interval of a parameter. Requires that the law has it.
  const Interval& interval(const ParameterId& id) const;
  /// Returns all parameters, in the order of parameters_of().
  const std::vector<ParameterId>& parameters() const { return parameters_; }
  /// Returns whether there is one body, in the plane, so that a Problem can be made of its
  /// grasps.
  bool is_one_planar_body() const { return one_body_ && !in_space_; }
  /// Returns the halves of the box below and above a cut. Requires that this is no margin, and
  /// that low < value < high.
  std::pair<GraspLaw, GraspLaw> halves(const PartSplit& split) const;
  /// Returns the law of the one grasp with every parameter in the middle of its interval. In
  /// place of a ball of loads it has the load that is nearest to the ball's middle, and in
  /// place of a margin the member with this multiple.
  GraspLaw middle(const Rational& multiple = 0) const;
  /// Returns the same margin with another range of multiples.
  GraspLaw within(const MultipleRange& range) const;

 private:
  void add_contact(const UncertainContact& contact, std::vector<RationalRow> motion,
                   const Rational& rate, unsigned bits);
  void add_spring(const Spring& spring, const Rational& rate);
  void add_corners(LawContact& contact) const;
  const Interval& load_interval(std::size_t component) const;
  void complete();

  bool in_space_ = false;
  bool one_body_ = true;
  std::vector<ParameterId> parameters_;
};

/// Returns the law of a question that is a box, with irrational lengths enclosed to `bits`
/// bits. If it asks about a margin, the law has the margin's growth.
GraspLaw law_of(const Question& question, unsigned bits);

}  // namespace stickslip
