// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Decisions that may be broken off, and what is answered then.
#pragma once

#include <functional>

#include "stickslip/core/time_limit.hpp"
#include "stickslip/engine/decide.hpp"

namespace stickslip {

/// Decides a question as decide() does. Calls `progress` with the first answer before it seeks
/// a second one.
Answer decide(Question question, const SearchOptions& options,
              const std::function<void(const Answer& first)>& progress);

/// Returns that the time was over before there was a verdict.
Undecided out_of_time(const TimeLimit& limit);

/// Returns the answer of a question that was given up for this reason. Throws what problem_of()
/// throws.
Answer unanswered(Question question, Undecided why);

/// Decides a question, or answers what is known when the time is over.
Answer decide_in_time(const Question& question, const SearchOptions& options,
                      const TimeLimit& limit);

}  // namespace stickslip
