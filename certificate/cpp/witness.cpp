// SPDX-License-Identifier: MIT
#include "witness.hpp"

#include <algorithm>

#include "answer.hpp"

namespace stickslip_check {
namespace {

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
  forces.reserve(box.size());
  for (std::size_t i = 0; i < box.size(); ++i) {
    const Row& row = box.row(i);
    Form slip;
    for (const Form& component : row.slips[0]) slip.push_back(dot(component, x));
    Vector share(slip.size());
    if (slip.size() == 1) share[0] = -sgn(slip[0]);
    forces.push_back({dot(row.v[0], x), std::move(slip), std::move(share)});
  }
  return forces;
}

/// `witness-bound`.
void check_bound(const Vector& bound, const Vector& x) {
  for (std::size_t j = 0; j < bound.size(); ++j) {
    const Rational most = bound[j] * x[bound.size()];
    if (abs(x[j]) <= most) continue;
    reject("witness-bound", "", "motion " + std::to_string(j + 1) + " is " + show(x[j]) +
                                ", not from " + show(Rational(-most)) + " to " + show(most));
  }
}

/// `witness-share`: sets the shares of contacts that stick.
void take_stated(const ContactAt& contact_at, const Witness& witness,
                 std::vector<ContactForce>& forces) {
  Integer above = -1;
  for (const auto& [contact, share] : witness.shares) {
    const auto require = [&, &i = contact](bool good, const std::string& found) {
      if (!good) reject("witness-share", "", name_of(i) + found);
    };
    require(contact > above, "not above the one before");
    require(contact < forces.size(), "there is none");
    const ContactBox& here = contact_at(contact.get_ui());
    require(is_contact(here.sight), "there is none");
    ContactForce& force = forces[contact.get_ui()];
    require(!force.slips(), "it slips");
    const bool in_space = share.size() > 1;
    require(!in_space || dot(share, here.normal) == 0,
            show(share) + " is not across its normal");
    require(friction_square(here, share) <= longest_square(here),
            in_space ? show(share) + " is longer than its normal"
                     : show(share[0]) + " is not in [-1, 1]");
    force.share = share;
    above = contact;
  }
}

/// `witness-root`: sets the share of a contact that slips in space.
void take_root(const ContactBox& contact, std::size_t i, ContactForce& force) {
  if (force.slip.size() <= 1 || !force.slips() || force.v <= 0 ||
      contact[Parameter::kFriction] == Bounds(0)) {
    return;
  }
  const Vector slip(force.slip.begin(), force.slip.end());
  const Vector against = conjugate(contact, slip);
  const Rational square = dot(contact.normal, contact.normal) / dot(against, slip);
  const std::optional<Rational> root = exact_sqrt(square);
  if (!root) {
    reject("witness-root", "",
           name_of(i) +
               "it slips in a direction whose length, over its normal's, is irrational");
  }
  for (std::size_t j = 0; j < against.size(); ++j) force.share[j] = -against[j] * *root;
}

/// a times N + b_1 S_1 + ..., with the shares times mu for b: the wrench of a contact.
Vector wrench_of(const Row& row, const Rational& friction, const Vector& share,
                 const Rational& a) {
  Vector wrench(row.normals[0].size());
  for (std::size_t j = 0; j < wrench.size(); ++j) wrench[j] = row.normals[0][j];
  for (std::size_t k = 0; k < share.size(); ++k) {
    const Rational b = friction * share[k];  // along row k of the slip
    for (std::size_t j = 0; j < wrench.size(); ++j) wrench[j] += b * row.slips[0][k][j];
  }
  for (Rational& entry : wrench) entry *= a;
  return wrench;
}

}  // namespace

/// A contact whose share is a whole number has the wrench (N + share mu T) v(x), a matrix times
/// x. The matrices of all of them are kept as one sum, which changes from witness to witness by
/// the contacts that do. Where v = 0 any share serves, and the one before is kept.
Vector ForceSum::total(const Box& box, const Form& x, const std::vector<ContactForce>& forces) {
  const std::size_t dimension = box.dimension();
  const std::size_t width = dimension + 2;  // no contact sees more of x
  held_.resize(forces.size());
  PairwiseSum changes;
  PairwiseSum wrenches;  // of the load, and of contacts that no matrix holds
  changes.add(sum_.empty() ? Vector(dimension * width) : std::move(sum_));
  Vector load = box.load.lowest();
  for (std::size_t j = 0; j < dimension; ++j) {
    load[j] *= x[dimension];
    for (std::size_t k = 0; k < box.growths.size(); ++k) {
      load[j] += x[dimension + 1 + k] * box.growths[k][j];
    }
  }
  wrenches.add(load);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const auto& [v, slip, share] = forces[i];
    const Row& row = box.row(i);
    const Rational& friction = box.contact(i)[Parameter::kFriction].low;
    const bool acts = v > 0 || is_spring(box.contact(i).sight);
    std::optional<int> held;
    if (acts && share.size() == 1 && share[0].get_den() == 1) held = sgn(share[0]);
    if (acts && !held) {
      wrenches.add(wrench_of(row, friction, share, row.v_scale * row.scale * v));
    }
    if (v == 0 || held == held_[i]) continue;
    const auto change = [&](const std::optional<int>& edge, int sign) {
      if (!edge) return;
      const Vector wrench =
          wrench_of(row, friction, {Rational(*edge)}, sign * row.v_scale * row.scale);
      Vector matrix;
      for (const Rational& w : wrench) {
        for (const Integer& c : row.v[0]) matrix.emplace_back(w * c);
      }
      changes.add(std::move(matrix));
    };
    change(held_[i], -1);
    change(held, 1);
    held_[i] = held;
  }
  sum_ = changes.total();
  Vector total = wrenches.total();
  for (std::size_t j = 0; j < dimension; ++j) {
    for (std::size_t k = 0; k < width; ++k) total[j] += sum_[j * width + k] * x[k];
  }
  return total;
}

void take_shares(const Question& question, const ContactAt& contact_at, const Witness& witness,
                 std::vector<ContactForce>& forces) {
  check_bound(question.asked.max_motion.value_or(Vector{}), witness.x);
  take_stated(contact_at, witness, forces);
  for (std::size_t i = 0; question.asked.bilateral && i < forces.size(); ++i) {
    if (forces[i].v < 0 && !is_spring(contact_at(i).sight)) {
      reject("witness-normal", "", name_of(i) + "v is below 0");
    }
  }
  for (std::size_t i = 0; i < forces.size(); ++i) take_root(contact_at(i), i, forces[i]);
}

void check_grasp(const Question& question) {
  if (question.is_box) {
    reject("witness-box", "", "an equilibrium of one grasp, but the question is about a box");
  }
}

void check_balance(Vector total, const Rational& scale) {
  if (total == Vector(total.size())) return;
  for (Rational& entry : total) entry *= scale;
  reject("witness-balance", "", "load and forces add up to " + show(total) + ", not to 0");
}

std::vector<ContactForce> check_witness(const Question& question, const Witness& witness,
                                        ForceSum& sum) {
  check_grasp(question);
  // All conditions are homogeneous, so a multiple of the point without denominators serves.
  Rational scale;
  const Form x = make_form(witness.x, &scale);
  const Box& box = *question.box;
  std::vector<ContactForce> forces = motion_of(box, x);
  take_shares(
      question, [&box](std::size_t i) -> const ContactBox& { return box.contact(i); }, witness,
      forces);
  check_balance(sum.total(box, x, forces), scale);
  return forces;
}

std::optional<std::string> mode_refusal(const Question& question,
                                        const std::vector<ContactForce>& first,
                                        const std::vector<ContactForce>& second) {
  const char* const slips = "its two slips are not in one direction";
  const char* const shares =
      "it slips at one end, and at the other its friction has another share";
  const auto opposite = [](const Integer& x, const Integer& y) { return sgn(x) * sgn(y) < 0; };
  for (std::size_t i = 0; i < question.box->size(); ++i) {
    const ContactForce& p = first[i];
    const ContactForce& q = second[i];
    const ContactBox& contact = question.box->contact(i);
    const bool opens = opposite(p.v, q.v) && !is_spring(contact.sight);
    if (opens) return name_of(i) + "v has opposite signs";
    const Rational& friction = contact[Parameter::kFriction].high;
    if (friction == 0 || (p.v <= 0 && q.v <= 0)) continue;
    if (p.slip.size() == 1) {  // the same in the plane, where a direction is a sign
      if (opposite(p.slip[0], q.slip[0])) return name_of(i) + slips;
      const int slip = sgn(p.slip[0]) != 0 ? sgn(p.slip[0]) : sgn(q.slip[0]);
      for (const ContactForce* end : {&p, &q}) {
        if (end->v > 0 && slip != 0 && end->share[0] != -slip) return name_of(i) + shares;
      }
      continue;
    }
    if (!is_largest(dot(p.slip, q.slip), dot(p.slip, p.slip) * dot(q.slip, q.slip))) {
      return name_of(i) + slips;
    }
    Vector slip;
    for (std::size_t k = 0; k < p.slip.size(); ++k) slip.emplace_back(p.slip[k] + q.slip[k]);
    const Rational largest = longest_square(contact) * dot(conjugate(contact, slip), slip);
    for (const ContactForce* end : {&p, &q}) {
      if (end->v > 0 && !is_largest(-dot(end->share, slip), largest)) {
        return name_of(i) + shares;
      }
    }
  }
  return std::nullopt;
}

}  // namespace stickslip_check
