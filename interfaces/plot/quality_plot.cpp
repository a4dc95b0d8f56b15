// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/quality_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "grasp_drawing.hpp"
#include "labels.hpp"
#include "map_drawing.hpp"
#include "picture_frame.hpp"
#include "stylesheet.hpp"

namespace stickslip {

using namespace plot_detail;

namespace {

constexpr double kAside = 56;     ///< left of a section, for the numbers of its axis
constexpr double kHeadings = 24;  ///< above a section
constexpr double kBelow = 56;     ///< room for the numbers and the name of its axis
constexpr double kSide = (kGraspWidth - 2 * kMargin) / 2 - kAside - 8;

std::string text_of(const Rational& a, const Rational& b) {
  return to_string(a) + "," + to_string(b);
}

Svg::Attributes dashed() {
  return {{"stroke-dasharray", "5 4"}};
}

class QualityPlot {
 public:
  QualityPlot(const Question& drawn, const Verdict& verdict, const Quality& quality,
              const std::vector<ResistedSection>& sections)
      : drawn_(drawn), verdict_(verdict), quality_(quality), sections_(sections) {}

  std::string draw() {
    const std::string& given = drawn_.description().name;
    const std::string& of_case = drawn_.case_name;
    const std::string name =
        (given.empty() ? "Grasp" : given) + (of_case.empty() ? "" : ", " + of_case);
    const std::string what = ": " + radii_text();
    Svg svg(kGraspWidth, 0, name + what, stylesheet());
    define_hatching(svg);
    Svg::Attributes radii;
    if (is_stable()) radii.emplace_back("data-proved", to_string(quality_.proved));
    if (quality_.refuted) radii.emplace_back("data-refuted", to_string(*quality_.refuted));
    const double room = kGraspWidth - 2 * kMargin - text_width("title", what);
    svg.text({kMargin, 34}, "title", fit(name, "title", room) + what, std::move(radii));
    double y = draw_grasp(svg, drawn_, verdict_) + 4;
    for (std::size_t k = 0; k < sections_.size(); k += 2) {
      for (std::size_t side = 0; side < 2 && k + side < sections_.size(); ++side) {
        draw_section(svg, sections_[k + side],
                     {kMargin + kAside + static_cast<double>(side) * (kSide + kAside + 8),
                      y + kHeadings});
      }
      y += kHeadings + kSide + kBelow;
    }
    if (!sections_.empty()) y = draw_key(svg, y + 8);
    svg.set_height(y);
    return svg.finish();
  }

 private:
  bool is_stable() const { return quality_.stable == true; }

  /// Returns the words that follow the name.
  std::string radii_text() const {
    if (!is_stable()) return quality_.stable ? "no quality" : "quality undecided";
    if (quality_.scales && quality_.refuted) return "quality 0";
    if (quality_.scales && !quality_.proved.is_zero()) return "every load is resisted";
    const std::string proved = "quality " + short_text(quality_.proved);
    return quality_.refuted ? proved + " to " + short_text(*quality_.refuted)
                            : proved + " or more";
  }

  /// Returns the direction, to two digits, of a vector that is no axis.
  static std::string direction_text(const RationalRow& vector) {
    Rational largest = 0;
    for (const Rational& x : vector) largest = std::max<Rational>(largest, abs(x));
    double square = 0;
    for (const Rational& x : vector) square += std::pow(to_double(x / largest), 2);
    std::string text;
    for (const Rational& x : vector) {
      text += (text.empty() ? "~(" : ", ") +
              typeset(svg_number(to_double(x / largest) / std::sqrt(square)));
    }
    return text + ")";
  }

  /// Returns the name of an axis: how loads along it differ from the one in the centre.
  std::string name_of_axis(const RationalRow& z) const {
    const std::size_t forces = z.size() == 6 ? 3 : 2;
    const auto is_zero = [](const Rational& x) { return x.is_zero(); };
    const auto torque = z.begin() + static_cast<std::ptrdiff_t>(forces);
    const bool is_force = !std::all_of(z.begin(), torque, is_zero);
    const RationalRow vector(is_force ? z.begin() : torque, is_force ? torque : z.end());
    std::string text = is_force ? "added force" : "added torque";
    const auto first = std::find_if_not(vector.begin(), vector.end(), is_zero);
    if (vector.size() > 1) {
      text += is_force ? " along " : " about ";
      text += std::all_of(first + 1, vector.end(), is_zero)
                  ? std::string(1, "xyz"[first - vector.begin()])
                  : direction_text(vector);
    }
    const LoadBall& ball = *quality_.ball.ball;
    const std::optional<Units>& units = drawn_.description().units;
    if (!is_force && (units || ball.length != 1)) {
      text += ", over " + short_text(ball.length) + length_unit(units);
    }
    const std::string unit = force_unit(units);
    return fit(unit.empty() ? text : text + " /" + unit, "small", kSide);
  }

  std::string heading(const LoadSection& section) const {
    const auto has_torque = [&](const RationalRow& z) {
      return std::any_of(z.begin() + (z.size() == 6 ? 3 : 2), z.end(),
                         [](const Rational& x) { return !x.is_zero(); });
    };
    return has_torque(section.along[1]) ? "forces and torques, with a load that is not resisted"
                                        : "forces, with the torque of w";
  }

  void draw_section(Svg& svg, const ResistedSection& all, InkPoint corner) {
    const LoadSection& section = all.section;
    const auto& [s, t] = section.axes;
    const auto place = [&](const Rational& x, const Rational& y) {
      return corner +
             0.5 * kSide *
                 InkPoint{1 + to_double(x / s.range.high), 1 - to_double(y / t.range.high)};
    };
    const std::vector<InkPoint> square{corner, corner + InkPoint{kSide, 0},
                                       corner + InkPoint{kSide, kSide},
                                       corner + InkPoint{0, kSide}};
    const auto text = [](const RationalRow& load) {
      std::string numbers;
      for (const Rational& x : load) numbers += (numbers.empty() ? "" : ",") + to_string(x);
      return numbers;
    };
    svg.open("g", {{"class", "section"}, {"data-u", text(s.along)}, {"data-v", text(t.along)}});
    svg.text(corner - InkPoint{0, 8}, "small muted", heading(section));
    svg.path(SvgPath().polygon(square), "paper");
    if (const auto* exact = std::get_if<PlaneUnion>(&all.resisted)) {
      draw_areas(svg, *exact, section, place);
    } else {
      draw_cells(svg, std::get<std::vector<MapCell>>(all.resisted), place);
    }
    draw_scale(svg, section, corner);
    svg.path(SvgPath().polygon(square), "frame");
    const LoadBall& ball = *quality_.ball.ball;
    const double pixels = 0.5 * kSide / std::sqrt(to_double(section.squared_norm(0, ball)));
    const auto draw_circle = [&](const Rational& radius, Svg::Attributes attributes) {
      attributes.emplace_back("data-radius", to_string(radius));
      svg.circle(place(0, 0), pixels * to_double(radius / s.range.high), "rim",
                 std::move(attributes));
    };
    if (!quality_.proved.is_zero()) draw_circle(quality_.proved, {});
    if (quality_.refuted) draw_circle(*quality_.refuted, dashed());
    svg.circle(place(0, 0), 2.5, "full centre");
    if (section.lost) {
      const auto& [x, y] = *section.lost;
      svg.circle(place(x, y), 5, "load lost",
                 {{"data-s", to_string(x)}, {"data-t", to_string(y)}});
    }
    svg.close();
  }

  template <class Place>
  static void draw_areas(Svg& svg, const PlaneUnion& region, const LoadSection& section,
                         const Place& place) {
    const Rational& s = section.axes[0].range.high;
    const Rational& t = section.axes[1].range.high;
    const PlaneUnion visible = clip_to_box(region, {-s, -t}, {s, t});
    for (const PlaneArea& area : visible.areas) {
      SvgPath path;
      std::string vertices;
      for (const Outline& outline : area.outlines) {
        std::vector<InkPoint> points;
        for (const PlanePoint& vertex : outline.vertices) {
          points.push_back(place(vertex[0], vertex[1]));
          vertices += (vertices.empty() ? "" : " ") + text_of(vertex[0], vertex[1]);
        }
        path.polygon(points);
      }
      svg.path(path, "area hue0", {{"fill-rule", "evenodd"}, {"data-vertices", vertices}});
    }
    for (const PlaneCell& curve : visible.curves) {
      const PlanePoint& from = curve.vertices().front();
      const PlanePoint& to = curve.vertices().back();
      svg.line(place(from[0], from[1]), place(to[0], to[1]), "border",
               {{"data-from", text_of(from[0], from[1])}, {"data-to", text_of(to[0], to[1])}});
    }
  }

  template <class Place>
  static void draw_cells(Svg& svg, const std::vector<MapCell>& cells, const Place& place) {
    for (const MapCell& cell : cells) {
      draw_cell(svg, cell, place(cell.x.low, cell.y.high), place(cell.x.high, cell.y.low));
    }
  }

  /// Draws round numbers, in the norm of the balls, the same along both axes.
  void draw_scale(Svg& svg, const LoadSection& section, InkPoint corner) const {
    const Rational reach = quality_.refuted.value_or(quality_.proved) * kSectionReach;
    const Rational step = round_down(reach / 2);
    for (Rational at = 0; at < reach; at += step) {
      for (const int sign : {1, -1}) {
        const Rational value = sign * at;
        if (sign < 0 && at.is_zero()) continue;
        const double off = 0.5 * kSide * (1 + to_double(value / reach));
        const InkPoint x = corner + InkPoint{off, kSide};
        const InkPoint y = corner + InkPoint{0, kSide - off};
        const char* css_class = at.is_zero() ? "axis-line" : "grid-line";
        svg.line(x, x - InkPoint{0, kSide}, css_class);
        svg.line(y, y + InkPoint{kSide, 0}, css_class);
        svg.text(x + InkPoint{0, 16}, "tiny middle tick", short_text(value));
        svg.text(y + InkPoint{-6, 3}, "tiny end tick", short_text(value));
      }
    }
    svg.text(corner + InkPoint{kSide / 2, kSide + 34}, "small middle",
             name_of_axis(section.along[0]));
    svg.open("g", {{"transform", "translate(" + svg_number(corner.x - kAside + 14) + " " +
                                     svg_number(corner.y + kSide / 2) + ") rotate(-90)"}});
    svg.text({0, 0}, "small middle", name_of_axis(section.along[1]));
    svg.close();
  }

  /// Draws the key of the sections; returns the baseline of the line below.
  double draw_key(Svg& svg, double y) const {
    const bool exact = std::holds_alternative<PlaneUnion>(sections_.front().resisted);
    svg.open("g", {{"class", "key"}});
    const auto row = [&](const std::string& text) {
      y = draw_lines(svg, {kMargin + 62, y + 4.5}, "legend", text,
                     kGraspWidth - 2 * kMargin - 62) +
          2;
    };
    const auto patch = [&](const char* css_class, const std::string& text) {
      svg.path(SvgPath().polygon({{kMargin + 4, y - 7},
                                  {kMargin + 48, y - 7},
                                  {kMargin + 48, y + 7},
                                  {kMargin + 4, y + 7}}),
               css_class);
      row(text);
    };
    patch("hue0", exact ? "loads that are resisted, exactly"
                        : "loads that are resisted, proved throughout each cell");
    if (!exact) patch("hatch5", "loads that are not, proved throughout each cell");
    svg.circle({kMargin + 26, y}, 2.5, "full");
    row("the load w in the centre");
    if (!quality_.proved.is_zero()) {
      svg.circle({kMargin + 26, y}, 8, "rim");
      row("the ball of radius " + short_text(quality_.proved) +
          ", every load of which is resisted: one proof for all");
    }
    if (quality_.refuted) {
      svg.circle({kMargin + 26, y}, 8, "rim", dashed());
      row("the ball of radius " + short_text(*quality_.refuted) +
          ", of which some load is not resisted");
    }
    const bool has_lost =
        std::any_of(sections_.begin(), sections_.end(),
                    [](const ResistedSection& s) { return s.section.lost.has_value(); });
    if (has_lost) {
      svg.circle({kMargin + 26, y}, 5, "load");
      row("this load: above it is on the body");
    }
    svg.close();
    return y;
  }

  const Question& drawn_;
  const Verdict& verdict_;
  const Quality& quality_;
  const std::vector<ResistedSection>& sections_;
};

}  // namespace

std::string plot_quality(const Question& drawn, const Verdict& verdict, const Quality& quality,
                         const std::vector<ResistedSection>& sections) {
  return QualityPlot(drawn, verdict, quality, sections).draw();
}

}  // namespace stickslip
