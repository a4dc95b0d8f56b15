// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "mode_walk.hpp"
#include "still_cell.hpp"

namespace stickslip {

using namespace resistance_detail;

std::variant<PlaneUnion, Undecided> resistible_region(const Problem& problem,
                                                      const WrenchPlane& plane,
                                                      const ResistibleOptions& options,
                                                      ResistibleWork* work) {
  ResistibleWork unused;
  ResistibleWork& counters = work != nullptr ? *work : unused;
  counters = {};
  MotionRays rays(problem);
  ModeImages images(problem, plane, rays);
  ModeSections sections(rays, images, counters);
  if (!walk_modes(problem, rays, images, options, counters, sections)) {
    return too_many_modes(options);
  }
  if (const auto cell = still_cell(rays, images)) sections.add(*cell);
  return sections.united();
}

}  // namespace stickslip
