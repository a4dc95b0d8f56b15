// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Grasps and boxes as files of their own, each with the certificate of its verdict: all that a
/// checker needs, under the normal law.
#pragma once

#include <string>
#include <vector>

#include "stickslip/core/grasp_file.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/measures/radius.hpp"

namespace stickslip {

/// A grasp file and a certificate that belong together.
struct ProvedFiles {
  std::string grasp;        ///< the grasp file; that of a box has intervals
  std::string certificate;  ///< the certificate of its verdict
  std::string uncertain{};  ///< the value of a checker's --uncertain, for a ball of loads
  std::optional<PreloadDirection> preload_direction{};  ///< the preload direction for a
                                                        ///< checker, of a margin
};

/// Returns the files of one grasp, which this decides once more. `producer` is a remark without
/// meaning. Requires that the verdict is stable if `stable`, and else unstable.
ProvedFiles proved_grasp(const GraspBox& point, NormalLaw law, bool stable,
                         const std::string& producer);

/// Returns the files of a box that is stable or unstable throughout, as `decision` proves. A
/// box of one grasp has that grasp's files.
ProvedFiles proved_box(const GraspBox& box, NormalLaw law, const BoxDecision& decision,
                       const std::string& producer);

/// Returns the files of a decision of decide_box(): the box if it has one verdict; the stable
/// example and the other one if it is fragile; none if it is undecided.
std::vector<ProvedFiles> proved_decision(const GraspBox& box, NormalLaw law,
                                         const BoxDecision& decision,
                                         const std::string& producer);

/// Returns the files of a result of find_radius() for a centre and a box about it: the largest
/// box that is proved, or the grasp in the centre if there is none; and then the
/// counterexample, if there is one. Requires that the centre is decided.
std::vector<ProvedFiles> proved_radius(const GraspBox& centre, const GraspBox& box,
                                       NormalLaw law, const Radius& radius,
                                       const std::string& producer);

}  // namespace stickslip
