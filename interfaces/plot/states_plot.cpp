// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/states_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "grasp_scene.hpp"
#include "marks.hpp"
#include "stickslip/core/error.hpp"
#include "stylesheet.hpp"
#include "upper_half.hpp"

namespace stickslip {

using namespace plot_detail;

namespace {

constexpr double kStatesWidth = 920;
constexpr double kDiscMiddle = 238;  ///< y of the discs and of the grasp
constexpr double kDiscRadius = 148;

/// The views of counterclockwise and of clockwise motions: r > 0 and r < 0.
constexpr std::array<View, 2> kDiscs{View{{412, kDiscMiddle}, kDiscRadius},
                                     View{{750, kDiscMiddle}, kDiscRadius}};
constexpr View kGraspView{{122, kDiscMiddle}, 66};
constexpr double kHalfPanel = 98;

/// The places of a number on its circle, from the rim on.
constexpr int kSpots = 48;
constexpr int kFirstSpot = 5;

/// The states of more contacts are too long for labels.
constexpr std::size_t kMostLabelledContacts = 12;

/// Draws the contacts and the lines along their tangents: the centres of rotation about which
/// they stick. `grasp` is in scene coordinates. Returns how many contacts found no room for
/// numbers.
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
  draw_body(svg, kGraspView, body_outline(grasp, {}, contacts), RingsAround::kOddTimes, "body");
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

/// Returns "3 contacts on 3 circles, rank 3: ...".
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

/// Draws the motions that turn about points at distance 1 in the scene.
void draw_rings(Svg& svg) {
  const double ring = length(project({std::sqrt(0.5), 0, std::sqrt(0.5)}));
  for (const View& disc : kDiscs) svg.circle(disc.origin, kDiscRadius * ring, "ring");
}

/// Draws the rims, the headings of the discs, and the translations on the rims.
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

class StatesPlot {
 public:
  explicit StatesPlot(const Grasp& grasp)
      : frame_(picture_frame(grasp)),
        grasp_(frame_.in_scene(grasp)),
        cells_(stick_planes(grasp_)),
        upper_half_(cells_),
        has_hues_(cells_.faces() <= 2 * kHues) {}

  std::string draw() {
    const std::string name = grasp_.name().empty() ? "Grasp" : grasp_.name();
    const std::string what = ": slip states";
    Svg svg(kStatesWidth, 0, name + what, stylesheet());
    define_hatching(svg);
    const double room = kStatesWidth - 2 * kMargin - text_width("title", what);
    svg.text({kMargin, 34}, "title", fit(name, "title", room) + what);
    left_out_ = draw_grasp_panel(svg, grasp_);
    svg.open("g",
             {{"class", has_hues_ ? "cells" : "cells thin"},
              {"data-centre", to_string(frame_.centre.x) + "," + to_string(frame_.centre.y)},
              {"data-radius", to_string(frame_.radius)}});
    draw_faces(svg);
    draw_rings(svg);
    draw_edges(svg);
    draw_vertices(svg);
    svg.close();
    draw_rims(svg);
    label_circles(svg);
    label_faces(svg);
    draw_caption(svg);
    return svg.finish();
  }

 private:
  using Pieces = std::array<std::vector<InkPoint>, 2>;  ///< the pieces of a cell, by disc, on
                                                        ///< the page

  static std::vector<InkPoint> on_disc(std::size_t disc,
                                       const std::vector<SpherePoint>& points) {
    std::vector<InkPoint> page;
    for (const SpherePoint& p : points) page.push_back(kDiscs[disc](project(p)));
    return page;
  }

  Pieces pieces(FaceId face) const {
    return {on_disc(0, upper_half_.face(face)),
            on_disc(1, upper_half_.face(cells_.antipode(face)))};
  }
  Pieces pieces(EdgeId edge) const {
    return {on_disc(0, upper_half_.edge(edge)),
            on_disc(1, upper_half_.edge(cells_.antipode(edge)))};
  }

  /// Returns the fills of faces. Few faces have a colour for each antipodal pair, hatched where
  /// contact 0 slips -; many are shaded by how many contacts slip +.
  std::vector<std::string> face_fills(const std::vector<SlipState>& states) const {
    std::vector<std::string> fills;
    std::map<SlipState, int> hues;
    for (const SlipState& state : states) {
      if (has_hues_) {
        const bool is_hatched = !state.empty() && state[0] == Sign::kNegative;
        SlipState key = state;
        if (is_hatched) {
          for (Sign& sign : key) sign = -sign;
        }
        const int hue = hues.emplace(key, static_cast<int>(hues.size())).first->second;
        fills.push_back((is_hatched ? "hatch" : "hue") + std::to_string(hue));
      } else {
        const auto plus = std::count(state.begin(), state.end(), Sign::kPositive);
        const auto contacts = static_cast<std::ptrdiff_t>(state.size());
        fills.push_back("shade" + std::to_string(plus * (kShades - 1) / contacts));
      }
    }
    return fills;
  }

  void draw_faces(Svg& svg) {
    for (std::size_t i = 0; i < cells_.faces(); ++i) {
      face_states_.push_back(cells_.signs(FaceId(i)));
      face_pieces_.push_back(pieces(FaceId(i)));
    }
    const std::vector<std::string> fills = face_fills(face_states_);
    for (std::size_t i = 0; i < cells_.faces(); ++i) {
      SvgPath path;
      for (const auto& piece : face_pieces_[i]) path.polygon(piece);
      const std::string state = to_string(face_states_[i]);
      svg.path(path, "face " + fills[i], {{"data-state", state}}, typeset(state));
    }
  }

  void draw_edges(Svg& svg) {
    for (std::size_t i = 0; i < cells_.edges(); ++i) {
      SvgPath path;
      for (const auto& piece : pieces(EdgeId(i))) {
        path.polyline(piece);
        labels_.avoid(piece);
      }
      const std::string state = to_string(cells_.signs(EdgeId(i)));
      svg.path(path, "edge", {{"data-state", state}}, typeset(state));
    }
  }

  void draw_vertices(Svg& svg) const {
    const double radius = has_hues_ ? 3.2 : 1.3;
    for (std::size_t i = 0; i < cells_.vertices(); ++i) {
      const VertexId vertex(i);
      SvgPath path;
      if (upper_half_.height(vertex) != Sign::kNegative) {
        path.circle(kDiscs[0](project(upper_half_.place(vertex))), radius);
      }
      if (upper_half_.height(vertex) != Sign::kPositive) {
        path.circle(kDiscs[1](project(upper_half_.place(cells_.antipode(vertex)))), radius);
      }
      const std::string state = to_string(cells_.signs(vertex));
      svg.path(path, "vertex", {{"data-state", state}}, typeset(state));
    }
  }

  /// Writes the number of each contact on the side where it slips +.
  void label_circles(Svg& svg) {
    for (std::size_t c = 0; c < cells_.circles().normals.size(); ++c) {
      for (const Sign side : {Sign::kPositive, Sign::kNegative}) {
        std::vector<std::size_t> contacts;
        for (std::size_t i = 0; i < grasp_.size(); ++i) {
          if (cells_.circles().circle[i] == CircleId(c) &&
              cells_.circles().orientation[i] == side) {
            contacts.push_back(i);
          }
        }
        if (contacts.empty()) continue;
        const std::string text = list_numbers(contacts);
        for (std::size_t disc = 0; disc < 2; ++disc) {
          if (!labels_.place(svg, "number halo", text,
                             places_beside(CircleId(c), side, disc, text))) {
            ++left_out_;
          }
        }
      }
    }
  }

  std::vector<LabelPlace> places_beside(CircleId circle, Sign side, std::size_t disc,
                                        const std::string& text) const {
    constexpr double kOff = 10;
    constexpr double kStep = 0.01;
    const double half_width = text_width("number", text) / 2;
    std::vector<LabelPlace> places;
    for (int i = kFirstSpot; i <= kSpots / 2; ++i) {
      for (const int step : {i, kSpots - i}) {
        const double angle = M_PI * step / kSpots;
        const auto at = [&](double a) { return project(upper_half_.on_circle(circle, a)); };
        // The positive side is to the left. At the same place of the other disc is the opposite
        // motion.
        const double sign = (disc == 0 ? 1 : -1) * to_int(side);
        const InkPoint off =
            sign * on_page_direction(quarter_turn(unit(at(angle + kStep) - at(angle - kStep))));
        const double push = kOff + std::abs(off.x) * std::max(0.0, half_width - 4);
        places.push_back({kDiscs[disc](at(angle)) + push * off});
      }
    }
    return places;
  }

  /// Labels each visible part of a face, if there is room.
  void label_faces(Svg& svg) {
    if (grasp_.size() == 0 || grasp_.size() > kMostLabelledContacts) return;
    for (std::size_t i = 0; i < face_pieces_.size(); ++i) {
      const std::string state = typeset(to_string(face_states_[i]));
      bool is_labelled = false;
      for (const std::vector<InkPoint>& piece : face_pieces_[i]) {
        for (const char* css_class :
             {"state halo large", "state halo", "state halo small", "state halo tiny"}) {
          if (labels_.place(svg, css_class, state, places_inside(piece, css_class, state))) {
            is_labelled = true;
            break;
          }
        }
      }
      if (is_labelled) ++labelled_;
    }
  }

  void draw_caption(Svg& svg) const {
    double y = kDiscMiddle + kDiscRadius + 42;
    const auto line = [&](const std::string& text) {
      y = draw_lines(svg, {kMargin, y}, "caption", text, kStatesWidth - 2 * kMargin);
    };
    const ArrangementCounts& c = cells_.counts();
    line(counts_text(c));
    line(
        "A point is the motion that turns the object about it; one place in both discs is d "
        "and \u2212d. On the rim: translations (arrows). Dotted ring: centres of rotation at "
        "distance " +
        short_text(frame_.radius) + length_unit(grasp_.description().units) + " from " +
        short_tuple({frame_.centre.x, frame_.centre.y}) +
        ", the middle of the discs. Equal areas of the discs are equal shares of the sphere.");
    if (c.planes > 0) {
      line(
          std::string("On a circle, the contacts it is numbered with stick. A number stands on "
                      "the side where its contact slips +.") +
          (left_out_ > 0 ? " Some numbers found no room; tooltips have all states." : ""));
      draw_key(svg, y);
    }
    svg.set_height(y);
  }

  /// Draws the key of the faces' colours, from the baseline y on.
  void draw_key(Svg& svg, double& y) const {
    double x = kMargin;
    std::string text;
    if (has_hues_) {
      text = std::string("One colour: opposite states. Hatched: contact 0 slips \u2212. ") +
             (labelled_ == cells_.faces() ? "Labels: the signs of contacts 0, 1, \u2026"
                                          : "Tooltips have the states without a label.");
    } else {
      for (int i = 0; i < kShades; ++i, x += 22) {
        svg.path(
            SvgPath().polygon({{x, y - 11}, {x + 22, y - 11}, {x + 22, y + 2}, {x, y + 2}}),
            "swatch shade" + std::to_string(i));
      }
      x += 10;
      text = "0 to " + std::to_string(grasp_.size()) + " contacts slip +, the others \u2212";
    }
    y = draw_lines(svg, {x, y}, "caption", text, kStatesWidth - kMargin - x);
  }

  PictureFrame frame_;
  Grasp grasp_;  ///< the grasp in the scene
  ArrangementStructure cells_;
  UpperHalf upper_half_;
  bool has_hues_;
  std::vector<SlipState> face_states_;
  std::vector<Pieces> face_pieces_;
  LabelPlacer labels_{{kDiscs[0].origin - InkPoint{kDiscRadius + 8, kDiscRadius + 8},
                       kDiscs[1].origin + InkPoint{kDiscRadius + 8, kDiscRadius + 8}}};
  std::size_t labelled_ = 0;  ///< faces with a label
  std::size_t left_out_ = 0;  ///< numbers without room
};

}  // namespace

std::string plot_states(const Grasp& grasp) {
  const std::size_t circles = merge_planes(stick_planes(grasp)).normals.size();
  if (circles > kMostCirclesToDraw) {
    throw InputError("", "contacts",
                     "their " + std::to_string(circles) + " circles are too many to draw",
                     "draw a grasp with at most " + std::to_string(kMostCirclesToDraw) +
                         " circles; `stickslip states` counts the cells of any number");
  }
  return StatesPlot(grasp).draw();
}

}  // namespace stickslip
