// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "earlier/robustness/double_forces.hpp"
#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/earlier/force_measures.hpp"
#include "stickslip/engine/cone.hpp"

namespace stickslip {

using namespace robustness_detail;

namespace {

/// A face of a hull: the points on it, increasing.
using HullFacet = std::vector<ConstraintIndex>;

/// Returns the absolute value of the determinant of a matrix.
Rational size_of_determinant(std::vector<RationalRow> a) {
  Rational result = 1;
  for (std::size_t k = 0; k < a.size(); ++k) {
    std::size_t pivot = k;
    while (pivot < a.size() && a[pivot][k].is_zero()) ++pivot;
    if (pivot == a.size()) return 0;
    std::swap(a[k], a[pivot]);
    result *= a[k][k];
    for (std::size_t i = k + 1; i < a.size(); ++i) {
      if (a[i][k].is_zero()) continue;
      const Rational factor = a[i][k] / a[k][k];
      for (std::size_t j = k + 1; j < a.size(); ++j) a[i][j] -= factor * a[k][j];
    }
  }
  return abs(result);
}

/// Cuts a hull into simplices: those with a corner at a point of a face, and a side in a face
/// of this face that does not hold the point.
class Simplices {
 public:
  explicit Simplices(const std::vector<RationalRow>& points) : points_(points) {}

  /// Adds the determinants of the simplices of a face of this dimension. `facets` are those of
  /// the face.
  void add(const HullFacet& face, std::size_t dimension, const std::vector<HullFacet>& facets) {
    corners_.push_back(face.front());
    if (dimension == 0) {
      add_simplex();
    } else {
      for (std::size_t k = 0; k < facets.size(); ++k) {
        if (facets[k].front() == face.front()) continue;
        add(facets[k], dimension - 1, facets_of(facets, k, dimension - 1));
      }
    }
    corners_.pop_back();
  }

  const Rational& sum() const { return sum_; }  ///< the volume times the factorial

 private:
  /// Returns the facets of a facet of this dimension: its largest intersections with others.
  static std::vector<HullFacet> facets_of(const std::vector<HullFacet>& facets,
                                          std::size_t which, std::size_t dimension) {
    std::set<HullFacet> common;
    for (std::size_t k = 0; k < facets.size(); ++k) {
      if (k == which) continue;
      HullFacet both;
      std::set_intersection(facets[k].begin(), facets[k].end(), facets[which].begin(),
                            facets[which].end(), std::back_inserter(both));
      if (!both.empty() && both.size() >= dimension) common.insert(std::move(both));
    }
    std::vector<HullFacet> result;
    for (const HullFacet& face : common) {
      const bool is_largest =
          std::none_of(common.begin(), common.end(), [&](const HullFacet& other) {
            return other.size() > face.size() &&
                   std::includes(other.begin(), other.end(), face.begin(), face.end());
          });
      if (is_largest) result.push_back(face);
    }
    return result;
  }

  void add_simplex() {
    std::vector<RationalRow> sides;
    for (std::size_t k = 1; k < corners_.size(); ++k) {
      RationalRow side = points_[corners_[k]];
      add_multiple(side, -1, points_[corners_[0]]);
      sides.push_back(std::move(side));
    }
    sum_ += size_of_determinant(std::move(sides));
  }

  const std::vector<RationalRow>& points_;
  HullFacet corners_;
  Rational sum_ = 0;
};

/// Returns a number c >= 1 such that the polygon with these unit vectors as corners, in their
/// order, contains the unit disc if it is scaled by c.
Rational scale_around(const std::vector<FrictionDirection>& corners) {
  constexpr unsigned kBits = 40;
  std::optional<Rational> least;  // the squared distance of a side from the centre
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const RationalRow& next = corners[(k + 1) % corners.size()].along;
    const Rational square = (1 + dot(corners[k].along, next)) / 2;
    if (!least || square < *least) least = square;
  }
  require(least && least->sign() > 0, "a polygon has at least three corners");
  return short_sqrt(1 / *least, kBits).upper;
}

}  // namespace

std::optional<Rational> hull_volume(const std::vector<RationalRow>& points,
                                    std::size_t most_facets) {
  if (points.empty()) return Rational(0);
  const std::size_t size = points.front().size();
  std::vector<RationalRow> all{RationalRow(size)};
  // The facets u.x <= h are the extreme rays of the polar {(u, h) : u.x <= h for all points x}.
  // Its first constraint, h >= 0, is that of the point 0.
  ConeOf<Row> polar(ConeOf<Row>::Multiples::kZero, size + 2);
  for (const RationalRow& x : points) {
    throw_if_cancelled();
    RationalRow plane;
    for (const Rational& coordinate : x) plane.push_back(-coordinate);
    plane.emplace_back(1);
    plane.emplace_back(0);
    polar.cut(primitive_multiple(plane), Side::kPositive);
    if (polar.rays().size() > most_facets) return std::nullopt;
    all.push_back(x);
  }
  if (!polar.lines().empty()) return Rational(0);
  std::vector<HullFacet> facets;
  for (const RayOf<Row>& ray : polar.rays()) facets.push_back(ray.tight);
  HullFacet whole;
  for (std::size_t k = 0; k < all.size(); ++k) {
    whole.push_back(static_cast<ConstraintIndex>(k));
  }
  Simplices simplices(all);
  simplices.add(whole, size, facets);
  Rational result = simplices.sum();
  for (std::size_t k = 2; k <= size; ++k) result /= Rational(static_cast<long>(k));
  return result;
}

std::optional<HullVolume> wrench_space_volume(const GraspBox& grasp, const Rational& length,
                                              std::size_t most_facets, std::size_t edges) {
  RobustnessOptions options;
  options.length = length;
  options.edges = edges;
  const ForceModel model(grasp, options);
  constexpr std::size_t kDirections = 9;
  const Directions directions(model, kDirections);
  const auto volume = [&](bool is_around) {
    std::vector<RationalRow> points;
    for (std::size_t i = 0; i < model.contacts.size(); ++i) {
      const ForceContact& contact = model.contacts[i];
      if (!contact.can_stick()) {
        points.push_back(contact.normal.row());
        continue;
      }
      const Rational friction =
          is_around ? Rational(contact.friction * scale_around(directions.of(i)))
                    : contact.friction;
      for (const FrictionDirection& direction : directions.of(i)) {
        RationalRow& x = points.emplace_back(contact.normal.row());
        for (std::size_t k = 0; k < direction.along.size(); ++k) {
          add_multiple(x, friction * direction.along[k], contact.tangents[k].row());
        }
      }
    }
    return hull_volume(points, most_facets);
  };
  const std::optional<Rational> inside = volume(false);
  if (!inside) return std::nullopt;
  if (!grasp.in_space() || edges > 0) return HullVolume{*inside, *inside};
  const std::optional<Rational> around = volume(true);
  if (!around) return std::nullopt;
  return HullVolume{*inside, *around};
}

}  // namespace stickslip
