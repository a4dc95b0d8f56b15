// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics_model.hpp"

#include <algorithm>
#include <cmath>

#include "few_columns.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/lp/exact_system.hpp"
#include "stickslip/lp/sparse_system.hpp"

namespace stickslip::statics_detail {
namespace {

/// Subtracts from a translation how a rotation w about the origin moves the point p.
void take_turn(RationalRow& translation, const RationalRow& rotation, const RationalRow& p) {
  if (p.size() == 2) {
    translation[0] += rotation[0] * p[1];
    translation[1] -= rotation[0] * p[0];
    return;
  }
  const Vector3 moved = cross(vector3(rotation), vector3(p));
  for (std::size_t j = 0; j < 3; ++j) translation[j] -= moved[j];
}

/// Returns whether a spring exerts its force whatever moves.
bool is_constant(const Spring& spring) {
  return !spring.is_ratchet() && !spring.max_torque && spring.stiffness.low.is_zero();
}

/// Returns whether a spring holds, as a joint that is locked.
bool is_locked(const Spring& spring) {
  return !spring.is_ratchet() && !spring.max_torque && !spring.stiffness.low.is_zero();
}

}  // namespace

Rational ForceCone::squared_friction(const RationalRow& force) const {
  Rational square = 0;
  for (std::size_t k = 0; k + 1 < force.size(); ++k) {
    square += force[k + 1] * force[k + 1] * squares[k];
  }
  return square;
}

Rational ForceCone::squared_slip(const RationalRow& y) const {
  Rational square = 0;
  for (std::size_t k = 0; k < slips.size(); ++k) {
    const Rational work = dot(slips[k], y);
    if (!work.is_zero()) square += work * work / squares[k];
  }
  return square;
}

RationalRow wrench_of_point(const GraspBox& grasp) {
  RationalRow wrench;
  for (const Interval& w : grasp.wrench) wrench.push_back(w.low);
  return wrench;
}

RationalRow wrench_with_springs(const GraspBox& grasp) {
  RationalRow wrench = wrench_of_point(grasp);
  for (const Spring& spring : grasp.springs) {
    if (is_constant(spring)) stickslip::add_multiple(wrench, spring.force.low, spring.row);
  }
  return wrench;
}

StaticsModel::StaticsModel(const GraspBox& grasp, const Rational& friction_factor,
                           bool springs_hold)
    : grasp_(grasp) {
  require(grasp.is_point(), "no number is uncertain");
  twist_ = grasp.in_space() ? 6 : 3;
  free_ = grasp.mechanism ? grasp.mechanism->joint_coordinate(0) : twist_;
  find_centres();
  hold_joints(springs_hold);
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    add_contact(grasp.contacts[i], i, friction_factor);
  }
  for (std::size_t s = 0; s < grasp.springs.size(); ++s) {
    if (!grasp.springs[s].is_ratchet() && !grasp.springs[s].max_torque) continue;
    ForceCone& cone = cones_.emplace_back();
    cone.element = grasp.contacts.size() + s;
    cone.normal = held(sparse(grasp.springs[s].row));
  }
  add_limits();
}

void StaticsModel::add_limits() {
  motions_ = size_;
  std::size_t cone = 0;
  for (const auto& [element, most] : grasp_.force_limits()) {
    while (cones_[cone].element != element) ++cone;
    limits_.emplace_back(cone, most);
  }
  size_ += limits_.size();
  load_ = load_of(wrench_with_springs(grasp_));
  for (std::size_t k = 0; k < limits_.size(); ++k) {
    const std::size_t coordinate = motions_ + k;
    const auto& [limited, most] = limits_[k];
    load_[coordinate] = -most;
    if (*cones_[limited].element >= grasp_.contacts.size()) {
      stickslip::add_multiple(load_, -most, cones_[limited].normal);
      load_[coordinate] = -2 * most;
    }
    cones_[limited].normal.emplace_back(coordinate, 1);
    cones_.emplace_back().normal.emplace_back(coordinate, 1);
    bodies_.push_back(bodies_.empty() ? 0 : bodies_.back() + 1);
    arms_.push_back(1);
  }
}

/// Puts the centre of each body amid its contacts, and finds how far they are from it.
void StaticsModel::find_centres() {
  const std::size_t coordinates = grasp_.in_space() ? 3 : 2;
  const std::size_t bodies = free_ / twist_;
  centres_.assign(bodies, RationalRow(coordinates));
  const Mechanism* mechanism = grasp_.mechanism.get();
  std::vector<std::optional<std::size_t>> place;  // of each body: among those that are no links
  std::size_t next = 0;
  for (std::size_t b = 0; mechanism && b < mechanism->bodies.size(); ++b) {
    place.push_back(mechanism->bodies[b].link ? std::nullopt : std::optional(next++));
  }
  const auto body_at = [&](BodyIndex body) -> std::optional<std::size_t> {
    if (!mechanism) return 0;
    return body ? place[*body] : std::nullopt;
  };
  std::vector<std::vector<const UncertainContact*>> touched(bodies);
  for (const UncertainContact& c : grasp_.contacts) {
    const auto of = body_at(c.of);
    if (of) touched[*of].push_back(&c);
    if (!mechanism) continue;
    if (const auto by = body_at(c.by)) touched[*by].push_back(&c);
  }
  arms_.assign(free_, 1);
  constexpr int kBits = 12;
  for (std::size_t b = 0; b < bodies; ++b) {
    if (touched[b].empty()) continue;
    double arm = 0;
    for (std::size_t j = 0; j < coordinates; ++j) {
      double sum = 0;
      double least = 0;
      double most = 0;
      for (const UncertainContact* c : touched[b]) {
        const double at = to_double(c->position[j].low);
        sum += at;
        least = c == touched[b].front() ? at : std::min(least, at);
        most = c == touched[b].front() ? at : std::max(most, at);
      }
      centres_[b][j] = rational_in_bits(sum / static_cast<double>(touched[b].size()), kBits);
      const double centre = to_double(centres_[b][j]);
      arm = std::max({arm, std::fabs(most - centre), std::fabs(least - centre)});
    }
    for (std::size_t k = coordinates; k < twist_; ++k) {
      if (arm > 0) arms_[b * twist_ + k] = std::ldexp(1.0, std::ilogb(arm));
    }
  }
  for (std::size_t j = 0; j < free_; ++j) bodies_.push_back(j / twist_);
}

/// Joints on which a spring with stiffness acts may exert any force along its row, and only
/// motions that do not move it are of use.
void StaticsModel::hold_joints(bool springs_hold) {
  size_ = grasp_.wrench.size();
  // Most springs hold one joint by itself, which then takes no part in what others leave free.
  std::vector<char> is_held(size_ - free_, 0);
  std::vector<SparseRow> coupled;
  for (const Spring& spring : grasp_.springs) {
    if (!springs_hold || !is_locked(spring)) continue;
    SparseRow row = sparse(spring.row);
    if (row.size() == 1) {
      is_held[row.front().first - free_] = 1;
    } else {
      coupled.push_back(std::move(row));
    }
  }
  std::vector<std::size_t> others;
  std::vector<std::size_t> place(is_held.size());
  for (std::size_t q = 0; q < is_held.size(); ++q) {
    place[q] = others.size();
    if (is_held[q] == 0) others.push_back(q);
  }
  if (others.size() < is_held.size() || !coupled.empty()) {
    std::vector<RationalRow> rows;
    for (const SparseRow& row : coupled) {
      RationalRow& on_others = rows.emplace_back(others.size());
      for (const auto& [j, entry] : row) {
        if (is_held[j - free_] == 0) on_others[place[j - free_]] = entry;
      }
    }
    joints_.emplace();
    for (const RationalRow& motion : null_space(matrix_of(rows, others.size()))) {
      RationalRow& of_all = joints_->emplace_back(is_held.size());
      for (std::size_t k = 0; k < others.size(); ++k) of_all[others[k]] = motion[k];
    }
    size_ = free_ + joints_->size();
  }
  std::size_t body = free_ / twist_;
  while (bodies_.size() < size_) {
    bodies_.push_back(body++);
    arms_.push_back(1);
  }
}

SparseRow StaticsModel::held(SparseRow row) const {
  if (!joints_) return row;
  SparseRow result;
  RationalRow on_joints(joints_->size());
  for (const auto& [j, entry] : row) {
    if (j < free_) {
      result.emplace_back(j, entry);
      continue;
    }
    for (std::size_t q = 0; q < joints_->size(); ++q) {
      on_joints[q] += entry * (*joints_)[q][j - free_];
    }
  }
  for (std::size_t q = 0; q < on_joints.size(); ++q) {
    if (!on_joints[q].is_zero()) result.emplace_back(free_ + q, on_joints[q]);
  }
  return result;
}

/// Moves torques from about the origin to about the centres.
SparseRow StaticsModel::shifted(SparseRow row) const {
  SparseRow result;
  std::size_t at = 0;
  while (at < row.size() && row[at].first < free_) {
    const std::size_t body = row[at].first / twist_;
    RationalRow wrench(twist_);
    for (; at < row.size() && row[at].first / twist_ == body && row[at].first < free_; ++at) {
      wrench[row[at].first % twist_] = row[at].second;
    }
    const RationalRow moment = wrench_at(centres_[body], wrench);
    for (std::size_t k = 0; k < twist_; ++k) {
      if (k >= centres_[body].size()) wrench[k] -= moment[k];
      if (!wrench[k].is_zero()) result.emplace_back(body * twist_ + k, wrench[k]);
    }
  }
  result.insert(result.end(), row.begin() + static_cast<std::ptrdiff_t>(at), row.end());
  return result;
}

RationalRow StaticsModel::load_of(const RationalRow& wrench) const {
  RationalRow load(size_);
  for (auto& [j, entry] : held(shifted(sparse(wrench)))) load[j] = entry;
  return load;
}

SparseRow StaticsModel::row_of(const UncertainContact& c, const RationalRow& wrench) const {
  if (!grasp_.mechanism) return shifted(sparse(wrench));
  SparseRow row = grasp_.mechanism->load_on(c.of, wrench);
  if (c.by) {
    for (auto& [j, entry] : grasp_.mechanism->load_on(c.by, opposite(wrench))) {
      const auto place =
          std::lower_bound(row.begin(), row.end(), j,
                           [](const auto& a, std::size_t index) { return a.first < index; });
      if (place == row.end() || place->first != j) {
        row.emplace(place, j, entry);
      } else if ((place->second += entry).is_zero()) {
        row.erase(place);
      }
    }
  }
  return held(shifted(std::move(row)));
}

void StaticsModel::add_contact(const UncertainContact& c, std::size_t element,
                               const Rational& friction_factor) {
  ForceCone& cone = cones_.emplace_back();
  cone.element = element;
  const RationalRow p = c.point();
  cone.normal = row_of(c, wrench_at(p, c.normal));
  const Rational mu = friction_factor * c.friction.low;
  if (mu.is_zero()) return;
  if (p.size() == 2) {
    cone.squared_most = mu * mu;
    cone.directions = {{1}};
    cone.squares = {1};
    cone.slips = {row_of(c, wrench_at(p, {-c.normal[1], c.normal[0]}))};
    return;
  }
  const Rational square = dot(c.normal, c.normal);
  cone.squared_most = mu * mu * square;
  for (const Turn& turn : turns_of(c)) {
    cone.directions.push_back(turn.direction);
    cone.squares.push_back(dot(turn.direction, turn.direction));
    cone.slips.push_back(row_of(c, wrench_at(p, turn.direction)));
  }
  if (c.torsion.is_zero()) return;
  for (RationalRow& direction : cone.directions) direction.emplace_back(0);
  cone.directions.push_back({0, 0, 0, 1});
  cone.squares.push_back(square / (c.torsion * c.torsion));
  cone.slips.push_back(row_of(c, {0, 0, 0, c.normal[0], c.normal[1], c.normal[2]}));
}

double StaticsModel::scale(const ForceCone& cone, std::size_t column) const {
  if (column == 0) return 1;
  return std::sqrt(to_double(cone.squared_most) / to_double(cone.squares[column - 1]));
}

ConePair StaticsModel::rounded(const RationalRow& load) const {
  ConePair pair;
  for (std::size_t j = 0; j < size_; ++j) pair.load.push_back(to_double(load[j]) / arms_[j]);
  for (const ForceCone& cone : cones_) {
    auto& columns = pair.cones.emplace_back();
    const auto add = [&](const SparseRow& row) {
      const double factor = scale(cone, columns.size());
      DoubleColumn& column = columns.emplace_back();
      for (const auto& [j, entry] : row) {
        column.emplace_back(j, factor * to_double(entry) / arms_[j]);
      }
    };
    add(cone.normal);
    for (const SparseRow& slip : cone.slips) add(slip);
  }
  return pair;
}

RationalRow StaticsModel::state_of(const RationalRow& y) const {
  RationalRow motion(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(free_));
  for (std::size_t body = 0; body < centres_.size(); ++body) {
    const std::size_t points = centres_[body].size();
    const auto from = motion.begin() + static_cast<std::ptrdiff_t>(body * twist_);
    RationalRow moved(from, from + static_cast<std::ptrdiff_t>(points));
    const RationalRow rotation(from + static_cast<std::ptrdiff_t>(points),
                               from + static_cast<std::ptrdiff_t>(twist_));
    take_turn(moved, rotation, centres_[body]);
    std::copy(moved.begin(), moved.end(), from);
  }
  motion.resize(grasp_.wrench.size());
  for (std::size_t q = 0; q < motions_ - free_; ++q) {
    if (!joints_) {
      motion[free_ + q] = y[free_ + q];
    } else {
      for (std::size_t j = free_; j < motion.size(); ++j) {
        motion[j] += y[free_ + q] * (*joints_)[q][j - free_];
      }
    }
  }
  return motion;
}

RationalRow StaticsModel::motion_of(const RationalRow& y) const {
  RationalRow motion = state_of(y);
  for (std::size_t k = 0; k < limits_.size(); ++k) {
    const ForceCone& cone = cones_[limits_[k].first];
    Rational q = y[motions_ + k];
    // A motor pushes with a - A, so that what it takes up from both ends is counted.
    if (*cone.element >= grasp_.contacts.size()) q += dot(cone.normal, y);
    motion.push_back(std::move(q));
  }
  const Row integers = primitive_multiple(motion);
  return {integers.begin(), integers.end()};
}

bool StaticsModel::is_unopposed(const ForceCone& cone, const RationalRow& y) {
  const Rational press = dot(cone.normal, y);
  return press.sign() >= 0 && press * press >= cone.squared_most * cone.squared_slip(y);
}

bool StaticsModel::is_in(const ForceCone& cone, const ConeForce& force) {
  return force[0].sign() >= 0 &&
         cone.squared_friction(force) <= cone.squared_most * force[0] * force[0];
}

RigidForces StaticsModel::forces_of(const std::vector<ConeForce>& forces,
                                    const RationalRow& wrench, const Rational& weight) const {
  RigidForces result(grasp_.elements());
  for (RigidForce& force : result) force.friction.resize(grasp_.in_space() ? 3 : 1);
  for (std::size_t i = 0; i < cones_.size(); ++i) {
    const ForceCone& cone = cones_[i];
    if (!cone.element) continue;
    RigidForce& force = result[*cone.element];
    force.normal = forces[i][0];
    const bool is_contact = *cone.element < grasp_.contacts.size();
    if (is_contact && !grasp_.contacts[*cone.element].torsion.is_zero()) {
      force.friction.resize(4);
    }
    for (std::size_t k = 0; k + 1 < forces[i].size(); ++k) {
      stickslip::add_multiple(force.friction, forces[i][k + 1], sparse(cone.directions[k]));
    }
  }
  for (const auto& [limited, most] : limits_) {
    const std::size_t element = *cones_[limited].element;
    if (element >= grasp_.contacts.size()) result[element].normal -= weight * most;
  }
  if (!joints_) return result;
  // Springs with stiffness take what is left on the joints that they hold.
  RationalRow left = wrench;
  const auto add_wrench = [&](const RigidForce& force, const UncertainContact& c) {
    const RationalRow p = c.point();
    const auto add = [&](const RationalRow& on_body) {
      stickslip::add_multiple(left, 1, grasp_.mechanism->load_on(c.of, on_body));
      stickslip::add_multiple(left, -1, grasp_.mechanism->load_on(c.by, on_body));
    };
    RationalRow push = wrench_at(p, c.normal);
    for (Rational& entry : push) entry *= force.normal;
    add(push);
    if (p.size() == 2) {
      add(wrench_at(p, {-c.normal[1] * force.friction[0], c.normal[0] * force.friction[0]}));
      return;
    }
    add(wrench_at(p, force.friction));
    if (force.friction.size() == 4) {
      RationalRow spin{0, 0, 0};
      for (const Rational& n : c.normal) spin.push_back(n * force.friction[3]);
      add(spin);
    }
  };
  for (std::size_t i = 0; i < grasp_.contacts.size(); ++i) {
    add_wrench(result[i], grasp_.contacts[i]);
  }
  std::vector<SparseRow> rows;
  std::vector<std::size_t> places;
  for (std::size_t s = 0; s < grasp_.springs.size(); ++s) {
    const Spring& spring = grasp_.springs[s];
    const std::size_t element = grasp_.contacts.size() + s;
    if (spring.is_ratchet() || spring.max_torque) {
      stickslip::add_multiple(left, result[element].normal, sparse(spring.row));
    } else if (is_constant(spring)) {
      stickslip::add_multiple(left, weight * spring.force.low, sparse(spring.row));
    } else {
      rows.push_back(sparse(spring.row));
      places.push_back(element);
    }
  }
  const auto torques = SparseSystem(left.size(), rows).solve(opposite(left));
  require(torques.has_value(), "the springs do not balance what is left");
  const RationalRow each = torques->row();
  for (std::size_t k = 0; k < places.size(); ++k) result[places[k]].normal = each[k];
  return result;
}

}  // namespace stickslip::statics_detail
