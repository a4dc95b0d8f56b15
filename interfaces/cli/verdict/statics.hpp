// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The answer of statics, for the commands that ask it.
#pragma once

#include <string>

#include "question_options.hpp"
#include "stickslip/core/time_limit.hpp"
#include "stickslip/interfaces/statics_answer.hpp"

namespace stickslip {

/// Answers on standard output, and writes certificates to that file, if it is not empty.
/// `grasp` is the name of the grasp file. Returns the exit code.
int answer_statics(StaticsQuestion asked, const std::string& certificate,
                   const std::string& grasp, const NumberOptions& output,
                   const TimeLimit& time);

}  // namespace stickslip
