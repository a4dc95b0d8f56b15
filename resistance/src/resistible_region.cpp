// SPDX-License-Identifier: GPL-3.0-or-later
//
// *The walk.* From four cones that make up the space of motions, contacts are split as in a
// refutation (certificate/FORMAT.md, section 4), but only where that can matter: a slip class
// (contacts whose slip planes coincide) into slip +, none and slip -, while one of its contacts
// has friction and may be closed; a separation into closed and open. A region is left where
// bounds say that no load of its motions is in the plane: n, the load's coordinate across the
// plane, is bounded by friction anywhere between the edges of the cones and by contacts either
// closed or open where they may be either; the bound is convex, so that rays tell.
//
// *It misses nothing.* Let d be a motion with forces that balance a load of the plane, not 0,
// and say that a class sticks if its slip is 0 and a closed contact of it with friction has a
// force. Go down from a cone that has d: to "none" with a class that sticks, to a side that has
// d with one that does not, and at separations to a side that has d. Bounds hold for d, so no
// region on the way is left. Nor is a region whose sticking class cannot have a force, as that
// is where d does not go. At the end no plane of a contact that matters cuts the region; a
// class that sticks and was not split touches it in a face, from where the walk goes on with
// "none" (a face that it has not been to). What is found at the end, a mode, has d. The motion
// 0, in all of these faces, has its own place (still_cell.hpp), and so have motions without any
// force.
//
// *What a mode resists* is the section by the plane of a cone of dimension 4: rays of motions
// times a polygon of friction (for classes that stick, of rank at most 2 beside d = 0), mapped
// linearly to loads. Where estimates tell the sides of its generators, and one triple of
// vertices that does not lie on a line, the map is injective, and the section is known as a
// polygon whose vertices are pairs of generators. Neighbours name theirs alike. So an edge
// between neighbours that do not overlap goes without that its ends are computed
// (plane_cover.hpp): what is left are folds, and where a neighbour is divided more finely. What
// estimates do not tell, exact numbers do; a section that is no such polygon is the hull of
// exact points.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "generated_cone.hpp"
#include "mode_image.hpp"
#include "motion_ray.hpp"
#include "plane_cover.hpp"
#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/resistance/resistible_set.hpp"
#include "still_cell.hpp"

namespace stickslip {

using namespace resistance_detail;

namespace {

/// A set of small numbers.
class BitSet {
 public:
  explicit BitSet(std::size_t size) : words_((size + 63) / 64) {}
  void insert(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
  bool contains(std::size_t i) const { return (words_[i / 64] >> (i % 64) & 1) != 0; }
  bool is_in(const BitSet& other) const {
    for (std::size_t w = 0; w < words_.size(); ++w) {
      if ((words_[w] & ~other.words_[w]) != 0) return false;
    }
    return true;
  }
  BitSet& operator|=(const BitSet& other) {
    for (std::size_t w = 0; w < words_.size(); ++w) words_[w] |= other.words_[w];
    return *this;
  }
  friend BitSet operator&(BitSet a, const BitSet& b) {
    for (std::size_t w = 0; w < a.words_.size(); ++w) a.words_[w] &= b.words_[w];
    return a;
  }

 private:
  std::vector<std::uint64_t> words_;
};

/// What is known of a contact's separation, or of a class's slip.
enum class Known : std::int8_t { kNegative = -1, kZero = 0, kPositive = 1, kNothing = 2 };

/// Motions between planes, and what splits have said.
struct WalkedRegion {
  std::vector<RayIndex> rays;
  std::vector<PlaneIndex> facets;  ///< and perhaps other planes that do not cut it
  std::vector<Known> separations;  ///< of contacts: kPositive is closed, kNegative open
  std::vector<Known> slips;        ///< of classes: kZero sticks

  friend bool operator<(const WalkedRegion& a, const WalkedRegion& b) {
    return std::tie(a.rays, a.separations, a.slips) < std::tie(b.rays, b.separations, b.slips);
  }
};

/// The signs that occur, of rays of motions those of 0 apart.
struct RaySigns {
  bool positive = false;
  bool negative = false;
  bool zero_in_motion = false;  ///< at some motion but 0
};

/// A vertex of a section: generators on either side of the plane, the positive one first.
using SectionVertex = std::pair<GeneratorIndex, GeneratorIndex>;

class RegionFinder {
 public:
  RegionFinder(const Problem& problem, const WrenchPlane& plane,
               const ResistibleOptions& options, ResistibleWork& work)
      : bilateral_(problem.law() == NormalLaw::kBilateral),
        options_(options),
        work_(work),
        contacts_(problem.size()),
        rays_(problem),
        images_(problem, plane, rays_) {}

  /// False if the limit on modes was exceeded.
  bool find() {
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      WalkedRegion root;
      root.rays.push_back(rays_.rest());
      for (std::size_t a = 0; a < 4; ++a) {
        if (a == left_out) continue;
        root.rays.push_back(rays_.corner(a));
        for (std::size_t b = 0; b < a; ++b) {
          if (b != left_out) root.facets.push_back(rays_.wall(a, b));
        }
      }
      root.facets.push_back(rays_.infinity());
      root.separations.assign(contacts_, Known::kNothing);
      root.slips.assign(rays_.classes().size(), Known::kNothing);
      if (!visit(std::move(root))) return false;
    }
    return true;
  }

  PlaneUnion found() {
    if (auto cell = still_cell(rays_, images_)) cover_.add(*cell);
    const IntegerVector4& none = images_.no_wrench();
    if (some_motion_is_free_ && none[2].is_zero()) {
      cover_.add(PlaneCell::hull({{none[0], none[1], none[3]}}));
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
    return cover_.covered();
  }

 private:
  double value(RayIndex ray, PlaneIndex plane) const { return rays_[ray].values[plane]; }

  RaySigns signs(const WalkedRegion& region, PlaneIndex plane) const {
    RaySigns result;
    bool zero_h = false;
    bool zero_beside_rest = false;
    for (const RayIndex ray : region.rays) {
      const double v = value(ray, plane);
      if (v > 0) result.positive = true;
      if (v < 0) result.negative = true;
      if (v == 0) {
        zero_h = zero_h || rays_[ray].h > 0;
        zero_beside_rest = zero_beside_rest || ray != rays_.rest();
      }
    }
    result.zero_in_motion = zero_h && zero_beside_rest;
    return result;
  }

  /// Some motion but 0.
  bool has_motion(const WalkedRegion& region) const {
    const bool only_rest = region.rays.size() == 1 && region.rays.front() == rays_.rest();
    return !only_rest && std::any_of(region.rays.begin(), region.rays.end(),
                                     [&](RayIndex ray) { return rays_[ray].h > 0; });
  }

  /// The part where a plane that does not cut the region is 0.
  WalkedRegion face(const WalkedRegion& region, PlaneIndex plane) const {
    WalkedRegion result = region;
    result.rays.erase(std::remove_if(result.rays.begin(), result.rays.end(),
                                     [&](RayIndex ray) { return value(ray, plane) != 0; }),
                      result.rays.end());
    return result;
  }

  bool may_have_friction(const WalkedRegion& region, std::size_t slip_class) const {
    const std::vector<std::size_t>& contacts = rays_.classes()[slip_class].contacts;
    return std::any_of(contacts.begin(), contacts.end(), [&](std::size_t i) {
      return region.separations[i] != Known::kNegative;
    });
  }

  /// Closed is >= 0 throughout and > 0 somewhere. False if the region has no motion, or as the
  /// bilateral law allows none of it.
  bool settle_separations(WalkedRegion& region) const {
    for (std::size_t i = 0; i < contacts_; ++i) {
      if (region.separations[i] == Known::kNegative) continue;
      const RaySigns s = signs(region, rays_.separation(i));
      if (bilateral_ && s.negative && !s.positive) {
        region = face(region, rays_.separation(i));
        return has_motion(region) && settle_separations(region);
      }
      if (!s.positive) region.separations[i] = Known::kNegative;
      if (s.positive && !s.negative) region.separations[i] = Known::kPositive;
    }
    return has_motion(region);
  }

  /// Whether n < 0, or n > 0, for all loads of all its motions but those without force.
  bool is_beside_plane(const WalkedRegion& region) {
    for (const int side : {-1, 1}) {
      bool beside = true;
      bool free_motion = false;
      bool zero_with_force = false;
      for (const RayIndex ray : region.rays) {
        const NearNumber bound = largest_across(region, ray, side);
        const std::optional<int> sign = bound.sign();
        if (sign && *sign < 0) continue;
        if (!sign || *sign > 0) {
          beside = false;
          break;
        }
        const MotionRay& motion = rays_[ray];
        if (!motion.is_free) zero_with_force = true;
        if (motion.h > 0) {
          if (!motion.is_free) beside = false;
          free_motion = true;
        }
      }
      if (!beside || (free_motion && zero_with_force)) continue;
      some_motion_is_free_ = some_motion_is_free_ || free_motion;
      return true;
    }
    return false;
  }

  /// The largest side * n at a ray.
  NearNumber largest_across(const WalkedRegion& region, RayIndex ray, int side) const {
    const MotionRay& motion = rays_[ray];
    const auto turned = [&](const NearNumber& e) { return side > 0 ? e : -e; };
    NearNumber sum;
    if (motion.h != 0) sum = turned(images_.at_rest()[2]) * NearNumber{motion.h, kValueError};
    for (std::size_t i = 0; i < contacts_; ++i) {
      const double v = motion.values[rays_.separation(i)];
      if (v <= 0 || region.separations[i] == Known::kNegative) continue;
      const std::size_t c = rays_.class_of(i);
      const Known slip = c == MotionRays::kNoClass ? Known::kPositive : slips_now_[c];
      NearNumber across;
      if (slip == Known::kPositive || slip == Known::kNegative) {
        const int s = (slip == Known::kPositive ? 1 : -1) * rays_.sense(i);
        across = turned(images_.slipping(i, s > 0 ? 0 : 1)[2]);
      } else {
        const NearNumber a = turned(images_.slipping(i, 0)[2]);
        const NearNumber b = turned(images_.slipping(i, 1)[2]);
        across = {std::max(a.value, b.value), std::max(a.error, b.error)};
      }
      if (region.separations[i] == Known::kNothing && across.value < -across.error) continue;
      if (region.separations[i] == Known::kNothing && across.value < 0) {
        across = {0, across.error};
      }
      sum = sum + across * NearNumber{v, kValueError};
    }
    return sum;
  }

  /// What splits and rays say of the slips: a class that touches the region at motions is known
  /// only if a split says so.
  void find_slips(const WalkedRegion& region) {
    slips_now_ = region.slips;
    for (std::size_t c = 0; c < slips_now_.size(); ++c) {
      if (slips_now_[c] != Known::kNothing) continue;
      const RaySigns s = signs(region, rays_.slip(c));
      if (s.zero_in_motion || (s.positive && s.negative)) continue;
      slips_now_[c] = s.positive ? Known::kPositive : Known::kNegative;
    }
  }

  /// The plane that cuts the region and leaves n most open; nothing at a mode.
  std::optional<PlaneIndex> plane_to_split(const WalkedRegion& region) const {
    std::optional<PlaneIndex> best;
    double most = -1;
    const auto consider = [&](PlaneIndex plane, double weight) {
      if (best && !(weight > most)) return;
      best = plane;
      most = weight;
    };
    std::vector<double> largest(contacts_, 0);
    for (std::size_t i = 0; i < contacts_; ++i) {
      if (region.separations[i] == Known::kNegative) continue;
      double above = 0;
      double below = 0;
      for (const RayIndex ray : region.rays) {
        const double v = value(ray, rays_.separation(i));
        above = std::max(above, v);
        below = std::max(below, -v);
      }
      largest[i] = above;
      if (region.separations[i] != Known::kNothing) continue;
      const double across = std::max(std::fabs(images_.slipping(i, 0)[2].value),
                                     std::fabs(images_.slipping(i, 1)[2].value));
      consider(rays_.separation(i), std::min(above, below) * across);
    }
    for (std::size_t c = 0; c < region.slips.size(); ++c) {
      if (region.slips[c] != Known::kNothing || !may_have_friction(region, c)) continue;
      const RaySigns s = signs(region, rays_.slip(c));
      if (!s.positive || !s.negative) continue;
      double weight = 0;
      for (const std::size_t i : rays_.classes()[c].contacts) {
        weight += largest[i] *
                  std::fabs(images_.slipping(i, 0)[2].value - images_.slipping(i, 1)[2].value);
      }
      consider(rays_.slip(c), weight);
    }
    return best;
  }

  /// False if the limit on modes was exceeded.
  bool visit(WalkedRegion region) {
    throw_if_cancelled();
    ++work_.nodes;
    if (!settle_separations(region)) return true;
    for (std::size_t c = 0; c < region.slips.size(); ++c) {
      if (region.slips[c] == Known::kZero && !may_have_friction(region, c)) return true;
    }
    find_slips(region);
    if (is_beside_plane(region)) return true;
    const std::optional<PlaneIndex> plane = plane_to_split(region);
    if (!plane) return visit_mode(std::move(region));
    std::vector<BitSet> tight;
    for (const RayIndex ray : region.rays) tight.push_back(tight_at(ray, region.facets));
    std::vector<RayIndex> on;
    WalkedRegion above = region;
    WalkedRegion below = region;
    above.rays.clear();
    below.rays.clear();
    for (std::size_t a = 0; a < region.rays.size(); ++a) {
      const double at_a = value(region.rays[a], *plane);
      if (at_a == 0) on.push_back(region.rays[a]);
      if (at_a > 0) above.rays.push_back(region.rays[a]);
      if (at_a < 0) below.rays.push_back(region.rays[a]);
      if (!(at_a > 0)) continue;
      for (std::size_t b = 0; b < region.rays.size(); ++b) {
        if (!(value(region.rays[b], *plane) < 0) || !are_neighbours(tight, a, b)) continue;
        on.push_back(rays_.between(region.rays[a], region.rays[b], *plane));
      }
    }
    WalkedRegion between = region;
    between.rays = on;
    above.rays.insert(above.rays.end(), on.begin(), on.end());
    below.rays.insert(below.rays.end(), on.begin(), on.end());
    const bool is_slip = *plane >= rays_.slip(0);
    const std::size_t index = is_slip ? *plane - rays_.slip(0) : *plane;
    std::vector<Known>& of_above = is_slip ? above.slips : above.separations;
    std::vector<Known>& of_below = is_slip ? below.slips : below.separations;
    of_above[index] = Known::kPositive;
    of_below[index] = Known::kNegative;
    for (WalkedRegion* part : {&above, &below, &between}) {
      if (part != &between) part->facets.push_back(*plane);
      drop_far_planes(*part);
    }
    region = {};
    if (!visit(std::move(above))) return false;
    if ((is_slip || !bilateral_) && !visit(std::move(below))) return false;
    if (!is_slip) return true;
    between.slips[index] = Known::kZero;
    return visit(std::move(between));
  }

  BitSet tight_at(RayIndex ray, const std::vector<PlaneIndex>& planes) const {
    BitSet result(planes.size());
    for (std::size_t k = 0; k < planes.size(); ++k) {
      if (value(ray, planes[k]) == 0) result.insert(k);
    }
    return result;
  }

  /// By the combinatorial test (cone.cpp): no third ray is on all planes that both are on.
  static bool are_neighbours(const std::vector<BitSet>& tight, std::size_t a, std::size_t b) {
    const BitSet shared = tight[a] & tight[b];
    for (std::size_t c = 0; c < tight.size(); ++c) {
      if (c != a && c != b && shared.is_in(tight[c])) return false;
    }
    return true;
  }

  /// Facets have a ray on them.
  void drop_far_planes(WalkedRegion& region) const {
    std::vector<PlaneIndex>& planes = region.facets;
    planes.erase(std::remove_if(planes.begin(), planes.end(),
                                [&](PlaneIndex plane) {
                                  return std::none_of(
                                      region.rays.begin(), region.rays.end(),
                                      [&](RayIndex ray) { return value(ray, plane) == 0; });
                                }),
                 planes.end());
  }

  /// A region that no plane cuts any more. False if the limit on modes was exceeded.
  bool visit_mode(const WalkedRegion& region) {
    ++work_.modes;
    if (options_.mode_limit != 0 && work_.modes > options_.mode_limit) return false;
    if (options_.progress) options_.progress(work_.modes);
    std::vector<Known> slips = region.slips;
    std::vector<WalkedRegion> faces;
    std::vector<std::size_t> sticking;
    for (std::size_t c = 0; c < slips.size(); ++c) {
      if (!may_have_friction(region, c)) continue;
      if (slips[c] == Known::kNothing) {
        const RaySigns s = signs(region, rays_.slip(c));
        slips[c] = s.positive ? Known::kPositive : s.negative ? Known::kNegative : Known::kZero;
        if (slips[c] != Known::kZero && s.zero_in_motion) {
          faces.push_back(face(region, rays_.slip(c)));
          faces.back().slips[c] = Known::kZero;
        }
      }
      if (slips[c] == Known::kZero) sticking.push_back(c);
    }
    add_section(region, slips, sticking);
    for (WalkedRegion& part : faces) {
      if (!settle_separations(part)) continue;
      std::sort(part.rays.begin(), part.rays.end());
      if (faces_seen_.insert(part).second && !visit(std::move(part))) return false;
    }
    return true;
  }

  /// The vertices of the friction of classes that stick, in order round the polygon that it is:
  /// each with the signs of the classes.
  std::vector<FrictionSigns> friction_polygon(const std::vector<std::size_t>& sticking) const {
    if (sticking.empty()) return {{}};
    if (sticking.size() == 1) return {{-1}, {1}};
    // Turned into one half of the plane that their tangents span, and sorted by angle.
    const auto tangent = [&](std::size_t k) { return rays_.classes()[sticking[k]].tangent; };
    const IntegerVector3 normal = cross(tangent(0), tangent(1));
    const auto turn = [&](std::size_t a, std::size_t b) {
      return dot(cross(tangent(a), tangent(b)), normal).sign();
    };
    std::vector<std::int8_t> turned(sticking.size(), 1);
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < sticking.size(); ++k) {
      order.push_back(k);
      if (turn(0, k) < 0) turned[k] = -1;
    }
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return turned[a] * turned[b] * turn(a, b) > 0;
    });
    FrictionSigns at(sticking.size());
    for (std::size_t k = 0; k < at.size(); ++k) at[k] = static_cast<std::int8_t>(-turned[k]);
    std::vector<FrictionSigns> vertices;
    for (int half = 0; half < 2; ++half) {
      for (const std::size_t k : order) {
        vertices.push_back(at);
        at[k] = static_cast<std::int8_t>(-at[k]);
      }
    }
    return vertices;
  }

  /// What the mode resists in the plane.
  void add_section(const WalkedRegion& region, const std::vector<Known>& slips,
                   const std::vector<std::size_t>& sticking) {
    const std::vector<FrictionSigns> friction = friction_polygon(sticking);
    const std::size_t planes = region.facets.size();
    std::map<GeneratorIndex, BitSet> tight;
    for (const RayIndex ray : region.rays) {
      const BitSet on_planes = tight_at(ray, region.facets);
      for (std::size_t k = 0; k < friction.size(); ++k) {
        FrictionSigns signs;
        for (const std::uint32_t c : rays_[ray].sticking) {
          const auto found = std::lower_bound(sticking.begin(), sticking.end(), c);
          signs.push_back(found != sticking.end() && *found == c
                              ? friction[k][static_cast<std::size_t>(found - sticking.begin())]
                              : static_cast<std::int8_t>(slips[c]));
        }
        BitSet on(planes + friction.size());
        for (std::size_t p = 0; p < planes; ++p) {
          if (on_planes.contains(p)) on.insert(p);
        }
        if (friction.size() > 1) on.insert(planes + k);
        if (friction.size() > 2) on.insert(planes + (k + 1) % friction.size());
        const auto [at, is_new] = tight.emplace(images_.index_of(ray, signs), on);
        if (!is_new) at->second |= on;
      }
    }
    std::vector<GeneratorIndex> generators;
    std::vector<BitSet> on;
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
    if (!has(0) && add_polygon(generators, on, sides, planes + friction.size())) {
      ++work_.pieces;
      return;
    }
    if (add_hull(generators)) ++work_.pieces;
  }

  /// False if the section may not be a polygon with the vertices and edges that signs tell.
  bool add_polygon(const std::vector<GeneratorIndex>& generators, const std::vector<BitSet>& on,
                   const std::vector<int>& sides, std::size_t facets) {
    std::vector<SectionVertex> vertices;
    std::vector<BitSet> on_facets;
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
      // All of them: not a facet but a plane that all lies in.
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

  /// The vertices in order, if the edges are one cycle through all; else nothing.
  static std::vector<std::size_t> cycle_of(
      const std::set<std::pair<std::size_t, std::size_t>>& edges, std::size_t vertices) {
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

  bool is_at_infinity(const SectionVertex& v) const {
    return rays_[images_.ray(v.first)].h == 0 && rays_[images_.ray(v.second)].h == 0;
  }

  /// Whether the vertices turn left or right, as three of them do that are not on one line; 0
  /// if all are.
  int turn_of(const std::vector<SectionVertex>& polygon) {
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
      const int sign = determinant(exact(polygon[k]), exact(polygon[(k + 1) % n]),
                                   exact(polygon[(k + 2) % n]))
                           .sign();
      if (sign != 0) return sign;
    }
    return 0;
  }

  const HomogeneousPoint& exact(const SectionVertex& vertex) {
    const auto [found, is_new] = exact_vertices_.emplace(vertex, HomogeneousPoint{});
    if (!is_new) return found->second;
    const IntegerVector4& high = images_.exact(vertex.first);
    const IntegerVector4& low = images_.exact(vertex.second);
    for (const std::size_t j : {0, 1, 2}) {
      const std::size_t from = j == 2 ? 3 : j;
      found->second[j] = high[2] * low[from] - low[2] * high[from];
    }
    found->second = primitive(std::move(found->second));
    return found->second;
  }

  /// False if the section is empty.
  bool add_hull(const std::vector<GeneratorIndex>& generators) {
    ++work_.exact_sections;
    std::set<IntegerVector4> images;
    for (const GeneratorIndex g : generators) images.insert(images_.exact(g));
    std::vector<HomogeneousPoint> points;
    bool has_point = false;
    for (const IntegerVector4& g :
         cut<4>({images.begin(), images.end()}, {0, 0, 1, 0}, Keep::kPlane)) {
      if (is_zero(g)) continue;
      points.push_back({g[0], g[1], g[3]});
      has_point = has_point || !g[3].is_zero();
    }
    if (has_point) cover_.add(PlaneCell::hull(std::move(points)));
    return has_point;
  }

  const bool bilateral_;
  const ResistibleOptions& options_;
  ResistibleWork& work_;
  const std::size_t contacts_;
  MotionRays rays_;
  ModeImages images_;
  bool some_motion_is_free_ = false;
  std::vector<Known> slips_now_;  ///< of the region looked at
  std::set<WalkedRegion> faces_seen_;
  /// Edges, the less end first: cells to the left less cells to the right.
  std::map<std::pair<SectionVertex, SectionVertex>, int> borders_;
  std::vector<std::pair<SectionVertex, SectionVertex>> arcs_;
  std::map<SectionVertex, HomogeneousPoint> exact_vertices_;
  PlaneCover cover_;  ///< what is known exactly
};

}  // namespace

std::variant<PlaneUnion, Undecided> resistible_region(const Problem& problem,
                                                      const WrenchPlane& plane,
                                                      const ResistibleOptions& options,
                                                      ResistibleWork* work) {
  ResistibleWork unused;
  ResistibleWork& counters = work != nullptr ? *work : unused;
  counters = {};
  RegionFinder finder(problem, plane, options, counters);
  if (!finder.find()) {
    return Undecided{"the limit of " + std::to_string(options.mode_limit) + " modes"};
  }
  return finder.found();
}

}  // namespace stickslip
