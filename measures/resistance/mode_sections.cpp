// SPDX-License-Identifier: GPL-3.0-or-later
#include "mode_sections.hpp"

#include <algorithm>
#include <set>

#include "friction_polygon.hpp"
#include "stickslip/core/cancellation.hpp"

namespace stickslip::resistance_detail {
namespace {

/// Returns the vertices of the polygon of friction of classes that stick, in order round it:
/// each with the signs of the classes.
std::vector<FrictionSigns> friction_polygon(const MotionRays& rays,
                                            const std::vector<std::size_t>& sticking) {
  if (sticking.empty()) return {{}};
  if (sticking.size() == 1) return {{-1}, {1}};
  std::vector<IntegerVector3> tangents;
  for (const std::size_t c : sticking) tangents.push_back(rays.classes()[c].tangent);
  const std::vector<PolygonStep> steps =
      half_way_round(tangents, cross(tangents[0], tangents[1]));
  FrictionSigns at(sticking.size());
  for (const auto& [k, end] : steps) at[k] = static_cast<std::int8_t>(-end);
  std::vector<FrictionSigns> vertices;
  for (int half = 0; half < 2; ++half) {
    for (const auto& [k, end] : steps) {
      vertices.push_back(at);
      at[k] = static_cast<std::int8_t>(-at[k]);
    }
  }
  return vertices;
}

/// Returns the vertices in order, if the edges are one cycle through all; else nothing.
std::vector<std::size_t> cycle_of(const std::set<std::pair<std::size_t, std::size_t>>& edges,
                                  std::size_t vertices) {
  if (vertices < 3 || edges.size() != vertices) return {};
  std::vector<std::vector<std::size_t>> next(vertices);
  for (const auto& [a, b] : edges) {
    next[a].push_back(b);
    next[b].push_back(a);
  }
  std::vector<std::size_t> cycle{0};
  std::size_t before = 0;
  for (std::size_t at = 0; cycle.size() <= vertices;) {
    if (next[at].size() != 2) return {};
    const std::size_t to = next[at][0] != before || at == 0 ? next[at][0] : next[at][1];
    if (to == 0) break;
    before = at;
    at = to;
    cycle.push_back(at);
  }
  if (cycle.size() != vertices) return {};
  return cycle;
}

}  // namespace

void ModeSections::add(const WalkedRegion& mode) {
  const auto& [rays, planes, separations, slips] = mode;
  std::vector<std::size_t> sticking;
  for (std::size_t c = 0; c < slips.size(); ++c) {
    if (slips[c] == Known::kZero) sticking.push_back(c);
  }
  const std::vector<FrictionSigns> friction = friction_polygon(rays_, sticking);
  std::map<GeneratorIndex, TightPlanes> tight;
  for (const RayIndex ray : rays) {
    const TightPlanes on_planes = tight_at(rays_, ray, planes, friction.size());
    for (std::size_t k = 0; k < friction.size(); ++k) {
      FrictionSigns signs;
      for (const std::uint32_t c : rays_[ray].sticking) {
        const auto found = std::lower_bound(sticking.begin(), sticking.end(), c);
        signs.push_back(found != sticking.end() && *found == c
                            ? friction[k][static_cast<std::size_t>(found - sticking.begin())]
                            : static_cast<std::int8_t>(slips[c]));
      }
      TightPlanes on = on_planes;
      if (friction.size() > 1) on.insert(planes.size() + k);
      if (friction.size() > 2) on.insert(planes.size() + (k + 1) % friction.size());
      const auto [at, is_new] = tight.emplace(images_.index_of(ray, signs), on);
      if (!is_new) at->second |= on;
    }
  }
  std::vector<GeneratorIndex> generators;
  std::vector<TightPlanes> on;
  std::vector<int> sides;
  for (auto& [g, bits] : tight) {
    generators.push_back(g);
    on.push_back(std::move(bits));
    sides.push_back(images_.side(g));
  }
  const auto has = [&](int side) {
    return std::find(sides.begin(), sides.end(), side) != sides.end();
  };
  if (!has(0) && !(has(1) && has(-1))) return;
  const bool is_polygon =
      !has(0) && add_polygon(generators, on, sides, planes.size() + friction.size());
  if (is_polygon) ++work_.pieces;
  if (is_polygon && !with_pieces_) return;
  const std::optional<PlaneCell> cell = hull(generators);
  if (!cell) return;
  if (!is_polygon) {
    ++work_.pieces;
    ++work_.exact_sections;
    cover_.add(*cell);
  }
  add_piece(modes_of(mode), *cell);
}

ModeSections::ForceModes ModeSections::modes_of(const WalkedRegion& mode) const {
  ForceModes modes;
  for (std::size_t i = 0; i < mode.separations.size(); ++i) {
    const std::size_t c = rays_.class_of(i);
    modes.push_back(mode.separations[i] != Known::kPositive ? 2
                    : c == MotionRays::kNoClass
                        ? 0
                        : static_cast<int>(mode.slips[c]) * rays_.sense(i));
  }
  return modes;
}

void ModeSections::add_piece(const ForceModes& modes, const PlaneCell& cell) {
  if (!with_pieces_) return;
  std::vector<HomogeneousPoint>& all = pieces_[modes];
  for (HomogeneousPoint& g : cell.generators()) all.push_back(std::move(g));
}

void ModeSections::add_still(const PlaneCell& cell) {
  cover_.add(cell);
  const MotionRay& rest = rays_[rays_.rest()];
  ForceModes modes;
  for (PlaneIndex i = 0; i < rays_.slip(0); ++i) modes.push_back(rest.values[i] > 0 ? 0 : 2);
  add_piece(modes, cell);
}

/// Adds the section as a polygon. Returns false if it may not be one with the vertices and
/// edges that signs tell.
bool ModeSections::add_polygon(const std::vector<GeneratorIndex>& generators,
                               const std::vector<TightPlanes>& on,
                               const std::vector<int>& sides, std::size_t facets) {
  std::vector<SectionVertex> vertices;
  std::vector<TightPlanes> on_facets;
  for (std::size_t a = 0; a < generators.size(); ++a) {
    if (sides[a] < 0) continue;
    for (std::size_t b = 0; b < generators.size(); ++b) {
      if (sides[b] > 0 || !are_neighbours(on, a, b)) continue;
      vertices.emplace_back(generators[a], generators[b]);
      on_facets.push_back(on[a] & on[b]);
    }
  }
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (std::size_t f = 0; f < facets; ++f) {
    std::vector<std::size_t> ends;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      if (on_facets[v].contains(f)) ends.push_back(v);
    }
    // A plane that all vertices lie in is no facet.
    if (ends.size() == 2 && vertices.size() > 2) edges.emplace(ends[0], ends[1]);
    if (ends.size() > 2 && ends.size() < vertices.size()) return false;
  }
  const std::vector<std::size_t> cycle = cycle_of(edges, vertices.size());
  if (cycle.empty()) return false;
  std::vector<SectionVertex> polygon;
  for (const std::size_t v : cycle) polygon.push_back(vertices[v]);
  const int turn = turn_of(polygon);
  if (turn == 0) return false;
  if (turn < 0) std::reverse(polygon.begin(), polygon.end());
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const SectionVertex& from = polygon[k];
    const SectionVertex& to = polygon[(k + 1) % polygon.size()];
    if (is_at_infinity(from) && is_at_infinity(to)) {
      arcs_.emplace_back(from, to);
    } else {
      const bool ordered = from < to;
      borders_[ordered ? std::make_pair(from, to) : std::make_pair(to, from)] +=
          ordered ? 1 : -1;
    }
  }
  return true;
}

bool ModeSections::is_at_infinity(const SectionVertex& v) const {
  return rays_[images_.ray(v.first)].h == 0 && rays_[images_.ray(v.second)].h == 0;
}

/// Returns the turn of the vertices, left or right, by three that are not on one line; 0 if all
/// are on one.
int ModeSections::turn_of(const std::vector<SectionVertex>& polygon) {
  const std::size_t n = polygon.size();
  std::vector<std::array<NearNumber, 3>> near;
  for (const auto& [a, b] : polygon) {
    const std::array<NearNumber, 4>& high = images_.estimate(a);
    const std::array<NearNumber, 4>& low = images_.estimate(b);
    std::array<NearNumber, 3> v;
    for (const std::size_t j : {0, 1, 2}) {
      const std::size_t from = j == 2 ? 3 : j;
      v[j] = high[2] * low[from] - low[2] * high[from];
    }
    near.push_back(v);
  }
  for (std::size_t k = 0; k < n; ++k) {
    const auto& a = near[k];
    const auto& b = near[(k + 1) % n];
    const auto& c = near[(k + 2) % n];
    const NearNumber turn = a[0] * (b[1] * c[2] - b[2] * c[1]) -
                            a[1] * (b[0] * c[2] - b[2] * c[0]) +
                            a[2] * (b[0] * c[1] - b[1] * c[0]);
    const std::optional<int> sign = turn.sign();
    if (sign && *sign != 0) return *sign;
  }
  ++work_.exact_turns;
  for (std::size_t k = 0; k < n; ++k) {
    const int sign =
        determinant(exact(polygon[k]), exact(polygon[(k + 1) % n]), exact(polygon[(k + 2) % n]))
            .sign();
    if (sign != 0) return sign;
  }
  return 0;
}

const HomogeneousPoint& ModeSections::exact(const SectionVertex& vertex) {
  const auto [found, is_new] = exact_vertices_.emplace(vertex, HomogeneousPoint{});
  if (!is_new) return found->second;
  found->second =
      primitive(crossing(images_.exact(vertex.first), images_.exact(vertex.second)));
  return found->second;
}

/// Returns the section, by exact points; nothing if it is empty.
std::optional<PlaneCell> ModeSections::hull(const std::vector<GeneratorIndex>& generators) {
  std::set<IntegerVector4> images;
  for (const GeneratorIndex g : generators) images.insert(images_.exact(g));
  std::vector<HomogeneousPoint> points;
  add_section({images.begin(), images.end()}, points);
  if (std::all_of(points.begin(), points.end(), stickslip::is_at_infinity)) return std::nullopt;
  return PlaneCell::hull(std::move(points));
}

ResistibleSet ModeSections::united() {
  const IntegerVector4& none = images_.no_wrench();
  if (some_motion_is_free_ && none[2].is_zero()) {
    const PlaneCell point = PlaneCell::hull({{none[0], none[1], none[3]}});
    cover_.add(point);
    add_piece(ForceModes(rays_.slip(0), 2), point);
  }
  for (const auto& [ends, cells] : borders_) {
    throw_if_cancelled();
    if (cells == 0) continue;
    ++work_.borders;
    cover_.add_border({exact(ends.first), exact(ends.second)}, cells);
  }
  for (const auto& [from, to] : arcs_) {
    cover_.add_arc(direction_of(exact(from)), direction_of(exact(to)));
  }
  work_.exact_images = images_.exact_images();
  ResistibleSet result{cover_.covered(), {}};
  for (auto& [modes, generators] : pieces_) {
    ResistiblePiece& piece =
        result.pieces.emplace_back(ResistiblePiece{{}, PlaneCell::hull(std::move(generators))});
    for (const int mode : modes) {
      piece.modes.push_back({mode != 2, sign_of_int(mode == 2 ? 0 : mode)});
    }
  }
  return result;
}

}  // namespace stickslip::resistance_detail
