// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Questions about the quality of a passive grasp; the answer as JSON, and its proofs.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "stickslip/certificate/proved_files.hpp"
#include "stickslip/core/number_text.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/measures/quality.hpp"

namespace stickslip {

/// The values of options; an option that is not given is empty.
struct QualityText {
  std::string length;           ///< the length by which torques are divided
  std::string about;            ///< the point of the torques, "X,Y"
  std::string body;             ///< the body that is loaded, of several
  std::string at_most;          ///< the largest radius of interest
  std::string accuracy = "1%";  ///< the accuracy of the two radii
};

/// A question about a quality, but for the grasp.
struct QualityAsked {
  LoadBall shape{1};         ///< the shape of the ball; its radius does not matter
  bool has_length = false;   ///< whether its length was given
  QualityOptions options{};  ///< the options of the search
};

/// Returns the question that they ask. Throws InputError naming the option.
QualityAsked quality_asked(const QualityText& text);

/// Returns the shape of the ball for a grasp: without a length it has that of
/// characteristic_length(), and if it names no body, it is on the only one of a mechanism.
LoadBall shape_for(const QualityAsked& asked, const Question& question);

/// Returns the one grasp, of that file, whose quality is asked for. Throws InputError if
/// numbers are uncertain, or if there can be no such ball of loads.
GraspBox grasp_for_ball(const Question& question, const LoadBall& shape,
                        const std::string& file);

/// Returns the two radii, the ball, and the load that is not resisted.
Json quality_json(const Question& question, const Quality& quality);

/// Returns grasp files with certificates: "proved", the ball that is resisted, and "refuted",
/// the load that is not, as far as they are known.
std::vector<std::pair<std::string, ProvedFiles>> proved_quality(const Question& question,
                                                                const Quality& quality);

}  // namespace stickslip
