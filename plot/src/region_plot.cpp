// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/plot/region_plot.hpp"

#include <algorithm>
#include <set>

#include "marks.hpp"
#include "picture_frame.hpp"
#include "stylesheet.hpp"

namespace stickslip {
namespace {

constexpr double kWidth = 640;
constexpr double kPanel = 520;  ///< side of the window
constexpr double kLeft = 72;
constexpr double kTop = 64;
constexpr double kHeight = kTop + kPanel + 100;
constexpr std::size_t kMostLabels = 12;

std::string text_of(const PlanePoint& point) {
  return to_string(point[0]) + "," + to_string(point[1]);
}

class RegionPlot {
 public:
  RegionPlot(const Question& question, const WrenchPlane& plane,
             const std::vector<PlaneCell>& cells)
      : question_(question), plane_(plane), region_(unite(cells)) {
    find_window();
    std::vector<PlaneCell> visible;
    for (const PlaneCell& cell : cells) {
      if (auto part = clip_to_box(cell, {-half_, -half_}, {half_, half_})) {
        visible.push_back(std::move(*part));
      }
    }
    visible_ = unite(visible);
  }

  std::string draw() const {
    const std::string& given = question_.loaded.grasp.name();
    const std::string title =
        (given.empty() ? "Grasp" : shorten(given, 50)) + ": resistible wrenches";
    Svg svg(kWidth, kHeight, title, stylesheet());
    define_hatching(svg);
    svg.text({kLeft, 34}, "title", title);
    draw_areas(svg);
    draw_grid(svg);
    draw_borders(svg);
    draw_labels(svg);
    draw_caption(svg);
    return svg.finish();
  }

 private:
  void find_window() {
    const auto see = [&](const PlanePoint& point) {
      corners_.insert(point);
      half_ = std::max(half_, largest_entry({point[0], point[1]}));
    };
    for (const PlaneArea& area : region_.areas) {
      for (const Outline& outline : area.outlines) {
        for (const PlanePoint& vertex : outline.vertices) see(vertex);
      }
    }
    for (const PlaneCell& curve : region_.curves) {
      for (const PlanePoint& vertex : curve.vertices()) see(vertex);
    }
    for (const PlanePoint& point : region_.points) see(point);
    // Nothing but the origin has no size: any window shows it.
    half_ = half_.is_zero() ? Rational(2) : half_ * Rational(8, 5);
  }

  InkPoint place(const PlanePoint& point) const {
    const InkPoint share = ratio({point[0], point[1]}, half_);
    return {kLeft + kPanel / 2 * (1 + share.x), kTop + kPanel / 2 * (1 - share.y)};
  }

  bool on_frame(const PlanePoint& point) const {
    return abs(point[0]) == half_ || abs(point[1]) == half_;
  }

  /// Whether an edge of what is visible is the frame's, not the region's.
  bool along_frame(const PlanePoint& a, const PlanePoint& b) const {
    for (std::size_t j = 0; j < 2; ++j) {
      if (a[j] == b[j] && abs(a[j]) == half_) return true;
    }
    return false;
  }

  void draw_areas(Svg& svg) const {
    svg.path(SvgPath().polygon({{kLeft, kTop},
                                {kLeft + kPanel, kTop},
                                {kLeft + kPanel, kTop + kPanel},
                                {kLeft, kTop + kPanel}}),
             "paper");
    for (const PlaneArea& area : visible_.areas) {
      SvgPath path;
      std::string vertices;
      for (const Outline& outline : area.outlines) {
        std::vector<InkPoint> points;
        for (const PlanePoint& vertex : outline.vertices) {
          points.push_back(place(vertex));
          vertices += (vertices.empty() ? "" : " ") + text_of(vertex);
        }
        path.polygon(points);
      }
      svg.path(path, "area hue0", {{"fill-rule", "evenodd"}, {"data-vertices", vertices}});
    }
  }

  /// Lines at round numbers, axes through the origin, and the frame.
  void draw_grid(Svg& svg) const {
    const Rational step = round_down(half_ / 2);
    svg.open("g", {{"class", "grid"}});
    for (Rational at = 0; at < half_; at += step) {
      for (const Rational& value : {at, Rational(-at)}) {
        const bool is_axis = value.is_zero();
        const char* css_class = is_axis ? "axis-line" : "grid-line";
        svg.line(place({value, -half_}), place({value, half_}), css_class);
        svg.line(place({-half_, value}), place({half_, value}), css_class);
        svg.text(place({value, -half_}) + InkPoint{0, 22}, "small middle", short_text(value));
        svg.text(place({-half_, value}) + InkPoint{-15, 4}, "small end", short_text(value));
        if (is_axis) break;
      }
    }
    svg.close();
    svg.path(SvgPath().polygon({{kLeft, kTop},
                                {kLeft + kPanel, kTop},
                                {kLeft + kPanel, kTop + kPanel},
                                {kLeft, kTop + kPanel}}),
             "frame");
    svg.text({kLeft + kPanel / 2, kTop + kPanel + 44}, "middle", axis_name(plane_.u(), "s"));
    svg.open("g", {{"transform",
                    "translate(20 " + svg_number(kTop + kPanel / 2) + ") rotate(-90)"}});
    svg.text({0, 0}, "middle", axis_name(plane_.v(), "t"));
    svg.close();
  }

  static std::string axis_name(const Wrench& direction, const std::string& coordinate) {
    if (direction == Wrench{1, 0, 0}) return "applied force along x";
    if (direction == Wrench{0, 1, 0}) return "applied force along y";
    if (direction == Wrench{0, 0, 1}) return "applied torque";
    return coordinate + ", multiples of the wrench " + tuple(direction);
  }

  static std::string tuple(const Wrench& w) { return short_tuple({w.x, w.y, w.torque}); }

  void draw_borders(Svg& svg) const {
    const auto draw = [&](const PlanePoint& from, const PlanePoint& to) {
      if (along_frame(from, to)) return;
      svg.line(place(from), place(to), "border",
               {{"data-from", text_of(from)}, {"data-to", text_of(to)}});
      // The frame cuts off what has no end.
      const InkPoint along = unit(place(to) - place(from));
      if (on_frame(to))
        draw_arrow(svg, place(to), place(to) + kHead * along, "border unbounded");
      if (on_frame(from)) {
        draw_arrow(svg, place(from), place(from) - kHead * along, "border unbounded");
      }
    };
    for (const PlaneArea& area : visible_.areas) {
      for (const Outline& outline : area.outlines) {
        const std::vector<PlanePoint>& v = outline.vertices;
        for (std::size_t k = 0; k < v.size(); ++k) draw(v[k], v[(k + 1) % v.size()]);
      }
    }
    for (const PlaneCell& curve : visible_.curves) {
      draw(curve.vertices().front(), curve.vertices().back());
    }
    for (const PlanePoint& point : visible_.points) {
      svg.circle(place(point), 4.5, "full", {{"data-point", text_of(point)}});
    }
  }

  void draw_labels(Svg& svg) const {
    if (corners_.size() > kMostLabels) return;
    std::vector<LabelBox> placed;
    for (const PlanePoint& corner : corners_) {
      const InkPoint at = place(corner);
      svg.circle(at, 3, "full", {{"data-corner", text_of(corner)}});
      const std::string text = "(" + short_text(corner[0]) + ", " + short_text(corner[1]) + ")";
      placed.push_back(free_place(at, text, placed));
      svg.text(placed.back().text_at, placed.back().css_class, text);
    }
  }

  struct LabelBox {
    InkPoint text_at;
    const char* css_class;
    InkPoint low;
    InkPoint high;

    bool overlaps(const LabelBox& other) const {
      return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y &&
             other.low.y < high.y;
    }
  };

  /// Where the label covers the least of the other labels, and of the region and its border.
  LabelBox free_place(InkPoint corner, const std::string& text,
                      const std::vector<LabelBox>& placed) const {
    const double width = 6.5 * static_cast<double>(text.size());
    const auto box = [&](InkPoint offset, const char* css_class, double left) {
      const InkPoint at = corner + offset;
      return LabelBox{at, css_class, at + InkPoint{left, -13}, at + InkPoint{left + width, 3}};
    };
    const LabelBox candidates[] = {box({0, -10}, "halo middle", -width / 2),
                                   box({0, 20}, "halo middle", -width / 2),
                                   box({10, -6}, "halo", 0),
                                   box({-10, -6}, "halo end", -width),
                                   box({10, 16}, "halo", 0),
                                   box({-10, 16}, "halo end", -width)};
    constexpr int kSamples = 8;
    const auto covered = [&](const LabelBox& candidate) {
      int count = 0;
      for (int k = 0; k <= kSamples; ++k) {
        const double x = candidate.low.x + width * k / kSamples;
        for (const double y : {candidate.low.y, candidate.high.y}) {
          count += visible_.contains(point_at({x, y})) ? 1 : 0;
        }
      }
      for (const LabelBox& other : placed) {
        count += candidate.overlaps(other) ? 2 * kSamples : 0;
      }
      return count;
    };
    return *std::min_element(
        std::begin(candidates), std::end(candidates),
        [&](const LabelBox& a, const LabelBox& b) { return covered(a) < covered(b); });
  }

  PlanePoint point_at(InkPoint ink) const {
    return {half_ * rational_from_double((ink.x - kLeft) / (kPanel / 2) - 1),
            half_ * rational_from_double(1 - (ink.y - kTop) / (kPanel / 2))};
  }

  void draw_caption(Svg& svg) const {
    const bool at_zero = plane_.origin() == Wrench{};
    std::string text = region_.is_empty()         ? "No wrench of this plane is resisted"
                       : region_.is_whole_plane() ? "Every wrench of this plane is resisted"
                                                  : "Shaded: resisted, borders included";
    if (reaches_frame() && !region_.is_whole_plane())
      text += "; at the frame it goes on without end";
    const double y = kTop + kPanel + 70;
    svg.text({kLeft, y}, "caption", text + ".");
    svg.text({kLeft, y + 18}, "small muted",
             std::string(at_zero ? "Other wrench coordinates 0"
                                 : "Wrench at (0, 0): " + tuple(plane_.origin())) +
                 "; normal law: " + to_string(question_.law) + preload_text() + ".");
  }

  std::string preload_text() const {
    if (!question_.preload) return "";
    return "; preload " + short_text(*question_.preload);
  }

  bool reaches_frame() const {
    const auto reaches = [&](const PlaneArea& area) {
      return std::any_of(area.outlines.begin(), area.outlines.end(), [&](const Outline& o) {
        return std::any_of(o.vertices.begin(), o.vertices.end(),
                           [&](const PlanePoint& vertex) { return on_frame(vertex); });
      });
    };
    return std::any_of(visible_.areas.begin(), visible_.areas.end(), reaches) ||
           std::any_of(region_.curves.begin(), region_.curves.end(),
                       [](const PlaneCell& curve) { return !curve.is_bounded(); });
  }

  const Question& question_;
  const WrenchPlane& plane_;
  PlaneUnion region_;
  Rational half_ = 0;  ///< of the window's side
  std::set<PlanePoint> corners_;
  PlaneUnion visible_;
};

}  // namespace

std::string plot_region(const Question& question, const WrenchPlane& plane,
                        const std::vector<PlaneCell>& cells) {
  return RegionPlot(question, plane, cells).draw();
}

}  // namespace stickslip
