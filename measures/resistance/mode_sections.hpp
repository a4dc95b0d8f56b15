// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The loads of a plane that modes resist, and the union of these sets.
///
/// *The set of one mode* is the section by the plane of a cone of dimension 4: rays of motions
/// times a polygon of friction (for classes that stick, of rank at most 2 beside d = 0), mapped
/// linearly to loads. If estimates tell the sides of its generators, and one triple of vertices
/// that does not lie on a line, the map is injective, and the section is known as a polygon
/// whose vertices are pairs of generators. Neighbours name their vertices alike. So an edge
/// between neighbours that do not overlap cancels, and its ends are never computed
/// (plane_cover.hpp). The rest are folds, and edges along which a neighbour is divided more
/// finely. Exact numbers decide if estimates do not; a section that is no such polygon is the
/// hull of exact points.
#pragma once

#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "mode_image.hpp"
#include "plane_cover.hpp"
#include "tight_planes.hpp"

namespace stickslip::resistance_detail {

/// The known sign of a contact's separation, or of a class's slip.
enum class Known : std::int8_t { kNegative = -1, kZero = 0, kPositive = 1, kNothing = 2 };

/// The motions between planes, with what splits have said about them. A mode is a region that
/// no plane cuts: everything that forces depend on is known.
struct WalkedRegion {
  std::vector<RayIndex> rays;
  std::vector<PlaneIndex> facets;  ///< the facets, and perhaps other planes that do not cut the
                                   ///< region
  std::vector<Known> separations;  ///< by contact: kPositive is closed, kNegative open
  std::vector<Known> slips;        ///< by class: kZero sticks

  friend bool operator<(const WalkedRegion& a, const WalkedRegion& b) {
    return std::tie(a.rays, a.separations, a.slips) < std::tie(b.rays, b.separations, b.slips);
  }
};

/// The sections of one mode after another, counted by their borders and, if asked for, kept as
/// pieces.
class ModeSections {
 public:
  /// The arguments must outlive this.
  ModeSections(const MotionRays& rays, ModeImages& images, bool with_pieces,
               ResistibleWork& work)
      : rays_(rays), images_(images), with_pieces_(with_pieces), work_(work) {}

  void add(const WalkedRegion& mode);
  /// Records that some motion but 0 has no force.
  void add_free_motion() { some_motion_is_free_ = true; }
  /// Adds the wrenches that are resisted without moving.
  void add_still(const PlaneCell& cell);

  /// Returns the union of all that was added.
  ResistibleSet united();

 private:
  /// A number for each contact: 2 without a force, else its slip; 0 also without friction.
  using ForceModes = std::vector<int>;

  /// A vertex of a section: generators on either side of the plane, the positive one first.
  using SectionVertex = std::pair<GeneratorIndex, GeneratorIndex>;

  bool add_polygon(const std::vector<GeneratorIndex>& generators,
                   const std::vector<TightPlanes>& on, const std::vector<int>& sides,
                   std::size_t facets);
  std::optional<PlaneCell> hull(const std::vector<GeneratorIndex>& generators);
  ForceModes modes_of(const WalkedRegion& mode) const;
  void add_piece(const ForceModes& modes, const PlaneCell& cell);
  bool is_at_infinity(const SectionVertex& v) const;
  int turn_of(const std::vector<SectionVertex>& polygon);
  const HomogeneousPoint& exact(const SectionVertex& vertex);

  const MotionRays& rays_;
  ModeImages& images_;
  const bool with_pieces_;
  ResistibleWork& work_;
  bool some_motion_is_free_ = false;
  /// Cells to the left less cells to the right, by edge, with the lesser end first.
  std::map<std::pair<SectionVertex, SectionVertex>, int> borders_;
  std::vector<std::pair<SectionVertex, SectionVertex>> arcs_;
  std::map<SectionVertex, HomogeneousPoint> exact_vertices_;
  PlaneCover cover_;  ///< the cells that are known exactly
  std::map<ForceModes, std::vector<HomogeneousPoint>> pieces_;  ///< the generators of pieces
};

}  // namespace stickslip::resistance_detail
