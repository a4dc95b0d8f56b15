// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/plot/grasp_plot.hpp"

#include <algorithm>

#include "grasp_ink.hpp"
#include "stylesheet.hpp"

namespace stickslip {

using namespace plot_detail;

namespace {

// In pixels. The scene is on the left, the legend on the right, the caption below.
constexpr double kPanelTop = 52;
constexpr double kPanelWidth = 470;
constexpr double kMostPanelHeight = 440;
constexpr double kAroundScene = 38;  ///< for fingers and numbers
constexpr double kLegendLeft = kMargin + kPanelWidth + 24;
constexpr double kLegendText = kLegendLeft + 62;
constexpr double kRow = 25;
constexpr double kGraspWidth = 800;
constexpr double kLongestBar = 120;
constexpr double kTorqueRadius = 26;

double head_of(const std::string& css_class) {
  return css_class == "force" || css_class == "load" ? kHead : kSmallHead;
}

/// A bar across `along`, of length 1.
void draw_bar(Svg& svg, InkPoint at, InkPoint along, Svg::Attributes attributes = {}) {
  const InkPoint across = 8 * quarter_turn(along);
  svg.line(at - across, at + across, "preload", std::move(attributes));
}

class GraspPlot {
 public:
  GraspPlot(const Question& question, const Verdict& verdict)
      : grasp_(question.loaded.grasp),
        case_(question.case_name.empty() ? "" : ", " + question.case_name),
        verdict_(name_of(verdict)),
        ink_(grasp_ink(question, verdict)) {}

  std::string draw() {
    const double panel_bottom = kPanelTop + choose_view();
    const std::string name = (grasp_.name().empty() ? "Grasp" : grasp_.name()) + case_;
    const std::string verdict = ": " + verdict_;
    Svg svg(kGraspWidth, 0, name + verdict, stylesheet());
    const double room = kGraspWidth - 2 * kMargin - text_width("title", verdict);
    svg.text({kMargin, 34}, "title", fit(name, "title", room) + verdict,
             {{"data-verdict", verdict_}});
    draw_scene(svg, {{kMargin, kPanelTop - 10}, {kMargin + kPanelWidth, panel_bottom + 10}});
    double y = std::max(panel_bottom, draw_legend(svg)) + 26;
    for (const std::string& paragraph : ink_.caption) {
      y = draw_lines(svg, {kMargin, y}, "caption", paragraph, kGraspWidth - 2 * kMargin);
    }
    svg.set_height(y);
    return svg.finish();
  }

 private:
  /// Chooses the view so that all ink is in the panel, and returns the panel's height.
  double choose_view() {
    std::vector<InkPoint> ink;
    for (const auto* rings : {&ink_.outline, &ink_.ghost}) {
      for (const auto& ring : *rings) ink.insert(ink.end(), ring.begin(), ring.end());
    }
    for (const Arrow& arrow : ink_.arrows) ink.push_back(arrow.tip);
    if (ink_.pivot) ink.push_back(*ink_.pivot);
    for (const auto& cone : ink_.cones) ink.insert(ink.end(), cone.begin(), cone.end());
    InkPoint low{-0.4, -0.4};  // around the load
    InkPoint high{0.4, 0.4};
    for (const InkPoint& p : ink) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const InkPoint size = high - low;
    view_.scale = std::min((kPanelWidth - 2 * kAroundScene) / size.x,
                           (kMostPanelHeight - 2 * kAroundScene) / size.y);
    const double height = view_.scale * size.y + 2 * kAroundScene;
    const InkPoint middle = 0.5 * (low + high);
    const InkPoint panel_middle{kMargin + kPanelWidth / 2, kPanelTop + height / 2};
    view_.origin = panel_middle - view_.scale * on_page_direction(middle);
    return height;
  }

  void draw_scene(Svg& svg, const Box& panel) {
    LabelPlacer labels(panel);
    draw_body(svg, view_, ink_.outline, "body");
    draw_cones(svg);
    if (!ink_.ghost.empty()) draw_body(svg, view_, ink_.ghost, ghost_class());
    draw_fingers(svg, view_, ink_.contacts);
    draw_frame(svg);
    for (const Arrow& arrow : ink_.arrows) {
      draw_arrow(svg, view_(arrow.tail), view_(arrow.tip), arrow.css_class, arrow.attributes,
                 head_of(arrow.css_class));
      labels.avoid(view_(arrow.tail), view_(arrow.tip));
    }
    if (ink_.pivot) draw_pivot(svg, view_(*ink_.pivot));
    if (!ink_.torque.is_zero()) {
      draw_torque(svg, view_({0, 0}), kTorqueRadius, ink_.torque.sign() > 0,
                  {{"data-value", to_string(ink_.torque)}});
    }
    draw_preloads(svg);
    for (std::size_t i = 0; i < ink_.contacts.size(); ++i) {
      const std::string text = "contact " + std::to_string(i);
      const char* mark = name_of(ink_.marks[i]);
      draw_contact(svg, view_(ink_.contacts[i].at), on_page_direction(ink_.contacts[i].tangent),
                   ink_.marks[i], {{"data-contact", std::to_string(i)}},
                   *mark == 0 ? text : text + ": " + typeset(mark));
      labels.avoid(view_(ink_.cones[i].front()),
                   view_(ink_.cones[i][ink_.cones[i].size() / 2]));
    }
    if (const std::size_t left_out = draw_numbers(svg, view_, ink_.contacts, labels)) {
      ink_.caption.push_back("No room for the numbers of " + std::to_string(left_out) +
                             " contacts; tooltips have them.");
    }
  }

  const char* ghost_class() const {
    return ink_.virtual_factor.is_zero() ? "ghost" : "virtual-ghost";
  }

  static void draw_pivot(Svg& svg, InkPoint at) {
    svg.path(SvgPath().circle(at, 6).circle(at, 1.5), "virtual-pivot");
  }

  void draw_cones(Svg& svg) const {
    for (std::size_t i = 0; i < ink_.contacts.size(); ++i) {
      const std::vector<InkPoint>& cone = ink_.cones[i];
      svg.path(SvgPath().polygon(on_page(view_, cone)), "cone",
               {{"data-contact", std::to_string(i)}});
      const InkPoint apex = view_(cone.front());
      const InkPoint end = view_(cone[cone.size() / 2]);
      const InkPoint neck = end - kSmallHead * unit(end - apex);
      svg.line(apex, neck, "axis");
      draw_arrow(svg, neck, end, "normal", {}, kSmallHead);
    }
  }

  /// At the tip that a force of this size along the normal would have.
  void draw_preloads(Svg& svg) const {
    for (std::size_t i = 0; i < ink_.contacts.size(); ++i) {
      const Rational& preload = grasp_.contacts()[i].preload;
      if (preload.is_zero()) continue;
      const ContactInk& c = ink_.contacts[i];
      draw_bar(svg, view_(c.at + ink_.force_length(preload) * c.normal),
               on_page_direction(c.normal),
               {{"data-contact", std::to_string(i)}, {"data-value", to_string(preload)}});
    }
  }

  /// A small cross where the load acts.
  void draw_frame(Svg& svg) const {
    const InkPoint at = view_({0, 0});
    svg.path(SvgPath()
                 .move(at - InkPoint{6, 0})
                 .line(at + InkPoint{6, 0})
                 .move(at - InkPoint{0, 6})
                 .line(at + InkPoint{0, 6}),
             "frame");
  }

  bool has_arrow(const std::string& css_class) const {
    return std::any_of(ink_.arrows.begin(), ink_.arrows.end(), [&](const Arrow& arrow) {
      return arrow.css_class == css_class &&
             length(view_(arrow.tip) - view_(arrow.tail)) >= 0.01;
    });
  }

  bool has_mark(ContactMark mark) const {
    return std::find(ink_.marks.begin(), ink_.marks.end(), mark) != ink_.marks.end();
  }

  /// A round force as a bar.
  void draw_force_scale(Svg& svg, InkPoint left) const {
    const double longest = view_.scale * GraspInk::kLongestForce;
    const double share = std::min(1.0, kLongestBar / longest);
    const Rational force = round_down(ink_.force_unit * rational_from_double(share));
    const InkPoint right = left + InkPoint{view_.scale * ink_.force_length(force), 0};
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
             "force " + short_text(force) + force_unit(grasp_));
  }

  /// Explains what is in the picture. Returns the y of its lower end.
  double draw_legend(Svg& svg) const {
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
    if (!ink_.contacts.empty()) {
      svg.path(SvgPath().polygon({at(4), at(48) + InkPoint{0, 8}, at(48) - InkPoint{0, 8}}),
               "cone");
      svg.line(at(4), at(40), "axis");
      draw_arrow(svg, at(40), at(48), "normal", {}, kSmallHead);
      row("normal, friction cone");
    }
    if (std::any_of(grasp_.contacts().begin(), grasp_.contacts().end(),
                    [](const Contact& c) { return !c.preload.is_zero(); })) {
      draw_bar(svg, at(26), {1, 0});
      row("preload P, on the normal");
    }
    arrow_row("force", "contact force");
    arrow_row("load", ink_.load_factor == 1 ? "applied force"
                                            : "applied force, enlarged \u00D7\u202F" +
                                                  short_text(ink_.load_factor));
    if (!ink_.torque.is_zero()) {
      draw_torque(svg, at(26), 9, ink_.torque.sign() > 0);
      row("torque " + short_text(ink_.torque) + torque_unit(grasp_));
    }
    if (!ink_.force_unit.is_zero()) {
      y += 4;
      draw_force_scale(svg, {kLegendLeft, y});
      y += kRow + 4;
    }
    arrow_row("motion", "motion, \u00D7\u202F" + short_text(ink_.motion_factor));
    arrow_row("virtual", "virtual twist, \u00D7\u202F" + short_text(ink_.virtual_factor));
    if (!ink_.ghost.empty()) {
      svg.path(SvgPath().polygon({at(2) + InkPoint{0, 8}, at(48) + InkPoint{0, 5},
                                  at(46) - InkPoint{0, 8}, at(4) - InkPoint{0, 6}}),
               ghost_class());
      row(ink_.virtual_factor.is_zero() ? "body after the motion" : "body after the twist");
    }
    if (ink_.pivot) {
      draw_pivot(svg, at(24));
      row("centre of its rotation");
    }
    mark_row(ContactMark::kLoses, "opposes the twist; loses");
    mark_row(ContactMark::kCannotOppose, "cannot oppose the twist");
    mark_row(ContactMark::kStick, "sticks");
    mark_row(ContactMark::kSlipPlus, "slips + (the way it points)");
    mark_row(ContactMark::kSlipMinus, "slips \u2212 (the way it points)");
    mark_row(ContactMark::kOpen, "open: detached");
    if (!ink_.outline.empty()) {
      svg.path(SvgPath().polygon({at(4) + InkPoint{0, 7}, at(48) + InkPoint{0, 7},
                                  at(44) - InkPoint{0, 7}, at(8) - InkPoint{0, 7}}),
               "body");
      row(grasp_.description().outline.empty() ? "body: hull of the contacts" : "body");
    }
    svg.close();
    return y;
  }

  const Grasp& grasp_;
  std::string case_;
  std::string verdict_;
  GraspInk ink_;
  View view_;
};

}  // namespace

std::string plot_grasp(const Question& question, const Verdict& verdict) {
  return GraspPlot(question, verdict).draw();
}

}  // namespace stickslip
