// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/grasp_plot.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "grasp_drawing.hpp"
#include "grasp_ink.hpp"
#include "stylesheet.hpp"

namespace stickslip {

using namespace plot_detail;

namespace {

// Lengths in pixels. The scene is on the left, the legend on the right, the caption below.
constexpr double kPanelTop = 52;
constexpr double kPanelWidth = 470;
constexpr double kMostPanelHeight = 440;
constexpr double kHeading = 18;      ///< above a view of space
constexpr double kAroundScene = 38;  ///< room for fingers and numbers
constexpr double kLegendLeft = kMargin + kPanelWidth + 24;
constexpr double kLegendText = kLegendLeft + 62;
constexpr double kRow = 25;
constexpr double kLongestBar = 120;
constexpr double kTorqueRadius = 26;

double head_of(const std::string& css_class) {
  return css_class == "force" || css_class == "load" ? kHead : kSmallHead;
}

/// Draws a bar across `along`, of length 1.
void draw_bar(Svg& svg, InkPoint at, InkPoint along, Svg::Attributes attributes = {}) {
  const InkPoint across = 8 * quarter_turn(along);
  svg.line(at - across, at + across, "preload", std::move(attributes));
}

class GraspPlot {
 public:
  GraspPlot(GraspInk ink, const char* verdict) : ink_(std::move(ink)), verdict_(verdict) {}

  std::string draw() {
    const std::string verdict = ": " + verdict_;
    Svg svg(kGraspWidth, 0, ink_.title + verdict, stylesheet());
    const double room = kGraspWidth - 2 * kMargin - text_width("title", verdict);
    svg.text({kMargin, 34}, "title", fit(ink_.title, "title", room) + verdict,
             {{"data-verdict", verdict_}});
    svg.set_height(draw_below(svg));
    return svg.finish();
  }

  /// Draws all but the title; returns the baseline of the line below.
  double draw_below(Svg& svg) {
    double y = ink_.scenes.size() == 1 ? draw_plane(svg) : draw_sides(svg);
    y += 26;
    if (left_out_ > 0) {
      ink_.caption.push_back("No room for the numbers of " + std::to_string(left_out_) +
                             " contacts; tooltips have them.");
    }
    for (const std::string& paragraph : ink_.caption) {
      y = draw_lines(svg, {kMargin, y}, "caption", paragraph, kGraspWidth - 2 * kMargin);
    }
    return y;
  }

 private:
  /// The range with ink along an axis of the object frame.
  struct Range {
    double low = -0.4;  // around the load
    double high = 0.4;

    void add(double at) {
      low = std::min(low, at);
      high = std::max(high, at);
    }
    double size() const { return high - low; }
    double middle() const { return 0.5 * (low + high); }
  };

  std::array<Range, 3> ranges() const {
    std::array<Range, 3> found;
    for (const SceneInk& scene : ink_.scenes) {
      std::vector<InkPoint> ink;
      const auto add = [&](const std::vector<std::vector<InkPoint>>& rings) {
        for (const auto& ring : rings) ink.insert(ink.end(), ring.begin(), ring.end());
      };
      add(scene.cones);
      for (const BodyInk& body : scene.bodies) {
        add(body.outline);
        add(body.ghost);
        if (body.held) ink.insert(ink.end(), body.held->begin(), body.held->end());
      }
      for (const Arrow& arrow : scene.arrows) ink.push_back(arrow.tip);
      if (scene.pivot) ink.push_back(*scene.pivot);
      for (const InkPoint& p : ink) {
        found[scene.axes[0]].add(p.x);
        found[scene.axes[1]].add(p.y);
      }
    }
    return found;
  }

  /// Returns the view in which the ranges of the scene's axes have their middle in this
  /// panel's.
  View view_in(const Box& panel, const SceneInk& scene,
               const std::array<Range, 3>& ranges) const {
    const InkPoint middle{ranges[scene.axes[0]].middle(), ranges[scene.axes[1]].middle()};
    return {0.5 * (panel.low + panel.high) - scale_ * on_page_direction(middle), scale_};
  }

  /// Draws the scene on the left and the legend on the right; returns the y of the lower end.
  double draw_plane(Svg& svg) {
    const std::array<Range, 3> all = ranges();
    scale_ = std::min((kPanelWidth - 2 * kAroundScene) / all[0].size(),
                      (kMostPanelHeight - 2 * kAroundScene) / all[1].size());
    const double bottom = kPanelTop + scale_ * all[1].size() + 2 * kAroundScene;
    const Box panel{{kMargin, kPanelTop}, {kMargin + kPanelWidth, bottom}};
    draw_scene(svg, ink_.scenes[0], view_in(panel, ink_.scenes[0], all),
               {panel.low - InkPoint{0, 10}, panel.high + InkPoint{0, 10}});
    return std::max(bottom, draw_legend(svg));
  }

  /// Draws three views with one scale: from above, with the legend beside it; below it from the
  /// front, with the same x, and beside that from the right, with the same z.
  double draw_sides(Svg& svg) {
    const std::array<Range, 3> all = ranges();
    const double around = 2 * kAroundScene;
    scale_ =
        std::min({(kPanelWidth - around) / all[0].size(),
                  (kGraspWidth - 2 * kMargin - 2 * around) / (all[0].size() + all[1].size()),
                  (kMostPanelHeight - around) / all[1].size(),
                  (kMostPanelHeight - around) / all[2].size()});
    const auto draw_side = [&](const SceneInk& scene, InkPoint corner) {
      const InkPoint size{scale_ * all[scene.axes[0]].size() + around,
                          scale_ * all[scene.axes[1]].size() + around};
      svg.text(corner + InkPoint{0, 13}, "small muted", scene.heading);
      const InkPoint low = corner + InkPoint{0, kHeading};
      const Box panel{low, low + size};
      draw_scene(svg, scene, view_in(panel, scene, all), panel);
      return panel.high;
    };
    const double below = draw_side(ink_.scenes[0], {kMargin, kPanelTop}).y;
    const double second = std::max(below, draw_legend(svg)) + 4;
    const InkPoint front = draw_side(ink_.scenes[1], {kMargin, second});
    draw_side(ink_.scenes[2], {front.x, second});
    return front.y;
  }

  void draw_scene(Svg& svg, const SceneInk& scene, const View& view, const Box& panel) {
    LabelPlacer labels(panel);
    for (const BodyInk& body : scene.bodies) {
      if (body.outline.empty() && ink_.of_several) continue;
      draw_body(svg, view, body.outline, body.within, "body");
    }
    draw_cones(svg, scene, view);
    for (const BodyInk& body : scene.bodies) {
      if (!body.ghost.empty()) draw_body(svg, view, body.ghost, body.within, ghost_class());
    }
    draw_fingers(svg, view, scene.contacts);
    for (const BodyInk& body : scene.bodies) {
      if (body.held) draw_held(svg, view((*body.held)[0]), view((*body.held)[1]));
    }
    if (!ink_.of_several) draw_frame(svg, view({0, 0}));
    for (const Arrow& arrow : scene.arrows) {
      if (ink_.of_several && arrow.css_class == "load") draw_frame(svg, view(arrow.tail));
      draw_arrow(svg, view(arrow.tail), view(arrow.tip), arrow.css_class, arrow.attributes,
                 head_of(arrow.css_class));
      labels.avoid(view(arrow.tail), view(arrow.tip));
    }
    if (scene.pivot) draw_pivot(svg, view(*scene.pivot));
    if (!scene.torque.is_zero()) {
      draw_torque(svg, view({0, 0}), kTorqueRadius, scene.torque.sign() > 0,
                  {{"data-value", to_string(scene.torque)}});
    }
    draw_preloads(svg, scene, view);
    for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
      const ContactInk& c = scene.contacts[i];
      const std::string text = "contact " + std::to_string(i);
      const char* mark = name_of(ink_.marks[i]);
      draw_contact(svg, view(c.at), on_page_direction(c.tangent), ink_.marks[i],
                   {{"data-contact", std::to_string(i)}},
                   *mark == 0 ? text : text + ": " + typeset(mark));
      labels.avoid(view(c.at), view(tip_of(c)));
    }
    left_out_ = std::max(left_out_, draw_numbers(svg, view, scene.contacts, labels));
    for (const BodyInk& body : scene.bodies) draw_name(svg, view, body, labels);
  }

  /// Writes the name in the body, if there is room.
  static void draw_name(Svg& svg, const View& view, const BodyInk& body, LabelPlacer& labels) {
    if (body.name.empty() || body.outline.empty()) return;
    constexpr const char* kClass = "small halo";
    std::vector<LabelPlace> places =
        places_inside(on_page(view, body.outline.front()), kClass, body.name);
    InkPoint middle{0, 0};
    for (const InkPoint& p : body.outline.front()) {
      middle = middle + 1 / static_cast<double>(body.outline.front().size()) * view(p);
    }
    for (const LabelPlace& near : places_around(middle, 0, {0, -1}, kClass, body.name)) {
      places.push_back(near);
    }
    labels.place(svg, kClass, body.name, places);
  }

  /// Draws how a link is held: a ring, and a line for an axis that is not seen from its end.
  static void draw_held(Svg& svg, InkPoint from, InkPoint to) {
    if (length(to - from) > 0.01) svg.line(from, to, "rule joint");
    svg.circle(0.5 * (from + to), 4, "hollow joint");
  }

  /// Returns the tip of the arrow of its normal.
  InkPoint tip_of(const ContactInk& contact) const {
    return contact.at + ink_.cone_length * contact.normal;
  }

  const char* ghost_class() const {
    return ink_.virtual_factor.is_zero() ? "ghost" : "virtual-ghost";
  }

  static void draw_pivot(Svg& svg, InkPoint at) {
    svg.path(SvgPath().circle(at, 6).circle(at, 1.5), "virtual-pivot");
  }

  void draw_cones(Svg& svg, const SceneInk& scene, const View& view) const {
    for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
      svg.path(SvgPath().polygon(on_page(view, scene.cones[i])), "cone",
               {{"data-contact", std::to_string(i)}});
      const InkPoint apex = view(scene.contacts[i].at);
      const InkPoint end = view(tip_of(scene.contacts[i]));
      const InkPoint neck = end - std::min(kSmallHead, length(end - apex)) * unit(end - apex);
      svg.line(apex, neck, "axis");
      draw_arrow(svg, neck, end, "normal", {}, kSmallHead);
    }
  }

  /// Draws preloads at the tip that a force of this size along the normal would have.
  void draw_preloads(Svg& svg, const SceneInk& scene, const View& view) const {
    for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
      const Rational& preload = ink_.preloads[i];
      const ContactInk& c = scene.contacts[i];
      if (preload.is_zero() || length(c.normal) < 0.01) continue;  // a disc from the front
      draw_bar(svg, view(c.at + ink_.force_length(preload) * c.normal),
               on_page_direction(unit(c.normal)),
               {{"data-contact", std::to_string(i)}, {"data-value", to_string(preload)}});
    }
  }

  /// Draws a small cross where a load acts.
  static void draw_frame(Svg& svg, InkPoint at) {
    svg.path(SvgPath()
                 .move(at - InkPoint{6, 0})
                 .line(at + InkPoint{6, 0})
                 .move(at - InkPoint{0, 6})
                 .line(at + InkPoint{0, 6}),
             "frame");
  }

  bool has_arrow(const std::string& css_class) const {
    return any_scene([&](const SceneInk& scene) {
      return std::any_of(scene.arrows.begin(), scene.arrows.end(), [&](const Arrow& arrow) {
        return arrow.css_class == css_class && scale_ * length(arrow.tip - arrow.tail) >= 0.01;
      });
    });
  }

  template <class Property>
  bool any_scene(Property property) const {
    return std::any_of(ink_.scenes.begin(), ink_.scenes.end(), property);
  }

  bool has_mark(ContactMark mark) const {
    return std::find(ink_.marks.begin(), ink_.marks.end(), mark) != ink_.marks.end();
  }

  /// Draws a round force as a bar.
  void draw_force_scale(Svg& svg, InkPoint left) const {
    const double longest = scale_ * GraspInk::kLongestForce;
    const double share = std::min(1.0, kLongestBar / longest);
    const Rational force = round_down(ink_.force_unit * rational_from_double(share));
    const InkPoint right = left + InkPoint{scale_ * ink_.force_length(force), 0};
    const InkPoint up{0, 4};
    SvgPath bar;
    bar.move(left - up)
        .line(left + up)
        .move(left)
        .line(right)
        .move(right - up)
        .line(right + up);
    svg.path(bar, "rule scale", {{"data-value", to_string(force)}});
    svg.text(right + InkPoint{8, 4.5}, "legend",
             "force " + short_text(force) + force_unit(ink_.units));
  }

  /// Draws the legend of the picture. Returns the y of its lower end.
  double draw_legend(Svg& svg) const {
    const SceneInk& first = ink_.scenes.front();
    double y = kPanelTop + 18;
    const auto row = [&](const std::string& text) {
      const double below = draw_lines(svg, {kLegendText, y + 4.5}, "legend", text,
                                      kGraspWidth - kMargin - kLegendText);
      y = below - 4.5 + kRow - kLine;
    };
    const InkPoint left{kLegendLeft, 0};
    const auto at = [&](double x) { return left + InkPoint{x, y}; };
    const auto arrow_row = [&](const std::string& css_class, const std::string& text) {
      if (!has_arrow(css_class)) return;
      draw_arrow(svg, at(2), at(48), css_class, {}, head_of(css_class));
      row(text);
    };
    const auto mark_row = [&](ContactMark mark, const std::string& text) {
      if (!has_mark(mark)) return;
      draw_contact(svg, at(24), {1, 0}, mark);
      row(text);
    };
    svg.open("g", {{"class", "key"}});
    if (!ink_.marks.empty()) {
      svg.path(SvgPath().polygon({at(4), at(48) + InkPoint{0, 8}, at(48) - InkPoint{0, 8}}),
               "cone");
      svg.line(at(4), at(40), "axis");
      draw_arrow(svg, at(40), at(48), "normal", {}, kSmallHead);
      row("normal, friction cone");
    }
    if (std::any_of(ink_.preloads.begin(), ink_.preloads.end(),
                    [](const Rational& preload) { return !preload.is_zero(); })) {
      draw_bar(svg, at(26), {1, 0});
      row("preload P, on the normal");
    }
    arrow_row("force", "contact force");
    arrow_row("load", ink_.load_factor == 1 ? "applied force"
                                            : "applied force, enlarged \u00D7\u202F" +
                                                  short_text(ink_.load_factor));
    if (!ink_.torque.empty()) {
      draw_torque(svg, at(26), 9, first.torque.sign() >= 0);
      row("torque " + ink_.torque + torque_unit(ink_.units));
    }
    if (!ink_.force_unit.is_zero()) {
      y += 4;
      draw_force_scale(svg, {kLegendLeft, y});
      y += kRow + 4;
    }
    arrow_row("motion", "motion, \u00D7\u202F" + short_text(ink_.motion_factor));
    arrow_row("virtual", "virtual twist, \u00D7\u202F" + short_text(ink_.virtual_factor));
    if (first.has_ghost()) {
      svg.path(SvgPath().polygon({at(2) + InkPoint{0, 8}, at(48) + InkPoint{0, 5},
                                  at(46) - InkPoint{0, 8}, at(4) - InkPoint{0, 6}}),
               ghost_class());
      const std::string who = ink_.of_several ? "bodies" : "body";
      row(who + (ink_.virtual_factor.is_zero() ? " after the motion" : " after the twist"));
    }
    if (first.pivot) {
      draw_pivot(svg, at(24));
      row("centre of its rotation");
    }
    mark_row(ContactMark::kLoses, "opposes the twist; loses");
    mark_row(ContactMark::kCannotOppose, "cannot oppose the twist");
    mark_row(ContactMark::kStick, "sticks");
    mark_row(ContactMark::kSlipPlus, "slips + (the way it points)");
    mark_row(ContactMark::kSlipMinus, "slips \u2212 (the way it points)");
    mark_row(ContactMark::kSlip, "slips");
    mark_row(ContactMark::kOpen, "open: detached");
    if (std::any_of(first.bodies.begin(), first.bodies.end(),
                    [](const BodyInk& body) { return body.held.has_value(); })) {
      draw_held(svg, at(8), at(40));
      row("hinge or slide of a link");
    }
    if (first.has_outline()) {
      svg.path(SvgPath().polygon({at(4) + InkPoint{0, 7}, at(48) + InkPoint{0, 7},
                                  at(44) - InkPoint{0, 7}, at(8) - InkPoint{0, 7}}),
               "body");
      row(ink_.of_several         ? ink_.outline_is_given ? "bodies" : "bodies, some sketched"
          : ink_.outline_is_given ? "body"
                                  : "body: a sketch");
    }
    svg.close();
    return y;
  }

  GraspInk ink_;
  std::string verdict_;
  double scale_ = 1;          ///< pixels per scene unit
  std::size_t left_out_ = 0;  ///< numbers without room in a view
};

GraspPlot plot_of(const Question& question, const Verdict& verdict) {
  const bool is_exact = question.box() == nullptr;
  return {is_exact ? grasp_ink(question, verdict) : bodies_ink(question, verdict),
          name_of(verdict)};
}

}  // namespace

double plot_detail::draw_grasp(Svg& svg, const Question& question, const Verdict& verdict) {
  return plot_of(question, verdict).draw_below(svg);
}

std::string plot_grasp(const Question& question, const Verdict& verdict) {
  return plot_of(question, verdict).draw();
}

}  // namespace stickslip
