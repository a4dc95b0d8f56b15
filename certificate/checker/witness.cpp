// SPDX-License-Identifier: MIT
#include "witness.hpp"

#include <string>

#include "answer.hpp"

namespace stickslip_check {

void check_witness(const std::vector<Row>& rows, const Vector3& wrench, bool bilateral,
                   const Vector3& d, const std::vector<Vector2>& forces, std::size_t stated) {
  if (stated != rows.size()) {
    throw Rejected{"witness-count", std::nullopt, "",
                   std::to_string(stated) + " pairs of forces for " +
                       std::to_string(rows.size()) + " contacts"};
  }
  Vector3 sum = wrench;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      sum[j] += forces[i][0] * rows[i].normal[j] + forces[i][1] * rows[i].tangent[j];
    }
  }
  if (sum[0] != 0 || sum[1] != 0 || sum[2] != 0) {
    throw Rejected{"witness-balance", std::nullopt, "",
                   "the wrenches add up to (" + show(sum[0]) + ", " + show(sum[1]) + ", " +
                       show(sum[2]) + "), not to 0"};
  }
  // Rule by rule, so that the first one to fail does not depend on the order of the contacts.
  const auto reject = [](const char* rule, std::size_t i, const std::string& found) {
    throw Rejected{rule, std::nullopt, "", "contact " + std::to_string(i) + ": " + found};
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Rational v = rows[i].preload - rows[i].stiffness * dot(rows[i].normal, d);
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
    const Rational slip = dot(rows[i].tangent, d);
    const Rational edge = rows[i].friction * forces[i][0];
    if ((slip > 0 && forces[i][1] != -edge) || (slip < 0 && forces[i][1] != edge)) {
      reject("witness-dissipation", i,
             "T.d = " + show(slip) + ", b = " + show(forces[i][1]) + ", mu a = " + show(edge));
    }
  }
}

}  // namespace stickslip_check
