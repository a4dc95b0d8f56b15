// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Contacts of several bodies whose normals seem to be turned round, or their "of" and "by"
/// exchanged, so that the contact would pull bodies apart (docs/model.md). All signs are exact,
/// at the middles of intervals.
///
/// The known points of a body are the vertices of its outline or mesh, hinges of its own and of
/// links on it, its contacts, and the points at which weights pull. A contact at p with the
/// normal n is said to be reversed if
///
/// - a body in the plane has an outline, p lies on it, and n is the opposite of a force that
///   can press there: of a normal of the edge or, at a vertex, of one between the two normals;
///   or
/// - no known point of `of` has n.(x - p) > 0 and one has < 0, and no known point of `by` has <
///   0 and one has > 0: turned round, the normal would separate the known points, and it does
///   not as it stands; or
/// - `by` is the ground, of which nothing is known, the condition on `of` holds, `of` is no
///   link, and every contact of `of` with the ground for which it holds pushes `of` where its
///   load pulls.
///
/// If n.(x - p) is at most |n| |x - p| / kFlatness in size, x counts as on the plane.
#pragma once

#include <optional>
#include <string>

#include "stickslip/core/box.hpp"

namespace stickslip::warnings_detail {

inline constexpr int kFlatness = 1000;  ///< one over the least angle that tells

/// Returns the warning about the first reversed contacts, or nothing. Requires a mechanism.
/// O(1) for each contact whose sign a vertex or two show to be right, otherwise O(points).
std::optional<std::string> reversed_contacts(const GraspBox& grasp);

}  // namespace stickslip::warnings_detail
