// SPDX-License-Identifier: GPL-3.0-or-later
#include "marks.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stickslip::plot_detail {

void draw_arrow(Svg& svg, InkPoint tail, InkPoint tip, const std::string& css_class,
                Svg::Attributes attributes, double head) {
  const double size = length(tip - tail);
  if (size < 0.01) return;
  const InkPoint along = unit(tip - tail);
  head = std::min(head, 0.6 * size);
  const InkPoint neck = tip - head * along;
  const InkPoint side = 0.42 * head * quarter_turn(along);
  SvgPath path;
  path.move(tail).line(neck).move(tip).line(neck + side).line(neck - side).close();
  svg.path(path, css_class, std::move(attributes));
}

void draw_torque(Svg& svg, InkPoint centre, double radius, bool counterclockwise,
                 Svg::Attributes attributes) {
  constexpr double kFrom = -0.6;
  constexpr double kTo = 4.0;  // radians, counterclockwise as seen
  const auto at = [&](double angle) {
    const double seen = counterclockwise ? angle : M_PI - angle;
    return centre + radius * InkPoint{std::cos(seen), -std::sin(seen)};
  };
  std::vector<InkPoint> arc;
  for (int i = 0; i <= 24; ++i) arc.push_back(at(kFrom + (kTo - kFrom) * i / 24));
  SvgPath path;
  path.polyline(arc);
  const InkPoint tip = at(kTo + 6.0 / radius);
  const InkPoint along = unit(tip - arc.back());
  const InkPoint side = 4.6 * quarter_turn(along);
  const InkPoint neck = tip - kHead * along;
  attributes.emplace_back("data-sense", counterclockwise ? "+" : "-");
  svg.path(path, "torque", std::move(attributes));
  svg.path(SvgPath().polygon({tip, neck + side, neck - side}), "load");
}

const char* name_of(ContactMark mark) {
  constexpr const char* kNames[] = {"",      "0",    "+",     "-",
                                    "slips", "open", "loses", "cannot oppose"};
  return kNames[static_cast<int>(mark)];
}

void draw_contact(Svg& svg, InkPoint at, InkPoint tangent, ContactMark mark,
                  Svg::Attributes attributes, std::string_view tooltip) {
  attributes.emplace_back("data-contact-state", name_of(mark));
  SvgPath path;
  const auto triangle = [&](InkPoint forwards) {
    const InkPoint side = 6.0 * quarter_turn(forwards);
    const InkPoint back = at - 4.5 * forwards;
    path.polygon({at + 8.0 * forwards, back + side, back - side});
  };
  switch (mark) {
    case ContactMark::kUnknown:
      path.circle(at, 3.2);
      break;
    case ContactMark::kStick:
      path.circle(at, 5);
      break;
    case ContactMark::kSlipPlus:
      triangle(tangent);
      break;
    case ContactMark::kSlipMinus:
      triangle(-1 * tangent);
      break;
    case ContactMark::kSlip:
      path.polygon({at + InkPoint{5, 5}, at + InkPoint{-5, 5}, at - InkPoint{5, 5},
                    at + InkPoint{5, -5}});
      break;
    case ContactMark::kOpen:
      path.circle(at, 4.6);
      break;
    case ContactMark::kLoses:
    case ContactMark::kCannotOppose:
      path.polygon(
          {at + InkPoint{7, 0}, at + InkPoint{0, 7}, at - InkPoint{7, 0}, at - InkPoint{0, 7}});
      break;
  }
  const bool is_hollow = mark == ContactMark::kSlipMinus || mark == ContactMark::kOpen ||
                         mark == ContactMark::kCannotOppose;
  svg.path(path, is_hollow ? "hollow" : "full", std::move(attributes), tooltip);
}

}  // namespace stickslip::plot_detail
