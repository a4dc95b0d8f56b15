// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What is asked about the quality of a passive grasp; the answer as JSON, and its proofs.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "stickslip/certificate/proved_files.hpp"
#include "stickslip/core/number_text.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/measures/quality.hpp"

namespace stickslip {

/// The values of options, empty where they are not given.
struct QualityText {
  std::string length;           ///< by which torques are divided
  std::string about;            ///< the point of the torques, "X,Y"
  std::string body;             ///< of several bodies that which is loaded
  std::string at_most;          ///< the largest radius of interest
  std::string accuracy = "1%";  ///< of the two radii
};

/// A question about a quality, but for the grasp.
struct QualityAsked {
  LoadBall shape{1};         ///< of the ball; its radius is of no matter
  QualityOptions options{};  ///< of the search
};

/// What they say. Throws InputError naming the option.
QualityAsked quality_asked(const QualityText& text);

/// The one grasp, of that file, whose quality is asked for. Throws InputError if numbers are
/// uncertain, or if there can be no such ball of loads.
GraspBox grasp_for_ball(const Question& question, const LoadBall& shape,
                        const std::string& file);

/// The two radii, what the ball is, and the load that is not resisted.
Json quality_json(const Question& question, const Quality& quality);

/// "proved", the ball that is resisted, and "refuted", the load that is not, those that there
/// are: grasp files with certificates.
std::vector<std::pair<std::string, ProvedFiles>> proved_quality(const Question& question,
                                                                const Quality& quality);

}  // namespace stickslip
