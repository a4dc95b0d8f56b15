// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A writer of SVG 1.1 documents that need no other file.
///
/// Positions are doubles in pixels (1/96 inch), x to the right and y down: they are ink and
/// decide nothing. Numbers are written with at most two decimals, so that the same picture has
/// the same bytes. Attributes named data-* carry exact values for programs that read pictures.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stickslip {

/// A place or a direction in the plane: on the page for everything in this header.
struct InkPoint {
  double x = 0;  ///< in pixels, to the right
  double y = 0;  ///< in pixels, down

  /// \{ Componentwise.
  friend InkPoint operator+(InkPoint a, InkPoint b) { return {a.x + b.x, a.y + b.y}; }
  friend InkPoint operator-(InkPoint a, InkPoint b) { return {a.x - b.x, a.y - b.y}; }
  friend InkPoint operator*(double s, InkPoint a) { return {s * a.x, s * a.y}; }
  /// \}
};

/// Returns the Euclidean length.
double length(InkPoint v);
/// Returns v / length(v); (1, 0) for the zero vector.
InkPoint unit(InkPoint v);
/// Returns (-y, x).
InkPoint quarter_turn(InkPoint v);

/// Returns "12.35", "-3", "0". Throws ContractError if the value is not finite or beyond 1e9.
std::string svg_number(double value);

/// Returns `text` as it may stand in an element or a quoted attribute. Characters that XML 1.0
/// cannot hold (control characters, broken UTF-8) become U+FFFD.
std::string svg_escape(std::string_view text);

/// The content of a path's attribute "d".
class SvgPath {
 public:
  SvgPath& move(InkPoint to);  ///< starts a new piece there
  SvgPath& line(InkPoint to);  ///< draws from where the last command ended
  SvgPath& close();            ///< draws back to the start of the piece
  /// Moves to the first point and draws lines to the others; draws nothing if there are none.
  SvgPath& polyline(const std::vector<InkPoint>& points);
  /// Draws a polyline and closes it.
  SvgPath& polygon(const std::vector<InkPoint>& points);
  /// Draws a full circle.
  SvgPath& circle(InkPoint centre, double radius);

  bool empty() const { return data_.empty(); }       ///< no command yet
  const std::string& data() const { return data_; }  ///< the text of the attribute

 private:
  std::string data_;
};

/// A document that is being written, elements in the order of drawing.
class Svg {
 public:
  /// Attributes in their order; values are escaped here.
  using Attributes = std::vector<std::pair<std::string, std::string>>;

  /// `style` is CSS whose rules start with ".stickslip", the class of the root element, so that
  /// they stay in this picture when it is put into a page. It must not contain '<' or '&'.
  Svg(double width, double height, std::string_view title, std::string_view style);

  /// Changes the height that the document was begun with.
  void set_height(double height) { height_ = height; }

  /// Starts an element that may hold others.
  void open(const std::string& element, const Attributes& attributes = {});
  /// Closes the element opened last. Throws ContractError if there is none.
  void close();
  /// Adds an element without children, or with a `title` (a tooltip) if `tooltip` is not empty.
  void element(const std::string& element, const Attributes& attributes,
               std::string_view tooltip = {});
  /// \{ Add the element of that name, with the class `css_class` and the `attributes`.
  void path(const SvgPath& path, const std::string& css_class, Attributes attributes = {},
            std::string_view tooltip = {});
  void line(InkPoint from, InkPoint to, const std::string& css_class,
            Attributes attributes = {});
  void circle(InkPoint centre, double radius, const std::string& css_class,
              Attributes attributes = {});
  /// \}
  /// Adds a text; `at` is on the baseline, at the start, middle or end according to the class.
  void text(InkPoint at, const std::string& css_class, std::string_view content,
            Attributes attributes = {});

  /// Returns the whole document. Throws ContractError if an element is still open.
  std::string finish();

 private:
  void start_tag(const std::string& element, const Attributes& attributes);

  double width_;
  double height_;
  std::string title_;
  std::string style_;
  std::string text_;  ///< the content of the root element
  std::vector<std::string> open_;
};

}  // namespace stickslip
