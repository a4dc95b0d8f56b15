// SPDX-License-Identifier: MIT
#include "large.hpp"

#include <utility>

#include "answer.hpp"
#include "statics.hpp"
#include "work.hpp"

namespace stickslip_check {
namespace {

[[noreturn]] void reject(const char* rule, const std::string& found) {
  throw Rejected{rule, std::nullopt, "", found};
}

std::string name_of(const Integer& contact) {
  return "contact " + show(Rational(contact)) + ": ";
}

/// The force of one element, as it follows from a motion.
struct LargeForce {
  Rational v;
  Vector slip;   ///< T.d or S d; none of what is no contact
  Vector share;  ///< friction over mu a

  bool slips() const {
    for (const Rational& s : slip) {
      if (s != 0) return true;
    }
    return false;
  }
};

/// gamma, and so the products of slips and of friction (FORMAT.md §1).
Rational gamma_of(const Contact& contact) {
  return contact.torsion * contact.torsion / dot(contact.normal, contact.normal);
}
Rational slip_square(const Contact& contact, const Vector& s) {
  Rational square;
  for (std::size_t k = 0; k < s.size(); ++k) {
    square += (k == 3 ? gamma_of(contact) : Rational(1)) * s[k] * s[k];
  }
  return square;
}
Rational share_square(const Contact& contact, const Vector& f) {
  Rational square;
  for (std::size_t k = 0; k < f.size(); ++k) {
    if (k == 3) {
      square += f[k] * f[k] / gamma_of(contact);
    } else {
      square += f[k] * f[k];
    }
  }
  return square;
}

/// v and the slips, of a point with this h; the shares of contacts that slip in the plane.
LargeForce moved_by(const Contact& contact, const Vector& local, const Rational& h) {
  if (!is_contact(contact.sight)) {
    return {contact.preload.low * h - contact.stiffness.low * local[0], {}, {}};
  }
  const Vector& n = contact.normal;
  const auto [u, turn] = motion_at(contact, local);
  const Rational length = dot(n, n);
  const Rational press = dot(n, u);
  LargeForce force;
  force.v = -contact.stiffness.low / length * press;
  // (The question is no box, so that the length is rational if it counts.)
  if (contact.preload.low != 0) force.v += contact.preload.low / *exact_sqrt(length) * h;
  if (n.size() == 2) {
    force.slip = {Rational(n[0] * u[1] - n[1] * u[0])};
    force.share = {Rational(-sgn(force.slip[0]))};
    return force;
  }
  force.slip = u;
  add(force.slip, -press / length, n);
  if (contact.torsion != 0) force.slip.push_back(dot(n, turn));
  force.share.resize(force.slip.size());
  return force;
}

/// `witness-share`: sets the shares of contacts that stick.
void take_shares(const Question& question, const Witness& witness,
                 std::vector<LargeForce>& forces) {
  Integer above = -1;
  for (const auto& [index, share] : witness.shares) {
    const auto require = [&, &i = index](bool good, const std::string& found) {
      if (!good) reject("witness-share", name_of(i) + found);
    };
    require(index > above, "not above the one before");
    require(index < forces.size(), "there is none");
    const Contact contact = question.contacts[index.get_ui()];
    require(is_contact(contact.sight), "there is none");
    LargeForce& force = forces[index.get_ui()];
    require(!force.slips(), "it slips");
    const bool in_space = share.size() > 1;
    const Vector across(share.begin(), share.begin() + (in_space ? 3 : 1));
    require(!in_space || dot(across, contact.normal) == 0,
            "its share is not across its normal");
    require(share_square(contact, share) <=
                (in_space ? dot(contact.normal, contact.normal) : Rational(1)),
            "its share is too long");
    force.share = share;
    above = index;
  }
}

/// `witness-root`: sets the share of a contact that slips in space.
void take_root(const Contact& contact, const std::string& name, LargeForce& force) {
  if (force.slip.size() < 3 || !force.slips() || force.v <= 0 || contact.friction.low == 0) {
    return;
  }
  const std::optional<Rational> root =
      exact_sqrt(dot(contact.normal, contact.normal) / slip_square(contact, force.slip));
  if (!root) {
    reject("witness-root",
           name + "it slips in a direction whose length, over its normal's, is irrational");
  }
  for (std::size_t k = 0; k < force.slip.size(); ++k) {
    force.share[k] = -*root * force.slip[k];
    if (k == 3) force.share[k] *= gamma_of(contact);
  }
}

}  // namespace

void check_large_witness(const Question& question, const Witness& witness) {
  if (question.is_box) {
    reject("witness-box", "an equilibrium of one grasp, but the question is about a box");
  }
  const std::size_t dimension = question.dimension();
  const Vector bound = question.asked.max_motion.value_or(Vector{});
  for (std::size_t j = 0; j < bound.size(); ++j) {
    if (abs(witness.x[j]) <= bound[j]) continue;
    reject("witness-bound", "motion " + std::to_string(j + 1) + " is " + show(witness.x[j]) +
                                ", and may be " + show(bound[j]));
  }
  // All conditions are homogeneous, so a multiple of the point without denominators serves.
  Rational scale;
  Vector d;
  for (const Integer& entry : make_form(witness.x, &scale)) d.emplace_back(entry);
  const Rational h = d[dimension];
  std::vector<LargeForce> forces;
  const std::size_t m = question.contacts.size();
  for (std::size_t i = 0; i < m; ++i) {
    spend(kStepsOfSum);
    const Contact contact = question.contacts[i];
    forces.push_back(moved_by(contact, moved(contact.sight->rows, d), h));
  }
  take_shares(question, witness, forces);
  for (std::size_t i = 0; question.asked.bilateral && i < m; ++i) {
    if (forces[i].v < 0 && !is_spring(question.contacts[i].sight)) {
      reject("witness-normal", name_of(Integer(i)) + "v is below 0");
    }
  }
  for (std::size_t i = 0; i < m; ++i) {
    take_root(question.contacts[i], name_of(Integer(i)), forces[i]);
  }
  Vector total;
  for (const Bounds& w : question.wrench) total.emplace_back(h * w.low);
  for (std::size_t i = 0; i < m; ++i) {
    spend(kStepsOfSum);
    const Contact contact = question.contacts[i];
    const Rational& v = forces[i].v;
    if (v <= 0 && !is_spring(contact.sight)) continue;
    if (!is_contact(contact.sight)) {
      add_combined(total, contact.sight->rows, {v});
      continue;
    }
    RigidForce force{Integer(i), v, {}};
    for (const Rational& share : forces[i].share) {
      force.friction.emplace_back(contact.friction.low * v * share);
    }
    add_combined(total, contact.sight->rows, wrench_of(force, contact));
  }
  if (total != Vector(total.size())) {
    for (Rational& entry : total) entry *= scale;
    reject("witness-balance", "load and forces add up to " + show(total) + ", not to 0");
  }
}

void check_large_leaf(const Question& question, const Node* leaf) {
  if (leaf == nullptr) {
    reject("large-proof", "neither an equilibrium nor a tree of one leaf");
  }
  Vector against;
  for (const Rational& y : leaf->numbers) against.emplace_back(-y);
  StaticsProof(question, 1).check_twist(against);
}

}  // namespace stickslip_check
