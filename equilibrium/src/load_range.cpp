// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/load_range.hpp"

#include "stickslip/core/error.hpp"

namespace stickslip {

LoadRange::LoadRange(const Wrench& wrench) : wrench_(wrench), ends_{{0, wrench}} {}

LoadRange::LoadRange(const Wrench& wrench, const Wrench& direction, const Rational& low,
                     const std::optional<Rational>& high, bool has_low)
    : wrench_(wrench),
      direction_(direction),
      has_high_(high.has_value()),
      low_is_strict_(!has_low) {
  require(!high || low < *high, "a range of loads has an inside");
  ends_.push_back({low, wrench_at(low)});
  if (high) ends_.push_back({*high, wrench_at(*high)});
}

std::optional<Wrench> LoadRange::recession() const {
  if (has_high_) return std::nullopt;
  return direction_;
}

}  // namespace stickslip
