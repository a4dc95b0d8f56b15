// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The picture of a grasp's quality (measures/quality.hpp).
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "stickslip/engine/question.hpp"
#include "stickslip/measures/load_section.hpp"
#include "stickslip/measures/plane_union.hpp"
#include "stickslip/measures/quality.hpp"

namespace stickslip {

/// The resisted part of a section: exactly, or in its window cell by cell.
struct ResistedSection {
  LoadSection section;                                      ///< the section, with its window
  std::variant<PlaneUnion, std::vector<MapCell>> resisted;  ///< the resisted part, in s and t
};

/// Returns SVG of the grasp under a load, as plot_grasp() draws it, and below it of sections
/// through the load in the centre of the balls, in coordinates in which these are discs. A
/// circle is around the ball that one proof shows to be resisted, a dashed one around a ball of
/// which some load is not resisted; this load is marked if it lies in a section. `drawn` is the
/// question about the load that is drawn, and `verdict` its answer: the load that is not
/// resisted or, if none is known, the one in the centre.
///
/// Programs can read the picture: each section is a group of class "section" with data-u and
/// data-v; data-vertices of its "area" and data-x, data-y of its cells are in s and t; circles
/// have data-radius, the load data-s and data-t.
std::string plot_quality(const Question& drawn, const Verdict& verdict, const Quality& quality,
                         const std::vector<ResistedSection>& sections);

}  // namespace stickslip
