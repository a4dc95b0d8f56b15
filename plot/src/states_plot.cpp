// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/plot/states_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "grasp_scene.hpp"
#include "sphere_labels.hpp"
#include "states_page.hpp"
#include "stickslip/core/error.hpp"
#include "stylesheet.hpp"
#include "upper_half.hpp"

namespace stickslip {
namespace {

constexpr double kWidth = 920;
constexpr double kHeight = 528;
constexpr double kMargin = 24;
constexpr double kLine = 19;
constexpr double kCharacter = 0.73;  ///< of the size of the font of states

/// The states of more are too long for labels.
constexpr std::size_t kMostLabelledContacts = 12;

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
    Svg svg(kWidth, kHeight, name + ": slip states", stylesheet());
    define_hatching(svg);
    svg.text({kMargin, 34}, "title", shorten(name, 70) + ": slip states");
    draw_grasp_panel(svg, grasp_);
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
  using Pieces = std::array<std::vector<InkPoint>, 2>;  ///< of a cell, by disc, on the page

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

  /// Few faces: a colour for each antipodal pair, hatched where contact 0 slips -. Many: shaded
  /// by how many contacts slip +.
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

  void draw_edges(Svg& svg) const {
    for (std::size_t i = 0; i < cells_.edges(); ++i) {
      SvgPath path;
      for (const auto& piece : pieces(EdgeId(i))) path.polyline(piece);
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

  /// A number stands on the side where its contact slips +.
  void label_circles(Svg& svg) {
    constexpr double kOff = 10;
    const std::vector<CircleSpot> spots = circle_spots(cells_, upper_half_);
    for (std::size_t c = 0; c < spots.size(); ++c) {
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
        const double half_width = 3.7 * static_cast<double>(text.size());
        for (std::size_t disc = 0; disc < 2; ++disc) {
          // At the same place of the other disc is the opposite motion.
          const double sign = (disc == 0 ? 1 : -1) * to_int(side);
          const InkPoint off = sign * on_page_direction(spots[c].to_positive);
          const double push = kOff + std::abs(off.x) * (half_width - 3.7);
          const InkPoint at = kDiscs[disc](spots[c].at) + push * off;
          taken_.push_back({at, {half_width + 2, 8}});
          svg.text(at + InkPoint{0, 4.5}, "number middle halo", text);
        }
      }
    }
  }

  /// Each visible part of a face, where there is room.
  void label_faces(Svg& svg) {
    if (grasp_.size() == 0 || grasp_.size() > kMostLabelledContacts) return;
    const auto characters = static_cast<double>(grasp_.size());
    for (std::size_t i = 0; i < face_pieces_.size(); ++i) {
      const std::string state = typeset(to_string(face_states_[i]));
      bool is_labelled = false;
      for (const std::vector<InkPoint>& piece : face_pieces_[i]) {
        for (const int size : {15, 13, 11, 9}) {
          const InkPoint half{characters * kCharacter * size / 2 + 2, 0.4 * size + 1};
          const auto place = room_for(half, piece, taken_);
          if (!place) continue;
          taken_.push_back({*place, half});
          svg.text(*place + InkPoint{0, 0.35 * size}, "state middle halo", state,
                   {{"style", "font-size: " + std::to_string(size) + "px"}});
          is_labelled = true;
          break;
        }
      }
      if (is_labelled) ++labelled_;
    }
  }

  void draw_caption(Svg& svg) const {
    double y = kDiscMiddle + kDiscRadius + 42;
    const auto line = [&](const std::string& text) {
      svg.text({kMargin, y}, "caption", text);
      y += kLine;
    };
    const ArrangementCounts& c = cells_.counts();
    line(counts_text(c));
    line(
        "A point is the motion that turns the object about it; one place in both discs is d "
        "and \u2212d. On the rim: translations (arrows).");
    line("Dotted ring: centres of rotation at distance " + short_text(frame_.radius) +
         " from " + short_tuple({frame_.centre.x, frame_.centre.y}) +
         ", the middle of the discs.");
    line("Equal areas of the discs are equal shares of the sphere.");
    if (c.planes == 0) return;
    line(
        "On a circle, the contacts it is numbered with stick. A number stands on the side "
        "where its contact slips +.");
    if (has_hues_) {
      line(std::string("One colour: opposite states. Hatched: contact 0 slips \u2212. ") +
           (labelled_ == c.faces ? "Labels: the signs of contacts 0, 1, \u2026"
                                 : "Tooltips have the states without a label."));
    } else {
      double x = kMargin;
      for (int i = 0; i < kShades; ++i, x += 22) {
        svg.path(
            SvgPath().polygon({{x, y - 11}, {x + 22, y - 11}, {x + 22, y + 2}, {x, y + 2}}),
            "swatch shade" + std::to_string(i));
      }
      svg.text({x + 10, y}, "caption",
               "0 to " + std::to_string(c.planes) + " contacts slip +, the others \u2212");
    }
  }

  PictureFrame frame_;
  Grasp grasp_;  ///< in the scene
  ArrangementStructure cells_;
  UpperHalf upper_half_;
  bool has_hues_;
  std::vector<SlipState> face_states_;
  std::vector<Pieces> face_pieces_;
  std::vector<Box> taken_;  ///< by labels
  std::size_t labelled_ = 0;
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
