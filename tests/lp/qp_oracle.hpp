// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// CGAL's exact QP_solver as an oracle, behind a header without CGAL.
#pragma once

#include "evidence_check.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::lp_test {

struct OracleAnswer {
  Status status = Status::kOptimal;
  Rational value;  ///< of an optimal program
};

/// Bland's rule: other pricings can cycle (CGAL issue 5672). Requires at least one variable.
OracleAnswer ask_qp_solver(const LinearProgram& program);

}  // namespace stickslip::lp_test
