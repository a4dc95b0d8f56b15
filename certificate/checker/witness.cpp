// SPDX-License-Identifier: MIT
#include "witness.hpp"

#include <string>

#include "answer.hpp"

namespace stickslip_check {

namespace {

/// v_i, with the preload times h.
Rational compression(const Row& row, const Witness& witness) {
  return row.preload * witness.h - row.stiffness * dot(row.normal, witness.d);
}

bool opposite(const Rational& x, const Rational& y) {
  return sgn(x) * sgn(y) < 0;
}

}  // namespace

void check_witness(const std::vector<Row>& rows, const Vector3& load, bool bilateral,
                   const Witness& witness) {
  const auto& forces = witness.forces;
  if (witness.stated != rows.size()) {
    throw Rejected{"witness-count", std::nullopt, "",
                   std::to_string(witness.stated) + " pairs of forces for " +
                       std::to_string(rows.size()) + " contacts"};
  }
  Vector3 sum = load;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      sum[j] += forces[i][0] * rows[i].normal[j] + forces[i][1] * rows[i].tangent[j];
    }
  }
  if (sum[0] != 0 || sum[1] != 0 || sum[2] != 0) {
    throw Rejected{"witness-balance", std::nullopt, "",
                   "the wrenches add up to " + show(sum) + ", not to 0"};
  }
  // Rule by rule, so that the first one to fail does not depend on the order of the contacts.
  const auto reject = [](const char* rule, std::size_t i, const std::string& found) {
    throw Rejected{rule, std::nullopt, "", "contact " + std::to_string(i) + ": " + found};
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Rational v = compression(rows[i], witness);
    if (v < 0 && bilateral) reject("witness-normal", i, "v = " + show(v) + " is below 0");
    const Rational a = v < 0 ? Rational(0) : v;
    if (forces[i][0] != a) {
      reject("witness-normal", i, "a = " + show(forces[i][0]) + ", but v = " + show(v));
    }
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (abs(forces[i][1]) > rows[i].friction * forces[i][0]) {
      reject("witness-cone", i,
             "b = " + show(forces[i][1]) + " with a = " + show(forces[i][0]));
    }
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Rational slip = dot(rows[i].tangent, witness.d);
    const Rational edge = rows[i].friction * forces[i][0];
    if ((slip > 0 && forces[i][1] != -edge) || (slip < 0 && forces[i][1] != edge)) {
      reject("witness-dissipation", i,
             "T.d = " + show(slip) + ", b = " + show(forces[i][1]) + ", mu a = " + show(edge));
    }
  }
}

std::optional<std::string> mode_refusal(const std::vector<Row>& rows, const Witness& first,
                                        const Witness& second) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    const std::string name = "contact " + std::to_string(i);
    const Rational v1 = compression(row, first);
    const Rational v2 = compression(row, second);
    if (opposite(v1, v2)) return name + " has v = " + show(v1) + " and v = " + show(v2);
    const auto& [a1, b1] = first.forces[i];
    const auto& [a2, b2] = second.forces[i];
    if (row.friction == 0 || a1 + a2 == 0) continue;
    const Rational slip1 = dot(row.tangent, first.d);
    const Rational slip2 = dot(row.tangent, second.d);
    if (opposite(slip1, slip2)) {
      return name + " has T.d = " + show(slip1) + " and T.d = " + show(slip2);
    }
    const Rational sigma = -sgn(slip1 + slip2) * row.friction;
    if (sigma != 0 && (b1 != sigma * a1 || b2 != sigma * a2)) {
      return name + " slips, but (a, b) = (" + show(a1) + ", " + show(b1) + ") and (" +
             show(a2) + ", " + show(b2) + ") are not on the same edge of the cone";
    }
  }
  return std::nullopt;
}

}  // namespace stickslip_check
