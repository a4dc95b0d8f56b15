// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Printed warnings of the subcommands that look for traps of the model.
#pragma once

#include "command_line.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"

namespace stickslip {

/// Adds --no-warnings.
void add_no_warnings_option(Command& command, bool& no_warnings);

/// Prints the warnings for people, a line each.
void print(const Warnings& warnings);

}  // namespace stickslip
