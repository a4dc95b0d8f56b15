// SPDX-License-Identifier: MIT
#include "witness.hpp"

#include <algorithm>

#include "answer.hpp"

namespace stickslip_check {
namespace {

[[noreturn]] void reject(const char* rule, const std::string& found) {
  throw Rejected{rule, std::nullopt, "", found};
}

std::string name_of(const Integer& contact) {
  return "contact " + show(Rational(contact)) + ": ";
}

/// The square of the length that a share has at most.
Rational longest_square(const ContactBox& contact) {
  return contact.normal.size() == 3 ? dot(contact.normal, contact.normal) : Rational(1);
}

/// Whether the product of two vectors is as large as the squares of their lengths, or of
/// bounds of these, allow: then one is 0, or each is a multiple > 0 of the other, as long as
/// its bound.
bool is_largest(const Rational& product, const Rational& squares) {
  return product >= 0 && product * product == squares;
}

/// v and the slips; the shares of contacts that slip in the plane.
std::vector<ContactForce> motion_of(const Box& box, const Form& x) {
  std::vector<ContactForce> forces;
  forces.reserve(box.rows.size());
  for (const auto& row : box.rows) {
    Form slip;
    for (const Form& component : row->slips[0]) slip.push_back(dot(component, x));
    Vector share(slip.size());
    if (slip.size() == 1) share[0] = -sgn(slip[0]);
    forces.push_back({dot(row->v[0], x), std::move(slip), std::move(share)});
  }
  return forces;
}

/// `witness-share`: sets the shares of contacts that stick.
void take_shares(const Box& box, const Witness& witness, std::vector<ContactForce>& forces) {
  Integer above = -1;
  for (const auto& [contact, share] : witness.shares) {
    const auto require = [&, &i = contact](bool good, const std::string& found) {
      if (!good) reject("witness-share", name_of(i) + found);
    };
    require(contact > above, "not above the one before");
    require(contact < forces.size(), "there is none");
    ContactForce& force = forces[contact.get_ui()];
    require(!force.slips(), "it slips");
    const Vector& normal = box.contacts[contact.get_ui()].normal;
    const bool in_space = share.size() == 3;
    require(!in_space || dot(share, normal) == 0, show(share) + " is not across its normal");
    require(dot(share, share) <= longest_square(box.contacts[contact.get_ui()]),
            in_space ? show(share) + " is longer than its normal"
                     : show(share[0]) + " is not in [-1, 1]");
    force.share = share;
    above = contact;
  }
}

/// `witness-root`: sets the shares of contacts that slip in space.
void take_roots(const Box& box, std::vector<ContactForce>& forces) {
  for (std::size_t i = 0; i < forces.size(); ++i) {
    ContactForce& force = forces[i];
    const ContactBox& contact = box.contacts[i];
    if (force.slip.size() == 1 || !force.slips() || force.v <= 0 ||
        contact[Parameter::kFriction] == Bounds(0)) {
      continue;
    }
    const Rational square = dot(contact.normal, contact.normal) / dot(force.slip, force.slip);
    const std::optional<Rational> root = exact_sqrt(square);
    if (!root) {
      reject("witness-root",
             name_of(i) +
                 "it slips in a direction whose length, over its normal's, is irrational");
    }
    for (std::size_t j = 0; j < 3; ++j) force.share[j] = -force.slip[j] * *root;
  }
}

/// All forces, and the load.
Vector total(const Box& box, const Form& x, const std::vector<ContactForce>& forces) {
  const std::size_t dimension = box.dimension();
  PairwiseSum sum;
  Vector term(dimension);
  for (std::size_t j = 0; j < dimension; ++j) {
    term[j] = x[dimension] * box.wrench[j].low + x[dimension + 1] * box.growth[j];
  }
  sum.add(term);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const auto& [v, slip, share] = forces[i];
    if (v <= 0) continue;
    const Row& row = *box.rows[i];
    const Rational a = row.v_scale * row.scale * v;
    const Rational& friction = box.contacts[i][Parameter::kFriction].low;
    for (std::size_t j = 0; j < dimension; ++j) term[j] = row.normals[0][j];
    for (std::size_t k = 0; k < share.size(); ++k) {
      const Rational b = friction * share[k];  // along row k of the slip
      for (std::size_t j = 0; j < dimension; ++j) term[j] += b * row.slips[0][k][j];
    }
    for (Rational& entry : term) entry *= a;
    sum.add(term);
  }
  return sum.total();
}

}  // namespace

std::vector<ContactForce> check_witness(const Question& question, const Witness& witness) {
  if (question.is_box) {
    reject("witness-box", "an equilibrium of one grasp, but the question is about a box");
  }
  // All conditions are homogeneous, so a multiple of the point without denominators serves.
  Rational scale;
  const Form x = make_form(witness.x, &scale);
  const Box& box = *question.box;
  std::vector<ContactForce> forces = motion_of(box, x);
  take_shares(box, witness, forces);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (question.asked.bilateral && forces[i].v < 0) {
      reject("witness-normal", name_of(i) + "v is below 0");
    }
  }
  take_roots(box, forces);
  Vector sum = total(box, x, forces);
  if (sum != Vector(sum.size())) {
    for (Rational& entry : sum) entry *= scale;
    reject("witness-balance", "load and forces add up to " + show(sum) + ", not to 0");
  }
  return forces;
}

std::optional<std::string> mode_refusal(const Question& question,
                                        const std::vector<ContactForce>& first,
                                        const std::vector<ContactForce>& second) {
  const auto opposite = [](const Integer& x, const Integer& y) { return sgn(x) * sgn(y) < 0; };
  for (std::size_t i = 0; i < question.box->rows.size(); ++i) {
    const ContactForce& p = first[i];
    const ContactForce& q = second[i];
    if (opposite(p.v, q.v)) return name_of(i) + "v has opposite signs";
    const Bounds& friction = question.box->contacts[i][Parameter::kFriction];
    if (friction == Bounds(0) || (p.v <= 0 && q.v <= 0)) continue;
    if (!is_largest(dot(p.slip, q.slip), dot(p.slip, p.slip) * dot(q.slip, q.slip))) {
      return name_of(i) + "its two slips are not in one direction";
    }
    Vector slip;
    for (std::size_t k = 0; k < p.slip.size(); ++k) slip.emplace_back(p.slip[k] + q.slip[k]);
    const Rational largest = longest_square(question.box->contacts[i]) * dot(slip, slip);
    for (const ContactForce* end : {&p, &q}) {
      if (end->v > 0 && !is_largest(-dot(end->share, slip), largest)) {
        return name_of(i) +
               "it slips at one end, and at the other its friction has another share";
      }
    }
  }
  return std::nullopt;
}

}  // namespace stickslip_check
