// SPDX-License-Identifier: GPL-3.0-or-later
#include "space_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stickslip/core/error.hpp"

namespace stickslip::space_detail {
namespace {

std::array<double, 2> rounded(const Interval& interval) {
  return {to_double(interval.low), to_double(interval.high)};
}

/// |n|^2 S for a contact at p, by rows: |n|^2 u - (n.u) n with u = (d1, d2, d3) + omega x p.
std::array<Vector6, 3> slip_rows(const Vector3& p, const Vector3& n, const Vector6& normal) {
  const Rational square = dot(n, n);
  std::array<Vector6, 3> rows{};
  for (std::size_t k = 0; k < 3; ++k) {
    Vector3 axis{};
    axis[k] = 1;
    const Vector3 moment = cross(p, axis);
    for (std::size_t j = 0; j < 3; ++j) {
      rows[k][j] = square * axis[j] - n[k] * normal[j];
      rows[k][j + 3] = square * moment[j] - n[k] * normal[j + 3];
    }
  }
  return rows;
}

/// From a multiple of S: in integers.
void set_slip(CornerRow& row, const std::array<Vector6, 3>& slip, const Rational& factor) {
  Integer common = 1;
  for (const Vector6& r : slip) {
    for (const Rational& entry : r) common = lcm(common, denominator(entry));
  }
  row.slip_factor = Rational(common) * factor;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t j = 0; j < 6; ++j) {
      row.slip[k][j] = numerator(slip[k][j]) * (common / denominator(slip[k][j]));
      row.slip_planes[k][j] = row.slip[k][j];
    }
  }
}

CornerRow row_at(const Vector3& p, const Vector3& n) {
  CornerRow row{};
  const Vector3 moment = cross(p, n);
  row.normal = {n[0], n[1], n[2], moment[0], moment[1], moment[2]};
  set_slip(row, slip_rows(p, n, row.normal), dot(n, n));
  return row;
}

void add_corners(SpaceContact& contact) {
  contact.centre = row_at({contact.position[0].middle(), contact.position[1].middle(),
                           contact.position[2].middle()},
                          contact.normal);
  contact.corners.clear();
  for_each_corner(contact.position, [&](const Vector3& p) {
    contact.corners.push_back(row_at(p, contact.normal));
  });
}

/// P' and P^u' at their ends.
std::vector<std::pair<Rational, Rational>> preloads_of(const SpaceContact& contact) {
  const Interval& p = contact.preload;
  const Interval& rate = contact.rate;
  if (p.is_point() && rate.is_point()) return {{p.low, rate.low}};
  return {{p.low, rate.low}, {p.high, rate.high}};
}

void add_separations(SpaceContact& contact) {
  contact.separations.clear();
  contact.separation_factors.clear();
  for (const CornerRow& corner : contact.corners) {
    for (const Rational& k : ends_of(contact.stiffness)) {
      for (const auto& [preload, rate] : preloads_of(contact)) {
        std::array<Rational, 8> v{};
        for (std::size_t j = 0; j < 6; ++j) v[j] = -k * corner.normal[j];
        v[6] = preload;
        v[7] = rate;
        Point plane = primitive_multiple<8>(v);
        std::size_t j = 0;
        while (plane[j].is_zero()) ++j;  // n is not 0
        Rational factor = v[j] / Rational(plane[j]);
        contact.separations.push_back(std::move(plane));
        contact.separation_factors.push_back(std::move(factor));
      }
    }
  }
}

}  // namespace

bool SpaceContact::has_certain_separation() const {
  return std::all_of(separations.begin(), separations.end(),
                     [&](const Point& plane) { return plane == separations.front(); });
}

SpaceModel::SpaceModel(const SpatialQuestion& question, unsigned bits)
    : wrench(question.grasp.wrench),
      growth(question.direction.value_or(Vector6{})),
      is_family(question.is_margin()),
      law(question.law) {
  for (std::size_t i = 0; i < question.grasp.contacts.size(); ++i) {
    const SpatialContact& c = question.grasp.contacts[i];
    const Rational rate = question.preload_growth.empty() ? 0 : question.preload_growth[i];
    SpaceContact contact{};
    contact.normal = c.normal;
    contact.axis = primitive_multiple<3>(c.normal);
    contact.squared_length = dot(c.normal, c.normal);
    contact.friction = c.friction;
    if (!c.preload.high.is_zero() || !rate.is_zero()) {
      const auto [lower, upper] = short_sqrt(1 / contact.squared_length, bits);
      contact.preload = {c.preload.low * lower, c.preload.high * upper};
      contact.rate = {rate * lower, rate * upper};
    }
    contact.stiffness = {c.stiffness.low / contact.squared_length,
                         c.stiffness.high / contact.squared_length};
    contact.position = c.position;
    add_corners(contact);
    contacts.push_back(std::move(contact));
  }
  complete();
}

/// What follows from the parameters.
void SpaceModel::complete() {
  // A corner's moment arm, |p x n| / |n|, is as large as distances that matter.
  double farthest = 0;
  for (const SpaceContact& c : contacts) {
    for (const CornerRow& row : c.corners) {
      double arm = 0;
      for (std::size_t j = 3; j < 6; ++j) arm = std::hypot(arm, to_double(row.normal[j]));
      farthest = std::max(farthest, arm / std::sqrt(to_double(c.squared_length)));
    }
  }
  length = farthest > 0 && std::isfinite(farthest) ? farthest : 1;
  double largest = 0;
  for (SpaceContact& c : contacts) {
    c.geometry_is_certain = c.corners.size() == 1;
    add_separations(c);
    const double size = std::sqrt(to_double(c.squared_length));
    c.slopes = {to_double(c.friction.low) * size, to_double(c.friction.high) * size};
    c.preloads = rounded(c.preload);
    c.rates = rounded(c.rate);
    c.stiffnesses = rounded(c.stiffness);
    largest = std::max(largest, c.preloads[1] * size);
    Double3 n{};
    for (std::size_t j = 0; j < 3; ++j) n[j] = to_double(c.normal[j]) / size;
    std::size_t least = 0;
    for (std::size_t j = 1; j < 3; ++j) {
      if (std::fabs(n[j]) < std::fabs(n[least])) least = j;
    }
    Double3 unit{};
    unit[least] = 1;
    c.tangents[0] = cross(n, unit);
    const double across = std::sqrt(dot(c.tangents[0], c.tangents[0]));
    for (double& entry : c.tangents[0]) entry /= across;
    c.tangents[1] = cross(n, c.tangents[0]);
    c.is_moderate = true;
    const auto over = [&](const Rational& exact, double scale) {
      const double value = to_double(exact) / scale;
      const double magnitude = std::fabs(value);
      const bool is_moderate = magnitude >= 0x1p-200 && magnitude <= 0x1p200;
      c.is_moderate = c.is_moderate && (exact.is_zero() || is_moderate);
      return value;
    };
    for (const Interval* interval : {&c.preload, &c.rate, &c.stiffness}) {
      over(interval->low, 1);
      over(interval->high, 1);
    }
    for (CornerRow& row : c.corners) {
      for (std::size_t j = 0; j < 6; ++j) {
        const double scale = j < 3 ? 1 : length;
        row.normal_rounded[j] = over(row.normal[j], scale);
        for (std::size_t k = 0; k < 3; ++k) {
          row.slip_rounded[k][j] = over(row.slip[k][j] / row.slip_factor, scale);
        }
      }
    }
  }
  for (std::size_t j = 0; j < 6; ++j) {
    const double scale = j < 3 ? 1 : length;
    load[j] = {to_double(wrench[j].low) / scale, to_double(wrench[j].high) / scale};
    growing[j] = to_double(growth[j]) / scale;
    largest = std::max({largest, std::fabs(load[j][0]), std::fabs(load[j][1])});
  }
  if (largest > 0 && std::isfinite(largest)) force = largest;
  double stiffest = 0;
  for (const SpaceContact& c : contacts) {
    stiffest = std::max(stiffest, c.stiffnesses[1] * to_double(c.squared_length));
  }
  if (stiffest > 0) reach = force / stiffest;
}

Double6 SpaceModel::load_at(double height, double multiple, const Double6& y) const {
  Double6 result{};
  for (std::size_t j = 0; j < 6; ++j) {
    result[j] = height * load[j][y[j] > 0 ? 1 : 0] + multiple * growing[j];
  }
  return result;
}

SpaceModel SpaceModel::within(const MultipleRange& range) const {
  SpaceModel result = *this;
  result.multiples = range;
  return result;
}

SpaceModel SpaceModel::at(const Rational& multiple) const {
  SpaceModel result = *this;
  result.growth = {};
  result.is_family = false;
  for (std::size_t j = 0; j < 6; ++j) {
    result.wrench[j].low += multiple * growth[j];
    result.wrench[j].high += multiple * growth[j];
  }
  const auto shrink = [](Interval& interval) { interval = point_interval(interval.middle()); };
  for (SpaceContact& c : result.contacts) {
    shrink(c.friction);
    c.preload = point_interval(c.preload.middle() + multiple * c.rate.middle());
    c.rate = {};
    shrink(c.stiffness);
    if (c.corners.size() == 1) continue;
    for (Interval& coordinate : c.position) shrink(coordinate);
    add_corners(c);
  }
  for (Interval& component : result.wrench) shrink(component);
  result.complete();
  return result;
}

Interval& SpaceModel::interval(Parameter parameter, std::size_t index) {
  if (parameter == Parameter::kWrench) return wrench.at(index);
  SpaceContact& c = contacts.at(index);
  switch (parameter) {
    case Parameter::kX:
      return c.position[0];
    case Parameter::kY:
      return c.position[1];
    case Parameter::kZ:
      return c.position[2];
    case Parameter::kFriction:
      return c.friction;
    case Parameter::kPreload:
      return c.preload;
    default:
      require(parameter == Parameter::kStiffness, "normals are certain in space");
      return c.stiffness;
  }
}

std::pair<SpaceModel, SpaceModel> SpaceModel::halves(const PartSplit& split) const {
  const auto half = [&](bool upper) {
    SpaceModel result = *this;
    Interval& cut = result.interval(split.parameter, split.index);
    require(cut.low < split.value && split.value < cut.high,
            "a part is cut inside its interval");
    (upper ? cut.low : cut.high) = split.value;
    if (split.parameter != Parameter::kWrench) add_corners(result.contacts[split.index]);
    result.complete();
    return result;
  };
  return {half(false), half(true)};
}

bool SpaceModel::is_point() const {
  return (!is_family || multiples.high == multiples.low) &&
         std::all_of(contacts.begin(), contacts.end(),
                     [](const SpaceContact& c) {
                       return c.geometry_is_certain && c.friction.is_point() &&
                              c.preload.is_point() && c.rate.is_point() &&
                              c.stiffness.is_point();
                     }) &&
         std::all_of(wrench.begin(), wrench.end(),
                     [](const Interval& component) { return component.is_point(); });
}

}  // namespace stickslip::space_detail
