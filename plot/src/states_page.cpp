// SPDX-License-Identifier: GPL-3.0-or-later
#include "states_page.hpp"

#include <cmath>

#include "grasp_scene.hpp"
#include "marks.hpp"
#include "upper_half.hpp"

namespace stickslip::plot_detail {
namespace {

constexpr View kGraspView{{122, kDiscMiddle}, 66};
constexpr double kHalfPanel = 98;

}  // namespace

std::size_t draw_grasp_panel(Svg& svg, const Grasp& grasp) {
  const std::vector<ContactInk> contacts = contact_ink(grasp, {});
  const InkPoint corner = kGraspView.origin - InkPoint{kHalfPanel, kHalfPanel};
  const std::string side = svg_number(2 * kHalfPanel);
  svg.open("clipPath", {{"id", "stickslip-grasp"}});
  svg.element("rect", {{"x", svg_number(corner.x)},
                       {"y", svg_number(corner.y)},
                       {"width", side},
                       {"height", side}});
  svg.close();
  svg.text(kGraspView.origin - InkPoint{0, kDiscRadius + 28}, "middle", "grasp");
  svg.open("g", {{"class", "grasp"}});
  svg.path(SvgPath().polygon(on_page(kGraspView, body_outline(contacts))), "body");
  svg.open("g", {{"clip-path", "url(#stickslip-grasp)"}});
  for (const ContactInk& c : contacts) {
    svg.line(kGraspView(c.at - 6.0 * c.tangent), kGraspView(c.at + 6.0 * c.tangent), "axis");
  }
  svg.close();
  draw_fingers(svg, kGraspView, contacts);
  for (const ContactInk& c : contacts) {
    draw_contact(svg, kGraspView(c.at), on_page_direction(c.tangent), ContactMark::kUnknown);
  }
  const InkPoint reach{kHalfPanel + 16, kHalfPanel + 24};
  LabelPlacer labels({kGraspView.origin - reach, kGraspView.origin + reach});
  const std::size_t left_out = draw_numbers(svg, kGraspView, contacts, labels);
  svg.close();
  return left_out;
}

std::string counts_text(const ArrangementCounts& c) {
  const auto count = [](std::size_t n, const std::string& one, const std::string& many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
  };
  return count(c.planes, "contact", "contacts") + " on " +
         count(c.circles, "circle", "circles") + ", rank " + std::to_string(c.rank) + ": " +
         count(c.faces, "face", "faces") + " + " + count(c.edges, "edge", "edges") + " + " +
         count(c.vertices, "vertex", "vertices") + " = " + count(c.cells(), "cell", "cells") +
         "; " + count(c.distinct_states, "distinct state", "distinct states") +
         ", all-stick (d = 0) included.";
}

void draw_rings(Svg& svg) {
  const double ring = length(project({std::sqrt(0.5), 0, std::sqrt(0.5)}));
  for (const View& disc : kDiscs) svg.circle(disc.origin, kDiscRadius * ring, "ring");
}

void draw_rims(Svg& svg) {
  constexpr std::array<const char*, 2> kTitles{"counterclockwise, r > 0", "clockwise, r < 0"};
  for (std::size_t disc = 0; disc < 2; ++disc) {
    const View& view = kDiscs[disc];
    svg.circle(view.origin, kDiscRadius, "rim");
    svg.text(view.origin - InkPoint{0, kDiscRadius + 28}, "middle", kTitles[disc]);
    for (int i = 0; i < 8; ++i) {
      // d = (x, y, 0) is at (-y, x) on the left disc, and at (y, -x) on the right one.
      const double angle = M_PI * i / 4;
      const InkPoint outwards{std::cos(angle), std::sin(angle)};
      const InkPoint along =
          (disc == 0 ? -11.0 : 11.0) * on_page_direction(quarter_turn(outwards));
      const InkPoint at = view.origin + (kDiscRadius + 11) * on_page_direction(outwards);
      draw_arrow(svg, at - along, at + along, "normal", {}, kSmallHead);
    }
  }
}

}  // namespace stickslip::plot_detail
