// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Contacts of several bodies whose normals seem to be turned round, or their "of" and "by"
/// exchanged, so that the contact would pull bodies apart (docs/model.md). All is exact, of the
/// middles of intervals.
///
/// What is known of a body are points: vertices of its outline or mesh, hinges of its own and
/// of links on it, its contacts, and where weights pull at it. A contact at p with the normal n
/// is said to be reversed if
///
/// - a body in the plane has an outline, p lies on it, and n is the opposite of a force that
///   can press there: of a normal of the edge, or, at a vertex, of those between the two; or
/// - no known point of `of` has n.(x - p) > 0 and one has < 0, and of `by` none < 0 and one >
/// 0:
///   turned round, the normal would separate what is known, and it does not as it stands; or
/// - `by` is the ground, of which nothing is known, this is true of `of`, which is no link, and
///   all contacts with the ground of which it is true push it where its load pulls.
///
/// Where n.(x - p) is at most |n| |x - p| / kFlatness, x counts as on the plane.
#pragma once

#include <optional>
#include <string>

#include "stickslip/core/box.hpp"

namespace stickslip::warnings_detail {

inline constexpr int kFlatness = 1000;  ///< one over the least angle that tells

/// What is wrong, if anything, with the first pair of bodies; requires a mechanism. O(1) for
/// each contact whose sign a vertex or two show to be right, otherwise O(points).
std::optional<std::string> reversed_contacts(const GraspBox& grasp);

}  // namespace stickslip::warnings_detail
