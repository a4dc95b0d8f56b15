// SPDX-License-Identifier: MIT
#include "large.hpp"

#include "answer.hpp"
#include "statics.hpp"
#include "work.hpp"

namespace stickslip_check {
namespace {

/// v and the slip of an element, of a point with this h.
std::pair<Rational, Vector> motion_of(const Contact& contact, const ContactBox& box,
                                      const Vector& local, const Rational& h) {
  const Rational& preload = box[Parameter::kPreload].low;
  const Rational& stiffness = box[Parameter::kStiffness].low;
  if (!is_contact(contact.sight)) return {preload * h - stiffness * local[0], {}};
  const Vector& n = contact.normal;
  const auto [u, turn] = motion_at(contact, local);
  const Rational press = dot(n, u);
  Vector slip;
  if (n.size() == 2) {
    slip = {Rational(n[0] * u[1] - n[1] * u[0])};
  } else {
    slip = u;
    add(slip, -press / dot(n, n), n);
    if (box.gamma != 0) slip.push_back(dot(n, turn));
  }
  return {preload * h - stiffness * press, std::move(slip)};
}

}  // namespace

void check_large_witness(const Question& question, const Witness& witness) {
  check_grasp(question);
  const Mechanism* const mechanism =
      question.several ? question.several->mechanism.get() : nullptr;
  // All conditions are homogeneous, so a multiple of the point without denominators serves.
  Rational scale;
  Vector d;
  for (const Integer& entry : make_form(witness.x, &scale)) d.emplace_back(entry);
  const Rational h = d[question.dimension()];
  const BodyMotions motions(mechanism, d);
  const std::size_t m = question.contacts.size();
  std::vector<ContactForce> forces;
  Vector v;
  ContactBox box;
  const auto box_at = [&](std::size_t i) -> const ContactBox& {
    spend(kStepsOfSum);
    return box = enlarged(question.contacts[i]);
  };
  for (std::size_t i = 0; i < m; ++i) {
    const Contact contact = question.contacts[i];
    auto [a, slip] = motion_of(contact, box_at(i), motions.seen_by(contact.sight), h);
    Vector share(slip.size());
    if (slip.size() == 1) share[0] = -sgn(slip[0]);
    forces.push_back({a.get_num(), make_form(slip), std::move(share)});
    v.push_back(std::move(a));
  }
  take_shares(question, box_at, witness, forces);
  BodyForces sum(mechanism, question.dimension());
  for (std::size_t i = 0; i < m; ++i) {
    const Contact contact = question.contacts[i];
    if (v[i] <= 0 && !is_spring(contact.sight)) continue;
    spend(kStepsOfSum);
    if (!is_contact(contact.sight)) {
      sum.add(contact.sight, {v[i]});
      continue;
    }
    RigidForce force{Integer(i), v[i], {}};
    for (const Rational& share : forces[i].share) {
      force.friction.emplace_back(contact.friction.low * v[i] * share);
    }
    sum.add(contact.sight, wrench_of(force, contact));
  }
  Vector total = sum.total();
  for (std::size_t j = 0; j < total.size(); ++j) total[j] += h * question.wrench[j].low;
  check_balance(std::move(total), scale);
}

void check_large_leaf(const Question& question, const Node* leaf) {
  if (leaf == nullptr) {
    reject("large-proof", "", "neither an equilibrium nor a tree of one leaf");
  }
  Vector against;
  for (const Rational& y : leaf->numbers) against.emplace_back(-y);
  StaticsProof(question, 1).check_twist(against);
}

}  // namespace stickslip_check
