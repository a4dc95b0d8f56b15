// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/map_plot.hpp"

#include <algorithm>

#include "labels.hpp"
#include "map_drawing.hpp"
#include "picture_frame.hpp"
#include "stylesheet.hpp"

namespace stickslip {

using namespace plot_detail;

namespace {

constexpr double kMapSide = 480;
constexpr double kLeft = 96;

/// Returns the place of a value along the panel, 0 to kMapSide.
double along(const MapAxis& axis, const Rational& value) {
  const Rational length = axis.range.high - axis.range.low;
  return kMapSide * to_double((value - axis.range.low) / length);
}

struct Look {
  const char* css_class;
  const char* words;
};

/// The looks, by the verdict's place in Verdict.
constexpr Look kLooks[] = {{"hue0", "stable, proved throughout each cell"},
                           {"hatch5", "unstable, proved throughout each cell"},
                           {"paper", ""},
                           {"paper", "not decided in the finest cells"}};

void draw_rectangle(Svg& svg, InkPoint from, InkPoint to, const std::string& css_class,
                    Svg::Attributes attributes) {
  Svg::Attributes all{{"class", css_class},
                      {"x", svg_number(from.x)},
                      {"y", svg_number(from.y)},
                      {"width", svg_number(to.x - from.x)},
                      {"height", svg_number(to.y - from.y)}};
  std::move(attributes.begin(), attributes.end(), std::back_inserter(all));
  svg.element("rect", all);
}

/// Returns the round values of an axis.
std::vector<Rational> ticks(const MapAxis& axis) {
  const Rational step = round_down((axis.range.high - axis.range.low) / 4);
  const Rational steps = axis.range.low / step;
  Rational at = step * Rational(numerator(steps) / denominator(steps) - 1);
  std::vector<Rational> result;
  for (; at <= axis.range.high; at += step) {
    if (at >= axis.range.low) result.push_back(at);
  }
  return result;
}

std::string ends_text(const Interval& interval) {
  return to_string(interval.low) + "," + to_string(interval.high);
}

}  // namespace

void plot_detail::draw_cell(Svg& svg, const MapCell& cell, InkPoint from, InkPoint to) {
  draw_rectangle(svg, from, to, kLooks[cell.decision.verdict.index()].css_class,
                 {{"shape-rendering", "crispEdges"},
                  {"data-verdict", name_of(cell.decision.verdict)},
                  {"data-x", ends_text(cell.x)},
                  {"data-y", ends_text(cell.y)}});
}

std::string plot_map(const std::string& name, const MapAxis& x_axis, const MapAxis& y_axis,
                     const std::vector<MapCell>& cells) {
  const double width = kLeft + kMapSide + kMargin;
  const double bottom = kTop + kMapSide;
  const std::string what = ": where it holds";
  const std::string title = name.empty() ? "Grasp" : name;
  Svg svg(width, bottom + 6 * kLine + kMargin, title + what, stylesheet());
  define_hatching(svg);
  const double room = width - kLeft - kMargin - text_width("title", what);
  svg.text({kLeft, 34}, "title", fit(title, "title", room) + what);
  draw_rectangle(svg, {kLeft, kTop}, {kLeft + kMapSide, bottom}, "paper", {});
  for (const MapCell& cell : cells) {
    draw_cell(svg, cell,
              {kLeft + along(x_axis, cell.x.low), bottom - along(y_axis, cell.y.high)},
              {kLeft + along(x_axis, cell.x.high), bottom - along(y_axis, cell.y.low)});
  }
  for (const Rational& at : ticks(x_axis)) {
    const double x = kLeft + along(x_axis, at);
    svg.line({x, bottom}, {x, bottom + 5}, "axis-line");
    svg.text({x, bottom + 18}, "small middle", short_text(at));
  }
  for (const Rational& at : ticks(y_axis)) {
    const double y = bottom - along(y_axis, at);
    svg.line({kLeft - 5, y}, {kLeft, y}, "axis-line");
    svg.text({kLeft - 9, y + 4}, "small end", short_text(at));
  }
  SvgPath frame;
  frame.polygon(
      {{kLeft, kTop}, {kLeft + kMapSide, kTop}, {kLeft + kMapSide, bottom}, {kLeft, bottom}});
  svg.path(frame, "frame");
  svg.text({kLeft + kMapSide / 2, bottom + 2 * kLine}, "middle", x_axis.name);
  svg.text({kLeft, kTop - 8}, "middle", y_axis.name);
  double y = bottom + 3 * kLine;
  for (const Look& look : kLooks) {
    if (*look.words == '\0') continue;
    draw_rectangle(svg, {kLeft, y - 11}, {kLeft + 18, y + 2}, look.css_class, {});
    SvgPath border;
    border.polygon(
        {{kLeft, y - 11}, {kLeft + 18, y - 11}, {kLeft + 18, y + 2}, {kLeft, y + 2}});
    svg.path(border, "frame");
    svg.text({kLeft + 26, y}, "small", look.words);
    y += kLine;
  }
  return svg.finish();
}

}  // namespace stickslip
