// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The enlarged box of certificate/FORMAT.md, section 6, of which the proofs speak: intervals
/// of parameters in which N, T, v, tau and alpha are multilinear.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/equilibrium/part.hpp"

namespace stickslip {

/// A parameter of one contact, or a component of the wrench.
struct ParameterId {
  Parameter parameter;  ///< of which contact: index
  std::size_t index;    ///< of the contact, or of the component
};

/// One contact's parameters.
struct ParameterContact {
  Vector2 normal;                      ///< n
  std::array<Interval, 6> parameters;  ///< by Parameter
};

/// A box of parameters.
class ParameterBox {
 public:
  /// The enlarged box. `bits` are those of the enclosure of 1/|n| where that is irrational and
  /// the preload may be above 0.
  ParameterBox(const GraspBox& box, NormalLaw law, unsigned bits = kDefaultBits);

  static constexpr unsigned kDefaultBits = 128;  ///< of a certificate that does not say

  const std::vector<ParameterContact>& contacts() const { return contacts_; }  ///< by ContactId
  std::size_t size() const { return contacts_.size(); }                        ///< m
  const WrenchBox& wrench() const { return wrench_; }                          ///< w
  NormalLaw law() const { return law_; }                                       ///< of all

  /// The interval of a parameter. Requires that there is one.
  const Interval& interval(Parameter parameter, std::size_t index) const;
  /// The halves below and above a cut. Requires low < value < high.
  std::pair<ParameterBox, ParameterBox> halves(const PartSplit& split) const;
  /// Whether no interval has more than one number.
  bool is_point() const;
  /// The one point in the middle of every interval.
  ParameterBox middle() const;

 private:
  std::vector<ParameterContact> contacts_;
  WrenchBox wrench_;
  NormalLaw law_;
};

/// Whether 1/|n| of some contact that may have a preload is irrational, so that even the box of
/// one grasp is known by an enclosure only.
bool needs_enclosure(const GraspBox& box);

}  // namespace stickslip
