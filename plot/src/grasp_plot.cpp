// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/plot/grasp_plot.hpp"

#include <algorithm>
#include <cmath>

#include "grasp_scene.hpp"
#include "marks.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/sign.hpp"
#include "stylesheet.hpp"

namespace stickslip {
namespace {

// In scene units: the radius of the grasp is 1.
constexpr double kLongestCone = 0.7;
constexpr double kLongestForce = 0.6;
constexpr double kLongestMotion = 0.3;

// In pixels.
constexpr double kMargin = 24;
constexpr double kPanelTop = 52;
constexpr double kPanelWidth = 470;
constexpr double kMostPanelHeight = 440;
constexpr double kAroundScene = 38;  ///< for fingers and numbers
constexpr double kLegendLeft = kMargin + kPanelWidth + 24;
constexpr double kLegendText = kLegendLeft + 62;
constexpr double kRow = 25;
constexpr double kLine = 19;
constexpr double kWidth = 800;
constexpr double kLongestBar = 150;
constexpr double kTorqueRadius = 26;

struct Arrow {
  InkPoint tail;  ///< in the scene
  InkPoint tip;
  std::string css_class;
  Svg::Attributes attributes;
};

Vector2 displacement(const Vector2& point, const Twist& d) {
  return {d.x - d.r * point.y, d.y + d.r * point.x};
}

double head_of(const std::string& css_class) {
  return css_class == "force" || css_class == "load" ? kHead : kSmallHead;
}

std::string pair_text(const Vector2& v) {
  return to_string(v.x) + "," + to_string(v.y);
}

class GraspPlot {
 public:
  GraspPlot(const Question& question, const Verdict& verdict)
      : question_(question),
        verdict_(verdict),
        grasp_(question.loaded.grasp),
        wrench_(question.loaded.wrench),
        rows_(contact_rows(grasp_)),
        frame_(picture_frame(grasp_)),
        contacts_(contact_ink(grasp_, frame_)),
        outline_(body_outline(contacts_)) {}

  std::string draw() {
    states_.assign(grasp_.size(), ContactState::kUnknown);
    choose_force_unit();
    add_load();
    if (const auto* stable = std::get_if<Stable>(&verdict_)) {
      add_witness(stable->witness);
    } else if (const auto* unstable = std::get_if<Unstable>(&verdict_)) {
      add_refutation(unstable->refutation);
    } else {
      lines_.push_back("Undecided: given up at " + std::get<Undecided>(verdict_).limit + ".");
    }
    return compose();
  }

 private:
  /// The force of contact i, exactly.
  Vector2 force(const Witness& witness, std::size_t i) const {
    const Vector2& n = grasp_.contacts()[i].normal;
    const ContactForce& f = witness.forces[i];
    return {f.normal * n.x - f.tangential * n.y, f.normal * n.y + f.tangential * n.x};
  }

  /// The largest force in the picture has about the length kLongestForce.
  void choose_force_unit() {
    force_unit_ = largest_entry({wrench_.x, wrench_.y});
    for (const Contact& c : grasp_.contacts()) force_unit_ = std::max(force_unit_, c.preload);
    if (const auto* stable = std::get_if<Stable>(&verdict_)) {
      require(stable->witness.forces.size() == grasp_.size(),
              "plot_grasp: the verdict is not about this grasp");
      for (std::size_t i = 0; i < grasp_.size(); ++i) {
        force_unit_ = std::max(force_unit_, largest_entry(force(stable->witness, i)));
      }
    }
    has_forces_ = !force_unit_.is_zero();
    if (!has_forces_) force_unit_ = 1;
  }

  InkPoint force_ink(const Vector2& force) const {
    return kLongestForce * ratio(force, force_unit_);
  }

  /// The wrench as a force at the centre of the scene and a torque about it.
  void add_load() {
    torque_ = wrench_.torque - (frame_.centre.x * wrench_.y - frame_.centre.y * wrench_.x);
    const Vector2 force{wrench_.x, wrench_.y};
    arrows_.push_back({{0, 0}, force_ink(force), "load", {{"data-value", pair_text(force)}}});
    lines_.push_back(
        "Applied wrench w = " + short_tuple({wrench_.x, wrench_.y, wrench_.torque}) +
        (frame_.centre == Vector2{}
             ? ""
             : ", drawn at " + short_tuple({frame_.centre.x, frame_.centre.y}) +
                   ", where its torque is " + short_text(torque_)) +
        ". Normal law: " + to_string(question_.law) + ".");
  }

  /// Adds an arrow for the motion of each contact; returns the factor of enlargement.
  Rational add_motion(const Twist& d, const std::string& css_class) {
    Rational largest = 0;
    for (const Contact& c : grasp_.contacts()) {
      largest = std::max(largest, largest_entry(displacement(c.position, d)));
    }
    if (largest.is_zero()) return 0;
    const Rational factor = round_down(Rational(static_cast<int>(1000 * kLongestMotion), 1000) *
                                       frame_.radius / largest);
    for (std::size_t i = 0; i < grasp_.size(); ++i) {
      const Vector2 move = displacement(grasp_.contacts()[i].position, d);
      arrows_.push_back(
          {contacts_[i].at,
           contacts_[i].at + ratio({factor * move.x, factor * move.y}, frame_.radius),
           css_class,
           {{"data-contact", std::to_string(i)}, {"data-value", pair_text(move)}}});
    }
    return factor;
  }

  void add_witness(const Witness& witness) {
    const Twist& d = witness.twist;
    motion_factor_ = add_motion(d, "motion");
    for (std::size_t i = 0; i < grasp_.size(); ++i) {
      const Sign slip = sign_of(power(rows_[i].tangent, d));
      states_[i] = rows_[i].normal_coefficient(d).sign() < 0 ? ContactState::kOpen
                   : slip == Sign::kPositive                 ? ContactState::kSlipPlus
                   : slip == Sign::kNegative                 ? ContactState::kSlipMinus
                                                             : ContactState::kStick;
      const Vector2 f = force(witness, i);
      arrows_.push_back({contacts_[i].at,
                         contacts_[i].at + force_ink(f),
                         "force",
                         {{"data-contact", std::to_string(i)}, {"data-value", pair_text(f)}}});
    }
    if (!motion_factor_.is_zero()) ghost_ = moved_outline(d);
    lines_.push_back("Motion d = " + short_tuple({d.x, d.y, d.r}) +
                     (motion_factor_.is_zero()
                          ? ": no contact moves."
                          : ", drawn \u00D7\u202F" + short_text(motion_factor_) + ".") +
                     " The forces balance w; checked exactly.");
  }

  /// The outline as the motion moves it: linear in d, as the model is.
  std::vector<InkPoint> moved_outline(const Twist& d) const {
    const Vector2 shift = displacement(frame_.centre, d);
    const InkPoint move =
        ratio({motion_factor_ * shift.x, motion_factor_ * shift.y}, frame_.radius);
    const double turn = to_double(motion_factor_ * d.r);
    std::vector<InkPoint> moved = outline_;
    for (InkPoint& p : moved) p = p + move + turn * quarter_turn(p);
    return moved;
  }

  void add_refutation(const Refutation& refutation) {
    const auto* leaf =
        refutation.size() == 1 ? std::get_if<VirtualWorkLeaf>(&refutation[0]) : nullptr;
    if (leaf == nullptr) {
      const auto cases =
          std::count_if(refutation.begin(), refutation.end(), [](const RefutationNode& node) {
            return std::holds_alternative<VirtualWorkLeaf>(node);
          });
      lines_.push_back(cases == 0 ? "The normal law allows no motion at all."
                                  : "No motion and forces satisfy all conditions: proved in " +
                                        std::to_string(cases) + " cases.");
      return;
    }
    // Along the leaf's twist the wrenches of load and contacts together do negative work
    // whatever the contacts do; so against it, the load drives the object.
    const Twist drift{Rational(-leaf->twist[0]), Rational(-leaf->twist[1]),
                      Rational(-leaf->twist[2])};
    virtual_factor_ = add_motion(drift, "virtual");
    lines_.push_back("Whatever the contacts do, along the virtual twist " +
                     short_tuple({drift.x, drift.y, drift.r}));
    lines_.push_back("the load does more work than the contacts can take up.");
  }

  /// Shorter when there are many, so that they leave room for the rest.
  double cone_length() const {
    return kLongestCone * std::min(1.0, 2.2 / std::sqrt(static_cast<double>(grasp_.size())));
  }

  /// A sector, so that wide cones look wide.
  std::vector<InkPoint> cone(std::size_t i) const {
    constexpr int kSteps = 12;
    const ContactInk& c = contacts_[i];
    const double half_angle = std::atan(to_double(grasp_.contacts()[i].friction));
    std::vector<InkPoint> sector{c.at};
    for (int step = -kSteps; step <= kSteps; ++step) {
      const double angle = half_angle * step / kSteps;
      sector.push_back(c.at + cone_length() * std::cos(angle) * c.normal +
                       cone_length() * std::sin(angle) * c.tangent);
    }
    return sector;
  }

  /// Chooses the view so that all ink is in the panel, and returns the panel's height.
  double choose_view() {
    std::vector<InkPoint> ink = outline_;
    ink.insert(ink.end(), ghost_.begin(), ghost_.end());
    for (const Arrow& arrow : arrows_) ink.push_back(arrow.tip);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const auto corners = cone(i);
      ink.insert(ink.end(), corners.begin(), corners.end());
    }
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

  void draw_scene(Svg& svg) const {
    svg.path(SvgPath().polygon(on_page(view_, outline_)), "body");
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      svg.path(SvgPath().polygon(on_page(view_, cone(i))), "cone",
               {{"data-contact", std::to_string(i)}});
      const InkPoint end = contacts_[i].at + 0.9 * cone_length() * contacts_[i].normal;
      svg.line(view_(contacts_[i].at), view_(end), "axis");
      draw_arrow(svg, view_(end), view_(contacts_[i].at + cone_length() * contacts_[i].normal),
                 "normal", {}, kSmallHead);
    }
    if (!ghost_.empty()) svg.path(SvgPath().polygon(on_page(view_, ghost_)), "ghost");
    draw_fingers(svg, view_, contacts_);
    draw_frame(svg);
    for (const Arrow& arrow : arrows_) {
      draw_arrow(svg, view_(arrow.tail), view_(arrow.tip), arrow.css_class, arrow.attributes,
                 head_of(arrow.css_class));
    }
    if (!torque_.is_zero()) {
      draw_torque(svg, view_({0, 0}), kTorqueRadius, torque_.sign() > 0,
                  {{"data-value", to_string(torque_)}});
    }
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const Rational& preload = grasp_.contacts()[i].preload;
      const double height = kLongestForce * to_double(preload / force_unit_);
      if (!preload.is_zero()) {
        draw_bar(svg, view_(contacts_[i].at + height * contacts_[i].normal),
                 on_page_direction(contacts_[i].normal), 8, "preload",
                 {{"data-contact", std::to_string(i)}, {"data-value", to_string(preload)}});
      }
    }
    draw_numbers(svg, view_, contacts_);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      draw_contact(svg, view_(contacts_[i].at), on_page_direction(contacts_[i].tangent),
                   states_[i], {{"data-contact", std::to_string(i)}});
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
    return std::any_of(arrows_.begin(), arrows_.end(), [&](const Arrow& arrow) {
      return arrow.css_class == css_class &&
             length(view_(arrow.tip) - view_(arrow.tail)) >= 0.01;
    });
  }

  bool has_state(ContactState state) const {
    return std::find(states_.begin(), states_.end(), state) != states_.end();
  }

  /// Returns the y of its lower end. Only what is in the picture is explained.
  double draw_legend(Svg& svg) const {
    double y = kPanelTop + 18;
    const auto row = [&](const std::string& text) {
      svg.text({kLegendText, y + 4.5}, "legend", text);
      y += kRow;
    };
    const InkPoint left{kLegendLeft, 0};
    const auto at = [&](double x) { return left + InkPoint{x, y}; };
    const auto arrow_row = [&](const std::string& css_class, const std::string& text) {
      if (!has_arrow(css_class)) return;
      draw_arrow(svg, at(2), at(48), css_class, {}, head_of(css_class));
      row(text);
    };
    const auto state_row = [&](ContactState state, const std::string& text) {
      if (!has_state(state)) return;
      draw_contact(svg, at(24), {1, 0}, state);
      row(text);
    };
    svg.open("g", {{"class", "key"}});
    if (!contacts_.empty()) {
      svg.path(SvgPath().polygon({at(4), at(48) + InkPoint{0, 8}, at(48) - InkPoint{0, 8}}),
               "cone");
      svg.line(at(4), at(40), "axis");
      draw_arrow(svg, at(40), at(48), "normal", {}, kSmallHead);
      row("normal, friction cone");
    }
    if (std::any_of(grasp_.contacts().begin(), grasp_.contacts().end(),
                    [](const Contact& c) { return !c.preload.is_zero(); })) {
      draw_bar(svg, at(26), {1, 0}, 8, "preload");
      row("preload P, on the normal");
    }
    arrow_row("force", "contact force");
    arrow_row("load", "applied force");
    if (!torque_.is_zero()) {
      draw_torque(svg, at(26), 9, torque_.sign() > 0);
      row("torque " + short_text(torque_));
    }
    if (has_forces_) {
      const double longest = view_.scale * kLongestForce;
      const Rational force = round_down(
          longest <= kLongestBar ? force_unit_
                                 : force_unit_ * rational_from_double(kLongestBar / longest));
      const double bar = longest * to_double(force / force_unit_);
      y += 4;
      svg.path(SvgPath()
                   .move(at(0) - InkPoint{0, 4})
                   .line(at(0) + InkPoint{0, 4})
                   .move(at(0))
                   .line(at(bar))
                   .move(at(bar) - InkPoint{0, 4})
                   .line(at(bar) + InkPoint{0, 4}),
               "rule scale", {{"data-value", to_string(force)}});
      svg.text(at(bar + 8) + InkPoint{0, 4.5}, "legend", "force " + short_text(force));
      y += kRow + 4;
    }
    arrow_row("motion", "motion, \u00D7\u202F" + short_text(motion_factor_));
    arrow_row("virtual", "virtual twist, \u00D7\u202F" + short_text(virtual_factor_));
    if (!ghost_.empty()) {
      svg.path(SvgPath().polygon({at(2) + InkPoint{0, 8}, at(48) + InkPoint{0, 5},
                                  at(46) - InkPoint{0, 8}, at(4) - InkPoint{0, 6}}),
               "ghost");
      row("body after the motion");
    }
    state_row(ContactState::kStick, "sticks");
    state_row(ContactState::kSlipPlus, "slips + (the way it points)");
    state_row(ContactState::kSlipMinus, "slips \u2212 (the way it points)");
    state_row(ContactState::kOpen, "open: detached");
    if (!outline_.empty()) {
      svg.path(SvgPath().polygon({at(4) + InkPoint{0, 7}, at(48) + InkPoint{0, 7},
                                  at(44) - InkPoint{0, 7}, at(8) - InkPoint{0, 7}}),
               "body");
      row("hull of contacts; body not given");
    }
    svg.close();
    return y;
  }

  std::string compose() {
    const double panel_bottom = kPanelTop + choose_view();
    const std::string name = grasp_.name().empty() ? "Grasp" : grasp_.name();
    const std::string verdict = name_of(verdict_);

    // The height is known when the legend is drawn, so the legend is drawn twice.
    Svg measure(kWidth, 1, "", "");
    const double text_top = std::max(panel_bottom, draw_legend(measure)) + 14;
    const double height = text_top + kLine * static_cast<double>(lines_.size()) + 6;

    Svg svg(kWidth, height, name + ": " + verdict, stylesheet());
    svg.text({kMargin, 34}, "title", shorten(name, 60) + ": " + verdict,
             {{"data-verdict", verdict}});
    draw_scene(svg);
    draw_legend(svg);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      svg.text({kMargin, text_top + kLine * static_cast<double>(i)}, "caption", lines_[i]);
    }
    return svg.finish();
  }

  const Question& question_;
  const Verdict& verdict_;
  const Grasp& grasp_;
  const Wrench& wrench_;
  std::vector<ContactRow> rows_;
  PictureFrame frame_;
  std::vector<ContactInk> contacts_;
  std::vector<InkPoint> outline_;
  std::vector<InkPoint> ghost_;
  std::vector<Arrow> arrows_;
  std::vector<ContactState> states_;
  std::vector<std::string> lines_;  ///< of the caption
  Rational force_unit_;             ///< has the length kLongestForce
  bool has_forces_ = false;
  Rational torque_;
  Rational motion_factor_{0};
  Rational virtual_factor_{0};
  View view_;
};

}  // namespace

std::string plot_grasp(const Question& question, const Verdict& verdict) {
  return GraspPlot(question, verdict).draw();
}

}  // namespace stickslip
