// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Texts of a picture: how much room they take, where their lines break, and where labels go.
///
/// The reader's fonts are not known. Each character is taken to be as wide as in DejaVu Sans or
/// in Helvetica, whichever is wider: they are the widest and the usual font that the stylesheet
/// names. A character that is not ASCII counts as a full square. So boxes are upper bounds for
/// the fonts named there.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "stickslip/interfaces/svg.hpp"

namespace stickslip::plot_detail {

/// A rectangle on the page.
struct Box {
  InkPoint low;   ///< left and top
  InkPoint high;  ///< right and bottom
};

/// \{ Return true if two boxes overlap, if a line crosses a box, or if a box contains another;
/// touching is no overlap.
bool overlap(const Box& a, const Box& b);
bool crosses(InkPoint from, InkPoint to, const Box& box);  ///< the line from one to the other
bool contains(const Box& outer, const Box& inner);
/// \}

/// Returns the box of a text; the classes give its size and anchor (stylesheet.hpp).
Box text_box(InkPoint at, const std::string& css_class, std::string_view text);
/// Returns the width of that box.
double text_width(const std::string& css_class, std::string_view text);

/// Returns `text` in lines that are no wider, broken at blanks outside of parentheses, and
/// elsewhere if there are too few of them.
std::vector<std::string> wrap(const std::string& text, const std::string& css_class,
                              double width);
/// Returns `text`, or as much of its beginning as fits, with an ellipsis for the rest.
std::string fit(const std::string& text, const std::string& css_class, double width);

/// Draws wrapped lines from the baseline `at` on; returns the baseline of the line after them.
double draw_lines(Svg& svg, InkPoint at, const std::string& css_class, const std::string& text,
                  double width);

/// A place where a label may go.
struct LabelPlace {
  InkPoint middle;
  double cost = 0;  ///< in points of covered ink
};

/// Returns places around a point, nearest first, for a label with this box of classes and text;
/// places in the direction `first` come first.
std::vector<LabelPlace> places_around(InkPoint point, double gap, InkPoint first,
                                      const std::string& css_class, std::string_view text);

/// Returns places at which such a label lies in the polygon; those near its middle are best.
std::vector<LabelPlace> places_inside(const std::vector<InkPoint>& polygon,
                                      const std::string& css_class, std::string_view text);

/// Draws labels that neither leave their frame nor meet each other.
class LabelPlacer {
 public:
  explicit LabelPlacer(const Box& frame) : frame_(frame) {}

  /// \{ Record ink that labels cover only if there is no better place: a point, a line, or
  /// points on a line.
  void avoid(InkPoint point) { ink_.push_back(point); }
  void avoid(InkPoint from, InkPoint to);
  void avoid(const std::vector<InkPoint>& line);
  /// \}

  /// Records a line that no label covers, and that is seldom between a label and its anchor.
  void keep_off(InkPoint from, InkPoint to) { lines_.push_back({from, to}); }

  /// Draws the text, with the class "middle", at the free place of least cost, covered ink
  /// included; the first of equals. Returns false, and draws nothing, if no place is free. A
  /// thin line leads to `*anchor` from a label that is not next to it.
  bool place(Svg& svg, const std::string& css_class, const std::string& text,
             const std::vector<LabelPlace>& places, const InkPoint* anchor = nullptr);

 private:
  bool is_taken(const Box& box) const;

  struct Line {
    InkPoint from;
    InkPoint to;
  };

  Box frame_;
  std::vector<Line> lines_;  ///< lines that no label covers
  std::vector<Box> taken_;   ///< the boxes of labels and of the lines to them
  std::vector<InkPoint> ink_;
};

}  // namespace stickslip::plot_detail
