// SPDX-License-Identifier: GPL-3.0-or-later
#include "naive_region.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace stickslip::test {
namespace {

Vector5 plus(const Vector5& a, const Rational& factor, const Vector5& b) {
  Vector5 sum;
  for (std::size_t j = 0; j < 5; ++j) sum[j] = a[j] + factor * b[j];
  return sum;
}

Vector5 minus(const Vector5& a) {
  return plus({}, -1, a);
}

Vector5 slip_function(const Problem& problem, std::size_t contact) {
  const Wrench& t = problem.rows()[contact].tangent;
  return {t.x, t.y, t.torque, 0, 0};
}

/// v = P' h + P^u' l - k' N.d.
Vector5 separation_function(const Problem& problem, std::size_t contact) {
  const ContactRow& row = problem.rows()[contact];
  return {-row.stiffness * row.normal.x, -row.stiffness * row.normal.y,
          -row.stiffness * row.normal.torque, row.preload,
          problem.separation(ContactId(contact))[4]};
}

/// Reduced row echelon form; the pivot columns are returned.
std::vector<std::size_t> reduce(Rays& rows) {
  std::vector<std::size_t> pivots;
  for (std::size_t column = 0; column < 5; ++column) {
    const std::size_t next = pivots.size();
    std::size_t found = next;
    while (found < rows.size() && rows[found][column].is_zero()) ++found;
    if (found == rows.size()) continue;
    std::swap(rows[next], rows[found]);
    const Rational pivot = rows[next][column];
    for (Rational& entry : rows[next]) entry /= pivot;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (r != next && !rows[r][column].is_zero()) {
        rows[r] = plus(rows[r], -rows[r][column], rows[next]);
      }
    }
    pivots.push_back(column);
  }
  rows.resize(pivots.size());
  return pivots;
}

Rays null_space(Rays rows) {
  const std::vector<std::size_t> pivots = reduce(rows);
  Rays basis;
  for (std::size_t free = 0; free < 5; ++free) {
    if (std::find(pivots.begin(), pivots.end(), free) != pivots.end()) continue;
    Vector5 v{};
    v[free] = 1;
    for (std::size_t p = 0; p < pivots.size(); ++p) v[pivots[p]] = -rows[p][free];
    basis.push_back(v);
  }
  return basis;
}

/// Calls visit with every choice of `count` of the functions.
template <class Visit>
void for_each_choice(const Rays& functions, std::size_t count, const Visit& visit,
                     std::size_t first = 0, const Rays& chosen = {}) {
  if (chosen.size() == count) {
    visit(chosen);
    return;
  }
  for (std::size_t f = first; f < functions.size(); ++f) {
    Rays more = chosen;
    more.push_back(functions[f]);
    for_each_choice(functions, count, visit, f + 1, more);
  }
}

}  // namespace

Rational value_at(const Vector5& function, const Vector5& x) {
  Rational sum = 0;
  for (std::size_t j = 0; j < 5; ++j) sum += function[j] * x[j];
  return sum;
}

Vector5 to_rational(const IntegerVector5& x) {
  return {Rational(x[0]), Rational(x[1]), Rational(x[2]), Rational(x[3]), Rational(x[4])};
}

bool Constraint::holds_at(const Vector5& x) const {
  const int found = value_at(function, x).sign();
  return found == 0 || found == sign;
}

Rays Generators::directions() const {
  Rays result;
  for (const Vector5& line : lines) {
    result.push_back(line);
    result.push_back(minus(line));
  }
  result.insert(result.end(), rays.begin(), rays.end());
  return result;
}

std::size_t rank_of(Rays vectors) {
  return reduce(vectors).size();
}

Generators brute_force_generators(const std::vector<Constraint>& constraints) {
  Rays functions;
  for (const Constraint& c : constraints) functions.push_back(c.function);
  Generators result;
  result.lines = null_space(functions);
  const std::size_t rank = 5 - result.lines.size();
  if (rank == 0) return result;
  // An extreme ray lies on rank - 1 independent planes. Modulo the lines it is known by the
  // values of the functions, up to scale.
  std::set<std::vector<Rational>> seen;
  for_each_choice(functions, rank - 1, [&](const Rays& chosen) {
    const Rays space = null_space(chosen);
    if (space.size() != result.lines.size() + 1) return;
    for (const Vector5& v : space) {
      for (const Vector5& x : {v, minus(v)}) {
        std::vector<Rational> values;
        Rational scale = 0;
        for (const Vector5& f : functions) {
          values.push_back(value_at(f, x));
          scale = std::max(scale, Rational(abs(values.back())));
        }
        if (scale.is_zero()) continue;  // on a line
        for (Rational& entry : values) entry /= scale;
        const bool inside = std::all_of(constraints.begin(), constraints.end(),
                                        [&](const Constraint& c) { return c.holds_at(x); });
        if (inside && seen.insert(values).second) result.rays.push_back(x);
      }
    }
  });
  return result;
}

NaiveRegion NaiveRegion::root(const Problem& problem) {
  NaiveRegion region;
  const Vector5 h{0, 0, 0, 1, 0};
  region.constraints.push_back({h, 1});
  region.strict.push_back(h);
  if (problem.is_family()) {
    const MultipleRange& range = problem.multiples();
    const auto add_end = [&](const Vector5& function, bool is_strict) {
      region.constraints.push_back({function, 1});
      if (is_strict) region.strict.push_back(function);
    };
    add_end({0, 0, 0, -range.low, 1}, !range.has_low);
    if (range.high) add_end({0, 0, 0, *range.high, -1}, true);
  } else {
    region.constraints.push_back({{0, 0, 0, 0, 1}, 0});
  }
  if (problem.law() == NormalLaw::kBilateral) {
    for (std::size_t i = 0; i < problem.size(); ++i) {
      region.constraints.push_back({separation_function(problem, i), 1});
    }
  }
  region.labels.resize(problem.size());
  return region;
}

NaiveRegion NaiveRegion::slip_child(const Problem& problem, std::size_t contact,
                                    int slip) const {
  NaiveRegion child = *this;
  child.constraints.push_back({slip_function(problem, contact), slip});
  child.labels[contact] = slip;
  if (slip != 0) child.strict.push_back(slip_function(problem, contact));
  return child;
}

NaiveRegion NaiveRegion::separation_child(const Problem& problem, std::size_t contact,
                                          bool closed) const {
  return plane_child(separation_function(problem, contact), closed);
}

NaiveRegion NaiveRegion::plane_child(const Vector5& plane, bool first) const {
  NaiveRegion child = *this;
  child.constraints.push_back({plane, first ? 1 : -1});
  if (!first) child.strict.push_back(plane);
  return child;
}

bool naive_is_barred(const NaiveRegion& region, const Rays& rays) {
  for (const Vector5& strict : region.strict) {
    bool zero_on_all = true;
    for (const Vector5& ray : rays)
      zero_on_all = zero_on_all && value_at(strict, ray).is_zero();
    if (zero_on_all) return true;
  }
  return false;
}

std::optional<int> naive_sign(const Problem& problem, const NaiveRegion& region,
                              const Rays& rays, std::size_t contact) {
  if (region.labels[contact] == 1) return 1;
  if (region.labels[contact] == -1) return -1;
  if (region.labels[contact] == 0) return std::nullopt;
  const Vector5 tau = slip_function(problem, contact);
  bool never_negative = true;
  bool never_positive = true;
  Rays zero;
  for (const Vector5& ray : rays) {
    const int sign = value_at(tau, ray).sign();
    if (sign < 0) never_negative = false;
    if (sign > 0) never_positive = false;
    if (sign == 0) zero.push_back(ray);
  }
  if (!naive_is_barred(region, zero)) return std::nullopt;
  if (never_negative) return 1;
  if (never_positive) return -1;
  return std::nullopt;
}

std::vector<Rational> naive_bounds(const Problem& problem, const NaiveRegion& region,
                                   const Rays& rays, const TwistLeaf& leaf) {
  const Rational y[] = {Rational(leaf.twist[0]), Rational(leaf.twist[1]),
                        Rational(leaf.twist[2])};
  const auto work = [&](const Wrench& w) { return y[0] * w.x + y[1] * w.y + y[2] * w.torque; };
  std::vector<Rational> bounds;
  for (const Vector5& ray : rays) {
    bounds.push_back(ray[3] * work(problem.wrench()) + ray[4] * work(problem.load_growth()));
  }
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    const Rational against = work(row.normal) - row.friction * work(row.tangent);
    const Rational along = work(row.normal) + row.friction * work(row.tangent);
    const std::optional<int> sign = naive_sign(problem, region, rays, i);
    const Rational alpha = sign == 1 ? against : sign == -1 ? along : std::max(against, along);
    std::vector<Rational> v;
    bool closed = true;
    for (const Vector5& ray : rays) {
      v.push_back(value_at(separation_function(problem, i), ray));
      closed = closed && v.back() >= 0;
    }
    for (std::size_t r = 0; r < rays.size(); ++r) {
      if (closed) {
        bounds[r] += alpha * v[r];
      } else {
        bounds[r] += std::max(Rational(0), alpha) * std::max(Rational(0), v[r]);
      }
    }
  }
  return bounds;
}

bool naive_refutes(const Problem& problem, const NaiveRegion& region, const Rays& rays,
                   const TwistLeaf& leaf) {
  if (naive_is_barred(region, rays)) return true;
  const std::vector<Rational> bounds = naive_bounds(problem, region, rays, leaf);
  Rays zero;
  for (std::size_t r = 0; r < rays.size(); ++r) {
    if (bounds[r] > 0) return false;
    if (bounds[r] == 0) zero.push_back(rays[r]);
  }
  return naive_is_barred(region, zero);
}

}  // namespace stickslip::test
