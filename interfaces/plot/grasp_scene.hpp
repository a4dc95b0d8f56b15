// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The part of a grasp that all pictures show the same way.
#pragma once

#include <vector>

#include "labels.hpp"
#include "picture_frame.hpp"

namespace stickslip::plot_detail {

/// A contact in scene coordinates (picture_frame.hpp); directions have length 1, or are
/// foreshortened in a view of space.
struct ContactInk {
  InkPoint at;
  InkPoint normal;
  InkPoint tangent;
  bool is_grounded = true;  ///< the body or finger that presses is not drawn
};

/// Returns the hull counterclockwise. Requires a point.
std::vector<InkPoint> convex_hull(std::vector<InkPoint> points);

std::vector<ContactInk> contact_ink(const Grasp& grasp, const PictureFrame& frame);

/// Returns the rings of the body's outline. If nobody gave one, a sketch stands for it: the
/// convex hull of the contacts and of points a little inside of them that are behind no
/// contact; empty without contacts.
std::vector<std::vector<InkPoint>> body_outline(const Grasp& grasp, const PictureFrame& frame,
                                                const std::vector<ContactInk>& contacts);

std::vector<InkPoint> on_page(const View& view, std::vector<InkPoint> scene);

/// The region that rings are around.
enum class RingsAround {
  kOddTimes,   ///< the region within an odd number of rings, as some may be holes
  kAnyWinding  ///< the region that they wind around in one sense more often than in the other
};

void draw_body(Svg& svg, const View& view, const std::vector<std::vector<InkPoint>>& rings,
               RingsAround around, const std::string& css_class);

/// Returns a direction of the scene on the page.
InkPoint on_page_direction(InkPoint scene);

/// Draws fingers at contacts whose normal is not foreshortened, and where nothing else is drawn
/// that presses.
void draw_fingers(Svg& svg, const View& view, const std::vector<ContactInk>& contacts);

/// Draws the numbers of contacts behind the fingers, or near. Contacts whose numbers would meet
/// share a label. Returns how many found no room.
std::size_t draw_numbers(Svg& svg, const View& view, const std::vector<ContactInk>& contacts,
                         LabelPlacer& labels);

/// Returns "0, 3": at most three numbers, then an ellipsis.
std::string list_numbers(const std::vector<std::size_t>& numbers);

}  // namespace stickslip::plot_detail
