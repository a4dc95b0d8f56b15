// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The rigid-body model (load_classes.hpp) cell by cell. The model is linear in a cell, where
/// each contact's N.a and T.a are known to be on one side of 0.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "most_power.hpp"
#include "stickslip/earlier/load_classes.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::earlier_detail {

/// The factors of all friction, from low to high, or without an end.
struct FrictionRange {
  Rational low = 1;
  std::optional<Rational> high = Rational(1);
};

/// A motion with forces, as a linear program finds them.
struct CellPoint {
  Twist acceleration;
  std::vector<ContactForce> forces;  ///< by ContactId
};

/// A closed and convex set of accelerations and forces. Each contact is in one of these
/// conditions; an unknown condition is relaxed.
class RigidCell {
 public:
  enum class Slip {
    kUnknown,
    kPlus,   ///< T.a >= 0, force on the edge N - mu T
    kMinus,  ///< T.a <= 0, force on the edge N + mu T
    kNone    ///< T.a = 0
  };

  /// Makes the cell of which nothing is known.
  explicit RigidCell(const Problem& problem)
      : touch_(problem.size(), Touch::kUnknown), slip_(problem.size(), Slip::kUnknown) {}

  /// Returns the cells of this split, which cover all solutions of the model in this one.
  std::vector<RigidCell> children(const Problem& problem, const RigidSplit& split) const;

  Touch touch(std::size_t contact) const { return touch_[contact]; }
  Slip slip(std::size_t contact) const { return slip_[contact]; }

  /// Returns a split at a contact where the point breaks the model at all factors in the range.
  /// Nothing only if all conditions that it breaks are known.
  std::optional<RigidSplit> split_for(const Problem& problem, const CellPoint& point,
                                      const Rational& least_friction) const;

 private:
  std::vector<Touch> touch_;
  std::vector<Slip> slip_;
};

/// The accelerations and forces of a cell that obey Newton's law, as a linear program. Its
/// variables are a, one for each edge of a cone, and any that are added behind them.
class CellProgram {
 public:
  CellProgram(const Problem& problem, const Inertia& inertia, const RigidCell& cell,
              const FrictionRange& friction = {});

  /// Lets the load grow by l u, with l a new variable; returns its index.
  std::size_t add_growth(const Wrench& u);
  /// Returns the program, to be extended and solved. Its last rows but added ones are balance.
  LinearProgram program() const;

  /// Returns a point with w.a > 0, of the greatest w.a if there is one; or the leaf that
  /// refutes all.
  std::variant<CellPoint, RigidLeaf> moving() const;

 private:
  CellPoint point(const std::vector<Rational>& x) const;
  RigidLeaf leaf(const NoPower& none) const;

  struct Edge {
    std::size_t contact;
    ContactForce force;
  };

  const Problem& problem_;
  LinearProgram program_;
  std::vector<Edge> edges_;
  std::vector<std::optional<std::size_t>> slip_rows_;  ///< by contact; the row of its normal
                                                       ///< has its own number
  std::array<std::vector<Rational>, 3> balance_;
};

/// The result of a search for accelerations along which the load does work.
struct AccelerationSearch {
  std::vector<RigidNode> tree;  ///< a proof that there are none, for all factors of the range
  std::optional<CellPoint> found;  ///< a solution of the model, if the range is one factor
  bool limited = false;            ///< whether the search found neither within the limit
};

AccelerationSearch search_accelerations(const Problem& problem, const Inertia& inertia,
                                        const FrictionRange& friction,
                                        std::size_t most_programs);

}  // namespace stickslip::earlier_detail
