// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A picture of a verdict: the grasp, its load, and the evidence.
#pragma once

#include <string>

#include "stickslip/engine/question.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {

/// Returns an SVG document. It has contacts (from 0), normals, friction cones and preloads; the
/// applied wrench as a force and a torque arc; and the verdict, in the title, with the case if
/// there is one. If the grasp has no outline, the hull of the contacts and of points a little
/// inside of them stands for the body.
///
/// - Stable: the witness. Contact forces to scale, whether each contact sticks, slips + or -
///   (forwards or backwards along its tangent), or is open, and the motion, enlarged by a
///   stated factor.
/// - Unstable: how the grasp fails in the largest leaf of the proof (summarize): the body after
///   the virtual twist along which load and contacts together do positive work, its centre of
///   rotation if that is near, the motions that it gives the contacts, and which of them have
///   forces that oppose it (and lose) or none.
///
/// All arrows of forces have one scale, shown by a bar; only a load that would be too short to
/// see is enlarged by a stated factor. Texts neither meet nor leave the page, and round numbers
/// to six digits. Programs can read each arrow: it is a path of class "force", "load", "motion"
/// or "virtual" whose first point is its tail and whose third is its tip. data-contact is its
/// contact, data-value the exact vector, data-factor the enlargement of a load.
///
/// A picture in space has three orthogonal views of one scale: from above, from the front (from
/// -y) and from the right (from +x). Torques are seen about the line of sight; cones are the
/// outlines of round ones. data-value is the whole vector, of which a view shows a projection.
///
/// - Stable: as in the plane; contacts stick, slip or are open. If the proof is by degree, no
///   equilibrium is known exactly: forces and motion are those near it in doubles, for people,
///   as the caption says, with data-near in place of data-value.
/// - Unstable: the grasp and its load.
///
/// Several bodies are drawn in the same way, in the plane or in space. Each has its outline or
/// mesh, or a hull of its contacts, a link of its hinges too. Each has its name and, unless it
/// is a link, the load at its middle. Forces are those on the body that a contact presses, and
/// the motion of a contact is that of this body seen from the other one.
///
/// - Stable: as in space. Unstable: the bodies and their load.
///
/// `verdict` is the answer to `question`, and not by degree in the plane. Requires that no
/// numbers of the question are uncertain but lengths that are irrational. Throws InputError as
/// Problem does; ContractError if the verdict does not fit the question.
std::string plot_grasp(const Question& question, const Verdict& verdict);

}  // namespace stickslip
