// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// CGAL's exact LP solver on the same programs, behind a header without CGAL.
#pragma once

#include <memory>

#include "stickslip/lp/linear_program.hpp"

namespace stickslip::bench {

/// Holds a program in CGAL's form, so that only solving is timed.
class QpSolver {
 public:
  explicit QpSolver(const LinearProgram& program);
  ~QpSolver();
  QpSolver(QpSolver&&) noexcept;
  QpSolver& operator=(QpSolver&&) noexcept;

  /// Solves from scratch, Bland's rule (the others can cycle: CGAL issue 5672).
  bool is_feasible() const;

 private:
  struct Model;
  std::unique_ptr<Model> model_;
};

}  // namespace stickslip::bench
