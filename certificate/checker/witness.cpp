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

}  // namespace

std::vector<ContactForce> check_witness(const Question& question, const Witness& witness) {
  if (question.is_box) {
    reject("witness-box", "an equilibrium of one grasp, but the question is about a box");
  }
  // All conditions are homogeneous, so a multiple of the point without denominators serves.
  const Form x = make_form(witness.x);
  const Box& box = *question.box;
  const std::size_t m = box.rows.size();
  std::vector<ContactForce> forces;
  forces.reserve(m);
  for (const auto& row : box.rows) {
    const Integer slip = dot(row->slip[0], x);
    forces.push_back({dot(row->v[0], x), slip, -sgn(slip)});
  }
  Integer above = -1;
  for (const auto& [contact, share] : witness.shares) {
    if (contact <= above)
      reject("witness-share", name_of(contact) + "not above the one before");
    if (contact >= m) reject("witness-share", name_of(contact) + "there is none");
    if (abs(share) > 1) {
      reject("witness-share", name_of(contact) + show(share) + " is not in [-1, 1]");
    }
    ContactForce& force = forces[contact.get_ui()];
    if (force.slip != 0) reject("witness-share", name_of(contact) + "it slips");
    force.share = share;
    above = contact;
  }
  for (std::size_t i = 0; i < m; ++i) {
    if (question.asked.bilateral && forces[i].v < 0) {
      reject("witness-normal", name_of(i) + "v is below 0");
    }
  }
  PairwiseSum sum;
  Vector term(kDimension);
  for (std::size_t j = 0; j < kDimension; ++j) {
    term[j] = x[kDimension] * box.wrench[j].low + x[kDimension + 1] * box.growth[j];
  }
  sum.add(term);
  for (std::size_t i = 0; i < m; ++i) {
    if (forces[i].v <= 0) continue;
    const Row& row = *box.rows[i];
    const Rational a = row.weight * forces[i].v;
    const Rational less = a * (1 - forces[i].share) / 2;  // along the edge N - mu T
    const Rational more = a - less;
    for (std::size_t j = 0; j < kDimension; ++j) {
      term[j] = less * row.edges[0][j] + more * row.edges[1][j];
    }
    sum.add(term);
  }
  Vector total = sum.total();
  if (total != Vector(kDimension)) {
    const std::size_t k = kDimension + (witness.x[kDimension] == 0 ? 1 : 0);
    for (Rational& entry : total) entry *= witness.x[k] / x[k];
    reject("witness-balance", "load and forces add up to " + show(total) + ", not to 0");
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
    if (question.box->rows[i]->frictionless || (p.v <= 0 && q.v <= 0)) continue;
    if (opposite(p.slip, q.slip)) return name_of(i) + "T.d has opposite signs";
    const int slip = sgn(p.slip) + sgn(q.slip);
    for (const ContactForce* end : {&p, &q}) {
      if (slip != 0 && end->v > 0 && end->share != -((slip > 0) - (slip < 0))) {
        return name_of(i) +
               "it slips at one end, and at the other its friction has another share";
      }
    }
  }
  return std::nullopt;
}

}  // namespace stickslip_check
