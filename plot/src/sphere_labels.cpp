// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere_labels.hpp"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr int kSpots = 48;           ///< tried on each circle
constexpr int kFirstSpot = 5;        ///< from the rim
constexpr double kFarEnough = 0.3;   ///< more distance makes no better spot
constexpr double kLabelSize = 0.14;  ///< nearer labels would meet
constexpr int kPlaces = 16;          ///< tried in each direction of a polygon

double dot(const SpherePoint& a, const SpherePoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

SpherePoint unit_normal(const IntegerVector3& n) {
  const Integer largest =
      std::max({Integer(abs(n[0])), Integer(abs(n[1])), Integer(abs(n[2]))});
  SpherePoint p{};
  for (std::size_t j = 0; j < 3; ++j) p[j] = to_double(Rational(n[j], largest));
  const double size = std::sqrt(dot(p, p));
  for (double& entry : p) entry /= size;
  return p;
}

bool contains(const std::vector<InkPoint>& polygon, InkPoint p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const InkPoint a = polygon[i];
    const InkPoint b = polygon[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) {
      inside = !inside;
    }
  }
  return inside;
}

bool contains(const std::vector<InkPoint>& polygon, const Box& box) {
  for (const double x : {-1.0, 0.0, 1.0}) {
    for (const double y : {-1.0, 0.0, 1.0}) {
      if (!contains(polygon, box.centre + InkPoint{x * box.half.x, y * box.half.y})) {
        return false;
      }
    }
  }
  return true;
}

bool overlap(const Box& a, const Box& b) {
  return std::abs(a.centre.x - b.centre.x) < a.half.x + b.half.x &&
         std::abs(a.centre.y - b.centre.y) < a.half.y + b.half.y;
}

}  // namespace

InkPoint project(const SpherePoint& p) {
  return 1 / std::sqrt(1 + p[2]) * InkPoint{-p[1], p[0]};
}

std::vector<CircleSpot> circle_spots(const ArrangementStructure& cells,
                                     const UpperHalf& upper_half) {
  std::vector<SpherePoint> normals;
  for (const IntegerVector3& n : cells.circles().normals) normals.push_back(unit_normal(n));
  std::vector<CircleSpot> spots;
  for (std::size_t c = 0; c < normals.size(); ++c) {
    SpherePoint best{};
    double best_distance = -1;
    for (int i = kFirstSpot; i <= kSpots / 2; ++i) {
      for (const int step : {i, kSpots - i}) {
        const SpherePoint p = upper_half.on_circle(CircleId(c), M_PI * step / kSpots);
        double distance = kFarEnough;
        for (std::size_t j = 0; j < normals.size(); ++j) {
          if (j != c) distance = std::min(distance, std::abs(dot(normals[j], p)));
        }
        for (const CircleSpot& spot : spots) {
          const double between = length(spot.at - project(p));
          if (between < kLabelSize) distance = std::min(distance, 0.1 * between);
        }
        if (distance > best_distance) {
          best_distance = distance;
          best = p;
        }
      }
    }
    SpherePoint beside = best;
    for (std::size_t j = 0; j < 3; ++j) beside[j] += 0.01 * normals[c][j];
    spots.push_back({project(best), unit(project(beside) - project(best))});
  }
  return spots;
}

double area(const std::vector<InkPoint>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const InkPoint a = polygon[i];
    const InkPoint b = polygon[(i + 1) % polygon.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return std::abs(twice) / 2;
}

std::optional<InkPoint> room_for(InkPoint half_size, const std::vector<InkPoint>& polygon,
                                 const std::vector<Box>& taken) {
  if (polygon.empty() || area(polygon) < 4 * half_size.x * half_size.y) return std::nullopt;
  InkPoint low = polygon.front();
  InkPoint high = low;
  InkPoint middle;
  for (const InkPoint& p : polygon) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    middle = middle + 1.0 / static_cast<double>(polygon.size()) * p;
  }
  std::vector<InkPoint> places{middle};
  for (int i = 0; i <= kPlaces; ++i) {
    for (int j = 0; j <= kPlaces; ++j) {
      places.push_back(
          {low.x + (high.x - low.x) * i / kPlaces, low.y + (high.y - low.y) * j / kPlaces});
    }
  }
  std::stable_sort(places.begin(), places.end(), [&](InkPoint a, InkPoint b) {
    return length(a - middle) < length(b - middle);
  });
  for (const InkPoint& place : places) {
    const Box box{place, half_size};
    if (contains(polygon, box) && std::none_of(taken.begin(), taken.end(),
                                               [&](const Box& t) { return overlap(box, t); })) {
      return place;
    }
  }
  return std::nullopt;
}

}  // namespace stickslip
