// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How the subcommands that look for traps of the model print what they find.
#pragma once

#include "command_line.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"

namespace stickslip {

/// --no-warnings.
void add_no_warnings_option(Command& command, bool& no_warnings);

/// For people, a line each.
void print(const Warnings& warnings);

}  // namespace stickslip
