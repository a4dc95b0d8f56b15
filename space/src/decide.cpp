// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/space/spatial_verdict.hpp"

namespace stickslip {

BoxDecision decide(const SpatialQuestion& question, const BoxOptions& options) {
  return decide_box(question.grasp.box, question.law, options);
}

}  // namespace stickslip
