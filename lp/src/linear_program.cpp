// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/lp/linear_program.hpp"

#include <optional>
#include <utility>

#include "steps.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/lp/verify.hpp"

namespace stickslip {

std::size_t LinearProgram::add_variable(VariableKind kind) {
  kinds_.push_back(kind);
  return kinds_.size() - 1;
}

std::size_t LinearProgram::add_variables(std::size_t count, VariableKind kind) {
  const std::size_t first = kinds_.size();
  kinds_.resize(first + count, kind);
  return first;
}

std::size_t LinearProgram::add_row(std::vector<Rational> coefficients, Relation relation,
                                   Rational rhs) {
  require(coefficients.size() <= kinds_.size(),
          "LinearProgram::add_row: more coefficients than variables");
  rows_.push_back(LpRow{std::move(coefficients), relation, std::move(rhs)});
  return rows_.size() - 1;
}

void LinearProgram::minimize(std::vector<Rational> objective) {
  require(objective.size() <= kinds_.size(),
          "LinearProgram::minimize: more coefficients than variables");
  objective_ = std::move(objective);
}

LpResult solve(const LinearProgram& program, LpWork* work) {
  return solve(program, LpOptions{}, work);
}

LpResult solve(const LinearProgram& program, const LpOptions& options, LpWork* work) {
  LpWork counted;
  counted.tier = options.first_tier;
  const lp_detail::ScaledSystem system(program);
  lp_detail::Proposal proposal;
  std::optional<LpResult> result;
  if (options.propose) {
    proposal = lp_detail::propose(system, counted);
    result = lp_detail::confirm(program, system, proposal, options.first_tier, counted);
    counted.basis_confirmed = result.has_value();
  }
  if (!result) {
    result = lp_detail::solve_exactly(program, system, std::move(proposal.nonbasic),
                                      options.first_tier, counted);
    require(verify(program, *result).holds, "lp: the evidence of an answer does not verify");
  }
  if (work != nullptr) *work = counted;
  return *std::move(result);
}

}  // namespace stickslip
