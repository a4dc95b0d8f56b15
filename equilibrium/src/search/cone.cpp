// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/search/cone.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace stickslip {
namespace {

/// The primitive positive multiple of p * a - q * b.
template <std::size_t n>
IntegerVector<n> combine(const Integer& p, const IntegerVector<n>& a, const Integer& q,
                         const IntegerVector<n>& b) {
  IntegerVector<n> result;
  for (std::size_t j = 0; j < n; ++j) result[j] = p * a[j] - q * b[j];
  return primitive(std::move(result));
}

template <std::size_t n>
std::vector<ConstraintIndex> common(const RayIn<n>& a, const RayIn<n>& b) {
  std::vector<ConstraintIndex> result;
  std::set_intersection(a.tight.begin(), a.tight.end(), b.tight.begin(), b.tight.end(),
                        std::back_inserter(result));
  return result;
}

bool keeps(Side side, int sign) {
  return sign == 0 || (side == Side::kPositive && sign > 0) ||
         (side == Side::kNegative && sign < 0);
}

}  // namespace

template <std::size_t n>
ConeIn<n>::ConeIn(Multiples multiples) : dimension_(multiples == Multiples::kAny ? n : n - 1) {
  const auto unit = [](std::size_t j) {
    IntegerVector<n> x{};
    x[j] = 1;
    return x;
  };
  for (std::size_t j = 0; j + 2 < n; ++j) lines_.push_back(unit(j));
  rays_.push_back({unit(n - 2), {}});
  if (multiples == Multiples::kAny) lines_.push_back(unit(n - 1));
}

template <std::size_t n>
std::vector<IntegerVector<n>> ConeIn<n>::directions() const {
  std::vector<IntegerVector<n>> result;
  result.reserve(2 * lines_.size() + rays_.size());
  for (const IntegerVector<n>& line : lines_) {
    result.push_back(line);
    result.push_back(negated(line));
  }
  for (const RayIn<n>& ray : rays_) result.push_back(ray.x);
  return result;
}

/// If the plane is not 0 on some line, that line becomes a ray (or goes, for kZero) and all
/// else moves along it into the plane.
template <std::size_t n>
bool ConeIn<n>::cut_along_a_line(const IntegerVector<n>& plane, Side side) {
  std::size_t chosen = 0;
  while (chosen < lines_.size() && dot(plane, lines_[chosen]).is_zero()) ++chosen;
  if (chosen == lines_.size()) return false;
  IntegerVector<n> line = std::move(lines_[chosen]);
  lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(chosen));
  Integer height = dot(plane, line);
  if (height.sign() < 0) {
    line = negated(line);
    height = -height;
  }
  for (IntegerVector<n>& other : lines_)
    other = combine(height, other, dot(plane, other), line);
  for (RayIn<n>& ray : rays_) {
    ray.x = combine(height, ray.x, dot(plane, ray.x), line);
    ray.tight.push_back(constraint_count_);
  }
  if (side != Side::kZero) {
    std::vector<ConstraintIndex> all_before(constraint_count_);
    std::iota(all_before.begin(), all_before.end(), ConstraintIndex{0});
    rays_.push_back({side == Side::kPositive ? line : negated(line), std::move(all_before)});
  }
  return true;
}

/// Two extreme rays span a face of dimension 2 iff no third one lies on all the constraints
/// that both lie on (Fukuda and Prodon 1996, Proposition 7); and then these are at least as
/// many as leave 2 dimensions beside the lines.
template <std::size_t n>
bool ConeIn<n>::adjacent(std::size_t a, std::size_t b) const {
  const std::vector<ConstraintIndex> shared = common(rays_[a], rays_[b]);
  if (shared.size() + 2 + lines_.size() < dimension_) return false;
  for (std::size_t c = 0; c < rays_.size(); ++c) {
    if (c != a && c != b &&
        std::includes(rays_[c].tight.begin(), rays_[c].tight.end(), shared.begin(),
                      shared.end())) {
      return false;
    }
  }
  return true;
}

template <std::size_t n>
void ConeIn<n>::cut(const IntegerVector<n>& plane, Side side) {
  if (!cut_along_a_line(plane, side)) {
    std::vector<Integer> heights;
    heights.reserve(rays_.size());
    for (const RayIn<n>& ray : rays_) heights.push_back(dot(plane, ray.x));
    std::vector<RayIn<n>> kept;
    for (std::size_t p = 0; p < rays_.size(); ++p) {
      if (heights[p].sign() <= 0) continue;
      for (std::size_t q = 0; q < rays_.size(); ++q) {
        if (heights[q].sign() >= 0 || !adjacent(p, q)) continue;
        RayIn<n> between{combine(heights[p], rays_[q].x, heights[q], rays_[p].x),
                         common(rays_[p], rays_[q])};
        between.tight.push_back(constraint_count_);
        kept.push_back(std::move(between));
      }
    }
    for (std::size_t r = 0; r < rays_.size(); ++r) {
      if (!keeps(side, heights[r].sign())) continue;
      if (heights[r].is_zero()) rays_[r].tight.push_back(constraint_count_);
      kept.push_back(std::move(rays_[r]));
    }
    rays_ = std::move(kept);
  }
  ++constraint_count_;
}

template class ConeIn<5>;
template class ConeIn<8>;

SignRange signs_on(const Cone& cone, const IntegerVector5& plane) {
  SignRange range;
  for (const IntegerVector5& line : cone.lines()) {
    if (!dot(plane, line).is_zero()) return {true, true, true};
  }
  for (const Ray& ray : cone.rays()) {
    const int sign = dot(plane, ray.x).sign();
    (sign < 0 ? range.negative : sign > 0 ? range.positive : range.zero) = true;
  }
  return range;
}

}  // namespace stickslip
