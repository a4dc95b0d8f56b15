// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Packed sign vectors over planes, changed circle by circle.
#pragma once

#include <cstdint>
#include <vector>

#include "filtered_normals.hpp"
#include "stickslip/arrangement/packed_signs.hpp"

namespace stickslip {

/// Where the digits of each circle's planes stand, and what they are when the circle, oriented
/// to the pole as in FilteredNormals, has a given sign.
class SignLayout {
 public:
  using Word = PackedSigns::Word;

  /// Over the planes of `circles`.
  SignLayout(const GreatCircles& circles, const FilteredNormals& normals);
  /// Over the circles themselves, with the signs of circles.normals.
  static SignLayout of_circles(const GreatCircles& circles, const FilteredNormals& normals);

  std::size_t planes() const { return planes_; }

  void set(Word* words, std::size_t circle, int sign) const {
    for_each_part(circle, [&](const Part& part) {
      Word& word = words[part.word];
      const Word digits = sign == 0  ? part.low << 1
                          : sign > 0 ? part.plus
                                     : part.plus ^ part.low;
      word = (word & ~(part.low | part.low << 1)) | digits;
    });
  }
  /// Replaces + by - and - by +. Requires a sign that is not 0.
  void flip(Word* words, std::size_t circle) const {
    for_each_part(circle, [&](const Part& part) { words[part.word] ^= part.low; });
  }

 private:
  /// The digits of a circle in one word: their lower bits, and those set when its sign is +.
  struct Part {
    std::size_t word;
    Word low;
    Word plus;
  };

  SignLayout(std::size_t planes, const std::vector<CircleId>& circle,
             const std::vector<Sign>& orientation, const FilteredNormals& normals);

  template <class Use>
  void for_each_part(std::size_t circle, Use use) const {
    for (std::size_t p = part_begin_[circle]; p < part_begin_[circle + 1]; ++p) use(parts_[p]);
  }

  std::size_t planes_;
  std::vector<std::size_t> part_begin_;
  std::vector<Part> parts_;
};

}  // namespace stickslip
