// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The loads that a problem asks about: one wrench, or the wrenches w + l u for all l in an
/// interval (certificate/FORMAT.md, section 5).
///
/// In a range the multiple l is one more homogeneous unknown beside x = (d, h): l/h is the
/// multiple when h > 0. Over a region of motions the points (x, l) are the combinations of
/// - (r, l h_r) for each ray r and each end l of the range, and
/// - the recession (0, 1) if the range has no upper end.
#pragma once

#include <optional>
#include <vector>

#include "stickslip/core/twist.hpp"

namespace stickslip {

/// One wrench, or an interval on a line of wrenches.
class LoadRange {
 public:
  /// A load at an end of the range.
  struct End {
    Rational multiple;  ///< l
    Wrench wrench;      ///< w + multiple u
  };

  /// One wrench; its multiple is 0.
  explicit LoadRange(const Wrench& wrench = {});
  /// w + l u for low < l < high, or low < l if there is no high; with `has_low` also l = low.
  /// Requires low < high.
  LoadRange(const Wrench& wrench, const Wrench& direction, const Rational& low,
            const std::optional<Rational>& high, bool has_low);

  /// w + multiple u
  Wrench wrench_at(const Rational& multiple) const { return wrench_ + multiple * direction_; }

  /// The low end, and the high end if there is one.
  const std::vector<End>& ends() const { return ends_; }
  /// The direction u, if the range has no high end.
  std::optional<Wrench> recession() const;
  bool is_single() const { return ends_.size() == 1 && has_high_; }  ///< one wrench
  /// \{ Whether l > low, or l < high, is asked: l - low h (or high h - l) is a strict function.
  bool low_is_strict() const { return low_is_strict_; }
  bool high_is_strict() const { return ends_.size() == 2; }
  /// \}

 private:
  Wrench wrench_;
  Wrench direction_;
  std::vector<End> ends_;
  bool has_high_ = true;
  bool low_is_strict_ = false;
};

}  // namespace stickslip
