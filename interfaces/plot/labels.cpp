// SPDX-License-Identifier: GPL-3.0-or-later
#include "labels.hpp"

#include <algorithm>
#include <cmath>

namespace stickslip::plot_detail {
namespace {

constexpr double kLineHeight = 1.45;  ///< the line height in sizes of the font
constexpr double kAscent = 0.8;
constexpr double kDescent = 0.26;
constexpr double kBold = 1.25;       ///< the width over that of the regular font
constexpr double kMonospace = 0.73;  ///< a character, with the letter spacing of states
constexpr double kApart = 2;         ///< pixels around a label
constexpr double kInkStep = 5;       ///< pixels between the points that stand for a line
constexpr int kDirections = 16;
constexpr int kRings = 8;
constexpr double kRing = 11;        ///< pixels from one to the next
constexpr double kTurnCost = 0.2;   ///< the cost of each direction tried before, in points of
                                    ///< ink
constexpr double kRingCost = 2;     ///< points of covered ink
constexpr int kPlaces = 16;         ///< the places tried in each direction of a polygon
constexpr double kAwayCost = 0.05;  ///< the cost of each pixel from its middle
constexpr double kAdjacent = 22;    ///< pixels; labels further away get a line
constexpr double kBehindCost = 12;  ///< the cost of each line between a label and its anchor

/// The widths of the characters from blank to tilde, in hundredths of the size of the font.
constexpr unsigned char kWidths[] = {
    32, 40, 46, 84, 64, 95, 78, 28, 39, 39, 50, 84, 32, 36,  32, 34, 64, 64, 64,
    64, 64, 64, 64, 64, 64, 64, 34, 34, 84, 84, 84, 56, 102, 69, 69, 73, 77, 67,
    61, 78, 76, 30, 50, 67, 56, 87, 75, 79, 67, 79, 73, 67,  61, 74, 69, 99, 69,
    67, 69, 39, 34, 39, 84, 56, 50, 62, 64, 55, 64, 62, 36,  64, 64, 28, 28, 58,
    28, 98, 64, 62, 64, 64, 42, 52, 40, 64, 60, 82, 60, 60,  53, 64, 34, 64, 84};

bool has_class(const std::string& css_class, const std::string& name) {
  return (" " + css_class + " ").find(" " + name + " ") != std::string::npos;
}

double font_size(const std::string& css_class) {
  if (has_class(css_class, "title")) return 18;
  if (has_class(css_class, "large")) return 15;
  if (has_class(css_class, "small")) return 11;
  if (has_class(css_class, "tiny")) return 9;
  return 13;
}

/// Returns the bytes of the UTF-8 character at the start of a text that is not empty.
std::size_t character_size(std::string_view text) {
  std::size_t size = 1;
  while (size < text.size() && (static_cast<unsigned char>(text[size]) & 0xC0) == 0x80) ++size;
  return size;
}

/// Returns the width in sizes of the font.
double character_width(std::string_view character) {
  if (character.size() > 3) return 1.4;  // emoji are wider than their square
  const char first = character[0];
  if (first >= ' ' && first <= '~') return kWidths[first - ' '] / 100.0;
  return character == "\u202F" ? 0.35 : character == "\u2212" ? 0.84 : 1.03;
}

bool contains(const std::vector<InkPoint>& polygon, InkPoint p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const InkPoint a = polygon[i];
    const InkPoint b = polygon[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) {
      inside = !inside;
    }
  }
  return inside;
}

std::vector<InkPoint> points_on(InkPoint from, InkPoint to) {
  std::vector<InkPoint> points;
  const int steps = 1 + static_cast<int>(length(to - from) / kInkStep);
  for (int k = 0; k <= steps; ++k) {
    points.push_back(from + (static_cast<double>(k) / steps) * (to - from));
  }
  return points;
}

InkPoint nearest_in(const Box& box, InkPoint p) {
  return {std::clamp(p.x, box.low.x, box.high.x), std::clamp(p.y, box.low.y, box.high.y)};
}

/// Returns the line to a label that is not next to its anchor; empty if it is next to it.
std::vector<InkPoint> leader(InkPoint anchor, const Box& box) {
  const InkPoint near = nearest_in(box, anchor);
  if (length(near - anchor) <= kAdjacent) return {};
  return points_on(anchor, near);
}

/// Returns true if two lines cross, ends excluded.
bool cross_each_other(InkPoint a, InkPoint b, InkPoint c, InkPoint d) {
  const auto side = [](InkPoint from, InkPoint to, InkPoint p) {
    return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

InkPoint middle_of(const Box& box) {
  return 0.5 * (box.low + box.high);
}

}  // namespace

bool overlap(const Box& a, const Box& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

bool crosses(InkPoint from, InkPoint to, const Box& box) {
  // begin and end: the part of the line that is within the box along each axis (Liang and
  // Barsky).
  double begin = 0;
  double end = 1;
  const auto cut = [&](double start, double step, double low, double high) {
    if (step == 0) {
      if (start <= low || start >= high) end = -1;
      return;
    }
    const double a = (low - start) / step;
    const double b = (high - start) / step;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  };
  cut(from.x, to.x - from.x, box.low.x, box.high.x);
  cut(from.y, to.y - from.y, box.low.y, box.high.y);
  return begin < end;
}

bool contains(const Box& outer, const Box& inner) {
  return outer.low.x <= inner.low.x && inner.high.x <= outer.high.x &&
         outer.low.y <= inner.low.y && inner.high.y <= outer.high.y;
}

double text_width(const std::string& css_class, std::string_view text) {
  double width = 0;
  const bool is_monospace = has_class(css_class, "state");
  while (!text.empty()) {
    const std::size_t size = character_size(text);
    width += is_monospace ? kMonospace : character_width(text.substr(0, size));
    text.remove_prefix(size);
  }
  return width * font_size(css_class) * (has_class(css_class, "title") ? kBold : 1);
}

Box text_box(InkPoint at, const std::string& css_class, std::string_view text) {
  const double width = text_width(css_class, text);
  const double size = font_size(css_class);
  const double left = has_class(css_class, "middle") ? width / 2
                      : has_class(css_class, "end")  ? width
                                                     : 0;
  return {at - InkPoint{left, kAscent * size}, at + InkPoint{width - left, kDescent * size}};
}

std::string fit(const std::string& text, const std::string& css_class, double width) {
  if (text_width(css_class, text) <= width) return text;
  const std::string rest = "\u2026";
  std::string begin;
  while (begin.size() < text.size()) {
    const std::string_view tail = std::string_view(text).substr(begin.size());
    const std::string longer = begin + std::string(tail.substr(0, character_size(tail)));
    if (text_width(css_class, longer + rest) > width) break;
    begin = longer;
  }
  return begin + rest;
}

std::vector<std::string> wrap(const std::string& text, const std::string& css_class,
                              double width) {
  std::vector<std::string> lines;
  std::string line;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t blank = at;
    for (int open = 0; blank < text.size() && (open > 0 || text[blank] != ' '); ++blank) {
      open += text[blank] == '(' ? 1 : text[blank] == ')' ? -1 : 0;
    }
    const std::string word = text.substr(at, blank - at);
    const std::string longer = line.empty() ? word : line + " " + word;
    at = blank + 1;
    if (text_width(css_class, longer) <= width) {
      line = longer;
      continue;
    }
    if (!line.empty()) lines.push_back(std::move(line));
    line.clear();
    for (std::size_t k = 0; k < word.size();) {
      const std::string_view tail = std::string_view(word).substr(k);
      const std::string character(tail.substr(0, character_size(tail)));
      if (!line.empty() && text_width(css_class, line + character) > width) {
        lines.push_back(std::move(line));
        line.clear();
      }
      line += character;
      k += character.size();
    }
  }
  if (!line.empty()) lines.push_back(std::move(line));
  return lines;
}

double draw_lines(Svg& svg, InkPoint at, const std::string& css_class, const std::string& text,
                  double width) {
  for (const std::string& line : wrap(text, css_class, width)) {
    svg.text(at, css_class, line);
    at.y += kLineHeight * font_size(css_class);
  }
  return at.y;
}

std::vector<LabelPlace> places_around(InkPoint point, double gap, InkPoint first,
                                      const std::string& css_class, std::string_view text) {
  const Box box = text_box({}, css_class, text);
  const InkPoint half = 0.5 * (box.high - box.low);
  const auto edge = [](double share) { return std::clamp(1.5 * share, -1.0, 1.0); };
  std::vector<LabelPlace> places;
  for (int ring = 0; ring < kRings; ++ring) {
    for (int k = 0; k < kDirections; ++k) {
      // Turns go alternately to both sides of the first direction.
      const int turn = k % 2 == 0 ? -k / 2 : (k + 1) / 2;
      const double angle = std::atan2(first.y, first.x) + 2 * M_PI * turn / kDirections;
      const InkPoint out{std::cos(angle), std::sin(angle)};
      places.push_back({point + (gap + kRing * ring) * out +
                            InkPoint{half.x * edge(out.x), half.y * edge(out.y)},
                        kRingCost * ring + kTurnCost * k});
    }
  }
  return places;
}

std::vector<LabelPlace> places_inside(const std::vector<InkPoint>& polygon,
                                      const std::string& css_class, std::string_view text) {
  std::vector<LabelPlace> places;
  if (polygon.empty()) return places;
  const Box box = text_box({}, css_class, text);
  const InkPoint half = 0.5 * (box.high - box.low);
  InkPoint low = polygon.front();
  InkPoint high = low;
  InkPoint middle;
  for (const InkPoint& p : polygon) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    middle = middle + 1.0 / static_cast<double>(polygon.size()) * p;
  }
  const auto try_place = [&](InkPoint at) {
    for (const double x : {-1.0, 0.0, 1.0}) {
      for (const double y : {-1.0, 0.0, 1.0}) {
        if (!contains(polygon, at + InkPoint{x * half.x, y * half.y})) return;
      }
    }
    places.push_back({at, kAwayCost * length(at - middle)});
  };
  try_place(middle);
  for (int i = 0; i <= kPlaces; ++i) {
    for (int j = 0; j <= kPlaces; ++j) {
      try_place(
          {low.x + (high.x - low.x) * i / kPlaces, low.y + (high.y - low.y) * j / kPlaces});
    }
  }
  return places;
}

void LabelPlacer::avoid(InkPoint from, InkPoint to) {
  for (const InkPoint& p : points_on(from, to)) ink_.push_back(p);
}

void LabelPlacer::avoid(const std::vector<InkPoint>& line) {
  for (std::size_t k = 1; k < line.size(); ++k) avoid(line[k - 1], line[k]);
}

bool LabelPlacer::is_taken(const Box& box) const {
  return std::any_of(taken_.begin(), taken_.end(),
                     [&](const Box& other) { return overlap(other, box); }) ||
         std::any_of(lines_.begin(), lines_.end(),
                     [&](const Line& line) { return crosses(line.from, line.to, box); });
}

bool LabelPlacer::place(Svg& svg, const std::string& css_class, const std::string& text,
                        const std::vector<LabelPlace>& places, const InkPoint* anchor) {
  const std::string centred = css_class + " middle";
  const Box origin = text_box({}, centred, text);
  const InkPoint apart{kApart, kApart};
  const LabelPlace* best = nullptr;
  double least = 0;
  Box best_box;
  for (const LabelPlace& place : places) {
    const InkPoint shift = place.middle - middle_of(origin);
    const Box box{origin.low + shift - apart, origin.high + shift + apart};
    if (!contains(frame_, box) || is_taken(box)) continue;
    const std::vector<InkPoint> line =
        anchor == nullptr ? std::vector<InkPoint>{} : leader(*anchor, box);
    if (std::any_of(line.begin(), line.end(), [&](InkPoint p) { return is_taken({p, p}); }))
      continue;
    const auto covered = std::count_if(ink_.begin(), ink_.end(), [&](InkPoint p) {
      return contains(box, {p, p});
    });
    const auto between = std::count_if(lines_.begin(), lines_.end(), [&](const Line& l) {
      return anchor != nullptr &&
             cross_each_other(*anchor, nearest_in(box, *anchor), l.from, l.to);
    });
    const double cost =
        place.cost + static_cast<double>(covered) + kBehindCost * static_cast<double>(between);
    if (best != nullptr && cost >= least) continue;
    best = &place;
    best_box = box;
    least = cost;
  }
  if (best == nullptr) return false;
  taken_.push_back(best_box);
  if (anchor != nullptr) {
    const std::vector<InkPoint> line = leader(*anchor, best_box);
    if (!line.empty()) svg.line(line.front(), line.back(), "leader");
    for (const InkPoint& p : line) taken_.push_back({p, p});
  }
  svg.text(best->middle - middle_of(origin), centred, text);
  return true;
}

}  // namespace stickslip::plot_detail
