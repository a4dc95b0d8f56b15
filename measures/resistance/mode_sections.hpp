// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What modes resist in a plane, and the union of it.
///
/// *What a mode resists* is the section by the plane of a cone of dimension 4: rays of motions
/// times a polygon of friction (for classes that stick, of rank at most 2 beside d = 0), mapped
/// linearly to loads. Where estimates tell the sides of its generators, and one triple of
/// vertices that does not lie on a line, the map is injective, and the section is known as a
/// polygon whose vertices are pairs of generators. Neighbours name theirs alike. So an edge
/// between neighbours that do not overlap goes without that its ends are computed
/// (plane_cover.hpp): what is left are folds, and where a neighbour is divided more finely.
/// What estimates do not tell, exact numbers do; a section that is no such polygon is the hull
/// of exact points.
#pragma once

#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "mode_image.hpp"
#include "plane_cover.hpp"
#include "tight_planes.hpp"

namespace stickslip::resistance_detail {

/// What is known of a contact's separation, or of a class's slip.
enum class Known : std::int8_t { kNegative = -1, kZero = 0, kPositive = 1, kNothing = 2 };

/// Motions between planes, and what splits have said. Of a mode, which no plane cuts, all that
/// forces depend on is known.
struct WalkedRegion {
  std::vector<RayIndex> rays;
  std::vector<PlaneIndex> facets;  ///< and perhaps other planes that do not cut it
  std::vector<Known> separations;  ///< of contacts: kPositive is closed, kNegative open
  std::vector<Known> slips;        ///< of classes: kZero sticks

  friend bool operator<(const WalkedRegion& a, const WalkedRegion& b) {
    return std::tie(a.rays, a.separations, a.slips) < std::tie(b.rays, b.separations, b.slips);
  }
};

/// The sections of one mode after another, counted by their borders, and if asked for each as a
/// piece.
class ModeSections {
 public:
  /// All must outlive this.
  ModeSections(const MotionRays& rays, ModeImages& images, bool with_pieces,
               ResistibleWork& work)
      : rays_(rays), images_(images), with_pieces_(with_pieces), work_(work) {}

  void add(const WalkedRegion& mode);
  /// Some motion but 0 has no force.
  void add_free_motion() { some_motion_is_free_ = true; }
  /// What is resisted without moving.
  void add_still(const PlaneCell& cell);

  /// All of it.
  ResistibleSet united();

 private:
  /// By contact: 2 where it has no force, else its slip; 0 also without friction.
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
  /// Edges, the less end first: cells to the left less cells to the right.
  std::map<std::pair<SectionVertex, SectionVertex>, int> borders_;
  std::vector<std::pair<SectionVertex, SectionVertex>> arcs_;
  std::map<SectionVertex, HomogeneousPoint> exact_vertices_;
  PlaneCover cover_;                                            ///< what is known exactly
  std::map<ForceModes, std::vector<HomogeneousPoint>> pieces_;  ///< their generators
};

}  // namespace stickslip::resistance_detail
