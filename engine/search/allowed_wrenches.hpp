// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The wrenches that a region allows, in doubles.
#pragma once

#include <optional>
#include <vector>

#include "engine/motion/nearest_wrench.hpp"
#include "law_forces.hpp"
#include "spring_lines.hpp"

namespace stickslip::search_detail {

/// What a contact can do on a virtual twist, per unit of normal coefficient.
struct Action {
  double alpha = 0;    ///< the most work
  Double3 friction{};  ///< f that does it
  std::size_t corner = 0;
};

/// All contacts of a region on y. The region must outlive this.
class Actions {
 public:
  Actions(const Law& law, const MotionRegion& region, const Reals& y);

  /// The most work of a contact at a generator; `acts` becomes true if its force is not 0.
  double work(std::size_t contact, std::size_t generator, bool& acts) const;
  /// Whether errors of alpha change nothing in which rule bounds it.
  bool is_clear(std::size_t contact, double error) const;
  /// Whether its force is 0 there by what is exact: zeros, and signs.
  bool is_idle(std::size_t contact, std::size_t generator) const;
  /// Adds the force that does it to these.
  void add_force(std::size_t contact, std::size_t generator, double& normal, Double3& friction,
                 Reals& wrench) const;

 private:
  struct PairsAction {
    SpringEnds<double> ends;
    std::vector<double> slopes;
    std::optional<CornerWork<double>> work;
  };

  Action action(std::size_t i, const Reals& y) const;
  bool is_against(std::size_t i, const Double3& slid) const;
  double normal(std::size_t contact, std::size_t generator) const;
  double height(std::size_t generator) const {
    return region_.generators()[generator][static_cast<Eigen::Index>(law_.motions)];
  }

  const Law& law_;
  const MotionRegion& region_;
  std::vector<Action> all_;
  std::vector<std::optional<PairsAction>> pairs_;
};

/// Of a region.
class AllowedWrenches {
 public:
  AllowedWrenches(const Law& law, const MotionRegion& region, const PullRule* pull);

  /// The one with the most work on y.
  std::optional<AllowedWrench> worst(const Reals& y) const;
  /// The rule of the leaf for this twist, by rounded numbers and a bound on their errors;
  /// nothing if they do not decide. In space they only say no.
  std::optional<bool> are_refuted_by(const Row& y) const;
  /// What springs do along the region's lines.
  const SpringLines& lines() const { return lines_; }
  /// Wrenches that add up to 0 are those of springs alone, at infinity, which is taken note of;
  /// false if it was known or is not so.
  bool are_of_springs(const NearestWrench<Reals, AllowedWrench>& found);
  /// Of wrenches that add up to 0.
  Relaxation combine(const NearestWrench<Reals, AllowedWrench>& found) const;

 private:
  Reals load_at(std::size_t generator, const Reals& y) const;
  void balance_along_lines(Relaxation& relaxed, const Reals& wrench) const;
  bool are_small(const std::vector<Row>& points) const;
  const std::vector<double>& sizes() const;

  const Law& law_;
  const MotionRegion& region_;
  SpringLines lines_;
  std::vector<double> scales_;
  std::vector<Reals> against_;         ///< of AllowedWrench::against
  mutable std::vector<double> sizes_;  ///< once they are needed
  bool may_certify_;                   ///< whether the errors of doubles are bounded
};

}  // namespace stickslip::search_detail
