// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/svg.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

constexpr double kLargest = 1e9;
constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

/// Returns the length of the UTF-8 sequence that `text` starts with if it spells a character of
/// XML 1.0; otherwise 0.
std::size_t xml_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' ? 1 : 0;
  const std::size_t size = first < 0xC2   ? 0
                           : first < 0xE0 ? 2
                           : first < 0xF0 ? 3
                           : first < 0xF5 ? 4
                                          : 0;
  if (size == 0 || text.size() < size) return 0;
  std::uint32_t code = first & (0xFFU >> (size + 1));
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3F);
  }
  constexpr std::uint32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_character = code >= kSmallest[size] && code <= 0x10FFFF &&
                            (code < 0xD800 || code > 0xDFFF) && code != 0xFFFE &&
                            code != 0xFFFF;
  return is_character ? size : 0;
}

}  // namespace

double length(InkPoint v) {
  return std::hypot(v.x, v.y);
}

InkPoint unit(InkPoint v) {
  const double size = length(v);
  return size > 0 ? (1 / size) * v : InkPoint{1, 0};
}

InkPoint quarter_turn(InkPoint v) {
  return {-v.y, v.x};
}

std::string svg_number(double value) {
  require(std::abs(value) <= kLargest, "svg: a position is not a number, or off the page");
  char buffer[32];
  const auto result =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, 2);
  std::string text(buffer, result.ptr);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string svg_escape(std::string_view text) {
  std::string escaped;
  while (!text.empty()) {
    const std::size_t size = xml_character(text);
    if (size == 0) {
      escaped += kReplacement;
    } else if (text[0] == '&') {
      escaped += "&amp;";
    } else if (text[0] == '<') {
      escaped += "&lt;";
    } else if (text[0] == '>') {
      escaped += "&gt;";
    } else if (text[0] == '"') {
      escaped += "&quot;";
    } else if (text[0] == '\n' || text[0] == '\t') {
      escaped += ' ';
    } else {
      escaped += text.substr(0, size);
    }
    text.remove_prefix(size == 0 ? 1 : size);
  }
  return escaped;
}

SvgPath& SvgPath::move(InkPoint to) {
  data_ += "M" + svg_number(to.x) + " " + svg_number(to.y);
  return *this;
}

SvgPath& SvgPath::line(InkPoint to) {
  data_ += "L" + svg_number(to.x) + " " + svg_number(to.y);
  return *this;
}

SvgPath& SvgPath::close() {
  data_ += "Z";
  return *this;
}

SvgPath& SvgPath::polyline(const std::vector<InkPoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) i == 0 ? move(points[i]) : line(points[i]);
  return *this;
}

SvgPath& SvgPath::polygon(const std::vector<InkPoint>& points) {
  return points.empty() ? *this : polyline(points).close();
}

SvgPath& SvgPath::circle(InkPoint centre, double radius) {
  const std::string arc = "A" + svg_number(radius) + " " + svg_number(radius) + " 0 1 1 ";
  const std::string y = " " + svg_number(centre.y);
  data_ += "M" + svg_number(centre.x - radius) + y + arc + svg_number(centre.x + radius) + y +
           arc + svg_number(centre.x - radius) + y + "Z";
  return *this;
}

Svg::Svg(double width, double height, std::string_view title, std::string_view style)
    : width_(width), height_(height), title_(title), style_(style) {}

void Svg::start_tag(const std::string& element, const Attributes& attributes) {
  text_ += "<" + element;
  for (const auto& [name, value] : attributes) {
    text_ += " " + name + "=\"" + svg_escape(value) + "\"";
  }
}

void Svg::open(const std::string& element, const Attributes& attributes) {
  start_tag(element, attributes);
  text_ += ">\n";
  open_.push_back(element);
}

void Svg::close() {
  require(!open_.empty(), "svg: no element is open");
  text_ += "</" + open_.back() + ">\n";
  open_.pop_back();
}

void Svg::element(const std::string& element, const Attributes& attributes,
                  std::string_view tooltip) {
  start_tag(element, attributes);
  text_ += tooltip.empty() ? "/>\n"
                           : "><title>" + svg_escape(tooltip) + "</title></" + element + ">\n";
}

void Svg::path(const SvgPath& path, const std::string& css_class, Attributes attributes,
               std::string_view tooltip) {
  attributes.insert(attributes.begin(), {"class", css_class});
  attributes.emplace_back("d", path.data());
  element("path", attributes, tooltip);
}

void Svg::line(InkPoint from, InkPoint to, const std::string& css_class,
               Attributes attributes) {
  attributes.insert(attributes.begin(), {{"class", css_class},
                                         {"x1", svg_number(from.x)},
                                         {"y1", svg_number(from.y)},
                                         {"x2", svg_number(to.x)},
                                         {"y2", svg_number(to.y)}});
  element("line", attributes);
}

void Svg::circle(InkPoint centre, double radius, const std::string& css_class,
                 Attributes attributes) {
  attributes.insert(attributes.begin(), {{"class", css_class},
                                         {"cx", svg_number(centre.x)},
                                         {"cy", svg_number(centre.y)},
                                         {"r", svg_number(radius)}});
  element("circle", attributes);
}

void Svg::text(InkPoint at, const std::string& css_class, std::string_view content,
               Attributes attributes) {
  attributes.insert(attributes.begin(),
                    {{"class", css_class}, {"x", svg_number(at.x)}, {"y", svg_number(at.y)}});
  start_tag("text", attributes);
  text_ += ">" + svg_escape(content) + "</text>\n";
}

std::string Svg::finish() {
  require(open_.empty(), "svg: an element is still open");
  const std::string inside = std::move(text_);
  text_.clear();
  const std::string w = svg_number(width_);
  const std::string h = svg_number(height_);
  open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
               {"class", "stickslip"},
               {"role", "img"},
               {"width", w},
               {"height", h},
               {"viewBox", "0 0 " + w + " " + h}});
  text_ += "<title>" + svg_escape(title_) + "</title>\n<style>\n" + style_ + "</style>\n";
  // The picture has its own paper, so that ink is legible whatever lies behind it.
  element("rect", {{"class", "paper"}, {"width", w}, {"height", h}});
  text_ += inside;
  close();
  return std::move(text_);
}

}  // namespace stickslip
