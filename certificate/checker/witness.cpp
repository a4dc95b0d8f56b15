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

bool opposite(const Rational& x, const Rational& y) {
  return sgn(x) * sgn(y) < 0;
}

}  // namespace

std::vector<ContactForce> check_witness(const Question& question, const Witness& witness) {
  const std::size_t m = question.rows.size();
  std::vector<ContactForce> forces(m);
  for (std::size_t i = 0; i < m; ++i) {
    const Row& row = question.rows[i];
    ContactForce& force = forces[i];
    force.v = dot(row.v, witness.x);
    force.slip = dot(row.tangent, witness.x);
    if (force.v > 0) force.a = force.v;
    force.b = -sgn(force.slip) * row.friction * force.a;
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
    if (force.slip != 0) {
      reject("witness-share", name_of(contact) + "it slips, T.d = " + show(force.slip));
    }
    force.b = share * question.rows[contact.get_ui()].friction * force.a;
    above = contact;
  }
  for (std::size_t i = 0; i < m; ++i) {
    if (question.asked.bilateral && forces[i].v < 0) {
      reject("witness-normal", name_of(i) + "v = " + show(forces[i].v) + " is below 0");
    }
  }
  PairwiseSum sum;
  Vector term(kDimension);
  for (std::size_t j = 0; j < kDimension; ++j) {
    term[j] = witness.x[kDimension] * question.wrench[j] +
              witness.x[kDimension + 1] * question.growth[j];
  }
  sum.add(term);
  for (std::size_t i = 0; i < m; ++i) {
    const Row& row = question.rows[i];
    if (forces[i].a == 0) continue;
    for (std::size_t j = 0; j < kDimension; ++j) {
      term[j] = forces[i].a * row.normal[j] + forces[i].b * row.tangent[j];
    }
    sum.add(term);
  }
  const Vector total = sum.total();
  if (total != Vector(kDimension)) {
    reject("witness-balance", "load and forces add up to " + show(total) + ", not to 0");
  }
  return forces;
}

std::optional<std::string> mode_refusal(const Question& question,
                                        const std::vector<ContactForce>& first,
                                        const std::vector<ContactForce>& second) {
  for (std::size_t i = 0; i < question.rows.size(); ++i) {
    const ContactForce& p = first[i];
    const ContactForce& q = second[i];
    const Rational& friction = question.rows[i].friction;
    if (opposite(p.v, q.v)) return name_of(i) + "v = " + show(p.v) + " and " + show(q.v);
    if (friction == 0 || p.a + q.a == 0) continue;
    if (opposite(p.slip, q.slip)) {
      return name_of(i) + "T.d = " + show(p.slip) + " and " + show(q.slip);
    }
    const Rational edge = -sgn(p.slip + q.slip) * friction;
    if (edge != 0 && (p.b != edge * p.a || q.b != edge * q.a)) {
      return name_of(i) +
             "it slips at one end, and at the other its friction is not the same " +
             "full share";
    }
  }
  return std::nullopt;
}

}  // namespace stickslip_check
