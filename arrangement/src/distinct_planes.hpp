// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The distinct planes of an arrangement in Q^D, with what is asked of their signs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "stickslip/arrangement/faces.hpp"

namespace stickslip::arrangement_detail {

/// Returns the rank of rows of one length, exactly.
int rank_of(const std::vector<Row>& rows);

/// A prime, and a row modulo it; entries may be negative, and those beyond the row's are 0.
inline constexpr std::int64_t kRankPrime = 2147483647;
using ReducedRow = std::array<std::int64_t, kMostFaceCoordinates>;

/// Returns the rank of rows of `n` entries modulo the prime, which is at most their rank.
int reduced_rank_of(const std::vector<ReducedRow>& rows, std::size_t n);

/// The distinct planes; equal and opposite ones are merged. Rows are primitive. A plane on
/// which something is asked is oriented so that positive is the side that is allowed.
struct DistinctPlanes {
  /// Merges planes. Checks what FacePlane and visit_faces() require.
  DistinctPlanes(std::size_t coordinates, const std::vector<FacePlane>& planes);

  std::size_t size() const { return rows.size(); }

  std::size_t coordinates;          ///< D
  std::vector<Row> rows;            ///< by distinct plane
  std::vector<double> rounded;      ///< D numbers a plane, in_doubles() of its row
  std::vector<std::int64_t> words;  ///< D numbers a plane; of no meaning where `fits` is false
  std::vector<char> fits;           ///< whether a row is in words below 2^60
  std::vector<ReducedRow> reduced;  ///< by distinct plane
  std::vector<AllowedSigns> sides;  ///< by distinct plane
  /// The number of given planes on a distinct one that are not kAny: how many are positive
  /// where it is.
  std::vector<std::size_t> asked;
  std::vector<std::vector<std::size_t>> owned;  ///< the planes that count where this one is 0
  std::vector<char> always_counts;              ///< whether a given plane there always counts
  int rank = 0;                                 ///< the rank of all rows
  bool possible = true;  ///< false if no point has the signs that are asked of one plane

  /// The distinct plane of each given one; nothing for a row that is 0.
  std::vector<std::optional<std::size_t>> group;
  std::vector<Sign> orientation;  ///< of each given plane beside its distinct one
  /// The distinct plane that has to be 0 where a given plane counts.
  std::vector<std::optional<std::size_t>> owner;
};

}  // namespace stickslip::arrangement_detail
