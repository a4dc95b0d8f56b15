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

Matrix unit_matrix(std::size_t size) {
  Matrix unit{size, {}};
  for (std::size_t j = 0; j < size; ++j) unit.rows.push_back({{j, 1}});
  return unit;
}

SparseRow plus(const SparseRow& to, const Rational& factor, const SparseRow& row) {
  SparseRow sum;
  auto a = to.begin();
  auto b = row.begin();
  while (a != to.end() || b != row.end()) {
    const bool from_a = b == row.end() || (a != to.end() && a->first <= b->first);
    const bool from_b = a == to.end() || (b != row.end() && b->first <= a->first);
    const std::size_t column = from_a ? a->first : b->first;
    Rational entry = from_a ? a++->second : Rational(0);
    if (from_b) entry += factor * b++->second;
    if (entry != 0) sum.emplace_back(column, std::move(entry));
  }
  return sum;
}

Mechanism::Mechanism(const std::vector<Body>& bodies, std::vector<Turns> joints, bool in_space)
    : joints_(std::move(joints)), dimension_(dimension_of(bodies, joints_.size(), in_space)) {
  ground_ = {dimension_, std::vector<SparseRow>(in_space ? kSpatial : kPlanar)};
  std::size_t next = 0;  // column
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Body& body = bodies[b];
    Matrix own = body.way ? motion(body.on) : ground_;
    for (std::size_t k = 0; k < own.rows.size(); ++k) {
      if (body.way) {
        own.rows[k] = plus(own.rows[k], 1, row({{b, (*body.way)[k]}}));
      } else {
        own.rows[k].emplace_back(next++, 1);
      }
    }
    motions_.push_back(std::move(own));
  }
}

SparseRow Mechanism::row_of_joint(std::size_t q) const {
  return {{dimension_ - joints_.size() + q, 1}};
}

SparseRow Mechanism::row(const Turns& over) const {
  SparseRow row;
  for (std::size_t q = 0; q < joints_.size(); ++q) {
    Rational sum;
    for (const auto& [link, r] : over) {
      const auto c = joints_[q].find(link);
      if (c != joints_[q].end()) sum += r * c->second;
    }
    if (sum != 0) row.emplace_back(dimension_ - joints_.size() + q, std::move(sum));
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

Vector combined(const Matrix& matrix, const Vector& factors) {
  Vector result(matrix.columns);
  add_combined(result, matrix, factors);
  return result;
}

void add_combined(Vector& to, const Matrix& matrix, const Vector& factors) {
  for (std::size_t k = 0; k < factors.size(); ++k) {
    spend(kStepsOfRational * (matrix.rows[k].size() + 1));
    for (const auto& [j, entry] : matrix.rows[k]) to[j] += factors[k] * entry;
  }
}

Vector moved(const Matrix& matrix, const Vector& motion) {
  Vector result;
  for (const SparseRow& row : matrix.rows) {
    spend(kStepsOfRational * (row.size() + 1));
    Rational& sum = result.emplace_back();
    for (const auto& [j, entry] : row) sum += entry * motion[j];
  }
  return result;
}

Vector seen(const Sight& sight, const Vector& row) {
  return sight ? combined(sight->rows, row) : row;
}

}  // namespace stickslip_check
