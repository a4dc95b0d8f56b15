// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Two grasps of a box with opposite verdicts: how answers show and write them.
#pragma once

#include <string>
#include <vector>

#include "box_numbers.hpp"
#include "stickslip/certificate/proved_files.hpp"

namespace stickslip {

/// What a fragile box is, and a table. `examples`: the folder to which both grasps are written;
/// may be empty.
std::string fragile_text(const std::vector<Difference>& differences, NumberText& text,
                         const std::string& examples);

/// stable.json and unstable.json, each with its certificate, for --examples.
void write_two_examples(const std::string& folder, ProvedFiles stable, ProvedFiles unstable);

/// Says on standard error that there are none: what was asked about, a box or one grasp, has
/// this verdict.
void say_no_examples(bool is_box, const std::string& verdict);

/// Says on standard error that a fragile box has two certificates, and how to get them.
void say_two_certificates();

}  // namespace stickslip
