// SPDX-License-Identifier: GPL-3.0-or-later
//
// How each cell is met exactly once.
//
// All normals are oriented to the pole z (FilteredNormals): n.z > 0. Counterclockwise about n
// is then eastward about z on every circle. Edges belong to their circle, and a vertex to the
// lowest circle through it. For faces, sweep the sphere by the half great circle from z to -z
// that turns eastward. A face is convex and does not contain z or -z, except for the one where
// all signs are + and its antipode; so it lies within a range of longitudes, and there is one
// vertex where the sweep meets it first (no two points of an edge have the same longitude,
// since no circle passes through z). At a vertex with t circles, t directions lead east, and
// the faces that start there are the t - 1 sectors between them: with the circles in the order
// of slope, north last, the sector above the first f of them has + on those and - on the
// others. All its other signs are those of the vertex.
//
// Hence F = 2 + the sum of t - 1 over the vertices.
#include "stickslip/arrangement/sweep.hpp"

#include <array>
#include <utility>

#include "assemble_states.hpp"
#include "circle_order.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {

using arrangement_detail::CircleOrder;
using arrangement_detail::FilteredNormals;

namespace {

using Word = PackedSigns::Word;

/// The places of the digits of each circle's planes in packed signs, and their values when the
/// circle, oriented to the pole as in FilteredNormals, has a given sign.
class SignLayout {
 public:
  SignLayout(const GreatCircles& circles, const FilteredNormals& normals)
      : planes_(circles.circle.size()) {
    std::vector<std::vector<Part>> parts(normals.size());
    for (std::size_t p = 0; p < planes_; ++p) {
      const std::size_t c = circles.circle[p].index();
      const std::size_t word = p / PackedSigns::kSignsPerWord;
      if (parts[c].empty() || parts[c].back().word != word) parts[c].push_back({word, 0, 0});
      const Word low = Word{1} << PackedSigns::shift_of(p);
      parts[c].back().low |= low;
      // The digit of '-' is 1.
      const bool is_minus =
          (circles.orientation[p] == Sign::kNegative) != normals.is_reversed(c);
      if (is_minus) parts[c].back().plus |= low;
    }
    part_begin_.push_back(0);
    for (const std::vector<Part>& of_circle : parts) {
      parts_.insert(parts_.end(), of_circle.begin(), of_circle.end());
      part_begin_.push_back(parts_.size());
    }
  }

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

  template <class Use>
  void for_each_part(std::size_t circle, Use use) const {
    for (std::size_t p = part_begin_[circle]; p < part_begin_[circle + 1]; ++p) use(parts_[p]);
  }

  std::size_t planes_;
  std::vector<std::size_t> part_begin_;
  std::vector<Part> parts_;
};

/// The numbers of vertices by their number of circles, on half of each circle.
class Census {
 public:
  explicit Census(std::size_t circles) : met_(circles + 1, 0), owned_(circles + 1, 0) {}

  /// Counts the points of the circle sorted last.
  void add(const CircleOrder& order) {
    for (std::size_t q = 0; q < order.half_points(); ++q) {
      ++met_[order.multiplicity(q)];
      if (order.is_lowest(q)) ++owned_[order.multiplicity(q)];
    }
  }

  Census& operator+=(const Census& other) {
    for (std::size_t t = 0; t < met_.size(); ++t) {
      met_[t] += other.met_[t];
      owned_[t] += other.owned_[t];
    }
    return *this;
  }

  void fill(ArrangementCounts& counts) const {
    counts.faces = 2;
    for (std::size_t t = 2; t < met_.size(); ++t) {
      require(met_[t] == t * owned_[t], "sweep: the circles disagree about their vertices");
      counts.edges += 2 * met_[t];
      counts.vertices += 2 * owned_[t];
      counts.faces += 2 * owned_[t] * (t - 1);
    }
  }

 private:
  std::vector<std::size_t> met_;    ///< the number of (circle, vertex) pairs
  std::vector<std::size_t> owned_;  ///< the number of vertices, counted at their lowest circle
};

/// Gives out the cells that belong to one circle after the other.
class CellWalk {
 public:
  CellWalk(std::size_t circles, const SignLayout& layout, const CellVisitor& visitor)
      : circles_(circles),
        layout_(layout),
        visitor_(visitor),
        words_(PackedSigns::words_for(layout.planes()), 0) {}

  /// Visits the face of the pole and its antipode or, without a crossing, all cells.
  void visit_poles() {
    set_all(1);
    give(CellKind::kFace);
    if (circles_ == 0) return;
    set_all(-1);
    give(CellKind::kFace);
    if (circles_ > 1) return;
    set(0, 0);
    give(CellKind::kEdge);
  }

  void visit(CircleOrder& order, std::size_t i) {
    for (std::size_t j = 0; j < circles_; ++j) set(j, j == i ? 0 : order.side(j));
    for (const int half : {1, -1}) {
      for (std::size_t q = 0; q < order.half_points(); ++q) {
        if (order.is_lowest(q)) {
          stop_at_vertex(order, i, q, half);
        } else {
          for (const std::uint32_t* j = order.begin(q); j != order.end(q); ++j) {
            layout_.flip(words_.data(), *j);
          }
        }
        give(CellKind::kEdge);
      }
    }
  }

 private:
  void stop_at_vertex(CircleOrder& order, std::size_t i, std::size_t q, int half) {
    const std::vector<std::uint32_t>& slopes = order.by_slope(q);
    const std::size_t t = slopes.size();
    for (const std::uint32_t c : slopes) set(c, 0);
    give(CellKind::kVertex);
    for (const std::uint32_t c : slopes) set(c, -1);
    for (std::size_t f = 0; f + 1 < t; ++f) {
      set(slopes[half > 0 ? f : t - 1 - f], 1);
      give(CellKind::kFace);
    }
    for (const std::uint32_t c : slopes) set(c, c == i ? 0 : -half * order.side(c));
  }

  void set(std::size_t circle, int sign) { layout_.set(words_.data(), circle, sign); }
  void set_all(int sign) {
    for (std::size_t j = 0; j < circles_; ++j) set(j, sign);
  }
  void give(CellKind kind) { visitor_(kind, PackedSigns(words_.data(), layout_.planes())); }

  std::size_t circles_;
  const SignLayout& layout_;
  const CellVisitor& visitor_;
  std::vector<Word> words_;
};

ArrangementCounts counts_of(const GreatCircles& circles, const Census& census) {
  ArrangementCounts counts;
  if (circles.normals.size() < 2) {
    counts.edges = circles.normals.size();
    counts.faces = circles.normals.size() + 1;
  } else {
    census.fill(counts);
  }
  arrangement_detail::complete_counts(counts, circles);
  return counts;
}

using FourSigns = std::array<Sign, 4>;

/// Returns the signs that each byte of digits spells. Some bytes have a digit 3, and are never
/// met.
std::array<FourSigns, 256> signs_of_bytes() {
  constexpr Sign kSignOfDigit[] = {Sign::kPositive, Sign::kNegative, Sign::kZero, Sign::kZero};
  std::array<FourSigns, 256> result{};
  for (std::size_t byte = 0; byte < 256; ++byte) {
    for (std::size_t i = 0; i < 4; ++i) {
      result[byte][i] = kSignOfDigit[(byte >> (6 - 2 * i)) & 3];
    }
  }
  return result;
}

}  // namespace

SlipState PackedSigns::unpack() const {
  static const std::array<FourSigns, 256> kSignsOfByte = signs_of_bytes();
  SlipState state(planes_);
  for (std::size_t p = 0; p < planes_; p += 4) {
    const Word byte = words_[p / kSignsPerWord] >> (shift_of(p) - 6) & 0xFF;
    std::copy_n(kSignsOfByte[byte].begin(), std::min<std::size_t>(4, planes_ - p),
                state.data() + p);
  }
  return state;
}

ArrangementCounts count_cells(const std::vector<Vector3>& plane_normals, unsigned threads,
                              SweepWork* work) {
  const GreatCircles circles = merge_planes(plane_normals);
  const FilteredNormals normals(circles.normals);
  const std::size_t k = normals.size();
  struct Scratch {
    CircleOrder order;
    Census census;
  };
  Census census(k);
  if (k > 1) {
    arrangement_detail::over_circles(
        k, threads,
        [&] {
          return Scratch{CircleOrder(normals), Census(k)};
        },
        [](Scratch& scratch, std::size_t i) {
          scratch.order.sort(i);
          scratch.census.add(scratch.order);
        },
        [&](Scratch& scratch) {
          census += scratch.census;
          if (work != nullptr) *work += scratch.order.work();
        });
  }
  return counts_of(circles, census);
}

ArrangementCounts visit_cells(const std::vector<Vector3>& plane_normals,
                              const CellVisitor& visitor, SweepWork* work) {
  const GreatCircles circles = merge_planes(plane_normals);
  const FilteredNormals normals(circles.normals);
  const SignLayout layout(circles, normals);
  const std::size_t k = normals.size();
  CellWalk cells(k, layout, visitor);
  cells.visit_poles();
  Census census(k);
  if (k > 1) {
    CircleOrder order(normals);
    for (std::size_t i = 0; i < k; ++i) {
      order.sort(i);
      census.add(order);
      cells.visit(order, i);
    }
    if (work != nullptr) *work += order.work();
  }
  return counts_of(circles, census);
}

SlipStates enumerate_slip_states_sweep(const std::vector<Vector3>& plane_normals,
                                       SweepWork* work) {
  arrangement_detail::StateList states(plane_normals.size());
  const ArrangementCounts counts = visit_cells(
      plane_normals, [&](CellKind, const PackedSigns& signs) { states.add(signs); }, work);
  return arrangement_detail::assemble_states(std::move(states), counts);
}

}  // namespace stickslip
