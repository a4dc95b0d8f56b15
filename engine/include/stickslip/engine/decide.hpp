// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// One question of any kind, one verdict.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "stickslip/engine/box_verdict.hpp"
#include "stickslip/engine/decide_problem.hpp"
#include "stickslip/engine/question.hpp"

namespace stickslip {

/// Returns the name of the engine for numbers that may be intervals: "intervals" in the plane,
/// "space", or "bodies" if there are several.
const char* box_engine(const Question& question);

/// The answer to one question. A question about one grasp in the plane becomes one about a box
/// of one point in two cases: some lengths are irrational and known as intervals, or it is
/// stable and an exact equilibrium would be too long (has_long_equilibria).
struct Answer {
  Question question;  ///< the question as asked, or about a box of one point, see above
  Verdict verdict;    ///< with its evidence
  /// The work of the engine that ran; none of a proof that another answer's search has brought.
  std::variant<std::monostate, StatesWork, BranchWork, SearchWork> work{};
  unsigned bits = kDefaultBits;      ///< the precision, as of BoxDecision
  std::optional<Problem> problem{};  ///< the problem, unless the question is about a box
  /// The answer to a second question, if rounding of the data alone may decide the first
  /// (second_question.hpp).
  std::shared_ptr<const Answer> within{};

  /// Returns "states", "branch-and-bound", or box_engine() of the question.
  const char* engine() const;
};

/// Decides a question of any kind: is the grasp stable, or every grasp in the box? Throws what
/// problem_of() throws, and InputError for a margin.
Answer decide(Question question, const SearchOptions& options = {});

/// Returns the work by name, in a fixed order.
std::vector<std::pair<std::string, std::size_t>> counters(const Answer& answer);

}  // namespace stickslip
