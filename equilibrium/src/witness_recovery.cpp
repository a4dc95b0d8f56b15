// SPDX-License-Identifier: GPL-3.0-or-later
#include "witness_recovery.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scaled_twist.hpp"

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

/// Gauss-Jordan on [a | b]; nothing if there is no solution or, unless `may_be_singular`, more
/// than one. Unknowns that are left open are 0.
std::optional<std::vector<Rational>> solve_exactly(std::vector<std::vector<Rational>> rows,
                                                   bool may_be_singular) {
  const std::size_t n = rows.front().size() - 1;
  std::vector<Rational> solution(n);
  std::vector<std::size_t> pivot_columns;  // of the rows, from the first
  for (std::size_t c = 0; c < n; ++c) {
    const std::size_t top = pivot_columns.size();
    std::size_t pivot = top;
    while (pivot < rows.size() && rows[pivot][c].is_zero()) ++pivot;
    if (pivot == rows.size()) {
      if (!may_be_singular) return std::nullopt;
      continue;
    }
    std::swap(rows[pivot], rows[top]);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (r == top || rows[r][c].is_zero()) continue;
      const Rational factor = rows[r][c] / rows[top][c];
      for (std::size_t k = c; k <= n; ++k) rows[r][k] -= factor * rows[top][k];
    }
    pivot_columns.push_back(c);
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (r < pivot_columns.size()) {
      solution[pivot_columns[r]] = rows[r][n] / rows[r][pivot_columns[r]];
    } else if (!rows[r][n].is_zero()) {
      return std::nullopt;
    }
  }
  return solution;
}

/// Sticks with all the friction there can be: known, and so is its slip.
bool rests_on_edge(const ContactMode& mode) {
  return mode.sticks && mode.closed && mode.exact_ratio && abs(*mode.exact_ratio) == 1;
}

/// At most three sticking contacts with linearly independent T, those with the most room in the
/// friction cone first.
std::vector<std::size_t> choose_basic(const Problem& problem,
                                      const std::vector<ContactMode>& modes) {
  std::vector<std::size_t> candidates;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    // Friction at an open or frictionless contact is 0 and cannot be an unknown.
    if (modes[i].sticks && modes[i].closed && !rests_on_edge(modes[i]) &&
        !problem.rows()[i].friction.is_zero()) {
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

/// Fine enough that the errors of many contacts together leave room at the basic ones.
Rational rounded_ratio(double ratio) {
  constexpr double kSteps = 4294967296.0;
  const double clamped = std::clamp(ratio, -1.0, 1.0);
  return Rational(std::lround(clamped * kSteps), static_cast<long>(kSteps));
}

}  // namespace

std::optional<Witness> complete_exactly(const Problem& problem,
                                        const std::vector<ContactMode>& modes,
                                        const Witness* near) {
  const std::vector<std::size_t> basic = choose_basic(problem, modes);
  const std::size_t n = 3 + basic.size();
  // Unknowns: d, then friction at the basic contacts. Rows: balance, then no slip at these.
  std::vector<Rational> ratio(modes.size());
  std::array<std::array<std::vector<Rational>, 4>, 3> terms;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (!modes[i].closed) continue;
    const ContactRow& row = problem.rows()[i];
    const bool is_basic = std::find(basic.begin(), basic.end(), i) != basic.end();
    if (!is_basic) {
      ratio[i] =
          modes[i].exact_ratio ? *modes[i].exact_ratio : rounded_ratio(modes[i].friction_ratio);
    }
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
  // What is on a border of its mode stays there.
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (!rests_on_edge(modes[i]) && !modes[i].touches) continue;
    const Vector3 t = coordinates(problem.rows()[i].tangent);
    const Vector4& v = problem.separation(ContactId(i));
    system.emplace_back(n + 1);
    for (std::size_t c = 0; c < 3; ++c) system.back()[c] = modes[i].touches ? v[c] : t[c];
    if (modes[i].touches) system.back()[n] = -v[3];
  }
  // With `near` the unknowns are the changes from there.
  std::vector<Rational> start(n);
  if (near != nullptr) {
    const Vector3 twist = coordinates(near->twist);
    std::copy(twist.begin(), twist.end(), start.begin());
    for (std::size_t k = 0; k < basic.size(); ++k) {
      start[3 + k] = near->forces[basic[k]].tangential;
    }
    for (std::vector<Rational>& row : system) {
      for (std::size_t c = 0; c < n; ++c) row[n] -= row[c] * start[c];
    }
  }
  auto solution = solve_exactly(std::move(system), near != nullptr);
  if (!solution) return std::nullopt;
  for (std::size_t c = 0; c < n; ++c) (*solution)[c] += start[c];
  Witness witness;
  witness.twist = {(*solution)[0], (*solution)[1], (*solution)[2]};
  const ScaledTwist scaled(witness.twist);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    ContactForce force{0, 0};
    if (modes[i].closed) {
      force.normal = scaled.normal_coefficient(row) / scaled.scale;
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

namespace {

/// Balance with friction made smooth, -mu c_n clamp(T.d / epsilon), as three equations in d.
class SmoothBalance {
 public:
  explicit SmoothBalance(const DoubleModel& model) : model_(model) {}

  void set_epsilon(double epsilon) { epsilon_ = epsilon; }

  /// The sum of all wrenches, and its derivative where asked.
  Double3 residual(const Double3& d, Matrix3* derivative) const {
    Double3 sum = model_.loads.front();
    if (derivative != nullptr) *derivative = {};
    const Double4 x{d[0], d[1], d[2], 1};
    for (const ContactDoubles& c : model_.contacts) {
      const double v = dot(c.separation, x);
      if (v <= 0) continue;
      const double slip = dot(c.slip, x);
      const double ratio = friction_ratio(slip);
      for (std::size_t r = 0; r < 3; ++r) {
        const double edge = c.normal[r] + ratio * c.friction[r];
        sum[r] += v * edge;
        if (derivative == nullptr) continue;
        const double give = std::fabs(ratio) < 1 ? v * c.friction[r] / epsilon_ : 0;
        for (std::size_t k = 0; k < 3; ++k) {
          (*derivative)[r][k] += edge * c.separation[k] - give * c.slip[k];
        }
      }
    }
    return sum;
  }

  double norm(const Double3& wrench) const {
    return std::fabs(wrench[0]) + std::fabs(wrench[1]) + std::fabs(wrench[2]) / model_.length;
  }

  /// Newton's method with step halving. Returns the norm of the residual reached.
  double solve(Double3& d, int steps) const {
    Matrix3 derivative;
    Double3 sum = residual(d, &derivative);
    double size = norm(sum);
    for (int step = 0; step < steps && size > kConverged * model_.force; ++step) {
      double trace = 0;
      for (std::size_t k = 0; k < 3; ++k) trace += std::fabs(derivative[k][k]);
      // The derivative is negative definite without friction; this keeps it regular.
      for (std::size_t k = 0; k < 3; ++k) derivative[k][k] -= 1e-12 * trace + 1e-300;
      Double3 change{};
      if (!solve3(derivative, {-sum[0], -sum[1], -sum[2]}, change)) return size;
      const double before = size;
      for (double factor = 1; factor > 1e-3 && !(size < before); factor *= 0.5) {
        const Double3 next{d[0] + factor * change[0], d[1] + factor * change[1],
                           d[2] + factor * change[2]};
        const Double3 next_sum = residual(next, &derivative);
        const double next_size = norm(next_sum);
        if (next_size < before) {
          d = next;
          sum = next_sum;
          size = next_size;
        }
      }
      if (!(size < before)) return size;
    }
    return size;
  }

  std::vector<ContactMode> modes(const Double3& d) const {
    std::vector<ContactMode> result;
    result.reserve(model_.contacts.size());
    const Double4 x{d[0], d[1], d[2], 1};
    for (const ContactDoubles& c : model_.contacts) {
      const double slip = dot(c.slip, x);
      result.push_back(
          {dot(c.separation, x) > 0, friction_ratio(slip), std::fabs(slip) < epsilon_});
    }
    return result;
  }

  static constexpr double kConverged = 1e-13;

 private:
  double friction_ratio(double slip) const { return std::clamp(-slip / epsilon_, -1.0, 1.0); }

  const DoubleModel& model_;
  double epsilon_ = 1;
};

}  // namespace

std::optional<Witness> find_witness_from_rest(const Problem& problem,
                                              const DoubleModel& model) {
  double stiffness = 0;
  for (const ContactDoubles& c : model.contacts) stiffness += c.stiffness;
  if (!(stiffness > 0)) return complete_exactly(problem, {});
  SmoothBalance balance(model);
  Double3 d{};
  double size = HUGE_VAL;
  constexpr int kStages = 14;
  constexpr int kSteps = 12;
  double epsilon = model.force / stiffness * static_cast<double>(model.contacts.size());
  for (int stage = 0; stage < kStages; ++stage, epsilon *= 0.1) {
    balance.set_epsilon(epsilon);
    size = balance.solve(d, kSteps);
  }
  if (!(size <= 1e-6 * model.force)) return std::nullopt;
  return complete_exactly(problem, balance.modes(d));
}

std::optional<Witness> find_witness_near(const Problem& problem, const DoubleModel& model,
                                         Double3 start) {
  double travel = 0;
  for (const ContactDoubles& c : model.contacts) {
    travel = std::max(travel, std::fabs(dot(c.slip, {start[0], start[1], start[2], 1})));
  }
  if (!(travel > 0)) return std::nullopt;
  SmoothBalance balance(model);
  Double3 d = start;
  constexpr int kSteps = 8;
  // A start that is near converges at once; one that is not is left to the search.
  for (const double shrink : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    balance.set_epsilon(shrink * travel);
    if (!(balance.solve(d, kSteps) <= 1e-3 * model.force)) return std::nullopt;
  }
  if (!(balance.solve(d, kSteps) <= 1e-6 * model.force)) return std::nullopt;
  return complete_exactly(problem, balance.modes(d));
}

}  // namespace stickslip
