// SPDX-License-Identifier: MIT
#include "statics.hpp"

#include <algorithm>
#include <utility>

#include "work.hpp"

namespace stickslip_check {
namespace {

Vector point_of(const Contact& contact) {
  Vector point;
  for (const Bounds& p : contact.position) point.push_back(p.low);
  return point;
}

bool is_held(const Contact& contact) {
  return is_spring(contact.sight) && contact.stiffness.low != 0 && !contact.limit;
}

bool is_all_zero(const Vector& v) {
  return std::all_of(v.begin(), v.end(), [](const Rational& x) { return x == 0; });
}

/// e^2 / L^2; 0 without torsion.
Rational gamma_of(const Contact& contact) {
  return contact.torsion * contact.torsion / dot(contact.normal, contact.normal);
}

}  // namespace

MotionAt motion_at(const Contact& contact, const Vector& local) {
  const Vector p = point_of(contact);
  const auto points = static_cast<std::ptrdiff_t>(p.size());
  Vector u(local.begin(), local.begin() + points);
  Vector turn(local.begin() + points, local.end());
  add(u, 1,
      points == 2 ? Vector{Rational(-turn[0] * p[1]), Rational(turn[0] * p[0])}
                  : cross(turn, p));
  return {std::move(u), std::move(turn)};
}

Vector wrench_of(const RigidForce& force, const Contact& contact) {
  const Vector& n = contact.normal;
  Vector f = force.friction;
  if (n.size() == 2) f = {Rational(-f[0] * n[1]), Rational(f[0] * n[0])};
  const Rational moment = f.size() > 3 ? f[3] : Rational(0);
  f.resize(n.size());
  add(f, force.normal, n);
  Vector wrench = at_point(point_of(contact), f);
  for (std::size_t j = 0; moment != 0 && j < 3; ++j) wrench[3 + j] += moment * n[j];
  return wrench;
}

StaticsProof::StaticsProof(const Question& question, const Rational& factor)
    : question_(question), square_(factor * factor) {
  BodyForces load(mechanism(), question.dimension());
  for (std::size_t i = 0; i < question.contacts.size(); ++i) {
    const Contact contact = question.contacts[i];
    if (contact.limit) limits_.push_back(*contact.limit);
    if (!is_spring(contact.sight) || is_held(contact) || contact.limit) continue;
    load.add(contact.sight, {contact.preload.low});
  }
  loads_.push_back(load.total());
  for (std::size_t j = 0; j < question.dimension(); ++j) loads_[0][j] += question.wrench[j].low;
  const Options& asked = question.asked;
  if (asked.direction) loads_.push_back(*asked.direction);
  if (asked.plane) loads_.insert(loads_.end(), asked.plane->begin(), asked.plane->end());
}

/// `static-force` of one.
bool StaticsProof::is_lawful(const RigidForce& force, const Contact& contact,
                             const Rational& h) const {
  const Vector& f = force.friction;
  if (contact.limit && abs(force.normal) > h * *contact.limit) return false;
  if (!is_contact(contact.sight)) {
    if (!is_all_zero(f)) return false;
    return is_spring(contact.sight) ? is_held(contact) || contact.limit : force.normal >= 0;
  }
  const Vector& n = contact.normal;
  const Rational most =
      square_ * contact.friction.low * contact.friction.low * force.normal * force.normal;
  if (force.normal < 0) return false;
  if (n.size() == 2) return f[0] * f[0] <= most;
  const Vector across(f.begin(), f.begin() + 3);
  const Rational length = dot(n, n);
  Rational square = dot(across, across);
  if (f.size() > 3) square += f[3] * f[3] / gamma_of(contact);
  return dot(n, across) == 0 && square <= most * length;
}

void StaticsProof::check(const StandPoint& stand, const std::string& place) {
  const Rational& h = stand.point[0];
  if (h < 0) reject("static-point", place, "h is " + show(h) + ", which is below 0");
  Integer next = 0;
  for (const RigidForce& force : stand.forces) {
    spend(kStepsOfSum);
    const std::string name = "contact " + force.contact.get_str();
    if (force.contact < next || force.contact >= question_.contacts.size()) {
      reject("static-force", place, name + " is not there, or out of order");
    }
    next = force.contact + 1;
    if (!is_lawful(force, question_.contacts[force.contact.get_ui()], h)) {
      reject("static-force", place,
             "the force of " + name + " is not in its cone, or above its limit");
    }
  }
  BodyForces sum(mechanism(), question_.dimension());
  for (const RigidForce& force : stand.forces) {
    spend(kStepsOfSum);
    const Contact contact = question_.contacts[force.contact.get_ui()];
    sum.add(contact.sight,
            is_contact(contact.sight) ? wrench_of(force, contact) : Vector{force.normal});
  }
  Vector total = sum.total();
  for (std::size_t k = 0; k < loads_.size(); ++k) add(total, stand.point[k], loads_[k]);
  for (std::size_t j = 0; j < total.size(); ++j) {
    if (total[j] == 0) continue;
    reject("static-balance", place,
           "load and forces are " + show(total[j]) + " together at coordinate " +
               std::to_string(j));
  }
  if (loads_.size() != 2) return;
  // The hull of multiples l / h, and all from it in the direction of l where h is 0.
  const Rational& l = stand.point[1];
  if (h == 0) {
    if (l < 0) standing_.low_end = false;
    if (l > 0) standing_.high_end = false;
    return;
  }
  const Rational multiple = l / h;
  standing_.low = has_point_ ? std::min(standing_.low, multiple) : multiple;
  standing_.high = has_point_ ? std::max(standing_.high, multiple) : multiple;
  standing_.any = has_point_ = true;
}

/// Whether some force of the element does negative work on the motion of what it is on, with
/// the price of a limit added to N.y.
bool StaticsProof::opposes(const Contact& contact, const Vector& local,
                           const Rational& price) const {
  if (!is_contact(contact.sight)) {
    if (!is_spring(contact.sight)) return local[0] < 0;
    return contact.limit ? abs(local[0]) > price : is_held(contact) && local[0] != 0;
  }
  const Vector& n = contact.normal;
  const auto [u, turn] = motion_at(contact, local);
  const Rational along = dot(n, u);
  const Rational press = along + price;
  if (press < 0) return true;
  const Rational length = dot(n, n);
  Rational square = dot(u, u) - along * along / length;
  if (contact.torsion != 0) square += gamma_of(contact) * dot(n, turn) * dot(n, turn);
  const Rational mu = contact.friction.low;
  return press * press < square_ * mu * mu * length * square;
}

void StaticsProof::check_unopposed(const Vector& twist, const std::string& place) const {
  const BodyMotions motions(mechanism(), twist);
  std::size_t next_price = question_.dimension();
  for (std::size_t i = 0; i < question_.contacts.size(); ++i) {
    spend(kStepsOfSum);
    const Contact contact = question_.contacts[i];
    const Rational price = contact.limit ? twist[next_price++] : Rational(0);
    if (price < 0) {
      reject("static-motion", place,
             "the number of the limit of contact " + std::to_string(i) + " is below 0");
    }
    if (opposes(contact, motions.seen_by(contact.sight), price)) {
      reject("static-motion", place,
             "a force of contact " + std::to_string(i) + " does negative work on it");
    }
  }
}

/// y.w, less what forces take up at their limits.
Rational StaticsProof::work_of_load(const Vector& twist) const {
  Rational work = dot(twist, loads_[0]);
  for (std::size_t k = 0; k < limits_.size(); ++k) {
    work -= twist[question_.dimension() + k] * limits_[k];
  }
  return work;
}

void StaticsProof::check_twist(const Vector& twist) const {
  check_unopposed(twist, "twist");
  if (work_of_load(twist) > 0) return;
  reject("static-motion", "twist", "the load does no work along it, or too little");
}

void StaticsProof::check(const Vector& twist, const std::string& place) {
  check_unopposed(twist, place);
  if (loads_.size() != 2) return;
  // It excludes the l with y.w + l y.u > 0.
  const Rational work = work_of_load(twist);
  const Rational growth = dot(twist, loads_[1]);
  if (growth == 0) {
    if (work > 0) standing_.always_moves = true;
    return;
  }
  const Rational border = -work / growth;
  std::optional<Rational>& end = growth > 0 ? standing_.above : standing_.below;
  if (!end || (growth > 0 ? border < *end : border > *end)) end = border;
}

}  // namespace stickslip_check
