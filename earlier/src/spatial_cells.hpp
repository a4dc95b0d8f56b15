// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The rigid-body model in space cell by cell, as rigid_cells.hpp has it in the plane: in a
/// cell it is relaxed to a linear program.
#pragma once

#include <optional>
#include <vector>

#include "friction_disc.hpp"
#include "most_power.hpp"
#include "stickslip/earlier/load_classes.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::earlier_detail {

/// Returns the contacts of a grasp in space without uncertain numbers.
std::vector<FrictionDisc> discs_of(const GraspBox& grasp);
/// Returns the load.
Vector6 load_of(const GraspBox& grasp);

/// The known state of a contact.
struct SpatialLabel {
  enum class Slip {
    kUnknown,
    kNone,    ///< S a = 0
    kSector,  ///< S a is in `sector` of contact `owner`, friction against directions of the
              ///< sector
    kLine     ///< S a is a multiple >= 0 of `line`, friction against that
  };
  Touch touch = Touch::kUnknown;
  Slip slip = Slip::kUnknown;
  Sector sector{};
  std::size_t owner = 0;
  Vector3 line{};
};
/// The states by contact.
using SpatialCell = std::vector<SpatialLabel>;

/// The polygons around discs or in them.
enum class DiscPolygon { kOuter, kInner };

/// Accelerations and forces, by contact.
struct SpatialPoint {
  Vector6 acceleration;
  SpatialForces forces;
};

/// The accelerations and forces of a cell that obey Newton's law; without an inertia the forces
/// at rest.
class SpatialProgram {
 public:
  /// Requires that no contact is kLine unless its friction is rational.
  SpatialProgram(const std::vector<FrictionDisc>& discs, const Vector6& load,
                 const Inertia* inertia, const SpatialCell& cell, DiscPolygon polygon);

  /// Returns forces at rest; or nothing, and the twist that proves it in `twist`.
  std::optional<SpatialForces> at_rest(Vector6& twist) const;
  /// Returns a point with w.a > 0, of the greatest w.a if there is one; or the leaf that
  /// refutes all.
  std::variant<SpatialPoint, RigidLeaf> moving() const;

 private:
  void add_edge(std::size_t contact, const Vector3& friction);
  void add_row(const Vector6& row, Relation relation);
  SpatialPoint point(const std::vector<Rational>& x) const;
  RigidLeaf leaf(const NoPower& none) const;

  struct Edge {
    std::size_t contact;
    Vector3 friction;
  };
  /// The meaning of a row: a contact's N.a, or its slip along a covector.
  struct SpatialRowOf {
    std::size_t contact;
    std::optional<Vector3> along;
  };

  const std::vector<FrictionDisc>& discs_;
  const Vector6& load_;
  std::size_t motions_;  ///< 6, or 0 at rest
  LinearProgram program_;
  std::vector<Edge> edges_;
  std::vector<SpatialRowOf> rows_;
  std::array<std::vector<Rational>, 6> balance_;
};

/// The result of a search for accelerations along which the load does work.
struct SpatialSearchResult {
  std::vector<RigidNode> tree;         ///< a proof that there are none
  std::optional<SpatialPoint> found;   ///< a solution of the model
  std::optional<Undecided> undecided;  ///< why the search found neither
};

SpatialSearchResult search_spatial_accelerations(std::vector<FrictionDisc>& discs,
                                                 const Vector6& load, const Inertia& inertia,
                                                 std::size_t most_programs);

/// Returns true if the point is exactly a solution of the model; with an acceleration of 0, if
/// its forces are a solution at rest.
bool is_solution(const std::vector<FrictionDisc>& discs, const Vector6& load,
                 const Inertia& inertia, const SpatialPoint& point);

}  // namespace stickslip::earlier_detail
