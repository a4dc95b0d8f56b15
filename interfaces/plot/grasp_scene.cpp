// SPDX-License-Identifier: GPL-3.0-or-later
#include "grasp_scene.hpp"

#include <algorithm>

#include "marks.hpp"

namespace stickslip::plot_detail {
namespace {

constexpr double kBehindFinger = 25;     ///< pixels from a contact to its number
constexpr double kFinger = 13;           ///< half its length, in pixels
constexpr double kLabelDistance = 12;    ///< pixels; nearer numbers share a label
constexpr std::size_t kMostNumbers = 3;  ///< the most numbers of one label

double cross(InkPoint a, InkPoint b) {
  return a.x * b.y - a.y * b.x;
}
double dot(InkPoint a, InkPoint b) {
  return a.x * b.x + a.y * b.y;
}

std::vector<InkPoint> hull_of(const std::vector<ContactInk>& contacts) {
  std::vector<InkPoint> points;
  for (const ContactInk& c : contacts) points.push_back(c.at);
  const auto is_behind = [](InkPoint p, const ContactInk& c) {
    return dot(p - c.at, c.normal) < 0;
  };
  for (const ContactInk& c : contacts) {
    for (const InkPoint inside : {InkPoint{0.12, 0.3}, {0.5, 0.4}}) {
      for (const double side : {-1.0, 1.0}) {
        const InkPoint p = c.at + inside.x * c.normal + side * inside.y * c.tangent;
        if (std::none_of(contacts.begin(), contacts.end(),
                         [&](const ContactInk& other) { return is_behind(p, other); })) {
          points.push_back(p);
        }
      }
    }
  }
  return convex_hull(std::move(points));
}

/// Draws a finger that holds a contact: a short hatched line behind it. `inwards` has length 1.
void draw_finger(Svg& svg, InkPoint at, InkPoint inwards) {
  constexpr double kHalfLength = 13;
  const InkPoint along = quarter_turn(inwards);
  const InkPoint base = at - 5.0 * inwards;
  SvgPath path;
  path.move(base - kHalfLength * along).line(base + kHalfLength * along);
  for (int i = -2; i <= 2; ++i) {
    const InkPoint from = base + (5.0 * i + 2) * along;
    path.move(from).line(from - 6.0 * inwards - 4.0 * along);
  }
  svg.path(path, "finger");
}

}  // namespace

// The algorithm is Andrew's monotone chain.
std::vector<InkPoint> convex_hull(std::vector<InkPoint> points) {
  std::sort(points.begin(), points.end(),
            [](InkPoint a, InkPoint b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<InkPoint> hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t start = hull.size();
    for (const InkPoint& p : points) {
      while (hull.size() >= start + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

std::vector<ContactInk> contact_ink(const Grasp& grasp, const PictureFrame& frame) {
  std::vector<ContactInk> contacts;
  for (const Contact& c : grasp.contacts()) {
    const InkPoint normal = direction(c.normal);
    contacts.push_back({frame.place(c.position), normal, quarter_turn(normal)});
  }
  return contacts;
}

std::vector<std::vector<InkPoint>> body_outline(const Grasp& grasp, const PictureFrame& frame,
                                                const std::vector<ContactInk>& contacts) {
  std::vector<std::vector<InkPoint>> rings;
  for (const Polygon& polygon : grasp.description().outline) {
    for (const Ring& ring : polygon) {
      rings.emplace_back();
      for (const Vector2& vertex : ring) rings.back().push_back(frame.place(vertex));
    }
  }
  if (rings.empty() && !contacts.empty()) rings.push_back(hull_of(contacts));
  return rings;
}

std::vector<InkPoint> on_page(const View& view, std::vector<InkPoint> scene) {
  for (InkPoint& p : scene) p = view(p);
  return scene;
}

void draw_body(Svg& svg, const View& view, const std::vector<std::vector<InkPoint>>& rings,
               RingsAround around, const std::string& css_class) {
  SvgPath path;
  for (const std::vector<InkPoint>& ring : rings) path.polygon(on_page(view, ring));
  Svg::Attributes attributes;
  if (rings.size() > 1 && around == RingsAround::kOddTimes) {
    attributes.emplace_back("fill-rule", "evenodd");
  }
  svg.path(path, css_class, attributes);
}

InkPoint on_page_direction(InkPoint scene) {
  return {scene.x, -scene.y};
}

std::string list_numbers(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i == kMostNumbers) return text + ", \u2026";
    text += (i == 0 ? "" : ", ") + std::to_string(numbers[i]);
  }
  return text;
}

void draw_fingers(Svg& svg, const View& view, const std::vector<ContactInk>& contacts) {
  for (const ContactInk& c : contacts) {
    if (c.is_grounded && length(c.normal) > 0.99)
      draw_finger(svg, view(c.at), on_page_direction(c.normal));
  }
}

std::size_t draw_numbers(Svg& svg, const View& view, const std::vector<ContactInk>& contacts,
                         LabelPlacer& labels) {
  struct Label {
    InkPoint at;
    InkPoint contact;
    std::vector<std::size_t> contacts;
  };
  std::vector<Label> numbers;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const InkPoint contact = view(contacts[i].at);
    const InkPoint inwards = on_page_direction(contacts[i].normal);
    const InkPoint along = kFinger * quarter_turn(inwards);
    labels.avoid(contact - 8.0 * inwards - along, contact - 8.0 * inwards + along);
    labels.avoid(contact - 3.0 * inwards, contact + 3.0 * inwards);
    const InkPoint behind = contact - kBehindFinger * inwards;
    const auto near = std::find_if(numbers.begin(), numbers.end(), [&](const Label& label) {
      return length(label.at - behind) < kLabelDistance;
    });
    if (near != numbers.end()) {
      near->contacts.push_back(i);
    } else {
      numbers.push_back({behind, contact, {i}});
    }
  }
  std::size_t left_out = 0;
  for (const Label& label : numbers) {
    const std::string text = list_numbers(label.contacts);
    std::vector<LabelPlace> places = places_around(label.contact, kBehindFinger - 8,
                                                   label.at - label.contact, "number", text);
    if (!labels.place(svg, "number halo", text, places, &label.contact)) {
      left_out += label.contacts.size();
    }
  }
  return left_out;
}

}  // namespace stickslip::plot_detail
