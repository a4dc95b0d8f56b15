// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The manual: a page, in section 1, for each command.
#pragma once

#include <map>
#include <string>

#include "command_tree.hpp"

namespace stickslip {

/// The pages of a program and of all its subcommands, by file name ("stickslip-plot-grasp.1"),
/// in the man macros (man(7)).
///
/// What --help shows below the options is set in sections: a line that begins with "Files:",
/// "Example:" or "Exit codes:" starts the section of that, and what comes before is
/// description. Lines that begin with a blank stay as they are; all others are filled.
std::map<std::string, std::string> manual_pages(const CommandEntry& tree);

}  // namespace stickslip
