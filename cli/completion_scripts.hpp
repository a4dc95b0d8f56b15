// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Completion scripts for shells. Each completes subcommands, options, values of which there
/// are few, and names of files (values called FILE) and folders (DIR).
#pragma once

#include <string>

#include "command_tree.hpp"

namespace stickslip {

/// Each is for the program that `tree` describes, whose subcommands may have subcommands.
std::string bash_completion(const CommandEntry& tree);
std::string zsh_completion(const CommandEntry& tree);
std::string fish_completion(const CommandEntry& tree);

}  // namespace stickslip
