// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Pictures of slip states. In the plane: the sphere of motions, cut by the great circles
/// T_i.d = 0 (Haas-Heger et al., RSS 2018, Section IV and Fig. 5).
///
/// The sphere is drawn as two discs, by Lambert's azimuthal equal-area projection: the
/// counterclockwise rotations (r > 0) and the clockwise ones. A motion with r != 0 turns the
/// object about a point; it is drawn in the direction of that point from the centre of the
/// disc, further out the further the point is away. So a great circle is the line along its
/// contact's tangent, and one place in both discs means opposite motions d and -d. Translations
/// are on the rim.
///
/// Lengths are measured from the object frame's origin, or the middle of the contacts if it is
/// far from them, in units of the grasp's size. This is a linear change of coordinates of d and
/// changes no sign.
#pragma once

#include <cstddef>
#include <string>

#include "stickslip/arrangement/contact_states.hpp"
#include "stickslip/core/box.hpp"
#include "stickslip/core/grasp.hpp"

namespace stickslip {

/// Cells that more circles than these cut are too small to see.
inline constexpr std::size_t kMostCirclesToDraw = 100;

/// Returns an SVG document. Each face, edge and vertex is one element of class "face", "edge"
/// or "vertex" whose data-state is its sign vector. data-centre and data-radius of their group
/// are the exact point from which lengths are measured, and their unit. Few faces have one
/// colour for each antipodal pair; many change shade with the number of contacts that slip +.
/// Throws InputError if there are more than kMostCirclesToDraw distinct circles.
std::string plot_states(const Grasp& grasp);

/// States of more than these are too many to look at.
inline constexpr std::size_t kMostStatesToDraw = 200;

/// Returns the same picture for the slip states of a single grasp in the plane, if it is kept
/// as one. Other sets of states, those in space and those of several bodies, with the default
/// lines of slip, have a row for each dimension of their motions, the largest on top. Each
/// state is one element of class "node" with data-state and data-dimension. A line of class
/// "link" goes from a state, data-from, to each state of one dimension less that its motions
/// tend to, data-to. Throws InputError if there are more than kMostStatesToDraw states.
std::string plot_states(const AnyGrasp& grasp, StateSet set);

}  // namespace stickslip
