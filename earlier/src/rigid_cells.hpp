// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The rigid-body model (load_classes.hpp) cell by cell: where it is known of each contact on
/// which sides of 0 its N.a and T.a are, the model is linear.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "most_power.hpp"
#include "stickslip/earlier/load_classes.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::earlier_detail {

/// By what all friction is multiplied: from low to high, or without an end.
struct FrictionRange {
  Rational low = 1;
  std::optional<Rational> high = Rational(1);
};

/// A motion with forces, as a linear program finds them.
struct CellPoint {
  Twist acceleration;
  std::vector<ContactForce> forces;  ///< by ContactId
};

/// A set of accelerations and forces, closed and convex: each contact is in one of these
/// conditions, in those that it is not known to be in it is relaxed.
class RigidCell {
 public:
  enum class Slip {
    kUnknown,
    kPlus,   ///< T.a >= 0, force on the edge N - mu T
    kMinus,  ///< T.a <= 0, force on the edge N + mu T
    kNone    ///< T.a = 0
  };

  /// Of which nothing is known.
  explicit RigidCell(const Problem& problem)
      : touch_(problem.size(), Touch::kUnknown), slip_(problem.size(), Slip::kUnknown) {}

  /// The cells of this split, which cover all solutions of the model in this one.
  std::vector<RigidCell> children(const Problem& problem, const RigidSplit& split) const;

  Touch touch(std::size_t contact) const { return touch_[contact]; }
  Slip slip(std::size_t contact) const { return slip_[contact]; }

  /// A split at a contact where the point breaks the model, if there is one: at all factors in
  /// the range. None is left only where all that it breaks is known.
  std::optional<RigidSplit> split_for(const Problem& problem, const CellPoint& point,
                                      const Rational& least_friction) const;

 private:
  std::vector<Touch> touch_;
  std::vector<Slip> slip_;
};

/// The accelerations and forces of a cell that obey Newton's law, as a linear program. Its
/// variables are a, one for each edge of a cone, and more that are added behind them.
class CellProgram {
 public:
  CellProgram(const Problem& problem, const Inertia& inertia, const RigidCell& cell,
              const FrictionRange& friction = {});

  /// With the load growing by l u, l a new variable; returns its index.
  std::size_t add_growth(const Wrench& u);
  /// The program, to be extended and solved. Balance is in its last rows but those added.
  LinearProgram program() const;

  /// A point with w.a > 0, of the greatest w.a if there is one; or the leaf that refutes all.
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
  std::vector<std::optional<std::size_t>> slip_rows_;  ///< by contact; its normal's is its own
  std::array<std::vector<Rational>, 3> balance_;
};

/// What became of a search for accelerations along which the load does work.
struct AccelerationSearch {
  std::vector<RigidNode> tree;     ///< if there are none: why, for all factors of the range
  std::optional<CellPoint> found;  ///< a solution of the model, if the range is one factor
  bool limited = false;            ///< neither, within the limit
};

AccelerationSearch search_accelerations(const Problem& problem, const Inertia& inertia,
                                        const FrictionRange& friction,
                                        std::size_t most_programs);

}  // namespace stickslip::earlier_detail
