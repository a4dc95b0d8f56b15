// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The walk to the modes that resist loads of a plane.
///
/// **Method.** Four cones make up the space of motions. From them the walk splits contacts as a
/// refutation does (certificate/FORMAT.md, section 4), but only where that can matter. It
/// splits a slip class (contacts whose slip planes coincide) into slip +, none and slip -,
/// while one of its contacts has friction and may be closed, and a separation into closed and
/// open. It leaves a region if bounds say that no load of its motions is in the plane. The
/// bound is about n, the load's coordinate across the plane: friction may be anywhere between
/// the edges of the cones, and contacts may be closed or open if both occur. The bound is
/// convex, so that rays tell.
///
/// **It misses nothing.** Let d be a motion with forces that balance a load of the plane, not
/// 0, and say that a class sticks if its slip is 0 and a closed contact of it with friction has
/// a force. Go down from a cone that has d: to "none" with a class that sticks, to a side that
/// has d with one that does not, and at separations to a side that has d. Bounds hold for d, so
/// the walk leaves no region on the way. Nor does the way lead to a region whose sticking class
/// cannot have a force. At the end no plane of a contact that matters cuts the region; a class
/// that sticks and was not split touches it in a face, from where the walk goes on with "none"
/// (in a face that it has not been to). The region at the end is a mode, and has d. The motion
/// 0, in all of these faces, has its own place (still_cell.hpp), and so have motions without
/// any force.
#pragma once

#include "mode_sections.hpp"

namespace stickslip::resistance_detail {

/// Adds the modes to the sections. Returns false if the limit on modes was exceeded.
bool walk_modes(const Problem& problem, MotionRays& rays, const ModeImages& images,
                const ResistibleOptions& options, ResistibleWork& work, ModeSections& sections);

}  // namespace stickslip::resistance_detail
