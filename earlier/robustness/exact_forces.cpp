// SPDX-License-Identifier: GPL-3.0-or-later
#include "earlier/robustness/exact_forces.hpp"

#include <algorithm>
#include <cmath>

#include "earlier/robustness/double_forces.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/lp/exact_system.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::robustness_detail {
namespace {

constexpr unsigned kLengthBits = 48;

/// Returns the power 2^exponent.
Rational power_of_two(int exponent) {
  const Integer power = Integer(1) << static_cast<unsigned>(std::abs(exponent));
  return exponent >= 0 ? Rational(power) : Rational(Integer(1), power);
}

/// Returns the integers nearest to x 2^bits.
Row on_grid(const Doubles& x, int bits, std::size_t size) {
  Row result;
  for (std::size_t j = 0; j < size; ++j) {
    result.emplace_back(Integer(std::round(std::ldexp(x[j], bits))));
  }
  return result;
}

/// Returns at least the length of a vector.
Rational length_above(const RationalRow& x) {
  if (x.size() == 1) return abs(x[0]);
  return short_sqrt(dot(x, x), kLengthBits).upper;
}

}  // namespace

Rational most_against(const ForceContact& contact, const Rational& along_normal,
                      const RationalRow& along_tangents) {
  Rational across = 0;
  if (contact.edges.empty()) across = length_above(along_tangents);
  for (const FrictionDirection& edge : contact.edges) {
    across = std::max(across, Rational(-dot(edge.along, along_tangents)));
  }
  const Rational most = contact.friction * across - along_normal;
  return most.sign() > 0 ? most : Rational(0);
}

Multipliers::Multipliers(const Doubles& twist, const std::vector<MatrixTerm>& terms,
                         std::size_t size)
    : matrix_(size, Row(size)) {
  constexpr int kTwistBits = 36;
  double largest = 0;
  for (const double x : twist) largest = std::max(largest, std::abs(x));
  int exponent = 0;
  if (largest > 0 && std::isfinite(largest)) std::frexp(largest, &exponent);
  twist_ = std::isfinite(largest) ? on_grid(twist, kTwistBits - exponent, size) : Row(size);
  twist_unit_ = power_of_two(exponent - kTwistBits);
  constexpr int kVectorBits = 30;
  constexpr int kWeightBits = 30;
  for (const MatrixTerm& term : terms) {
    const Integer weight(std::round(std::ldexp(std::min(term.weight, 1e6), kWeightBits)));
    if (weight.sign() <= 0) continue;
    const Row u = on_grid(term.u, kVectorBits, size);
    for (std::size_t j = 0; j < size; ++j) {
      for (std::size_t k = 0; k < size; ++k) matrix_[j][k] += weight * u[j] * u[k];
    }
  }
  matrix_unit_ = power_of_two(-kWeightBits - 2 * kVectorBits);
  for (std::size_t j = 0; j < size; ++j) trace_ += matrix_unit_ * Rational(matrix_[j][j]);
}

Rational Multipliers::along(const ScaledRow& a) const {
  return twist_unit_ * a.factor * Rational(stickslip::dot(twist_, a.integers));
}

Rational Multipliers::along(const RationalRow& a) const {
  return twist_unit_ * stickslip::dot(twist_, a);
}

Rational Multipliers::square(const ScaledRow& a) const {
  Integer sum;
  for (std::size_t j = 0; j < matrix_.size(); ++j) {
    if (a.integers[j].is_zero()) continue;
    Integer row;
    for (std::size_t k = j + 1; k < matrix_.size(); ++k) row += matrix_[j][k] * a.integers[k];
    row += row;
    row += matrix_[j][j] * a.integers[j];
    sum += a.integers[j] * row;
  }
  return matrix_unit_ * a.factor * a.factor * Rational(sum);
}

MixtureLeaf Multipliers::leaf() const {
  MixtureLeaf leaf;
  for (const Integer& x : twist_) leaf.twist.push_back(twist_unit_ * Rational(x));
  for (const Row& row : matrix_) {
    RationalRow& scaled = leaf.matrix.emplace_back();
    for (const Integer& x : row) scaled.push_back(matrix_unit_ * Rational(x));
  }
  return leaf;
}

NodeBound node_bound(const ForceModel& model, const std::vector<StateSet>& sets,
                     const Rational& distance, const Multipliers& multipliers) {
  const bool has_matrix = multipliers.trace().sign() > 0;
  Rational sum = -multipliers.along(model.load);
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    const ForceContact& contact = model.contacts[i];
    std::optional<Rational> most;
    const auto offer = [&](Rational value) {
      if (!most || value > *most) most = std::move(value);
    };
    if ((sets[i] & only(SpringState::kDetached)) != 0) offer(0);
    const bool may_slip =
        (sets[i] & only(SpringState::kSlip)) != 0 && 2 * distance <= contact.most_force;
    Rational offset;
    Rational room = -1;
    if ((sets[i] & only(SpringState::kStick)) != 0 && contact.can_stick()) {
      // The root is rounded down, which allows more forces.
      offset = distance * contact.root.lower / contact.friction;
      room = contact.most_force - distance - offset;
    }
    const bool may_stick = room.sign() >= 0;
    if (may_slip || may_stick) {
      const Rational along = multipliers.along(contact.normal);
      Rational square = has_matrix ? multipliers.square(contact.normal) : Rational(0);
      if (may_slip) {
        // The normal force is from distance to f - distance.
        const Rational force =
            along.sign() >= 0 ? distance : Rational(contact.most_force - distance);
        offer(square - force * along);
      }
      if (may_stick) {
        RationalRow across;
        for (const ScaledRow& t : contact.tangents) {
          across.push_back(multipliers.along(t));
          if (has_matrix) square += multipliers.square(t);
        }
        offer(square - offset * along + room * most_against(contact, along, across));
      }
    }
    if (!most) return {true, std::nullopt};
    sum += *most;
  }
  if (sum.sign() < 0) return {true, std::nullopt};
  if (!has_matrix) return {};
  return {false, sum / multipliers.trace()};
}

Rational greatest_distance(const ForceModel& model, const std::vector<SpringState>& states,
                           const RationalRow& twist) {
  // Forces with a distance of d need 0 <= sum f h - y.w - d sum (offset y.N + (1 + offset) h),
  // where h = most_against.
  Rational constant = -dot(twist, model.load);
  Rational slope = 0;
  Rational least = model.most_force / 2;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const ForceContact& contact = model.contacts[i];
    if (states[i] == SpringState::kDetached) continue;
    const Rational along = dot(twist, contact.normal.row());
    RationalRow across;
    Rational offset = 1;
    if (states[i] == SpringState::kStick) {
      if (!contact.can_stick()) return 0;
      offset = contact.root.lower / contact.friction;
      for (const ScaledRow& t : contact.tangents) across.push_back(dot(twist, t.row()));
    } else {
      across.resize(contact.tangents.size());
    }
    const Rational against = most_against(contact, along, across);
    constant += contact.most_force * against;
    slope += offset * along + (1 + offset) * against;
    least = std::min(least, Rational(contact.most_force / (1 + offset)));
  }
  if (slope.sign() > 0) return std::min(least, Rational(constant / slope));
  if (constant.sign() < 0) return -1;
  return least;
}

ExactForces exact_forces(const ForceModel& model, const std::vector<SpringState>& states,
                         const std::vector<std::vector<FrictionDirection>>& directions) {
  struct Share {
    std::size_t contact;
    RationalRow force;  ///< the normal force and the tangential ones
  };
  const std::size_t size = model.coordinates;
  std::vector<Share> shares;
  std::vector<RationalRow> rows(size, RationalRow(1));
  std::vector<RationalRow> bounds;  // the rows of the bounds of normal forces
  std::vector<Rational> offsets(states.size());
  std::vector<std::optional<std::size_t>> bound_of(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    const ForceContact& contact = model.contacts[i];
    if (states[i] == SpringState::kDetached) continue;
    const bool sticks = states[i] == SpringState::kStick;
    require(!sticks || contact.can_stick(), "a contact without friction does not stick");
    offsets[i] = sticks ? Rational(contact.root.upper / contact.friction) : Rational(1);
    const RationalRow normal = contact.normal.row();
    bound_of[i] = bounds.size();
    bounds.emplace_back(1);
    bounds.back()[0] = 1 + offsets[i];
    for (std::size_t j = 0; j < size; ++j) rows[j][0] += offsets[i] * normal[j];
    const auto add = [&](RationalRow force) {
      RationalRow column = normal;
      for (std::size_t k = 1; k < force.size(); ++k) {
        add_multiple(column, force[k], contact.tangents[k - 1].row());
      }
      for (std::size_t j = 0; j < size; ++j) rows[j].push_back(column[j]);
      bounds.back().resize(2 + shares.size());
      bounds.back()[1 + shares.size()] = 1;
      shares.push_back({i, std::move(force)});
    };
    if (!sticks) {
      RationalRow force(1 + contact.tangents.size());
      force[0] = 1;
      add(std::move(force));
      continue;
    }
    for (const FrictionDirection& direction : directions[i]) {
      RationalRow force{1};
      for (const Rational& x : direction.along) force.push_back(contact.friction * x);
      add(std::move(force));
    }
  }
  LinearProgram program;
  program.add_variables(1 + shares.size(), VariableKind::kNonNegative);
  program.minimize({-1});
  for (std::size_t j = 0; j < size; ++j) {
    program.add_row(rows[j], Relation::kEqual, -model.load[j]);
  }
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!bound_of[i]) continue;
    program.add_row(bounds[*bound_of[i]], Relation::kLessEqual, model.contacts[i].most_force);
  }
  const LpResult result = solve(program);
  ExactForces found{-1, {}, RationalRow(size)};
  if (const auto* none = std::get_if<Infeasible>(&result)) {
    for (std::size_t j = 0; j < size; ++j) found.twist[j] = -none->farkas[j];
    return found;
  }
  const auto* best = std::get_if<Optimal>(&result);
  if (best == nullptr) return found;  // without contacts
  found.distance = best->point[0];
  for (std::size_t j = 0; j < size; ++j) found.twist[j] = -best->dual[j];
  for (std::size_t i = 0; i < states.size(); ++i) {
    RationalRow force(1 + model.contacts[i].tangents.size());
    if (bound_of[i]) force[0] = offsets[i] * found.distance;
    found.at.push_back(std::move(force));
  }
  for (std::size_t k = 0; k < shares.size(); ++k) {
    add_multiple(found.at[shares[k].contact], best->point[1 + k], shares[k].force);
  }
  RationalRow balance = model.load;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const ForceContact& contact = model.contacts[i];
    const RationalRow& force = found.at[i];
    add_multiple(balance, force[0], contact.normal.row());
    Rational friction = 0;
    for (std::size_t k = 1; k < force.size(); ++k) {
      add_multiple(balance, force[k], contact.tangents[k - 1].row());
      friction += force[k] * force[k];
    }
    if (states[i] == SpringState::kDetached) continue;
    require(force[0] >= found.distance && force[0] + found.distance <= contact.most_force,
            "a normal force is too near to its bounds");
    if (states[i] == SpringState::kSlip) continue;
    const Rational room = contact.friction * force[0] - contact.root.upper * found.distance;
    require(room.sign() >= 0 && friction <= room * room, "a force is too near to its cone");
  }
  require(is_zero(primitive_multiple(balance)), "forces that do not balance the load");
  return found;
}

bool is_positive_semidefinite(std::vector<RationalRow> a) {
  const std::size_t n = a.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (a[k][k].sign() < 0) return false;
    if (a[k][k].is_zero()) {
      for (std::size_t j = k + 1; j < n; ++j) {
        if (!a[k][j].is_zero()) return false;
      }
      continue;
    }
    for (std::size_t i = k + 1; i < n; ++i) {
      const Rational factor = a[i][k] / a[k][k];
      for (std::size_t j = k + 1; j < n; ++j) a[i][j] -= factor * a[k][j];
    }
  }
  return true;
}

namespace {

using Matrix = std::vector<RationalRow>;

}  // namespace

Rational semidefinite_multiple(const Matrix& p, const Matrix& q, const Rational& above) {
  for (double part = 0x1p-40; part < 1; part *= 64) {
    Rational c = above * (1 - rational_in_bits(part, 10));
    Matrix rest = p;
    for (std::size_t j = 0; j < p.size(); ++j) add_multiple(rest[j], -c, q[j]);
    if (is_positive_semidefinite(std::move(rest))) return c;
  }
  return 0;
}

namespace {

void add_square(Matrix& to, const Rational& factor, const RationalRow& x) {
  for (std::size_t j = 0; j < x.size(); ++j) {
    add_multiple(to[j], factor * x[j], x);
  }
}

Rational quadratic(const Matrix& a, const RationalRow& z) {
  Rational sum = 0;
  for (std::size_t j = 0; j < z.size(); ++j) sum += z[j] * dot(a[j], z);
  return sum;
}

}  // namespace

InverseSquare inverse_square(const ForceModel& model, const std::vector<SpringState>& states) {
  const std::size_t n = model.coordinates;
  const std::vector<RationalRow> none = null_space(matrix_of(model.columns(states), n));
  if (!none.empty()) return {0, 0, none.front()};
  // 1/sigma_max^2 is the least z.P z / z.Q z. Here P = M and Q = 1 if all stiffnesses are k;
  // else, for A = G K G^T and B = G K^2 G^T, P = A^2 and Q = B, since B <= sigma_max^2 A^2.
  Matrix p(n, RationalRow(n));
  Matrix q(n, RationalRow(n));
  for (std::size_t i = 0; i < states.size(); ++i) {
    const ForceContact& contact = model.contacts[i];
    if (states[i] == SpringState::kDetached) continue;
    const Rational k = model.is_uniform ? Rational(1) : contact.stiffness;
    const auto add = [&](const RationalRow& x) {
      add_square(p, k, x);
      if (!model.is_uniform) add_square(q, k * k, x);
    };
    add(contact.normal.row());
    if (states[i] == SpringState::kSlip) continue;
    for (const ScaledRow& t : contact.tangents) add(t.row());
  }
  if (model.is_uniform) {
    for (std::size_t j = 0; j < n; ++j) q[j][j] = 1;
  } else {
    Matrix square(n, RationalRow(n));
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t k = 0; k < n; ++k) square[j][k] = dot(p[j], p[k]);
    }
    p = std::move(square);
  }
  const Doubles vector = least_stiff(model, states).direction;
  RationalRow z;
  for (std::size_t j = 0; j < n; ++j) z.push_back(rational_in_bits(vector[j], 40));
  if (is_zero(primitive_multiple(z))) z[0] = 1;
  const Rational upper = quadratic(p, z) / quadratic(q, z);
  return {semidefinite_multiple(p, q, upper), upper, z};
}

}  // namespace stickslip::robustness_detail
