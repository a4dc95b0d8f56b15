// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How the subcommands that look for traps of the model print what they find.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <vector>

#include "question_options.hpp"
#include "stickslip/equilibrium/model_warnings.hpp"

namespace stickslip {

/// Nothing when they were not asked for.
using Warnings = std::optional<std::vector<ModelWarning>>;

/// --no-warnings.
void add_no_warnings_option(CLI::App& command, bool& no_warnings);

Json warnings_json(const std::vector<ModelWarning>& warnings);

/// For people, a line each.
void print(const Warnings& warnings);

}  // namespace stickslip
