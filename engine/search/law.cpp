// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/law.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stickslip/core/error.hpp"
#include "stickslip/core/motion_bound.hpp"

namespace stickslip {
namespace {

std::array<double, 2> rounded(const Interval& interval) {
  return {to_double(interval.low), to_double(interval.high)};
}

/// Returns whether a number is 0, or neither so large nor so small that products may overflow
/// or vanish.
bool is_moderate_number(const Rational& exact, double rounded) {
  const double size = std::fabs(rounded);
  return exact.is_zero() || (size >= 0x1p-200 && size <= 0x1p200);
}

bool is_moderate_interval(const Interval& interval) {
  return is_moderate_number(interval.low, to_double(interval.low)) &&
         is_moderate_number(interval.high, to_double(interval.high));
}

/// Returns P' and P^u' at their ends.
std::vector<std::pair<Rational, Rational>> preloads_of(const LawContact& contact) {
  const Interval& p = contact.preload;
  const Interval& rate = contact.rate;
  if (p.is_point() && rate.is_point()) return {{p.low, rate.low}};
  return {{p.low, rate.low}, {p.high, rate.high}};
}

void add_separations(LawContact& contact) {
  contact.separations.clear();
  contact.separation_factors.clear();
  for (const CornerRow& corner : contact.corners) {
    for (const Rational& k : ends_of(contact.stiffness)) {
      for (const auto& [preload, rate] : preloads_of(contact)) {
        RationalRow v;
        for (const Rational& entry : corner.normal) v.emplace_back(-k * entry);
        v.push_back(preload);
        v.push_back(rate);
        Row plane = primitive_multiple(v);
        std::size_t j = 0;
        while (j + 1 < plane.size() && plane[j].is_zero()) ++j;
        // (v may be 0 for a spring, or where no body moves along a normal.)
        contact.separation_factors.push_back(plane[j].is_zero() ? Rational(1)
                                                                : v[j] / Rational(plane[j]));
        contact.separations.push_back(std::move(plane));
      }
    }
  }
  contact.has_certain_separation =
      std::all_of(contact.separations.begin(), contact.separations.end(),
                  [&](const Row& plane) { return plane == contact.separations.front(); });
}

Integer common_denominator(const RationalRow& values) {
  Integer common = 1;
  for (const Rational& value : values) common = lcm(common, denominator(value));
  return common;
}

WholeCorners whole_corners(const LawContact& c) {
  RationalRow entries;
  std::vector<RationalRow> tangents;
  for (const CornerRow& corner : c.corners) {
    RationalRow& tangent = tangents.emplace_back();
    for (const Integer& entry : corner.slip.front()) {
      tangent.emplace_back(Rational(entry) / corner.slip_factor);
    }
    entries.insert(entries.end(), corner.normal.begin(), corner.normal.end());
    entries.insert(entries.end(), tangent.begin(), tangent.end());
  }
  const Integer length = common_denominator(entries);
  const Integer law =
      common_denominator({c.preload.low, c.preload.high, c.stiffness.low, c.stiffness.high});
  const auto times = [](const Rational& value, const Integer& factor) {
    return Integer(numerator(value) * (factor / denominator(value)));
  };
  const auto whole = [&](const RationalRow& row) {
    Row result;
    for (const Rational& entry : row) result.push_back(times(entry, length));
    return result;
  };
  WholeCorners result;
  for (std::size_t k = 0; k < c.corners.size(); ++k) {
    result.normals.push_back(whole(c.corners[k].normal));
    result.tangents.push_back(whole(tangents[k]));
  }
  result.cone = common_denominator({c.friction.low, c.friction.high});
  result.frictions = {times(c.friction.low, result.cone), times(c.friction.high, result.cone)};
  result.ends.preloads = {times(c.preload.low, law) * length,
                          times(c.preload.high, law) * length};
  result.ends.stiffnesses = {times(c.stiffness.low, law), times(c.stiffness.high, law)};
  result.weight =
      Rational(1) / Rational(length * length * result.cone * law * Integer(c.corners.size()));
  return result;
}

}  // namespace

std::vector<Rational> ends_of(const Interval& interval) {
  if (interval.is_point()) return {interval.low};
  return {interval.low, interval.high};
}

void CornerRow::set_slip(const std::vector<RationalRow>& multiple, const Rational& factor) {
  Integer common = 1;
  for (const RationalRow& row : multiple) {
    for (const Rational& entry : row) common = lcm(common, denominator(entry));
  }
  slip_factor = Rational(common) * factor;
  slip.clear();
  for (const RationalRow& row : multiple) {
    Row& whole = slip.emplace_back();
    for (const Rational& entry : row) {
      whole.emplace_back(numerator(entry) * (common / denominator(entry)));
    }
  }
}

RationalRow LawContact::force_near(const Double3& coordinates, int bits) const {
  RationalRow result(slip_numbers());
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const Rational part = rational_in_bits(coordinates[k] / direction_sizes[k], bits);
    for (std::size_t j = 0; j < result.size(); ++j) result[j] += part * directions[k][j];
  }
  return result;
}

Double3 LawContact::coordinates_of(const RationalRow& force) const {
  require(slip_dimension() < 3, "the force of a contact with torsion");
  Double3 result{};
  for (std::size_t k = 0; k < directions.size(); ++k) {
    result[k] = to_double(dot(directions[k], force)) / direction_sizes[k];
  }
  return result;
}

Double3 LawContact::direction_of(const IntegerVector<4>& slip) const {
  if (slip_dimension() == 1) return {static_cast<double>(slip[0].sign()), 0, 0};
  const std::array<double, 4> rounded = in_doubles(slip);
  Double3 result{};
  for (std::size_t k = 0; k < directions.size(); ++k) {
    for (std::size_t j = 0; j < slip_numbers(); ++j) {
      result[k] += unit_directions[k][j] * rounded[j];
    }
  }
  normalize(result);
  return result;
}

RationalRow CornerRow::wrench_of(const RationalRow& friction) const {
  RationalRow result(normal.size());
  for (std::size_t k = 0; k < friction.size(); ++k) {
    if (friction[k].is_zero()) continue;
    const Rational factor = friction[k] / slip_factor;
    for (std::size_t j = 0; j < result.size(); ++j) result[j] += factor * slip[k][j];
  }
  return result;
}

RationalRow CornerRow::push_with(const RationalRow& friction) const {
  RationalRow result = wrench_of(friction);
  for (std::size_t j = 0; j < result.size(); ++j) result[j] += normal[j];
  return result;
}

std::vector<Row> CornerRow::slip_planes(std::size_t coordinates) const {
  std::vector<Row> planes;
  for (const Row& row : slip) {
    planes.push_back(primitive(row));
    planes.back().resize(coordinates);
  }
  return planes;
}

bool Law::allows(const RationalRow& motion) const {
  return is_within(motion, max_motion);
}

bool Law::may_be_rounded() const {
  constexpr unsigned kLong = 40;
  const auto is_long = [](const Integer& value) {
    return !value.is_zero() && msb(abs(value)) >= kLong;
  };
  return std::any_of(contacts.begin(), contacts.end(), [&](const LawContact& c) {
    const RationalRow& normal = c.corners.front().normal;
    return std::any_of(normal.begin(), normal.end(), [&](const Rational& entry) {
      return is_long(numerator(entry)) || is_long(denominator(entry));
    });
  });
}

void Law::complete(double distance) {
  length = distance > 0 && std::isfinite(distance) ? distance : 1;
  for (LawContact& c : contacts) {
    add_separations(c);
    const double slope = std::sqrt(to_double(c.squared_length));
    c.slopes = {to_double(c.friction.low) * slope, to_double(c.friction.high) * slope};
    c.tilted = 1.5 * to_double(c.tilt);
    c.preloads = rounded(c.preload);
    c.rates = rounded(c.rate);
    c.stiffnesses = rounded(c.stiffness);
    // A part that is one grasp keeps nothing of the corners of the whole.
    c.whole.reset();
    if (c.slip_dimension() == 1 && c.corners.size() > 1) c.whole = whole_corners(c);
    c.direction_sizes.clear();
    c.unit_directions.clear();
    for (const RationalRow& direction : c.directions) {
      const double size = std::sqrt(to_double(c.squared_force(direction)));
      c.direction_sizes.push_back(size);
      std::array<double, 4>& unit = c.unit_directions.emplace_back();
      for (std::size_t j = 0; j < direction.size(); ++j) {
        unit[j] = to_double(direction[j]) / size;
      }
    }
    c.is_moderate = true;
    const auto over = [&](const Rational& exact, double scale) {
      const double value = to_double(exact) / scale;
      c.is_moderate = c.is_moderate && is_moderate_number(exact, value);
      return value;
    };
    for (const Interval* interval : {&c.preload, &c.rate, &c.stiffness}) {
      c.is_moderate = c.is_moderate && is_moderate_interval(*interval);
    }
    const auto n = static_cast<Eigen::Index>(motions);
    for (CornerRow& row : c.corners) {
      row.normal_rounded.resize(n);
      row.slip_rounded.assign(c.directions.size(), Reals(n));
      for (std::size_t j = 0; j < motions; ++j) {
        row.normal_rounded[static_cast<Eigen::Index>(j)] = over(row.normal[j], unit(j));
      }
      for (std::size_t k = 0; k < c.directions.size(); ++k) {
        const RationalRow along = row.wrench_of(c.directions[k]);
        for (std::size_t j = 0; j < motions; ++j) {
          row.slip_rounded[k][static_cast<Eigen::Index>(j)] =
              over(along[j], unit(j) * c.direction_sizes[k]);
        }
      }
    }
  }
  for (LawContact& c : contacts) c.size = force_size(c);
  complete_loads();
}

Rational Law::short_length() const {
  constexpr int kBits = 4;
  return rational_in_bits(length, kBits);
}

Rational Law::squared_size(const RationalRow& row, const Rational& about) const {
  Rational sum = 0;
  for (std::size_t j = 0; j < row.size(); ++j) {
    const Rational entry = rotates[j] != 0 ? Rational(row[j] / about) : row[j];
    sum += entry * entry;
  }
  return sum;
}

/// Returns the length of the part of N that is a force: for one body's contact that of its
/// normal.
double Law::force_size(const LawContact& c) const {
  const Reals& normal = c.corners.front().normal_rounded;
  double square = 0;
  for (std::size_t j = 0; j < motions; ++j) {
    const double entry = normal[static_cast<Eigen::Index>(j)];
    if (rotates[j] == 0) square += entry * entry;
  }
  const double size = square > 0 ? std::sqrt(square) : normal.norm();
  return size > 0 ? size : 1;
}

void Law::complete_loads() {
  is_moderate = is_moderate_number(1, length);
  double largest = 0;
  for (const LawContact& c : contacts) {
    largest = std::max(largest, std::fabs(c.preloads[1]) * c.size);
    is_moderate = is_moderate && c.is_moderate && is_moderate_interval(c.friction);
  }
  load.assign(motions, {});
  growing = Reals::Zero(static_cast<Eigen::Index>(motions));
  for (std::size_t j = 0; j < motions; ++j) {
    load[j] = {to_double(wrench[j].low) / unit(j), to_double(wrench[j].high) / unit(j)};
    is_moderate = is_moderate && is_moderate_interval(wrench[j]);
    if (is_family) growing[static_cast<Eigen::Index>(j)] = to_double(growth[j]) / unit(j);
    largest = std::max({largest, std::fabs(load[j][0]), std::fabs(load[j][1])});
  }
  const auto round = [&](LoadGenerator& g) {
    g.rounded.resize(static_cast<Eigen::Index>(motions));
    for (std::size_t j = 0; j < motions; ++j) {
      const double value = to_double(g.load[j]) / unit(j);
      g.rounded[static_cast<Eigen::Index>(j)] = value;
      is_moderate = is_moderate && is_moderate_number(g.load[j], value);
    }
  };
  if (hull) {
    for (LoadGenerator& corner : hull->corners) {
      round(corner);
      largest = std::max(largest, corner.rounded.lpNorm<Eigen::Infinity>());
    }
    for (LoadGenerator& direction : hull->directions) {
      round(direction);
      normalize(direction.rounded);
    }
  }
  if (ball) {
    ball->rounded.resize(static_cast<Eigen::Index>(ball->motion.size()),
                         static_cast<Eigen::Index>(motions));
    for (std::size_t k = 0; k < ball->motion.size(); ++k) {
      is_moderate = is_moderate && is_moderate_interval(ball->parts[k]);
      for (std::size_t j = 0; j < motions; ++j) {
        const double value = to_double(ball->motion[k][j]) / unit(j);
        ball->rounded(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(j)) = value;
        is_moderate = is_moderate && is_moderate_number(ball->motion[k][j], value);
      }
    }
    const double radius = to_double(ball->radius);
    is_moderate = is_moderate && is_moderate_number(ball->radius, radius) &&
                  is_moderate_number(ball->length, to_double(ball->length));
    largest = std::max(largest, radius);
  }
  force = largest > 0 && std::isfinite(largest) ? largest : 1;
  double stiffest = 0;
  for (const LawContact& c : contacts) {
    stiffest = std::max(stiffest, c.stiffnesses[1] * c.size * c.size);
  }
  reach = stiffest > 0 ? force / stiffest : 1;
}

Law planar_law(const Problem& problem) {
  Law law;
  law.normal_law = problem.law();
  const auto as_row = [](const Wrench& w) { return RationalRow{w.x, w.y, w.torque}; };
  for (const Rational& w : as_row(problem.wrench())) law.wrench.push_back(point_interval(w));
  double distance = 0;
  for (const ContactRow& row : problem.rows()) {
    LawContact& contact = law.contacts.emplace_back();
    contact.friction = point_interval(row.friction);
    contact.preload = point_interval(row.preload);
    contact.stiffness = point_interval(row.stiffness);
    CornerRow& corner = contact.corners.emplace_back();
    corner.normal = as_row(row.normal);
    corner.set_slip({as_row(row.tangent)}, 1);
    const double size = std::hypot(to_double(row.normal.x), to_double(row.normal.y));
    for (const Wrench& w : {row.normal, row.tangent}) {
      distance = std::max(distance, std::fabs(to_double(w.torque)) / size);
    }
  }
  law.complete(distance);
  return law;
}

Reals Law::scaled(const Row& point) const {
  Reals x = in_doubles(point);
  scale(x);
  normalize(x);
  return x;
}

double Law::value_at(const Row& plane, const Reals& x) const {
  Reals p = in_doubles(plane);
  scale_function(p);
  normalize(p);
  return p.dot(x);
}

Row Law::plane_between(const Reals& a, const Reals& b, const Reals& x) const {
  Reals across = a - b;
  constexpr double kClose = 1e-8;  // squared
  const double size = x.squaredNorm();
  if (!(size > 0) || across.squaredNorm() < kClose) return Row(coordinates());
  across -= across.dot(x) / size * x;
  scale(across);
  constexpr int kBits = 12;
  return in_bits(across, kBits);
}

Reals Law::load_at(double height, double multiple, const Reals& y) const {
  Reals result(static_cast<Eigen::Index>(motions));
  for (std::size_t j = 0; j < motions; ++j) {
    const auto at = static_cast<Eigen::Index>(j);
    result[at] = height * load[j][y[at] > 0 ? 1 : 0] + multiple * growing[at];
  }
  if (hull) result += height * hull->worst(y);
  if (ball) result += height * ball->load(ball->worst(y));
  return result;
}

Rational Law::most_load_work(const Row& y) const {
  Rational most = hull ? hull->most_work(y) : Rational(0);
  if (ball) most += ball->most_work(y);
  for (std::size_t j = 0; j < motions; ++j) {
    most += Rational(y[j]) * (y[j].sign() > 0 ? wrench[j].high : wrench[j].low);
  }
  return most;
}

double Law::load_size(const Reals& y) const {
  double size = 0;
  for (std::size_t j = 0; j < motions; ++j) {
    const auto at = static_cast<Eigen::Index>(j);
    double most = std::max(std::fabs(load[j][0]), std::fabs(load[j][1]));
    if (hull) {
      double beside = 0;
      for (const LoadGenerator& corner : hull->corners) {
        beside = std::max(beside, std::fabs(corner.rounded[at]));
      }
      most += beside;
    }
    for (std::size_t k = 0; ball && k < ball->parts.size(); ++k) {
      most += std::fabs(ball->rounded(static_cast<Eigen::Index>(k), at)) * ball->unit(k) *
              to_double(ball->radius);
    }
    size += most * std::fabs(y[at]);
  }
  return size;
}

bool Law::is_linear() const {
  return std::all_of(contacts.begin(), contacts.end(),
                     [](const LawContact& c) { return c.slip_dimension() == 1; });
}

bool Law::is_point() const {
  const auto is_point = [](const Interval& component) { return component.is_point(); };
  return (!is_family || multiples.high == multiples.low) && !hull &&
         std::all_of(contacts.begin(), contacts.end(),
                     [](const LawContact& c) {
                       return c.geometry_is_certain() && c.friction.is_point() &&
                              c.preload.is_point() && c.rate.is_point() &&
                              c.stiffness.is_point();
                     }) &&
         (!ball || std::all_of(ball->parts.begin(), ball->parts.end(), is_point)) &&
         std::all_of(wrench.begin(), wrench.end(), is_point);
}

}  // namespace stickslip
