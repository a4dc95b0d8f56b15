// SPDX-License-Identifier: GPL-3.0-or-later
#include "space_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stickslip/core/error.hpp"

namespace stickslip::space_detail {
namespace {

/// |n|^2 S for a contact at p, by rows: |n|^2 u - (n.u) n with u = (d1, d2, d3) + omega x p.
std::vector<RationalRow> slip_rows(const Vector3& p, const Vector3& n,
                                   const RationalRow& normal) {
  const Rational square = dot(n, n);
  std::vector<RationalRow> rows(3, RationalRow(6));
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

CornerRow row_at(const Vector3& p, const Vector3& n) {
  CornerRow row{};
  const Vector3 moment = cross(p, n);
  row.normal = {n[0], n[1], n[2], moment[0], moment[1], moment[2]};
  row.set_slip(slip_rows(p, n, row.normal), dot(n, n));
  return row;
}

void add_corners(LawContact& contact) {
  SpatialPlace& place = *contact.place;
  place.centre = row_at(
      {place.position[0].middle(), place.position[1].middle(), place.position[2].middle()},
      place.normal);
  contact.corners.clear();
  for_each_corner(place.position, [&](const Vector3& p) {
    contact.corners.push_back(row_at(p, place.normal));
  });
}

void shrink(Interval& interval) {
  interval = point_interval(interval.middle());
}

}  // namespace

SpaceModel::SpaceModel(const SpatialQuestion& question, unsigned bits) {
  motions = 6;
  first_rotation = 3;
  wrench.assign(question.grasp.wrench.begin(), question.grasp.wrench.end());
  const Vector6 u = question.direction.value_or(Vector6{});
  growth.assign(u.begin(), u.end());
  is_family = question.is_margin();
  law = question.law;
  for (std::size_t i = 0; i < question.grasp.contacts.size(); ++i) {
    const SpatialContact& c = question.grasp.contacts[i];
    const Rational rate = question.preload_growth.empty() ? 0 : question.preload_growth[i];
    LawContact& contact = contacts.emplace_back();
    contact.place = SpatialPlace{c.position, c.normal, {}};
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
    add_corners(contact);
  }
  complete();
}

/// A corner's moment arm, |p x n| / |n|, is as large as distances that matter.
void SpaceModel::complete() {
  double farthest = 0;
  for (const LawContact& c : contacts) {
    for (const CornerRow& row : c.corners) {
      double arm = 0;
      for (std::size_t j = 3; j < 6; ++j) arm = std::hypot(arm, to_double(row.normal[j]));
      farthest = std::max(farthest, arm / std::sqrt(to_double(c.squared_length)));
    }
  }
  Law::complete(farthest);
}

SpaceModel SpaceModel::within(const MultipleRange& range) const {
  SpaceModel result = *this;
  result.multiples = range;
  return result;
}

SpaceModel SpaceModel::at(const Rational& multiple) const {
  SpaceModel result = *this;
  result.growth.assign(6, 0);
  result.is_family = false;
  for (std::size_t j = 0; j < 6; ++j) {
    result.wrench[j].low += multiple * growth[j];
    result.wrench[j].high += multiple * growth[j];
  }
  for (LawContact& c : result.contacts) {
    shrink(c.friction);
    c.preload = point_interval(c.preload.middle() + multiple * c.rate.middle());
    c.rate = {};
    shrink(c.stiffness);
    if (c.geometry_is_certain()) continue;
    for (Interval& coordinate : c.place->position) shrink(coordinate);
    add_corners(c);
  }
  for (Interval& component : result.wrench) shrink(component);
  result.complete();
  return result;
}

Interval& SpaceModel::interval(Parameter parameter, std::size_t index) {
  if (parameter == Parameter::kWrench) return wrench.at(index);
  LawContact& c = contacts.at(index);
  switch (parameter) {
    case Parameter::kX:
      return c.place->position[0];
    case Parameter::kY:
      return c.place->position[1];
    case Parameter::kZ:
      return c.place->position[2];
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

}  // namespace stickslip::space_detail
