// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>
#include <optional>
#include <vector>

#include "labels.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/interfaces/states_plot.hpp"
#include "stylesheet.hpp"

namespace stickslip {

using namespace plot_detail;

namespace {

constexpr double kContactRow = 11;  ///< from a contact's signs to those of the next
constexpr double kInside = 5;       ///< between the border of a state and its signs
constexpr double kGap = 6;          ///< between states, at least
constexpr double kLayerGap = 62;
constexpr double kLeastWidth = 640;
constexpr const char* kSigns = "state tiny middle";

/// A state and its place.
struct Node {
  std::string text;                        ///< contacts with a blank between them
  std::vector<std::string> rows;           ///< the same, a contact each
  std::vector<std::optional<Sign>> signs;  ///< of all planes
  double x = 0;
  std::vector<std::size_t> below;  ///< states that its motions tend to, one dimension less
};

/// Returns whether motions with the signs of one state tend to motions of another. Signs of
/// slip do not count where a contact opens, and may be any where it then is closed.
bool tends_to(const Node& from, const Node& to) {
  for (std::size_t i = 0; i < to.signs.size(); ++i) {
    if (!from.signs[i] || to.signs[i] == Sign::kZero) continue;
    if (from.signs[i] != to.signs[i]) return false;
  }
  return true;
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c == ' ') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

/// Says what the signs of a set of states mean.
std::string meaning_of(StateSet set) {
  std::string text = "A column is a state, a line a contact";
  const bool opens = set == StateSet::kOpening || set == StateSet::kContact;
  if (opens) text += "; o: it opens";
  if (set == StateSet::kOpening) text += ", c: it stays closed";
  if (set == StateSet::kFull) text += "; before |: + moves apart, \u2212 is pressed together";
  if (set != StateSet::kOpening) {
    text += "; a sign for each line of slip: + along it, \u2212 against it, 0 neither";
  }
  return text + ". Motions of a state tend to those of states below that a line joins it to.";
}

class LayersPlot {
 public:
  LayersPlot(const GraspBox& grasp, StateSet set)
      : planes_(
            state_planes(motion_coordinates(grasp), contact_rows_for_states(grasp, {}), set)),
        title_(grasp.description.name.empty() ? "Grasp" : grasp.description.name),
        layers_(planes_.coordinates + 1) {
    find_states();
    arrange();
  }

  std::string draw() {
    const std::string what =
        planes_.set == StateSet::kOpening || planes_.set == StateSet::kContact
            ? ": contact modes"
            : ": slip states";
    Svg svg(width_, 0, title_ + what, stylesheet());
    const double room = width_ - 2 * kMargin - text_width("title", what);
    svg.text({kMargin, 34}, "title", fit(title_, "title", room) + what);
    draw_links(svg);
    draw_nodes(svg);
    double y = bottom() + kMargin;
    const auto line = [&](const std::string& text) {
      y = draw_lines(svg, {kMargin, y}, "caption", text, width_ - 2 * kMargin);
    };
    line(std::to_string(total_) + (total_ == 1 ? " state" : " states") +
         ", by the dimension of their motions: d, and how many there are.");
    line(meaning_of(planes_.set));
    svg.set_height(y);
    return svg.finish();
  }

 private:
  void find_states() {
    const FaceCounts counts =
        visit_faces(planes_.coordinates, planes_.planes, [&](const Face& face) {
          Node node;
          planes_.append_text(node.text, face);
          node.rows = words_of(node.text);
          for (std::size_t i = 0; i < planes_.planes.size(); ++i) {
            node.signs.push_back(face.sign(i));
          }
          layers_[static_cast<std::size_t>(face.dimension())].push_back(std::move(node));
          return ++total_ <= kMostStatesToDraw;
        });
    if (!counts.complete) {
      throw InputError("", "contacts",
                       "they have more than " + std::to_string(kMostStatesToDraw) + " states",
                       "draw a grasp with fewer; `stickslip states` counts any number");
    }
    for (std::size_t d = 1; d < layers_.size(); ++d) link(layers_[d], layers_[d - 1]);
  }

  static void link(std::vector<Node>& above, const std::vector<Node>& below) {
    for (Node& from : above) {
      for (std::size_t i = 0; i < below.size(); ++i) {
        if (tends_to(from, below[i])) from.below.push_back(i);
      }
    }
  }

  /// Finds the places of all states: below the middle of those that tend to them.
  void arrange() {
    std::size_t rows = 1;
    std::size_t most = 1;
    for (const std::vector<Node>& layer : layers_) {
      most = std::max(most, layer.size());
      for (const Node& node : layer) {
        rows = std::max(rows, node.rows.size());
        for (const std::string& row : node.rows) {
          node_width_ = std::max(node_width_, text_width(kSigns, row) + kInside);
        }
      }
    }
    node_height_ = static_cast<double>(rows) * kContactRow + kInside;
    left_ = 2 * kMargin + text_width("layer", "d = 12: 200");
    width_ = std::max(kLeastWidth,
                      left_ + static_cast<double>(most) * (node_width_ + kGap) + kMargin);
    for (std::size_t d = layers_.size(); d-- > 0;) {
      std::vector<Node>& layer = layers_[d];
      if (d + 1 < layers_.size()) sort_below(layers_[d + 1], layer);
      const double pitch = (width_ - kMargin - left_) / static_cast<double>(layer.size());
      for (std::size_t i = 0; i < layer.size(); ++i) {
        layer[i].x = left_ + (static_cast<double>(i) + 0.5) * pitch;
      }
    }
  }

  /// Puts the states of a layer in the order of the middles of those above that tend to them.
  static void sort_below(std::vector<Node>& above, std::vector<Node>& layer) {
    std::vector<double> sum(layer.size());
    std::vector<double> number(layer.size());
    for (const Node& from : above) {
      for (const std::size_t i : from.below) {
        sum[i] += from.x;
        number[i] += 1;
      }
    }
    const auto middle = [&](std::size_t i) { return number[i] > 0 ? sum[i] / number[i] : 0; };
    std::vector<std::size_t> order(layer.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return middle(a) < middle(b); });
    std::vector<Node> sorted;
    std::vector<std::size_t> place(layer.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      place[order[i]] = i;
      sorted.push_back(std::move(layer[order[i]]));
    }
    layer = std::move(sorted);
    for (Node& from : above) {
      for (std::size_t& i : from.below) i = place[i];
    }
  }

  /// Returns the upper end of a layer. Layers without states take no room.
  double top(std::size_t dimension) const {
    double y = kTop;
    for (std::size_t d = dimension + 1; d < layers_.size(); ++d) {
      if (!layers_[d].empty()) y += node_height_ + kLayerGap;
    }
    return y;
  }

  double bottom() const {
    const auto last =
        std::find_if(layers_.begin(), layers_.end(),
                     [](const std::vector<Node>& layer) { return !layer.empty(); });
    return top(static_cast<std::size_t>(last - layers_.begin())) + node_height_;
  }

  void draw_links(Svg& svg) const {
    for (std::size_t d = 1; d < layers_.size(); ++d) {
      for (const Node& from : layers_[d]) {
        for (const std::size_t i : from.below) {
          const Node& to = layers_[d - 1][i];
          svg.line({from.x, top(d) + node_height_}, {to.x, top(d - 1)}, "leader link",
                   {{"data-from", from.text}, {"data-to", to.text}});
        }
      }
    }
  }

  void draw_nodes(Svg& svg) const {
    for (std::size_t d = 0; d < layers_.size(); ++d) {
      if (layers_[d].empty()) continue;
      const double y = top(d);
      svg.text({kMargin, y + node_height_ / 2 + 4}, "layer",
               "d = " + std::to_string(d) + ": " + std::to_string(layers_[d].size()));
      for (const Node& node : layers_[d]) {
        const double x = node.x;
        const double half = node_width_ / 2;
        svg.path(SvgPath().polygon({{x - half, y},
                                    {x + half, y},
                                    {x + half, y + node_height_},
                                    {x - half, y + node_height_}}),
                 "hollow node",
                 {{"data-state", node.text}, {"data-dimension", std::to_string(d)}}, node.text);
        for (std::size_t i = 0; i < node.rows.size(); ++i) {
          svg.text({x, y + static_cast<double>(i + 1) * kContactRow}, kSigns, node.rows[i]);
        }
      }
    }
  }

  StatePlanes planes_;
  std::string title_;
  std::vector<std::vector<Node>> layers_;  ///< by dimension
  std::size_t total_ = 0;
  double node_width_ = 0;
  double node_height_ = 0;
  double left_ = 0;  ///< where layers begin
  double width_ = 0;
};

}  // namespace

std::string plot_states(const AnyGrasp& grasp, StateSet set) {
  const LoadedGrasp* one = grasp.single();
  if (set == StateSet::kSlip && one != nullptr) return plot_states(one->grasp);
  return LayersPlot(grasp.as_box(), set).draw();
}

}  // namespace stickslip
