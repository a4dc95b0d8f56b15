// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/load_hull.hpp"

#include <algorithm>

namespace stickslip {
Rational LoadHull::most_work(const Row& y) const {
  Rational most = dot(y, corners.front().load);
  for (const LoadGenerator& g : corners) most = std::max(most, dot(y, g.load));
  return most;
}

const Reals& LoadHull::worst(const Reals& y) const {
  return std::max_element(corners.begin(), corners.end(),
                          [&](const LoadGenerator& a, const LoadGenerator& b) {
                            return a.rounded.dot(y) < b.rounded.dot(y);
                          })
      ->rounded;
}

bool LoadHull::is_unbounded(const Row& y) const {
  return std::any_of(directions.begin(), directions.end(),
                     [&](const LoadGenerator& g) { return dot(y, g.load).sign() > 0; });
}

bool LoadHull::bars(const Row& y, bool at_corners) const {
  std::vector<char> is_zero(corners.front().strict.size(), 1);
  const auto note = [&](const LoadGenerator& g) {
    for (std::size_t k = 0; k < is_zero.size(); ++k) {
      if (!g.strict[k].is_zero()) is_zero[k] = 0;
    }
  };
  const Rational most = most_work(y);
  for (const LoadGenerator& g : corners) {
    if (at_corners && dot(y, g.load) == most) note(g);
  }
  for (const LoadGenerator& g : directions) {
    if (dot(y, g.load).is_zero()) note(g);
  }
  return std::find(is_zero.begin(), is_zero.end(), 1) != is_zero.end();
}

}  // namespace stickslip
