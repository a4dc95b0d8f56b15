// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Signs of the pictures' language, in page coordinates.
#pragma once

#include <string>

#include "stickslip/interfaces/svg.hpp"

namespace stickslip::plot_detail {

/// The lengths of arrow heads, in pixels: of forces, and of other arrows.
inline constexpr double kHead = 11;
inline constexpr double kSmallHead = 8;

/// Draws a path of five points: tail, neck, tip and the two corners of the head, which shrinks
/// with short arrows. Draws nothing if tail and tip are the same.
void draw_arrow(Svg& svg, InkPoint tail, InkPoint tip, const std::string& css_class,
                Svg::Attributes attributes = {}, double head = kHead);

/// Draws an arc about `centre` with an arrow head. The angle is no measure of anything.
void draw_torque(Svg& svg, InkPoint centre, double radius, bool counterclockwise,
                 Svg::Attributes attributes = {});

/// The behaviour of a contact in an equilibrium; or, if there is none, whether it opposes the
/// virtual twist that proves so.
enum class ContactMark {
  kUnknown,
  kStick,
  kSlipPlus,
  kSlipMinus,
  kSlip,  ///< in space
  kOpen,
  kLoses,
  kCannotOppose
};

/// Returns "0", "+", "-", "slips", "open", "loses", "cannot oppose", or "".
const char* name_of(ContactMark mark);

/// Draws a disc, a triangle that points where the object slips, a square, a ring, or a full or
/// hollow diamond. `tangent` is the contact's, on the page, of length 1.
void draw_contact(Svg& svg, InkPoint at, InkPoint tangent, ContactMark mark,
                  Svg::Attributes attributes = {}, std::string_view tooltip = {});

}  // namespace stickslip::plot_detail
