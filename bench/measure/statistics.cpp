// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace stickslip::bench {

double beyond_limit() {
  return std::numeric_limits<double>::infinity();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  if (values.size() % 2 == 1) return values[middle];
  return (values[middle - 1] + values[middle]) / 2;
}

double log_log_slope(const std::vector<std::pair<double, double>>& points) {
  double n = 0;
  double sx = 0;
  double sy = 0;
  double sxx = 0;
  double sxy = 0;
  for (const auto& [x, y] : points) {
    if (!(x > 0) || !(y > 0)) continue;
    const double lx = std::log(x);
    const double ly = std::log(y);
    ++n;
    sx += lx;
    sy += ly;
    sxx += lx * lx;
    sxy += lx * ly;
  }
  const double spread = n * sxx - sx * sx;
  if (n < 2 || spread == 0) return std::numeric_limits<double>::quiet_NaN();
  return (n * sxy - sx * sy) / spread;
}

std::string show_ms(double ms, double limit_ms) {
  char text[32];
  if (std::isinf(ms)) {
    std::snprintf(text, sizeof text, "> %.0f", limit_ms);
  } else {
    std::snprintf(text, sizeof text, ms < 10 ? "%.2f" : ms < 100 ? "%.1f" : "%.0f", ms);
  }
  return text;
}

}  // namespace stickslip::bench
