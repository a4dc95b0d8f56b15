// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The fast enumerator: exact, streaming, for thousands of planes.
///
/// The planes n_i.d = 0 are any central planes of R^3; their cells on the unit sphere are the
/// regions (faces), facets (edges) and lines (vertices) of Haas-Heger et al., RSS 2018,
/// Section IV. The circles are walked one by one. On a circle the crossings with the others
/// are sorted by angle, each adjacent pair is confirmed by the exact sign of
/// det(n_i, n_j, n_k), and every crossing changes the signs of the circles that cross there.
/// Where three or more circles pass through one point that point is one vertex: ties are
/// found exactly, and nothing is perturbed.
///
/// Every face is met exactly once without being traced: see src/sweep.cpp.
///
/// Cost, for m planes on k distinct circles: O(m + k^2 log k) operations and O(m + k) memory
/// to count; to visit, O(1) sign changes more a cell (O(1 + p) for p planes on one circle).
/// Almost all operations are in double precision; what the error bound leaves open goes to
/// 128-bit integers, and to GMP when those are too short (filtered_normals.hpp).
///
/// Everything here is deterministic: results, the order of visits, and the work counters
/// depend on the planes alone, not on the number of threads. `threads` = 0 stands for all that
/// the machine has. Functions throw ContractError if a normal is zero or if an internal check
/// fails, in every build type.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "stickslip/arrangement/slip_states.hpp"

namespace stickslip {

/// The signs of all planes on one cell, two bits a plane: what the sweep hands out, so that no
/// table of all sign vectors has to exist. A view of words that belong to somebody else.
///
/// Plane p has the digit 0 for '+', 1 for '-', 2 for '0': its sign's place in the order of
/// texts. Digit p stands in word p / 32, the first plane of a word in its most significant
/// bits; unused digits are 0. So two vectors over the same planes compare as their texts do
/// by comparing words from the first to the last, and are equal iff their words are.
class PackedSigns {
 public:
  using Word = std::uint64_t;                       ///< holds the digits
  static constexpr std::size_t kSignsPerWord = 32;  ///< at two bits each

  /// Returns the number of words for so many planes: at least one, also for no plane.
  static constexpr std::size_t words_for(std::size_t planes) {
    return planes == 0 ? 1 : (planes + kSignsPerWord - 1) / kSignsPerWord;
  }
  /// Returns how far left the digit of `plane` stands in its word.
  static constexpr unsigned shift_of(std::size_t plane) {
    return static_cast<unsigned>(2 * (kSignsPerWord - 1 - plane % kSignsPerWord));
  }

  /// Returns the digit of a sign.
  static constexpr Word digit(Sign sign) {
    return sign == Sign::kPositive ? 0 : sign == Sign::kNegative ? 1 : 2;
  }

  /// Makes a view of words_for(planes) words at `words`, which must outlive the view.
  PackedSigns(const Word* words, std::size_t planes) : words_(words), planes_(planes) {}

  std::size_t size() const { return planes_; }  ///< the number of planes
  /// Returns the sign of `plane`, which must be below size(). O(1).
  Sign operator[](std::size_t plane) const {
    constexpr Sign kSignOfDigit[] = {Sign::kPositive, Sign::kNegative, Sign::kZero};
    return kSignOfDigit[(words_[plane / kSignsPerWord] >> shift_of(plane)) & 3];
  }

  const Word* words() const { return words_; }  ///< the digits, word_count()
  /// Returns the number of words, at least 1.
  std::size_t word_count() const { return words_for(planes_); }

  /// Returns a copy that owns its signs. O(size()).
  SlipState unpack() const;

  /// Compares the planes and their signs.
  friend bool operator==(const PackedSigns& a, const PackedSigns& b) {
    return a.planes_ == b.planes_ && std::equal(a.words_, a.words_ + a.word_count(), b.words_);
  }

 private:
  const Word* words_;
  std::size_t planes_;
};

/// A vertex, edge or face of the arrangement: 0-, 1- or 2-dimensional on the sphere.
enum class CellKind : std::uint8_t { kVertex, kEdge, kFace };

/// The number of exact signs that were asked for, by what decided them.
struct SweepWork {
  std::uint64_t by_double = 0;  ///< the error bound sufficed
  std::uint64_t by_int128 = 0;  ///< 128-bit integers sufficed
  std::uint64_t by_gmp = 0;     ///< integers of any length were needed
  /// The circles whose order in double precision was so wrong that they were sorted again by
  /// exact comparisons only. This bounds the work at O(k log k) exact signs a circle.
  std::uint64_t exact_sorts = 0;

  /// Adds the counts of another sweep.
  SweepWork& operator+=(const SweepWork& other) {
    by_double += other.by_double;
    by_int128 += other.by_int128;
    by_gmp += other.by_gmp;
    exact_sorts += other.exact_sorts;
    return *this;
  }
};

/// Counts the cells without visiting them, in O(m) memory a thread. No face is traced: F
/// follows from V and E by V - E + F = 2, which therefore checks nothing. Another check is
/// made: a vertex on t circles is found independently from each of them, so for every t the
/// number of (circle, vertex) pairs must be t times the number of vertices counted at their
/// lowest circle.
ArrangementCounts count_cells(const std::vector<Vector3>& plane_normals, unsigned threads = 1,
                              SweepWork* work = nullptr);

/// A function that takes a cell. Its signs are valid during the call.
using CellVisitor = std::function<void(CellKind, const PackedSigns&)>;

/// Calls `visitor` for every cell of the sphere exactly once, in a fixed order, with the signs
/// of all planes on it. All-stick is given only where it is a cell: at rank 2 by both vertices,
/// at rank 1 by the edge, at rank 0 by the face. At rank 3 no cell has it, yet it is a slip
/// state.
ArrangementCounts visit_cells(const std::vector<Vector3>& plane_normals,
                              const CellVisitor& visitor, SweepWork* work = nullptr);

/// Returns the same result as enumerate_slip_states_cgal, in the same order. The states take
/// O(m^3) memory; to count or to stream them, use the functions above.
SlipStates enumerate_slip_states_sweep(const std::vector<Vector3>& plane_normals,
                                       SweepWork* work = nullptr);

}  // namespace stickslip
