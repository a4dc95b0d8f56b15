// SPDX-License-Identifier: MIT
#include "bodies.hpp"

#include <utility>

#include "work.hpp"

namespace stickslip_check {

Vector way_of_slide(const Vector& g) {
  Vector way = g;
  way.resize(g.size() == 2 ? kPlanar : kSpatial);
  return way;
}

Vector way_of_hinge(const Vector& c, const Vector& g) {
  if (c.size() == 2) return {c[1], Rational(-c[0]), 1};
  Vector way = cross(c, g);
  way.insert(way.end(), g.begin(), g.end());
  return way;
}

std::size_t dimension_of(const std::vector<Body>& bodies, std::size_t joints, bool in_space) {
  std::size_t dimension = joints;
  for (const Body& body : bodies) dimension += body.way ? 0 : in_space ? kSpatial : kPlanar;
  return dimension;
}

Mechanism::Mechanism(const std::vector<Body>& bodies, std::vector<Turns> joints, bool in_space)
    : joints_(std::move(joints)), dimension_(dimension_of(bodies, joints_.size(), in_space)) {
  const std::size_t rows = in_space ? kSpatial : kPlanar;
  ground_ = Matrix(rows, Vector(dimension_));
  std::size_t next = 0;  // column
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Body& body = bodies[b];
    Matrix own = body.way ? motion(body.on) : ground_;
    for (std::size_t k = 0; k < rows; ++k) {
      if (!body.way) {
        own[k][next++] = 1;
        continue;
      }
      const Vector turn = row({{b, (*body.way)[k]}});
      for (std::size_t j = 0; j < dimension_; ++j) own[k][j] += turn[j];
    }
    motions_.push_back(std::move(own));
  }
}

Vector Mechanism::row_of_joint(std::size_t q) const {
  Vector row(dimension_);
  row[dimension_ - joints_.size() + q] = 1;
  return row;
}

Vector Mechanism::row(const Turns& over) const {
  Vector row(dimension_);
  for (const auto& [link, r] : over) {
    for (std::size_t q = 0; q < joints_.size(); ++q) {
      const auto c = joints_[q].find(link);
      if (c != joints_[q].end()) row[dimension_ - joints_.size() + q] += r * c->second;
    }
  }
  return row;
}

Vector at_point(const Vector& p, const Vector& f) {
  if (p.size() == 2) return {f[0], f[1], Rational(p[0] * f[1] - p[1] * f[0])};
  Vector wrench = f;
  for (std::size_t j = 0; j < 3; ++j) {
    const std::size_t k = (j + 1) % 3;
    const std::size_t l = (j + 2) % 3;
    wrench.emplace_back(p[k] * f[l] - p[l] * f[k]);
  }
  return wrench;
}

Vector bound_of(const Rational& length, const Rational& angle, std::size_t dimension,
                bool in_space) {
  const std::size_t numbers = in_space ? kSpatial : kPlanar;
  const std::size_t translations = in_space ? 3 : 2;
  Vector bound;
  for (std::size_t j = 0; j < dimension; ++j) {
    bound.push_back(j % numbers < translations ? length : angle);
  }
  return bound;
}

Vector combined(const Matrix& rows, const Vector& factors) {
  Vector result(rows[0].size());
  spend(kStepsOfRational * factors.size() * result.size());
  for (std::size_t k = 0; k < factors.size(); ++k) add(result, factors[k], rows[k]);
  return result;
}

Vector seen(const Sight& sight, const Vector& row) {
  return sight ? combined(sight->rows, row) : row;
}

}  // namespace stickslip_check
