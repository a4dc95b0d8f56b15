// SPDX-License-Identifier: MIT
#include "statics.hpp"

#include <algorithm>
#include <utility>

#include "work.hpp"

namespace stickslip_check {
namespace {

[[noreturn]] void reject(const char* rule, const std::string& place, const std::string& found) {
  throw Rejected{rule, std::nullopt, place, found};
}

Vector point_of(const Contact& contact) {
  Vector point;
  for (const Bounds& p : contact.position) point.push_back(p.low);
  return point;
}

bool is_held(const Contact& contact) {
  return is_spring(contact.sight) && contact.stiffness.low != 0;
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
  Vector& load = loads_.emplace_back();
  for (const Bounds& w : question.wrench) load.push_back(w.low);
  for (std::size_t i = 0; i < question.contacts.size(); ++i) {
    const Contact contact = question.contacts[i];
    if (!is_spring(contact.sight) || is_held(contact)) continue;
    add_combined(load, contact.sight->rows, {contact.preload.low});
  }
  const Options& asked = question.asked;
  if (asked.direction) loads_.push_back(*asked.direction);
  if (asked.plane) loads_.insert(loads_.end(), asked.plane->begin(), asked.plane->end());
}

/// `static-force` of one.
bool StaticsProof::is_lawful(const RigidForce& force, const Contact& contact) const {
  const Vector& f = force.friction;
  if (!is_contact(contact.sight)) {
    if (!is_all_zero(f)) return false;
    return is_spring(contact.sight) ? is_held(contact) : force.normal >= 0;
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
    if (!is_lawful(force, question_.contacts[force.contact.get_ui()])) {
      reject("static-force", place, "the force of " + name + " is not in its cone");
    }
  }
  Vector total(question_.dimension());
  for (std::size_t k = 0; k < loads_.size(); ++k) add(total, stand.point[k], loads_[k]);
  for (const RigidForce& force : stand.forces) {
    spend(kStepsOfSum);
    const Contact contact = question_.contacts[force.contact.get_ui()];
    const Vector wrench =
        is_contact(contact.sight) ? wrench_of(force, contact) : Vector{force.normal};
    if (contact.sight) {
      add_combined(total, contact.sight->rows, wrench);
    } else {
      add(total, 1, wrench);
    }
  }
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

/// Whether some force of the element does negative work on the motion of what it is on.
bool StaticsProof::opposes(const Contact& contact, const Vector& local) const {
  if (!is_contact(contact.sight)) {
    return is_spring(contact.sight) ? is_held(contact) && local[0] != 0 : local[0] < 0;
  }
  const Vector& n = contact.normal;
  const auto [u, turn] = motion_at(contact, local);
  const Rational press = dot(n, u);
  if (press < 0) return true;
  const Rational length = dot(n, n);
  Rational square = dot(u, u) - press * press / length;
  if (contact.torsion != 0) square += gamma_of(contact) * dot(n, turn) * dot(n, turn);
  const Rational mu = contact.friction.low;
  return press * press < square_ * mu * mu * length * square;
}

void StaticsProof::check_unopposed(const Vector& twist, const std::string& place) const {
  const Element* seen_last = nullptr;
  Vector local = twist;
  for (std::size_t i = 0; i < question_.contacts.size(); ++i) {
    spend(kStepsOfSum);
    const Contact contact = question_.contacts[i];
    if (contact.sight.get() != seen_last) {
      local = moved(contact.sight->rows, twist);
      seen_last = contact.sight.get();
    }
    if (opposes(contact, local)) {
      reject("static-motion", place,
             "a force of contact " + std::to_string(i) + " does negative work on it");
    }
  }
}

void StaticsProof::check_twist(const Vector& twist) const {
  check_unopposed(twist, "twist");
  if (dot(twist, loads_[0]) > 0) return;
  reject("static-motion", "twist", "the load does no work along it");
}

void StaticsProof::check(const Vector& twist, const std::string& place) {
  check_unopposed(twist, place);
  if (loads_.size() != 2) return;
  // It excludes the l with y.w + l y.u > 0.
  const Rational work = dot(twist, loads_[0]);
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
