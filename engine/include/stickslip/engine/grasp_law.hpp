// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The law of a box of grasps, in the plane or in space, in *parameters*: numbers, each in an
/// interval of its own, in which N, S, v and the work of a force are multilinear. They are the
/// point and the turns of the normal of each contact, mu, P' = P / |n|, k' = k / |n|^2, and the
/// load. The box of parameters contains a little more than the grasps that are asked about,
/// since P' and k' are taken to be independent of the turn (certificate/FORMAT.md, section 6).
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

/// Returns the parameters of the grasps in a box: those of each contact, then those of each
/// spring, and then the components of the wrench, or of a load in the ball if there is one.
/// Those whose interval is one number are among them.
std::vector<ParameterId> parameters_of(const GraspBox& box);

/// The law of every grasp in a box, or in a part of it.
class GraspLaw : public Law {
 public:
  /// Makes the law of a box. Where 1/|n| is irrational and the preload may be above 0, or
  /// grows, 1/|n| is enclosed between two neighbouring numbers of `bits` bits. A `margin`
  /// requires that the box is one grasp. Throws InputError if motions have more than 30
  /// coordinates.
  GraspLaw(const GraspBox& box, NormalLaw law, unsigned bits = kDefaultBits,
           const std::optional<Growth>& margin = {});

  /// Returns the interval of a parameter. Requires that the law has it.
  const Interval& interval(const ParameterId& id) const;
  /// Returns all parameters, in the order of parameters_of().
  const std::vector<ParameterId>& parameters() const { return parameters_; }
  /// Returns the problem of a law of one grasp; nothing in space and of several bodies, which
  /// have none.
  std::optional<Problem> problem() const;
  /// Returns the laws of the two parts of the box, below and above a cut. Requires that this is
  /// no margin. Throws ContractError unless low < split.value < high for the parameter's
  /// interval [low, high].
  std::pair<GraspLaw, GraspLaw> halves(const PartSplit& split) const;
  /// Returns the law of the one grasp with every parameter in the middle of its interval. A
  /// ball of loads is replaced by the load of this part of it that is nearest to the ball's
  /// centre. A margin is replaced by its member with this multiple; without a margin the
  /// multiple plays no part.
  GraspLaw middle(const Rational& multiple = 0) const;
  /// Returns the law without these contacts. Requires that they are there and increase. The
  /// others are numbered anew.
  GraspLaw without(const std::vector<ContactId>& contacts) const;
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

/// Returns the law of a question, with irrational lengths enclosed to `bits` bits. If it asks
/// about a margin, the law has the margin's growth. Requires that the question's grasp is kept
/// as a GraspBox (Question::box()).
GraspLaw law_of(const Question& question, unsigned bits);

}  // namespace stickslip
