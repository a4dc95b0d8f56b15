// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The rigid-body model in space cell by cell, as rigid_cells.hpp in the plane: in a cell it is
/// relaxed to a linear program.
#pragma once

#include <optional>
#include <vector>

#include "friction_disc.hpp"
#include "most_power.hpp"
#include "stickslip/earlier/load_classes.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::earlier_detail {

/// The contacts of a point in space.
std::vector<FrictionDisc> discs_of(const GraspBox& grasp);
/// The load.
Vector6 load_of(const GraspBox& grasp);

/// What is known of a contact.
struct SpatialLabel {
  enum class Slip {
    kUnknown,
    kNone,    ///< S a = 0
    kSector,  ///< S a in `sector` of contact `owner`, friction against directions of it
    kLine     ///< S a a multiple >= 0 of `line`, friction against that
  };
  Touch touch = Touch::kUnknown;
  Slip slip = Slip::kUnknown;
  Sector sector{};
  std::size_t owner = 0;
  Vector3 line{};
};
/// By contact.
using SpatialCell = std::vector<SpatialLabel>;

/// Which of the polygons around discs and in them.
enum class DiscPolygon { kOuter, kInner };

/// Accelerations and forces, by contact.
struct SpatialPoint {
  Vector6 acceleration;
  SpatialForces forces;
};

/// The accelerations and forces of a cell that obey Newton's law; without an inertia those at
/// rest.
class SpatialProgram {
 public:
  /// Requires kLine of no contact whose friction is not rational.
  SpatialProgram(const std::vector<FrictionDisc>& discs, const Vector6& load,
                 const Inertia* inertia, const SpatialCell& cell, DiscPolygon polygon);

  /// Forces at rest, or none; then the twist that proves it is in `twist`.
  std::optional<SpatialForces> at_rest(Vector6& twist) const;
  /// A point with w.a > 0, of the greatest w.a if there is one; or the leaf that refutes all.
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
  /// Of a contact's N.a, or of its slip along a covector.
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

/// What became of a search for accelerations along which the load does work.
struct SpatialSearchResult {
  std::vector<RigidNode> tree;         ///< if there are none: why
  std::optional<SpatialPoint> found;   ///< a solution of the model
  std::optional<Undecided> undecided;  ///< neither
};

SpatialSearchResult search_spatial_accelerations(std::vector<FrictionDisc>& discs,
                                                 const Vector6& load, const Inertia& inertia,
                                                 std::size_t most_programs);

/// Whether these are a solution of the model, exactly; with an acceleration of 0, forces at
/// rest.
bool is_solution(const std::vector<FrictionDisc>& discs, const Vector6& load,
                 const Inertia& inertia, const SpatialPoint& point);

}  // namespace stickslip::earlier_detail
