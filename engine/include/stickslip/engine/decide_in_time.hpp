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

/// Decides a question, or answers what is known when the time is over. `then` is done with the
/// answer in what is left of the time. `finishes` does all of it within the limit; without it
/// TimeLimit::finishes() does. Throws what decide() throws.
Answer decide_in_time(
    Question question, const SearchOptions& options, const TimeLimit& limit,
    const std::function<void(const Answer&)>& then = {},
    const std::function<bool(const std::function<void()>& work)>& finishes = {});

}  // namespace stickslip
