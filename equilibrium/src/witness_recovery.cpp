// SPDX-License-Identifier: GPL-3.0-or-later
#include "witness_recovery.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using Matrix3 = std::array<Double3, 3>;

/// Solves (a + damping) x = b; false if singular in double.
bool solve3(Matrix3 a, Double3 b, Double3& x) {
  for (std::size_t c = 0; c < 3; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < 3; ++r) {
      if (std::fabs(a[r][c]) > std::fabs(a[pivot][c])) pivot = r;
    }
    if (!(std::fabs(a[pivot][c]) > 0)) return false;
    std::swap(a[pivot], a[c]);
    std::swap(b[pivot], b[c]);
    for (std::size_t r = 0; r < 3; ++r) {
      if (r == c) continue;
      const double factor = a[r][c] / a[c][c];
      for (std::size_t k = c; k < 3; ++k) a[r][k] -= factor * a[c][k];
      b[r] -= factor * b[c];
    }
  }
  for (std::size_t c = 0; c < 3; ++c) x[c] = b[c] / a[c][c];
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

/// The sum of rationals in pairs, so that long numbers meet only at the end.
Rational sum_in_pairs(std::vector<Rational> terms) {
  if (terms.empty()) return 0;
  while (terms.size() > 1) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k + 1 < terms.size(); k += 2)
      terms[kept++] = terms[k] + terms[k + 1];
    if (terms.size() % 2 == 1) terms[kept++] = std::move(terms.back());
    terms.resize(kept);
  }
  return std::move(terms.front());
}

/// Gauss-Jordan on [a | b]; nothing if singular.
std::optional<std::vector<Rational>> solve_exactly(std::vector<std::vector<Rational>> rows) {
  const std::size_t n = rows.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    while (pivot < n && rows[pivot][c].is_zero()) ++pivot;
    if (pivot == n) return std::nullopt;
    std::swap(rows[pivot], rows[c]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == c || rows[r][c].is_zero()) continue;
      const Rational factor = rows[r][c] / rows[c][c];
      for (std::size_t k = c; k <= n; ++k) rows[r][k] -= factor * rows[c][k];
    }
  }
  std::vector<Rational> solution;
  for (std::size_t c = 0; c < n; ++c) solution.push_back(rows[c][n] / rows[c][c]);
  return solution;
}

/// At most three sticking contacts with linearly independent T, those with the most room in the
/// friction cone first.
std::vector<std::size_t> choose_basic(const Problem& problem,
                                      const std::vector<ContactMode>& modes) {
  std::vector<std::size_t> candidates;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    // Friction at an open or frictionless contact is 0 and cannot be an unknown.
    if (modes[i].sticks && modes[i].closed && !problem.rows()[i].friction.is_zero()) {
      candidates.push_back(i);
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(), [&](std::size_t a, std::size_t b) {
    return std::fabs(modes[a].friction_ratio) < std::fabs(modes[b].friction_ratio);
  });
  std::vector<std::size_t> basic;
  std::vector<std::vector<Rational>> echelon;
  for (const std::size_t i : candidates) {
    const Vector3 t = coordinates(problem.rows()[i].tangent);
    std::vector<Rational> row(t.begin(), t.end());
    for (const std::vector<Rational>& e : echelon) {
      const auto lead = static_cast<std::size_t>(
          std::find_if(e.begin(), e.end(), [](const Rational& v) { return !v.is_zero(); }) -
          e.begin());
      const Rational factor = row[lead] / e[lead];
      for (std::size_t k = 0; k < 3; ++k) row[k] -= factor * e[k];
    }
    if (std::all_of(row.begin(), row.end(), [](const Rational& v) { return v.is_zero(); }))
      continue;
    echelon.push_back(std::move(row));
    basic.push_back(i);
    if (basic.size() == 3) break;
  }
  return basic;
}

Rational rounded_ratio(double ratio) {
  constexpr double kSteps = 4096;
  const double clamped = std::clamp(ratio, -1.0, 1.0);
  return Rational(std::lround(clamped * kSteps), static_cast<long>(kSteps));
}

}  // namespace

std::optional<Witness> complete_exactly(const Problem& problem,
                                        const std::vector<ContactMode>& modes) {
  const std::vector<std::size_t> basic = choose_basic(problem, modes);
  const std::size_t n = 3 + basic.size();
  // Unknowns: d, then friction at the basic contacts. Rows: balance, then no slip at these.
  std::vector<Rational> ratio(modes.size());
  std::array<std::array<std::vector<Rational>, 4>, 3> terms;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (!modes[i].closed) continue;
    const ContactRow& row = problem.rows()[i];
    const bool is_basic = std::find(basic.begin(), basic.end(), i) != basic.end();
    if (!is_basic) ratio[i] = rounded_ratio(modes[i].friction_ratio);
    const Vector3 wrench = coordinates(row.normal + (ratio[i] * row.friction) * row.tangent);
    const Vector4& v = problem.separation(ContactId(i));
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 4; ++c) terms[r][c].push_back(wrench[r] * v[c]);
    }
  }
  std::vector<std::vector<Rational>> system(n, std::vector<Rational>(n + 1));
  const Vector3 load = coordinates(problem.wrench());
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) system[r][c] = sum_in_pairs(std::move(terms[r][c]));
    system[r][n] = -load[r] - sum_in_pairs(std::move(terms[r][3]));
  }
  for (std::size_t k = 0; k < basic.size(); ++k) {
    const Vector3 t = coordinates(problem.rows()[basic[k]].tangent);
    for (std::size_t r = 0; r < 3; ++r) {
      system[r][3 + k] = t[r];
      system[3 + k][r] = t[r];
    }
  }
  const auto solution = solve_exactly(std::move(system));
  if (!solution) return std::nullopt;
  Witness witness;
  witness.twist = {(*solution)[0], (*solution)[1], (*solution)[2]};
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    ContactForce force{0, 0};
    if (modes[i].closed) {
      force.normal = row.normal_coefficient(witness.twist);
      force.tangential = ratio[i] * row.friction * force.normal;
    }
    witness.forces.push_back(std::move(force));
  }
  for (std::size_t k = 0; k < basic.size(); ++k) {
    witness.forces[basic[k]].tangential = (*solution)[3 + k];
  }
  if (find_violation(problem, witness)) return std::nullopt;
  return witness;
}

std::optional<Witness> find_witness_near(const Problem& problem, const DoubleModel& model,
                                         Double3 start) {
  const std::size_t m = model.contacts.size();
  Double3 d = start;
  double epsilon = 0;
  // Balance and its derivative, lengths scaled so that all entries are comparable.
  const auto residual = [&](const Double3& at, Matrix3* derivative) {
    Double3 f = model.load;
    if (derivative != nullptr) *derivative = {};
    for (const ContactDoubles& c : model.contacts) {
      const Double4 x{at[0], at[1], at[2], 1};
      const double v = dot(c.separation, x);
      if (v <= 0) continue;
      const double slip = dot(c.slip, x);
      const double ratio = std::clamp(-slip / epsilon, -1.0, 1.0);
      for (std::size_t r = 0; r < 3; ++r) {
        const double edge = c.normal[r] + ratio * c.friction[r];
        f[r] += v * edge;
        if (derivative == nullptr) continue;
        for (std::size_t k = 0; k < 3; ++k) {
          (*derivative)[r][k] += edge * c.separation[k];
          if (std::fabs(ratio) < 1) {
            (*derivative)[r][k] -= v * c.friction[r] * c.slip[k] / epsilon;
          }
        }
      }
    }
    return f;
  };
  const auto norm = [&](const Double3& f) {
    return std::fabs(f[0]) + std::fabs(f[1]) + std::fabs(f[2]) / model.length;
  };
  double stiffness = 0;
  for (const ContactDoubles& c : model.contacts) stiffness += c.stiffness;
  if (m == 0 || !(stiffness > 0)) return complete_exactly(problem, {});
  const double travel = model.force / stiffness * static_cast<double>(m);
  constexpr int kStages = 14;
  constexpr int kSteps = 12;
  constexpr double kShrink = 0.1;
  epsilon = travel;
  for (int stage = 0; stage < kStages; ++stage, epsilon *= kShrink) {
    for (int step = 0; step < kSteps; ++step) {
      Matrix3 derivative;
      const Double3 f = residual(d, &derivative);
      const double size = norm(f);
      if (size <= 1e-13 * model.force) break;
      Double3 change{};
      const Double3 minus{-f[0], -f[1], -f[2]};
      double trace = 0;
      for (std::size_t k = 0; k < 3; ++k) trace += std::fabs(derivative[k][k]);
      // The derivative is negative definite without friction; this keeps it regular.
      for (std::size_t k = 0; k < 3; ++k) derivative[k][k] -= 1e-12 * trace + 1e-300;
      if (!solve3(derivative, minus, change)) return std::nullopt;
      double factor = 1;
      bool better = false;
      for (int halving = 0; halving < 8 && !better; ++halving, factor *= 0.5) {
        const Double3 next{d[0] + factor * change[0], d[1] + factor * change[1],
                           d[2] + factor * change[2]};
        if (norm(residual(next, nullptr)) < size) {
          d = next;
          better = true;
        }
      }
      if (!better) break;
    }
  }
  epsilon /= kShrink;
  if (norm(residual(d, nullptr)) > 1e-6 * model.force) return std::nullopt;
  std::vector<ContactMode> modes;
  modes.reserve(m);
  for (const ContactDoubles& c : model.contacts) {
    const Double4 x{d[0], d[1], d[2], 1};
    const double slip = dot(c.slip, x);
    const double ratio = std::clamp(-slip / epsilon, -1.0, 1.0);
    modes.push_back({dot(c.separation, x) > 0, ratio, std::fabs(slip) < epsilon});
  }
  return complete_exactly(problem, modes);
}

}  // namespace stickslip
