// SPDX-License-Identifier: GPL-3.0-or-later
#include "distinct_planes.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "stickslip/core/error.hpp"
#include "stickslip/lp/exact_system.hpp"

namespace stickslip::arrangement_detail {
namespace {

constexpr long kLargestWord = 1L << 60;

void round_to_one(const Row& row, double* result) {
  core_detail::round_to_one(row.data(), result, row.size());
}

/// Returns the sign of the first entry that is not 0.
int leading_sign(const Row& row) {
  for (const Integer& entry : row) {
    if (!entry.is_zero()) return entry.sign();
  }
  return 0;
}

}  // namespace

int rank_of(const std::vector<Row>& rows) {
  std::vector<RationalRow> rational;
  for (const Row& row : rows) rational.emplace_back(row.begin(), row.end());
  return static_cast<int>(stickslip::rank_of(rational));
}

int reduced_rank_of(const std::vector<ReducedRow>& rows, std::size_t n) {
  std::array<ReducedRow, kMostFaceCoordinates> pivots;
  std::array<std::size_t, kMostFaceCoordinates> columns;
  std::size_t rank = 0;
  for (ReducedRow row : rows) {
    for (std::size_t i = 0; i < rank; ++i) {
      const std::int64_t factor = row[columns[i]];
      if (factor == 0) continue;
      const std::int64_t scale = pivots[i][columns[i]];
      for (std::size_t j = 0; j < n; ++j) {
        row[j] =
            (row[j] * scale % kRankPrime - factor * pivots[i][j] % kRankPrime) % kRankPrime;
      }
    }
    std::size_t column = 0;
    while (column < n && row[column] == 0) ++column;
    if (column == n) continue;
    pivots[rank] = row;
    columns[rank] = column;
    if (++rank == n) break;
  }
  return static_cast<int>(rank);
}

DistinctPlanes::DistinctPlanes(std::size_t coordinates_of_points,
                               const std::vector<FacePlane>& planes)
    : coordinates(coordinates_of_points) {
  require(coordinates <= kMostFaceCoordinates, "faces: too many coordinates");
  // Planes are sorted by what is asked of their signs: those come first, as equations first.
  std::vector<std::size_t> order(planes.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto place = [&](std::size_t i) {
    const AllowedSigns side = planes[i].side;
    return side == AllowedSigns::kZero ? 0 : side == AllowedSigns::kAny ? 2 : 1;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return place(a) < place(b); });

  group.resize(planes.size());
  orientation.resize(planes.size(), Sign::kPositive);
  owner.resize(planes.size());
  struct Asked {
    bool zero = false;
    bool not_negative = false;
    bool not_positive = false;
    bool strict = false;
  };
  std::vector<Asked> signs;
  std::map<Row, std::size_t> known;
  for (const std::size_t i : order) {
    const FacePlane& plane = planes[i];
    require(plane.row.size() == coordinates, "faces: a row of another length");
    Row row = primitive(plane.row);
    const int leading = leading_sign(row);
    if (leading == 0) {
      possible = possible && plane.side != AllowedSigns::kPositive;
      continue;
    }
    if (leading < 0) row = negated(std::move(row));
    const auto [found, is_new] = known.emplace(row, rows.size());
    if (is_new) {
      rows.push_back(std::move(row));
      signs.emplace_back();
      asked.push_back(0);
    }
    const std::size_t g = found->second;
    group[i] = g;
    orientation[i] = sign_of_int(leading);
    Asked& at = signs[g];
    at.zero = at.zero || plane.side == AllowedSigns::kZero;
    if (plane.side == AllowedSigns::kNotNegative || plane.side == AllowedSigns::kPositive) {
      (leading > 0 ? at.not_negative : at.not_positive) = true;
      at.strict = at.strict || plane.side == AllowedSigns::kPositive;
      ++asked[g];
    }
  }
  require(rows.size() <= kMostFacePlanes, "faces: too many planes");
  std::vector<char> reversed(rows.size(), 0);
  for (std::size_t g = 0; g < rows.size(); ++g) {
    const Asked& at = signs[g];
    const bool zero = at.zero || (at.not_negative && at.not_positive);
    possible = possible && !(zero && at.strict);
    sides.push_back(zero                                 ? AllowedSigns::kZero
                    : at.strict                          ? AllowedSigns::kPositive
                    : at.not_negative || at.not_positive ? AllowedSigns::kNotNegative
                                                         : AllowedSigns::kAny);
    if (at.not_positive && !at.not_negative) {
      rows[g] = negated(std::move(rows[g]));
      reversed[g] = 1;
    }
  }
  owned.resize(rows.size());
  always_counts.resize(rows.size(), 0);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (group[i] && reversed[*group[i]] != 0) orientation[i] = -orientation[i];
    const auto& where_zero = planes[i].where_zero;
    if (where_zero) {
      require(*where_zero < planes.size() && planes[i].side == AllowedSigns::kAny &&
                  planes[*where_zero].side != AllowedSigns::kAny,
              "faces: a plane counts where one is 0 of which a sign is asked");
      owner[i] = group[*where_zero];  // A row that is 0 is 0 everywhere.
    }
    if (!group[i]) continue;
    if (owner[i]) {
      owned[*owner[i]].push_back(*group[i]);
    } else {
      always_counts[*group[i]] = 1;
    }
  }
  rounded.resize(rows.size() * coordinates);
  words.resize(rows.size() * coordinates);
  fits.resize(rows.size(), 1);
  reduced.resize(rows.size());
  for (std::size_t g = 0; g < rows.size(); ++g) {
    round_to_one(rows[g], &rounded[g * coordinates]);
    for (std::size_t j = 0; j < coordinates; ++j) {
      const Integer& entry = rows[g][j];
      reduced[g][j] = static_cast<std::int64_t>(mpz_fdiv_ui(entry.gmp(), kRankPrime));
      if (entry >= kLargestWord || entry <= -kLargestWord) {
        fits[g] = 0;
      } else {
        words[g * coordinates + j] = entry.convert_to<std::int64_t>();
      }
    }
  }
  rank = rank_of(rows);
}

}  // namespace stickslip::arrangement_detail
