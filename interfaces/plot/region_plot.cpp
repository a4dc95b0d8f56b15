// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/region_plot.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "labels.hpp"
#include "marks.hpp"
#include "picture_frame.hpp"
#include "stylesheet.hpp"

namespace stickslip {

using namespace plot_detail;

namespace {

constexpr double kRegionSide = 520;  ///< side of the window
constexpr std::size_t kMostLabels = 12;
constexpr int kSamples = 32;  ///< samples of the region in each direction, which labels avoid

std::string text_of(const PlanePoint& point) {
  return to_string(point[0]) + "," + to_string(point[1]);
}

class RegionPlot {
 public:
  RegionPlot(const Question& question, const WrenchPlane& plane, const PlaneUnion& region)
      : question_(question), plane_(plane), region_(region) {
    find_window();
    visible_ = clip_to_box(region_, {-half_, -half_}, {half_, half_});
    find_borders();
    find_ticks();
    t_name_ = wrap(axis_name(plane_.v(), "t"), "", kRegionSide);
    left_ = kMargin + kLine * static_cast<double>(t_name_.size()) + 15 + widest_tick_;
    width_ = left_ + kRegionSide + 2 * kMargin;
  }

  std::string draw() {
    const std::string& given = question_.loaded().grasp.name();
    const std::string name = given.empty() ? "Grasp" : given;
    const std::string what = ": resistible wrenches";
    Svg svg(width_, 0, name + what, stylesheet());
    define_hatching(svg);
    const double room = width_ - left_ - kMargin - text_width("title", what);
    svg.text({left_, 34}, "title", fit(name, "title", room) + what);
    draw_areas(svg);
    draw_grid(svg);
    draw_borders(svg);
    draw_labels(svg);
    draw_caption(svg);
    return svg.finish();
  }

 private:
  struct Tick {
    Rational value;
    std::string text;
  };

  /// Finds ticks at round numbers, as far apart as their texts need.
  void find_ticks() {
    const Rational step = round_down(half_ / 2);
    Rational first = 0;
    while (first - step > -half_) first -= step;
    for (Rational at = first; at < half_; at += step) {
      ticks_.push_back({at, short_text(at)});
      widest_tick_ = std::max(widest_tick_, text_width("small", ticks_.back().text));
    }
    // Lines are every one, every second, ... but always the origin's.
    const double apart = kRegionSide / 2 * to_double(step / half_);
    std::size_t every = 1;
    while (static_cast<double>(every) * apart < widest_tick_ + 8) ++every;
    const std::size_t origin = ticks_.size() / 2;
    for (std::size_t k = 0; k < ticks_.size(); ++k) {
      if ((k > origin ? k - origin : origin - k) % every != 0) ticks_[k].text.clear();
    }
  }

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
    // The origin alone has no size: any window shows it.
    half_ = half_.is_zero() ? Rational(2) : half_ * Rational(8, 5);
  }

  InkPoint place(const PlanePoint& point) const {
    const InkPoint share = ratio({point[0], point[1]}, half_);
    return {left_ + kRegionSide / 2 * (1 + share.x), kTop + kRegionSide / 2 * (1 - share.y)};
  }

  bool on_frame(const PlanePoint& point) const {
    return abs(point[0]) == half_ || abs(point[1]) == half_;
  }

  /// Returns true if an edge of the visible part is the frame's, not the region's.
  bool along_frame(const PlanePoint& a, const PlanePoint& b) const {
    for (std::size_t j = 0; j < 2; ++j) {
      if (a[j] == b[j] && abs(a[j]) == half_) return true;
    }
    return false;
  }

  void draw_areas(Svg& svg) const {
    svg.path(SvgPath().polygon({{left_, kTop},
                                {left_ + kRegionSide, kTop},
                                {left_ + kRegionSide, kTop + kRegionSide},
                                {left_, kTop + kRegionSide}}),
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

  /// Draws lines at round numbers, axes through the origin, and the frame.
  void draw_grid(Svg& svg) const {
    svg.open("g", {{"class", "grid"}});
    for (const auto& [value, text] : ticks_) {
      const char* css_class = value.is_zero() ? "axis-line" : "grid-line";
      svg.line(place({value, -half_}), place({value, half_}), css_class);
      svg.line(place({-half_, value}), place({half_, value}), css_class);
      if (text.empty()) continue;
      svg.text(place({value, -half_}) + InkPoint{0, 22}, "small middle tick", text);
      svg.text(place({-half_, value}) + InkPoint{-15, 4}, "small end tick", text);
    }
    svg.close();
    svg.path(SvgPath().polygon({{left_, kTop},
                                {left_ + kRegionSide, kTop},
                                {left_ + kRegionSide, kTop + kRegionSide},
                                {left_, kTop + kRegionSide}}),
             "frame");
    draw_lines(svg, {left_ + kRegionSide / 2, kTop + kRegionSide + 44}, "middle",
               axis_name(plane_.u(), "s"), kRegionSide);
    svg.open("g", {{"transform", "translate(" + svg_number(kMargin) + " " +
                                     svg_number(kTop + kRegionSide / 2) + ") rotate(-90)"}});
    for (std::size_t k = 0; k < t_name_.size(); ++k) {
      svg.text({0, kLine * static_cast<double>(k)}, "middle", t_name_[k]);
    }
    svg.close();
  }

  std::string axis_name(const Wrench& direction, const std::string& coordinate) const {
    const Grasp& grasp = question_.loaded().grasp;
    const auto with = [](const std::string& name, const std::string& unit) {
      return unit.empty() ? name : name + " /" + unit;
    };
    if (direction == Wrench{1, 0, 0})
      return with("applied force along x", force_unit(grasp.description().units));
    if (direction == Wrench{0, 1, 0})
      return with("applied force along y", force_unit(grasp.description().units));
    if (direction == Wrench{0, 0, 1})
      return with("applied torque", torque_unit(grasp.description().units));
    return coordinate + ", multiples of the wrench " + tuple(direction);
  }

  static std::string tuple(const Wrench& w) { return short_tuple({w.x, w.y, w.torque}); }

  void find_borders() {
    const auto add = [&](const PlanePoint& from, const PlanePoint& to) {
      if (!along_frame(from, to)) borders_.emplace_back(from, to);
    };
    for (const PlaneArea& area : visible_.areas) {
      for (const Outline& outline : area.outlines) {
        const std::vector<PlanePoint>& v = outline.vertices;
        for (std::size_t k = 0; k < v.size(); ++k) add(v[k], v[(k + 1) % v.size()]);
      }
    }
    for (const PlaneCell& curve : visible_.curves) {
      add(curve.vertices().front(), curve.vertices().back());
    }
  }

  void draw_borders(Svg& svg) const {
    for (const auto& [from, to] : borders_) {
      svg.line(place(from), place(to), "border",
               {{"data-from", text_of(from)}, {"data-to", text_of(to)}});
      // The frame cuts off unbounded borders.
      const InkPoint along = unit(place(to) - place(from));
      if (on_frame(to))
        draw_arrow(svg, place(to), place(to) + kHead * along, "border unbounded");
      if (on_frame(from)) {
        draw_arrow(svg, place(from), place(from) - kHead * along, "border unbounded");
      }
    }
    for (const PlanePoint& point : visible_.points) {
      svg.circle(place(point), 4.5, "full", {{"data-point", text_of(point)}});
    }
  }

  void draw_labels(Svg& svg) {
    if (corners_.size() > kMostLabels) return;
    LabelPlacer labels({{left_, kTop}, {left_ + kRegionSide, kTop + kRegionSide}});
    for (int i = 0; i < kSamples; ++i) {
      for (int j = 0; j < kSamples; ++j) {
        const auto middle = [&](int k) -> Rational {
          return half_ * Rational(2 * k + 1 - kSamples, kSamples);
        };
        const PlanePoint point{middle(i), middle(j)};
        if (visible_.contains(point)) labels.avoid(place(point));
      }
    }
    for (const auto& [from, to] : borders_) labels.keep_off(place(from), place(to));
    const std::vector<PlanePoint> corners(corners_.begin(), corners_.end());
    for (const PlanePoint& corner : corners) {
      const InkPoint at = place(corner);
      svg.circle(at, 3, "full", {{"data-corner", text_of(corner)}});
      labels.keep_off(at - InkPoint{4, 4}, at + InkPoint{4, 4});
    }
    const std::vector<std::string> texts = point_labels(corners);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const InkPoint at = place(corners[k]);
      if (!labels.place(svg, "halo", texts[k], places_around(at, 10, {0, -1}, "", texts[k]),
                        &at)) {
        ++left_out_;
      }
    }
  }

  void draw_caption(Svg& svg) const {
    const bool at_zero = plane_.origin() == Wrench{};
    std::string text = region_.is_empty()         ? "No wrench of this plane is resisted"
                       : region_.is_whole_plane() ? "Every wrench of this plane is resisted"
                                                  : "Shaded: resisted, borders included";
    if (reaches_frame() && !region_.is_whole_plane())
      text += "; at the frame it goes on without end";
    if (left_out_ > 0) text += "; no room for the labels of " + std::to_string(left_out_);
    const double room = width_ - left_ - kMargin;
    const auto s_lines = wrap(axis_name(plane_.u(), "s"), "", kRegionSide).size();
    double y = kTop + kRegionSide + 51 + kLine * static_cast<double>(s_lines);
    y = draw_lines(svg, {left_, y}, "caption", text + ".", room);
    y = draw_lines(svg, {left_, y}, "small muted",
                   std::string(at_zero ? "Other wrench coordinates 0"
                                       : "Wrench at (0, 0): " + tuple(plane_.origin())) +
                       "; normal law: " + to_string(question_.law) + preload_text() +
                       units_text() + ".",
                   room);
    svg.set_height(y);
  }

  std::string units_text() const {
    const std::optional<Units>& units = question_.loaded().grasp.description().units;
    return units ? "; units: " + units->force + ", " + units->length : "";
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
  const PlaneUnion& region_;
  Rational half_ = 0;  ///< half of the window's side
  std::set<PlanePoint> corners_;
  PlaneUnion visible_;
  std::vector<std::pair<PlanePoint, PlanePoint>> borders_;  ///< the borders of the visible part
  std::vector<Tick> ticks_;
  double widest_tick_ = 0;
  std::vector<std::string> t_name_;  ///< the name of the axis, in lines
  double left_ = 0;                  ///< the left side of the window
  double width_ = 0;                 ///< the width of the page
  std::size_t left_out_ = 0;         ///< corners without a label
};

}  // namespace

std::string plot_region(const Question& question, const WrenchPlane& plane,
                        const PlaneUnion& region) {
  return RegionPlot(question, plane, region).draw();
}

}  // namespace stickslip
