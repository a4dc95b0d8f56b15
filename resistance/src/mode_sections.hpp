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
#include <utility>
#include <vector>

#include "mode_image.hpp"
#include "plane_cover.hpp"
#include "tight_planes.hpp"

namespace stickslip::resistance_detail {

/// What is known of a contact's separation, or of a class's slip.
enum class Known : std::int8_t { kNegative = -1, kZero = 0, kPositive = 1, kNothing = 2 };

/// The sections of one mode after another, counted by their borders.
class ModeSections {
 public:
  /// All must outlive this.
  ModeSections(const MotionRays& rays, ModeImages& images, ResistibleWork& work)
      : rays_(rays), images_(images), work_(work) {}

  /// A mode: the rays of its motions; planes that do not cut it, its facets among them; and the
  /// slips of classes, kZero where they stick with friction.
  void add(const std::vector<RayIndex>& rays, const std::vector<PlaneIndex>& planes,
           const std::vector<Known>& slips);
  /// Some motion but 0 has no force.
  void add_free_motion() { some_motion_is_free_ = true; }
  /// What else is resisted.
  void add(const PlaneCell& cell) { cover_.add(cell); }

  /// All of it.
  PlaneUnion united();

 private:
  /// A vertex of a section: generators on either side of the plane, the positive one first.
  using SectionVertex = std::pair<GeneratorIndex, GeneratorIndex>;

  bool add_polygon(const std::vector<GeneratorIndex>& generators,
                   const std::vector<TightPlanes>& on, const std::vector<int>& sides,
                   std::size_t facets);
  bool add_hull(const std::vector<GeneratorIndex>& generators);
  bool is_at_infinity(const SectionVertex& v) const;
  int turn_of(const std::vector<SectionVertex>& polygon);
  const HomogeneousPoint& exact(const SectionVertex& vertex);

  const MotionRays& rays_;
  ModeImages& images_;
  ResistibleWork& work_;
  bool some_motion_is_free_ = false;
  /// Edges, the less end first: cells to the left less cells to the right.
  std::map<std::pair<SectionVertex, SectionVertex>, int> borders_;
  std::vector<std::pair<SectionVertex, SectionVertex>> arcs_;
  std::map<SectionVertex, HomogeneousPoint> exact_vertices_;
  PlaneCover cover_;  ///< what is known exactly
};

}  // namespace stickslip::resistance_detail
