// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The walk to the modes that resist loads of a plane.
///
/// **Method.** From four cones that make up the space of motions, contacts are split as in a
/// refutation (certificate/FORMAT.md, section 4), but only where that can matter: a slip class
/// (contacts whose slip planes coincide) into slip +, none and slip -, while one of its
/// contacts has friction and may be closed; a separation into closed and open. A region is left
/// where bounds say that no load of its motions is in the plane: n, the load's coordinate
/// across the plane, is bounded by friction anywhere between the edges of the cones and by
/// contacts either closed or open where they may be either; the bound is convex, so that rays
/// tell.
///
/// **It misses nothing.** Let d be a motion with forces that balance a load of the plane, not
/// 0, and say that a class sticks if its slip is 0 and a closed contact of it with friction has
/// a force. Go down from a cone that has d: to "none" with a class that sticks, to a side that
/// has d with one that does not, and at separations to a side that has d. Bounds hold for d, so
/// no region on the way is left. Nor is a region whose sticking class cannot have a force, as
/// that is where d does not go. At the end no plane of a contact that matters cuts the region;
/// a class that sticks and was not split touches it in a face, from where the walk goes on with
/// "none" (a face that it has not been to). What is found at the end, a mode, has d. The motion
/// 0, in all of these faces, has its own place (still_cell.hpp), and so have motions without
/// any force.
#pragma once

#include "mode_sections.hpp"

namespace stickslip::resistance_detail {

/// Adds the modes to the sections. False if the limit on modes was exceeded.
bool walk_modes(const Problem& problem, MotionRays& rays, const ModeImages& images,
                const ResistibleOptions& options, ResistibleWork& work, ModeSections& sections);

}  // namespace stickslip::resistance_detail
