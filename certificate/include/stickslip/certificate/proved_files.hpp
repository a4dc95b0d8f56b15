// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Grasps and boxes as files of their own, each with the certificate of its verdict: what a
/// checker needs and nothing else, under the normal law.
#pragma once

#include <string>
#include <vector>

#include "stickslip/core/grasp_file.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/measures/radius.hpp"

namespace stickslip {

/// Two files that belong together.
struct ProvedFiles {
  std::string grasp;        ///< a grasp file, of a box one with intervals
  std::string certificate;  ///< of its verdict
  std::string uncertain{};  ///< what --uncertain is for a checker, of a ball of loads
  std::optional<PreloadDirection> preload_direction{};  ///< likewise, of a margin
};

/// Of one grasp, decided here once more. `producer` is a remark without meaning. Requires that
/// the verdict is stable, or unstable, as `stable` says.
ProvedFiles proved_grasp(const GraspBox& point, NormalLaw law, bool stable,
                         const std::string& producer);

/// Of a box that is stable or unstable throughout, as `decision` proves. A box of one grasp has
/// that grasp's files.
ProvedFiles proved_box(const GraspBox& box, NormalLaw law, const BoxDecision& decision,
                       const std::string& producer);

/// Of decide_box(): the box if it has one verdict, and if it is fragile the stable example and
/// the other one; nothing if it is undecided.
std::vector<ProvedFiles> proved_decision(const GraspBox& box, NormalLaw law,
                                         const BoxDecision& decision,
                                         const std::string& producer);

/// Of find_radius() for a centre and a box about it: the largest box that is proved, or the
/// grasp in the centre if there is none; and then the counterexample, if there is one. Requires
/// that the centre is decided.
std::vector<ProvedFiles> proved_radius(const GraspBox& centre, const GraspBox& box,
                                       NormalLaw law, const Radius& radius,
                                       const std::string& producer);

}  // namespace stickslip
