// SPDX-License-Identifier: GPL-3.0-or-later
#include "spring_lines.hpp"

#include <algorithm>

namespace stickslip::search_detail {

SpringLines::SpringLines(const Law& law, const MotionRegion& region)
    : law_(law), region_(region) {
  has_springs_ = std::any_of(law.contacts.begin(), law.contacts.end(),
                             [](const LawContact& c) { return c.is_spring; });
  if (!has_springs_) return;
  is_in_.assign(region.points().size(), 0);
  const std::size_t lines = region.cone().lines().size();
  for (std::size_t k = 0; k < lines; ++k) {  // both ways stand side by side
    note(2 * k);
    is_in_[2 * k + 1] = 1;
  }
  if (lines > 0) find_twists();
}

bool SpringLines::add(const std::vector<std::size_t>& generators) {
  if (!has_springs_) return false;
  bool is_new = false;
  for (const std::size_t g : generators) {
    if (is_in_[g] != 0) continue;
    note(g);
    is_new = true;
  }
  if (is_new) find_twists();
  return is_new;
}

void SpringLines::note(std::size_t generator) {
  is_in_[generator] = 1;
  generators_.push_back(generator);
  const Row& x = region_.points()[generator];
  RationalRow sum(law_.motions);
  for (const LawContact& c : law_.contacts) {
    if (!c.is_spring) continue;
    const RationalRow& normal = c.corners.front().normal;
    Rational along = dot(x, normal);
    if (along.is_zero()) continue;
    if (!c.stiffness.is_point()) {
      seen_.push_back(normal);
      continue;
    }
    along *= c.stiffness.low;
    for (std::size_t j = 0; j < law_.motions; ++j) sum[j] += along * normal[j];
  }
  seen_.push_back(std::move(sum));
}

void SpringLines::find_twists() {
  const ForceSpan span(law_.motions, seen_);
  across_.clear();
  columns_.clear();
  if (span.rank() == 0) return;
  basis_ = span.free_motions();
  for (std::size_t j = 0; j < law_.motions; ++j) {
    const auto& taken = span.columns();
    if (std::find(taken.begin(), taken.end(), j) == taken.end()) columns_.push_back(j);
  }
  for (const RationalRow& row : span.rows()) {
    Reals wrench(static_cast<Eigen::Index>(law_.motions));
    for (std::size_t j = 0; j < law_.motions; ++j) {
      wrench[static_cast<Eigen::Index>(j)] = to_double(row[j]);
    }
    law_.scale_function(wrench);
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
