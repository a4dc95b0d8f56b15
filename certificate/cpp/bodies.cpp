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

namespace {

/// to += factor row
void add_row(SparseRow& to, const Rational& factor, const SparseRow& row) {
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
  to = std::move(sum);
}

Rational product(const SparseRow& row, const Vector& d) {
  spend(kStepsOfRational * (row.size() + 1));
  Rational sum;
  for (const auto& [j, entry] : row) sum += entry * d[j];
  return sum;
}

}  // namespace

Mechanism::Mechanism(std::vector<Body> bodies, const std::vector<Turns>& joints, bool in_space)
    : bodies_(std::move(bodies)),
      turns_(bodies_.size()),
      size_(in_space ? kSpatial : kPlanar),
      joints_(joints.size()),
      dimension_(dimension_of(bodies_, joints.size(), in_space)) {
  std::size_t next = 0;
  for (const Body& body : bodies_) {
    first_.push_back(body.way ? 0 : next);
    if (!body.way) next += size_;
  }
  for (std::size_t q = 0; q < joints.size(); ++q) {
    for (const auto& [link, c] : joints[q]) turns_[link].emplace_back(next + q, c);
  }
}

Matrix Mechanism::motion(std::optional<std::size_t> body) const {
  Matrix own{dimension_, std::vector<SparseRow>(size_)};
  for (; body; body = bodies_[*body].on) {
    for (std::size_t k = 0; k < size_; ++k) {
      if (bodies_[*body].way) {
        add_row(own.rows[k], (*bodies_[*body].way)[k], turns_[*body]);
      } else {
        add_row(own.rows[k], 1, {{first_[*body] + k, 1}});
      }
    }
  }
  return own;
}

Matrix Mechanism::motion_between(std::size_t of, std::optional<std::size_t> by) const {
  Matrix rows = motion(of);
  const Matrix under = motion(by);
  for (std::size_t k = 0; k < size_; ++k) add_row(rows.rows[k], -1, under.rows[k]);
  return rows;
}

SparseRow Mechanism::row_of_joint(std::size_t q) const {
  return {{dimension_ - joints_ + q, 1}};
}

SparseRow Mechanism::row(const Turns& over) const {
  SparseRow row;
  for (const auto& [link, r] : over) add_row(row, r, turns_[link]);
  return row;
}

std::vector<Vector> Mechanism::moved(const Vector& d) const {
  std::vector<Vector> motions;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const Body& body = bodies_[b];
    spend(kStepsOfRational * size_);
    if (!body.way) {
      const auto first = d.begin() + static_cast<std::ptrdiff_t>(first_[b]);
      motions.emplace_back(first, first + static_cast<std::ptrdiff_t>(size_));
      continue;
    }
    Vector motion = body.on ? motions[*body.on] : Vector(size_);
    add(motion, product(turns_[b], d), *body.way);
    motions.push_back(std::move(motion));
  }
  return motions;
}

void Mechanism::add_pulled(std::vector<Vector> wrenches, Vector& to) const {
  for (std::size_t b = wrenches.size(); b-- > 0;) {
    const Vector wrench = std::move(wrenches[b]);
    if (wrench.empty()) continue;
    spend(kStepsOfRational * (size_ + turns_[b].size()));
    const Body& body = bodies_[b];
    if (!body.way) {
      for (std::size_t k = 0; k < size_; ++k) to[first_[b] + k] += wrench[k];
      continue;
    }
    const Rational work = dot(wrench, *body.way);
    for (const auto& [q, c] : turns_[b]) to[q] += work * c;
    if (!body.on) continue;
    wrenches[*body.on].resize(size_);
    add(wrenches[*body.on], 1, wrench);
  }
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
  for (std::size_t k = 0; k < factors.size(); ++k) {
    spend(kStepsOfRational * (matrix.rows[k].size() + 1));
    for (const auto& [j, entry] : matrix.rows[k]) result[j] += factors[k] * entry;
  }
  return result;
}

Vector seen(const Sight& sight, const Vector& row) {
  return sight ? combined(sight->rows, row) : row;
}

BodyMotions::BodyMotions(const Mechanism* mechanism, Vector d) : d_(std::move(d)) {
  if (mechanism != nullptr) motions_ = mechanism->moved(d_);
}

Vector BodyMotions::seen_by(const Sight& sight) const {
  if (!sight) return d_;
  if (!is_contact(sight)) return {product(sight->rows.rows[0], d_)};
  Vector motion = motions_[sight->of];
  if (sight->by) stickslip_check::add(motion, -1, motions_[*sight->by]);
  return motion;
}

void BodyForces::add(const Sight& sight, const Vector& row) {
  if (!sight) return stickslip_check::add(sum_, 1, row);
  if (!is_contact(sight)) {
    for (const auto& [j, entry] : sight->rows.rows[0]) sum_[j] += row[0] * entry;
    return;
  }
  const auto on_body = [&](std::size_t body, int sign) {
    if (wrenches_.size() <= body) wrenches_.resize(body + 1);
    wrenches_[body].resize(row.size());
    stickslip_check::add(wrenches_[body], sign, row);
  };
  on_body(sight->of, 1);
  if (sight->by) on_body(*sight->by, -1);
}

Vector BodyForces::total() {
  if (mechanism_ != nullptr) mechanism_->add_pulled(std::move(wrenches_), sum_);
  return std::move(sum_);
}

}  // namespace stickslip_check
