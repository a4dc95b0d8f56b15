// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "spatial_cells.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/earlier/grasp_wrench_space.hpp"
#include "stickslip/engine/cone.hpp"

namespace stickslip {

using namespace earlier_detail;

namespace {

/// A unit normal force with the friction of its disc: the points N + (f, p x f) of the space.
class UnitDisc {
 public:
  UnitDisc(const UncertainContact& contact, std::size_t index, const Rational& length)
      : disc_(contact), unit_(1 / rational_length(contact, index)), length_(length) {}

  /// Returns the point with friction along the direction of the disc at this place.
  RationalRow point(std::size_t quarter, const Rational& t) const {
    Vector3 force = disc_.normal();
    if (disc_.has_friction()) {
      // The friction has a rational length, as the normal has.
      force = plus(force, -1, *disc_.against(disc_.direction(quarter, t)));
    }
    const Vector6 w = disc_.wrench(force);
    RationalRow result;
    for (std::size_t j = 0; j < 6; ++j) {
      result.push_back(j < 3 ? Rational(unit_ * w[j]) : Rational(unit_ * w[j] / length_));
    }
    return result;
  }

  /// Returns the motion that does the work u.x.
  Vector6 motion(const RationalRow& u) const {
    return {u[0], u[1], u[2], u[3] / length_, u[4] / length_, u[5] / length_};
  }

  /// Returns true if u.x <= 0 for all its points.
  bool is_below(const RationalRow& u) const {
    const Vector6 d = motion(u);
    const Rational along = dot(disc_.normal_row(), d);
    const Vector3 slip = disc_.slip(d);
    return along.sign() <= 0 && disc_.square() * dot(slip, slip) <= along * along;
  }

  /// Returns at least the largest u.x of its points.
  Rational reach(const RationalRow& u) const {
    const Vector6 d = motion(u);
    const Vector3 slip = disc_.slip(d);
    constexpr unsigned kBits = 60;
    const Rational friction = short_sqrt(disc_.square() * dot(slip, slip), kBits).upper;
    return unit_ * (dot(disc_.normal_row(), d) + friction);
  }

  /// Returns a place near that of the point farthest along u, to 2^-bits of its angle.
  Sector farthest(const RationalRow& u, unsigned bits) const {
    const Vector3 slip = disc_.slip(motion(u));
    if (slip == Vector3{}) return {};
    Sector place = disc_.near(slip);
    const Integer scale = Integer(1) << bits;
    const Rational t = place.low * Rational(scale) + Rational(1, 2);
    place.low = place.high = Rational(numerator(t) / denominator(t)) / Rational(scale);
    return place;
  }

 private:
  FrictionDisc disc_;
  Rational unit_;  ///< 1 / |n|
  Rational length_;
};

struct Facet {
  RationalRow normal;
  Rational offset;

  Rational distance_squared() const { return offset * offset / dot(normal, normal); }
};

/// The hull of 0 and points. Its facets are the extreme rays of the polar {(u, h) : u.x <= h
/// for all points x}.
class Hull {
 public:
  void add(const RationalRow& x) {
    RationalRow plane;
    for (const Rational& coordinate : x) plane.push_back(-coordinate);
    plane.emplace_back(1);
    plane.emplace_back(0);
    polar_.cut(primitive_multiple(plane), Side::kPositive);
    ++points_;
  }

  /// Returns a row orthogonal to all points, if they have no volume.
  std::optional<RationalRow> flat() const {
    if (polar_.lines().empty()) return std::nullopt;
    return normal_of(polar_.lines().front());
  }

  /// Returns the facet nearest to 0. Requires volume.
  Facet nearest() const {
    std::optional<Facet> best;
    Rational least = 0;
    for (const RayOf<Row>& ray : polar_.rays()) {
      Facet facet{normal_of(ray.x), Rational(ray.x[6])};
      const Rational distance = facet.distance_squared();
      if (best && distance >= least) continue;
      least = distance;
      best = std::move(facet);
    }
    require(best.has_value(), "a hull without facets");
    return *best;
  }

  /// Returns a row inside the cone of the u with u.x <= 0 for all points x, if there is such a
  /// cone: the facets through 0 are at its border.
  std::optional<RationalRow> inside_polar() const {
    RationalRow sum(6);
    bool has_any = false;
    for (const RayOf<Row>& ray : polar_.rays()) {
      if (!ray.x[6].is_zero()) continue;
      has_any = true;
      Integer largest = 1;
      for (std::size_t j = 0; j < 6; ++j) largest = std::max(largest, Integer(abs(ray.x[j])));
      for (std::size_t j = 0; j < 6; ++j) {
        sum[j] += rational_in_bits(to_double(Rational(ray.x[j]) / Rational(largest)), 30);
      }
    }
    return has_any ? std::optional(sum) : std::nullopt;
  }

  std::size_t points() const { return points_; }
  std::size_t facets() const { return polar_.rays().size(); }

 private:
  static RationalRow normal_of(const Row& x) { return {x.begin(), x.begin() + 6}; }

  ConeOf<Row> polar_{ConeOf<Row>::Multiples::kZero, 8};
  std::size_t points_ = 0;
};

}  // namespace

WrenchBall wrench_ball(const GraspBox& grasp, const Rational& length,
                       const WrenchBallLimits& limits) {
  require(length.sign() > 0, "the characteristic length must be above 0");
  std::vector<UnitDisc> discs;
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    discs.emplace_back(grasp.contacts[i], i, length);
  }
  Hull hull;
  std::set<std::tuple<std::size_t, std::size_t, Rational>> known;
  const auto add = [&](std::size_t contact, std::size_t quarter, const Rational& t) {
    const bool is_new = known.emplace(contact, quarter, t).second;
    if (is_new) hull.add(discs[contact].point(quarter, t));
    return is_new;
  };
  for (std::size_t i = 0; i < discs.size(); ++i) {
    // The hull starts with a triangle of each disc, nearly an equilateral one.
    add(i, 0, 0);
    if (grasp.contacts[i].friction.low.is_zero()) continue;
    add(i, 1, Rational(1, 4));
    add(i, 2, Rational(4, 7));
  }
  const auto found = [&](Rational low, Rational high, const RationalRow& u) {
    return WrenchBall{std::move(low), std::move(high), primitive_multiple(u), hull.points(),
                      hull.facets()};
  };
  if (const auto u = hull.flat()) return found(0, 0, *u);
  std::optional<Rational> high;
  RationalRow direction;
  for (unsigned bits = 6;;) {
    const Facet facet = hull.nearest();
    const Rational square = dot(facet.normal, facet.normal);
    Rational reach = 0;
    std::size_t farthest = 0;
    for (std::size_t i = 0; i < discs.size(); ++i) {
      const Rational here = discs[i].reach(facet.normal);
      if (here <= reach) continue;
      reach = here;
      farthest = i;
    }
    const auto bounds_all = [&](const RationalRow& u) {
      return !is_zero(primitive_multiple(u)) &&
             std::all_of(discs.begin(), discs.end(),
                         [&](const UnitDisc& disc) { return disc.is_below(u); });
    };
    if (facet.offset.is_zero()) {
      for (const RationalRow& u : {facet.normal, *hull.inside_polar()}) {
        if (bounds_all(u)) return found(0, 0, u);
      }
    }
    const Rational above = reach * reach / square;
    if (!high || above < *high) {
      high = above;
      direction = facet.normal;
    }
    const Rational low = facet.distance_squared();
    if (low >= limits.ratio * limits.ratio * *high || hull.facets() > limits.most_facets) {
      return found(low, *high, direction);
    }
    constexpr unsigned kMostBits = 24;
    for (;; bits += 2) {
      const Sector place = discs[farthest].farthest(facet.normal, bits);
      if (add(farthest, place.quarter, place.low)) break;
      if (bits >= kMostBits) return found(low, *high, direction);
    }
  }
}

}  // namespace stickslip
