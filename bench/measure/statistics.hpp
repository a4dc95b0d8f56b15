// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace stickslip::bench {

/// Stands for a run that did not end within its limit; sorts after every time.
double beyond_limit();

/// The middle, or the mean of the two in the middle. Requires values.
double median(std::vector<double> values);

/// Slope of the least-squares line through (log x, log y); NaN for fewer than two points.
double log_log_slope(const std::vector<std::pair<double, double>>& points);

/// Three significant digits; "> limit" beyond it.
std::string show_ms(double ms, double limit_ms);

}  // namespace stickslip::bench
