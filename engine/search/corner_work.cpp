// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/corner_work.hpp"

namespace stickslip {
namespace {

CornerPairs make_pairs(std::size_t dimensions) {
  const std::size_t corners = std::size_t{1} << dimensions;
  CornerPairs result{corners, 1, {}, {}};
  for (std::size_t k = 0; k < dimensions; ++k) result.cells *= 3;
  std::vector<std::size_t> count(result.cells, 0);
  for (std::size_t a = 0; a < corners; ++a) {
    for (std::size_t b = 0; b < corners; ++b) {
      std::size_t cell = 0;
      for (std::size_t k = dimensions; k-- > 0;) cell = 3 * cell + (a >> k & 1) + (b >> k & 1);
      result.cell.push_back(cell);
      ++count[cell];
    }
  }
  for (const std::size_t n : count) result.share.push_back(corners / n);
  return result;
}

}  // namespace

const CornerPairs& CornerPairs::of(std::size_t corners) {
  static const std::array<CornerPairs, 4> kPairs{make_pairs(0), make_pairs(1), make_pairs(2),
                                                 make_pairs(3)};
  std::size_t dimensions = 0;
  while ((std::size_t{1} << dimensions) < corners) ++dimensions;
  return kPairs[dimensions];
}

}  // namespace stickslip
