// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Forces in doubles that nearly balance a load, made to balance it exactly.
#pragma once

#include <optional>
#include <vector>

#include "statics_model.hpp"

namespace stickslip::statics_detail {

/// A way in which the force of a cone may change: by a multiple of `change`, whose wrench is
/// `column`.
struct ForceChange {
  std::size_t cone;
  ConeForce change;
  SparseRow column;
  double weight;         ///< how far it may change
  bool is_edge = false;  ///< whether it goes along an edge of the cone, which the force is on
};

/// Rounded forces and the ways in which they may change.
class ForceRounding {
 public:
  /// Rounds forces to a grid of so many bits below the largest. Those that are within a part
  /// `border` of the border of their cone are put on it, and those of less than that part of
  /// the largest are 0.
  ForceRounding(const StaticsModel& model, const RationalRow& load,
                const ConeProposal& proposal, int bits, double border);

  /// Changes forces so that nearly nothing of the load is left, most where they are deep in
  /// their cones. What is left after it is smaller by many digits.
  void refine(const ConeSearch& search, int bits);
  /// Changes forces so that nothing of the load is left; returns whether it could.
  bool balance();
  /// Returns whether all forces are in their cones.
  bool is_lawful() const;
  const std::vector<ConeForce>& forces() const { return forces_; }  ///< by cone

 private:
  void add(std::size_t i, ConeForce change, double weight);
  void add_wrench(const ForceCone& cone, const ConeForce& force);
  void change_by(const ForceChange& change, const Rational& multiple);
  bool balance_by_tree();
  bool push(std::size_t body, std::size_t first, std::size_t rows,
            const std::vector<std::size_t>& changes,
            const std::vector<std::vector<std::size_t>>& touched,
            const std::vector<std::size_t>& place);

  const StaticsModel& model_;
  RationalRow left_;  ///< load and forces together
  std::vector<ConeForce> forces_;
  std::vector<ForceChange> changes_;
};

}  // namespace stickslip::statics_detail
