// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/cone.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <numeric>

#include "certain_sign.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

/// Returns a vector of n zeros.
template <class Vector>
Vector zero_of(std::size_t n) {
  if constexpr (kCoordinates<Vector> == 0) {
    return Vector(n);
  } else {
    return {};
  }
}

/// Returns the primitive positive multiple of p * a - q * b.
template <class Vector>
Vector combine(const Integer& p, const Vector& a, const Integer& q, const Vector& b) {
  auto result = zero_of<Vector>(a.size());
  for (std::size_t j = 0; j < a.size(); ++j) {
    if (!a[j].is_zero()) result[j] = p * a[j];
    if (!b[j].is_zero()) result[j] -= q * b[j];
  }
  return primitive(std::move(result));
}

/// Returns whether a ray that is not in the plane is kept.
bool keeps(Side side, int sign) {
  return (side == Side::kPositive && sign > 0) || (side == Side::kNegative && sign < 0);
}

/// The constraints that are 0 at each ray, one bit for each.
template <class Vector>
class TightSets {
 public:
  TightSets(const std::vector<RayOf<Vector>>& rays, ConstraintIndex constraints)
      : words_((constraints + kBits - 1) / kBits), all_(rays.size() * words_), shared_(words_) {
    for (std::size_t r = 0; r < rays.size(); ++r) {
      for (const ConstraintIndex c : rays[r].tight) {
        all_[r * words_ + c / kBits] |= std::uint64_t{1} << (c % kBits);
      }
    }
  }

  /// Returns whether rays a and b span a face of dimension 2. Two extreme rays do iff no third
  /// one lies on all the constraints that both lie on (Fukuda and Prodon 1996, Proposition 7).
  /// Then they share at least `least_shared` constraints, which turns most pairs down.
  bool adjacent(std::size_t a, std::size_t b, std::size_t least_shared) {
    std::size_t count = 0;
    for (std::size_t w = 0; w < words_; ++w) {
      shared_[w] = all_[a * words_ + w] & all_[b * words_ + w];
      count += static_cast<std::size_t>(__builtin_popcountll(shared_[w]));
    }
    if (count < least_shared) return false;
    for (std::size_t c = 0; c < all_.size() / words_; ++c) {
      if (c != a && c != b && has_shared(c)) return false;
    }
    return true;
  }

 private:
  static constexpr ConstraintIndex kBits = 64;

  bool has_shared(std::size_t ray) const {
    for (std::size_t w = 0; w < words_; ++w) {
      if ((shared_[w] & ~all_[ray * words_ + w]) != 0) return false;
    }
    return true;
  }

  std::size_t words_;
  std::vector<std::uint64_t> all_;
  std::vector<std::uint64_t> shared_;  ///< the constraints that the last pair shares
};

}  // namespace

template <class Vector>
ConeOf<Vector>::ConeOf(Multiples multiples, std::size_t n)
    : dimension_(multiples == Multiples::kAny ? n : n - 1) {
  require(n >= 2, "points have a height and a multiple");
  const auto unit = [n](std::size_t j) {
    Vector x = zero_of<Vector>(n);
    x[j] = 1;
    return x;
  };
  for (std::size_t j = 0; j + 2 < n; ++j) lines_.push_back(unit(j));
  rays_.push_back({unit(n - 2), {}});
  if (multiples == Multiples::kAny) lines_.push_back(unit(n - 1));
}

template <class Vector>
std::vector<Vector> ConeOf<Vector>::directions() const {
  std::vector<Vector> result;
  result.reserve(2 * lines_.size() + rays_.size());
  for (const Vector& line : lines_) {
    result.push_back(line);
    result.push_back(negated(line));
  }
  for (const RayOf<Vector>& ray : rays_) result.push_back(ray.x);
  return result;
}

/// Looks for a line on which the plane is not 0, and returns false if there is none. Such a
/// line becomes the last ray, above the plane, and all else moves along it into the plane.
template <class Vector>
bool ConeOf<Vector>::move_along_a_line(const Vector& plane) {
  pairs_ = 0;
  std::size_t chosen = 0;
  while (chosen < lines_.size() && dot(plane, lines_[chosen]).is_zero()) ++chosen;
  if (chosen == lines_.size()) return false;
  Vector line = std::move(lines_[chosen]);
  lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(chosen));
  Integer height = dot(plane, line);
  if (height.sign() < 0) {
    line = negated(line);
    height = -height;
  }
  const auto move_into_plane = [&](Vector& x) {
    const Integer above = dot(plane, x);
    if (!above.is_zero()) x = combine(height, x, above, line);
  };
  for (Vector& other : lines_) move_into_plane(other);
  for (RayOf<Vector>& ray : rays_) {
    move_into_plane(ray.x);
    ray.tight.push_back(constraint_count_);
  }
  std::vector<ConstraintIndex> all_before(constraint_count_);
  std::iota(all_before.begin(), all_before.end(), ConstraintIndex{0});
  rays_.push_back({std::move(line), std::move(all_before)});
  return true;
}

/// Returns the extreme rays in the plane that are not extreme rays of the cone: one for each
/// pair of neighbours on opposite sides.
template <class Vector>
std::vector<RayOf<Vector>> ConeOf<Vector>::rays_between(const std::vector<Integer>& heights) {
  pairs_ = 0;
  std::vector<RayOf<Vector>> between;
  const auto any = [&](int sign) {
    return std::any_of(heights.begin(), heights.end(),
                       [&](const Integer& height) { return height.sign() == sign; });
  };
  if (!any(1) || !any(-1)) return between;
  TightSets<Vector> tight(rays_, constraint_count_);
  const std::size_t free = 2 + lines_.size();
  const std::size_t least_shared = dimension_ > free ? dimension_ - free : 0;
  for (std::size_t p = 0; p < rays_.size(); ++p) {
    if (heights[p].sign() <= 0) continue;
    for (std::size_t q = 0; q < rays_.size(); ++q) {
      if (heights[q].sign() >= 0) continue;
      ++pairs_;
      if (!tight.adjacent(p, q, least_shared)) continue;
      RayOf<Vector>& ray = between.emplace_back();
      ray.x = combine(heights[p], rays_[q].x, heights[q], rays_[p].x);
      std::set_intersection(rays_[p].tight.begin(), rays_[p].tight.end(),
                            rays_[q].tight.begin(), rays_[q].tight.end(),
                            std::back_inserter(ray.tight));
      ray.tight.push_back(constraint_count_);
    }
  }
  return between;
}

template <class Vector>
std::vector<ConeOf<Vector>> ConeOf<Vector>::split(const Vector& plane,
                                                  const std::vector<Side>& sides) {
  const bool is_along_a_line = move_along_a_line(plane);
  std::vector<Integer> heights;
  std::vector<RayOf<Vector>> in_plane;  // of those that are new
  if (!is_along_a_line) {
    heights.reserve(rays_.size());
    for (const RayOf<Vector>& ray : rays_) heights.push_back(dot(plane, ray.x));
    in_plane = rays_between(heights);
  }
  const ConstraintIndex constraint = constraint_count_++;
  std::vector<RayOf<Vector>> rays = std::move(rays_);
  std::vector<ConeOf> parts;
  parts.reserve(sides.size());
  for (const Side side : sides) {
    const bool is_last = parts.size() + 1 == sides.size();
    ConeOf& part = parts.emplace_back(is_last ? std::move(*this) : *this);
    if (is_along_a_line) {
      part.rays_ = is_last ? std::move(rays) : rays;
      RayOf<Vector>& ray = part.rays_.back();
      if (side == Side::kNegative) ray.x = negated(ray.x);
      if (side == Side::kZero) part.rays_.pop_back();
      continue;
    }
    if (parts.size() > 1) part.pairs_ = 0;
    part.rays_ = is_last ? std::move(in_plane) : in_plane;
    for (std::size_t r = 0; r < rays.size(); ++r) {
      if (heights[r].is_zero()) {
        part.rays_.push_back(rays[r]);
        part.rays_.back().tight.push_back(constraint);
      } else if (keeps(side, heights[r].sign())) {
        part.rays_.push_back(std::move(rays[r]));  // no other side keeps it
      }
    }
  }
  return parts;
}

template <class Vector>
void ConeOf<Vector>::cut(const Vector& plane, Side side) {
  *this = std::move(split(plane, {side}).front());
}

template <class Vector>
std::vector<ConeOf<Vector>> ConeOf<Vector>::parts(const Vector& plane,
                                                  const std::vector<Side>& sides) const {
  return ConeOf(*this).split(plane, sides);
}

template class ConeOf<IntegerVector5>;
template class ConeOf<Row>;

ConeSigns::ConeSigns(const Cone& cone) : cone_(cone) {
  rounded_.reserve(cone.rays().size());
  for (const Ray& ray : cone.rays()) {
    rounded_.push_back(in_doubles(ray.x));
  }
}

template <class Visit>
void ConeSigns::for_each_sign(const IntegerVector5& plane, const Visit& visit) const {
  const std::array<double, 5> rounded = in_doubles(plane);
  for (std::size_t r = 0; r < rounded_.size(); ++r) {
    double value = 0;
    const auto certain = certain_sign(rounded, rounded_[r], value);
    const Ray& ray = cone_.rays()[r];
    visit(ray, certain ? *certain : sign_of(dot(plane, ray.x)));
  }
}

SignRange ConeSigns::on(const IntegerVector5& plane) const {
  for (const IntegerVector5& line : cone_.lines()) {
    if (!dot(plane, line).is_zero()) return {true, true, true};
  }
  SignRange range;
  for_each_sign(plane, [&](const Ray&, Sign sign) {
    (sign == Sign::kNegative   ? range.negative
     : sign == Sign::kPositive ? range.positive
                               : range.zero) = true;
  });
  return range;
}

std::vector<const Ray*> ConeSigns::rays_in(const IntegerVector5& plane) const {
  std::vector<const Ray*> result;
  for_each_sign(plane, [&](const Ray& ray, Sign sign) {
    if (sign == Sign::kZero) result.push_back(&ray);
  });
  return result;
}

}  // namespace stickslip
