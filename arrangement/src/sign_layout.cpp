// SPDX-License-Identifier: GPL-3.0-or-later
#include "sign_layout.hpp"

namespace stickslip {

SignLayout::SignLayout(const GreatCircles& circles, const FilteredNormals& normals)
    : SignLayout(circles.circle.size(), circles.circle, circles.orientation, normals) {}

SignLayout SignLayout::of_circles(const GreatCircles& circles, const FilteredNormals& normals) {
  std::vector<CircleId> itself;
  for (std::size_t c = 0; c < normals.size(); ++c) itself.emplace_back(c);
  return SignLayout(circles.normals.size(), itself,
                    std::vector<Sign>(normals.size(), Sign::kPositive), normals);
}

SignLayout::SignLayout(std::size_t planes, const std::vector<CircleId>& circle,
                       const std::vector<Sign>& orientation, const FilteredNormals& normals)
    : planes_(planes) {
  std::vector<std::vector<Part>> parts(normals.size());
  for (std::size_t p = 0; p < planes; ++p) {
    const std::size_t c = circle[p].index();
    const std::size_t word = p / PackedSigns::kSignsPerWord;
    if (parts[c].empty() || parts[c].back().word != word) parts[c].push_back({word, 0, 0});
    const Word low = Word{1} << PackedSigns::shift_of(p);
    parts[c].back().low |= low;
    // The digit of '-' is 1.
    const bool is_minus = (orientation[p] == Sign::kNegative) != normals.is_reversed(c);
    if (is_minus) parts[c].back().plus |= low;
  }
  part_begin_.push_back(0);
  for (const std::vector<Part>& of_circle : parts) {
    parts_.insert(parts_.end(), of_circle.begin(), of_circle.end());
    part_begin_.push_back(parts_.size());
  }
}

}  // namespace stickslip
