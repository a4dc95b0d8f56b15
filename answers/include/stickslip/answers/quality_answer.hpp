// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The quality of a passive grasp as JSON, and its proofs.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "stickslip/box/quality.hpp"
#include "stickslip/certificate/proved_files.hpp"
#include "stickslip/core/number_text.hpp"
#include "stickslip/equilibrium/question.hpp"

namespace stickslip {

/// The ball of --length, --about and --body as they are spelled; what is empty is left out.
/// Its radius is 1. Throws InputError that names the option.
LoadBall ball_shape(const std::string& length, const std::string& about,
                    const std::string& body);

/// The two radii, what the ball is, and the load that is not resisted.
Json quality_json(const Question& question, const Quality& quality);

/// "proved", the ball that is resisted, and "refuted", the load that is not, those that there
/// are: grasp files with certificates.
std::vector<std::pair<std::string, ProvedFiles>> proved_quality(const Question& question,
                                                                const Quality& quality);

}  // namespace stickslip
