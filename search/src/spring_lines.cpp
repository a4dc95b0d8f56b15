// SPDX-License-Identifier: GPL-3.0-or-later
#include "spring_lines.hpp"

#include <algorithm>

namespace stickslip::search_detail {

SpringLines::SpringLines(const Law& law, const MotionRegion& region)
    : lines_(2 * region.cone().lines().size()) {
  if (lines_ == 0) return;
  std::vector<RationalRow> seen;
  for (const Row& line : region.cone().lines()) {
    RationalRow sum(law.motions);
    for (const LawContact& c : law.contacts) {
      if (!c.is_spring) continue;
      const RationalRow& normal = c.corners.front().normal;
      Rational along = 0;
      for (std::size_t j = 0; j < law.motions; ++j) along += normal[j] * Rational(line[j]);
      if (along.is_zero()) continue;
      if (!c.stiffness.is_point()) {
        seen.push_back(normal);
        continue;
      }
      along *= c.stiffness.low;
      for (std::size_t j = 0; j < law.motions; ++j) sum[j] += along * normal[j];
    }
    seen.push_back(std::move(sum));
  }
  const ForceSpan span(law.motions, seen);
  if (span.rank() == 0) return;
  basis_ = span.free_motions();
  for (std::size_t j = 0; j < law.motions; ++j) {
    const auto& taken = span.columns();
    if (std::find(taken.begin(), taken.end(), j) == taken.end()) columns_.push_back(j);
  }
  for (const RationalRow& row : span.rows()) {
    Reals wrench(static_cast<Eigen::Index>(law.motions));
    for (std::size_t j = 0; j < law.motions; ++j) {
      wrench[static_cast<Eigen::Index>(j)] = to_double(row[j]);
    }
    law.scale_function(wrench);
    for (const int round : {0, 1}) {  // the second mends what rounding left
      project(wrench);
      if (round == 0) wrench.normalize();
    }
    wrench.normalize();
    if (wrench.allFinite()) across_.push_back(std::move(wrench));
  }
}

Row SpringLines::twist_near(const Row& y) const {
  if (empty()) return y;
  RationalRow twist(y.size());
  for (std::size_t k = 0; k < basis_.size(); ++k) {
    const Rational part(y[columns_[k]]);
    if (part.is_zero()) continue;
    for (std::size_t j = 0; j < twist.size(); ++j) twist[j] += part * basis_[k][j];
  }
  return primitive_multiple(twist);
}

void SpringLines::project(Reals& wrench) const {
  for (const Reals& way : across_) wrench -= way.dot(wrench) * way;
}

}  // namespace stickslip::search_detail
