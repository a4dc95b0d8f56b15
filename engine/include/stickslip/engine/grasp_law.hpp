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

/// By how much a margin grows per multiple.
struct GrowthRates {
  RationalRow load{};                ///< u; empty: 0
  std::vector<Rational> preloads{};  ///< P^u by contact; empty: none grows
};

/// All parameters of grasps like this: contact by contact, spring by spring, and then those of
/// the wrench, or of the ball of loads beside it.
std::vector<ParameterId> parameters_of(const GraspBox& box);

/// The law of every grasp in a box, or in a part of it.
class GraspLaw : public Law {
 public:
  /// 1/|n| is enclosed in so many bits where it is irrational and the preload may be above 0.
  /// Margins are of one grasp in space.
  GraspLaw(const GraspBox& box, NormalLaw law, unsigned bits = kDefaultBits,
           const std::optional<GrowthRates>& margin = {});

  /// The interval of a parameter. Requires that there is one.
  const Interval& interval(const ParameterId& id) const;
  /// All of them.
  const std::vector<ParameterId>& parameters() const { return parameters_; }
  /// Whether it is one body in the plane, of which a Problem can be made.
  bool is_one_planar_body() const { return one_body_ && !in_space_; }
  /// The halves below and above a cut; not of a margin. Requires low < value < high.
  std::pair<GraspLaw, GraspLaw> halves(const PartSplit& split) const;
  /// The one grasp with every parameter in the middle of its interval, of a ball of loads with
  /// that nearest to 0; of a margin with this multiple.
  GraspLaw middle(const Rational& multiple = 0) const;
  /// The same margin for other multiples.
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

/// That of a question about a box, of a margin as it grows, with lengths enclosed to these
/// bits.
GraspLaw law_of(const Question& question, unsigned bits);

}  // namespace stickslip
