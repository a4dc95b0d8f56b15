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

/// The most work of a contact on a virtual twist, per unit of normal coefficient.
struct Action {
  double alpha = 0;    ///< the most work
  Double3 friction{};  ///< the f that does it
  std::size_t corner = 0;
};

/// The most work that all contacts of a region do on y. The region must outlive this.
class Actions {
 public:
  Actions(const Law& law, const MotionRegion& region, const Reals& y);

  /// Returns the most work of a contact at a generator.
  double work(std::size_t contact, std::size_t generator) const;
  /// Adds the most work of a contact at each generator.
  void add_work(std::size_t contact, std::vector<double>& works) const;
  /// Returns whether the force that does the most work there is not 0.
  bool acts(std::size_t contact, std::size_t generator) const;
  /// Returns whether errors of alpha change nothing in which rule bounds the contact.
  bool is_clear(std::size_t contact, double error) const;
  /// Returns whether the contact's force is surely 0 there, by exact zeros and signs.
  bool is_idle(std::size_t contact, std::size_t generator) const;
  /// Adds the force that does the most work to these sums.
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

/// The wrenches that a region allows.
class AllowedWrenches {
 public:
  AllowedWrenches(const Law& law, const MotionRegion& region, const PullRule* pull);

  /// Returns the one with the most work on y; nothing if nothing acts.
  std::optional<AllowedWrench> worst(const Reals& y) const;
  /// Applies the rule of the leaf to this twist, by rounded numbers and a bound on their
  /// errors. Returns nothing if they do not decide. They may only say no in space, of a family,
  /// and where errors are not bounded.
  std::optional<bool> are_refuted_by(const Row& y) const;
  /// Returns the wrenches of springs along the region's lines.
  const SpringLines& lines() const { return lines_; }
  /// Notes that wrenches which add up to 0 are those of springs alone, at infinity. Returns
  /// false if that was known or is not so.
  bool are_of_springs(const NearestWrench<Reals, AllowedWrench>& found);
  /// Returns the relaxed equilibrium of wrenches that add up to 0.
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
  std::vector<Reals> against_;         ///< wrenches with AllowedWrench::against
  mutable std::vector<double> sizes_;  ///< filled once they are needed
  bool may_certify_;                   ///< whether the errors of doubles are bounded
};

}  // namespace stickslip::search_detail
