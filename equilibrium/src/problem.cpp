// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/problem.hpp"

namespace stickslip {

Problem::Problem(const LoadedGrasp& loaded, NormalLaw law)
    : rows_(contact_rows(loaded.grasp)), wrench_(loaded.wrench), law_(law) {
  for (const ContactRow& row : rows_) {
    const Wrench& n = row.normal;
    const Wrench& t = row.tangent;
    slip_planes_.push_back(primitive_multiple<4>({t.x, t.y, t.torque, 0}));
    separations_.push_back(
        {-row.stiffness * n.x, -row.stiffness * n.y, -row.stiffness * n.torque, row.preload});
    separation_planes_.push_back(primitive_multiple<4>(separations_.back()));
  }
}

Wrench Problem::edge_wrench(ContactId contact, int sigma) const {
  const ContactRow& r = row(contact);
  return r.normal + (Rational(sigma) * r.friction) * r.tangent;
}

}  // namespace stickslip
