// SPDX-License-Identifier: GPL-3.0-or-later
#include "faces_by_programs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "stickslip/lp/linear_program.hpp"

namespace stickslip::test {
namespace {

/// Returns whether some point has these signs, scaled so that signs other than 0 are of numbers
/// of at least 1.
bool is_possible(std::size_t coordinates, const std::vector<FacePlane>& planes,
                 const std::vector<int>& signs) {
  LinearProgram program;
  program.add_variables(coordinates, VariableKind::kFree);
  for (std::size_t i = 0; i < signs.size(); ++i) {
    std::vector<Rational> row(planes[i].row.begin(), planes[i].row.end());
    program.add_row(std::move(row),
                    signs[i] == 0  ? Relation::kEqual
                    : signs[i] > 0 ? Relation::kGreaterEqual
                                   : Relation::kLessEqual,
                    signs[i]);
  }
  return !std::holds_alternative<Infeasible>(solve(program));
}

bool is_asked(AllowedSigns side, int sign) {
  return side == AllowedSigns::kAny || (side == AllowedSigns::kZero && sign == 0) ||
         (side == AllowedSigns::kNotNegative && sign >= 0) ||
         (side == AllowedSigns::kPositive && sign > 0);
}

/// A distinct plane with the least index of those that it was made of.
using Restricted = std::map<Row, std::size_t>;

/// Returns a multiple of the row with a positive leading entry and no common divisor; nothing
/// if it is 0.
std::optional<Row> normal_form(Row row) {
  row = primitive(std::move(row));
  for (const Integer& entry : row) {
    if (!entry.is_zero()) return entry.sign() > 0 ? row : negated(std::move(row));
  }
  return std::nullopt;
}

/// Returns the row as a function on the plane, whose coordinate at the pivot is eliminated.
std::optional<Row> restricted(const Row& row, const Row& plane) {
  std::size_t pivot = 0;
  while (plane[pivot].is_zero()) ++pivot;
  Row result;
  for (std::size_t j = 0; j < row.size(); ++j) {
    if (j != pivot) result.push_back(row[j] * plane[pivot] - row[pivot] * plane[j]);
  }
  return normal_form(std::move(result));
}

std::uint64_t chambers(const std::vector<Row>& rows) {
  std::uint64_t result = 1;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::set<Row> on_plane;
    for (std::size_t j = 0; j < i; ++j) {
      if (auto row = restricted(rows[j], rows[i])) on_plane.insert(std::move(*row));
    }
    result += chambers({on_plane.begin(), on_plane.end()});
  }
  return result;
}

/// Adds the chambers on this flat and on each that is reached by planes from number `first`.
void add_flats(const Restricted& planes, std::size_t first, std::size_t dimension,
               std::vector<std::uint64_t>& counts) {
  std::vector<Row> rows;
  for (const auto& [row, index] : planes) rows.push_back(row);
  counts[dimension] += chambers(rows);
  for (const auto& [plane, index] : planes) {
    if (index < first) continue;
    Restricted on_plane;
    for (const auto& [row, other] : planes) {
      if (other == index) continue;
      const auto found = on_plane.emplace(*restricted(row, plane), other);
      if (!found.second) found.first->second = std::min(found.first->second, other);
    }
    add_flats(on_plane, index + 1, dimension - 1, counts);
  }
}

}  // namespace

std::vector<std::string> faces_by_programs(std::size_t coordinates,
                                           const std::vector<FacePlane>& planes) {
  std::set<std::string> found;
  std::vector<int> signs;
  const std::function<void()> extend = [&] {
    // Signs that contradict one another are not extended.
    if (!is_possible(coordinates, planes, signs)) return;
    if (signs.size() == planes.size()) {
      std::string text;
      for (std::size_t i = 0; i < signs.size(); ++i) {
        const auto& owner = planes[i].where_zero;
        text += owner && signs[*owner] != 0 ? '.' : to_char(sign_of_int(signs[i]));
      }
      found.insert(text);
      return;
    }
    for (const int sign : {1, -1, 0}) {
      if (!is_asked(planes[signs.size()].side, sign)) continue;
      signs.push_back(sign);
      extend();
      signs.pop_back();
    }
  };
  extend();
  return {found.begin(), found.end()};
}

std::vector<std::uint64_t> faces_by_restriction(std::size_t coordinates,
                                                const std::vector<Row>& rows) {
  Restricted planes;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (auto row = normal_form(rows[i])) planes.emplace(std::move(*row), i);
  }
  std::vector<std::uint64_t> counts(coordinates + 1);
  add_flats(planes, 0, coordinates, counts);
  return counts;
}

std::string signs_of(const Face& face, std::size_t planes) {
  std::string text;
  for (std::size_t i = 0; i < planes; ++i) {
    const std::optional<Sign> sign = face.sign(i);
    text += sign ? to_char(*sign) : '.';
  }
  return text;
}

/// Returns decimal digits, one by one.
std::string digits_of(LongWord value) {
  if (value < 0) return "-" + digits_of(-value);
  if (value > 9) return digits_of(value / 10) + digits_of(value % 10);
  return std::string(1, static_cast<char>('0' + static_cast<int>(value)));
}

std::vector<std::string> checked_faces(std::size_t coordinates,
                                       const std::vector<FacePlane>& planes,
                                       const FaceOptions& options) {
  std::vector<std::string> found;
  std::vector<std::uint64_t> by_dimension(coordinates + 1);
  const FaceCounts counts = visit_faces(
      coordinates, planes,
      [&](const Face& face) {
        found.push_back(signs_of(face, planes.size()));
        ++by_dimension[static_cast<std::size_t>(face.dimension())];
        const Row motion = face.motion();
        for (std::size_t i = 0; i < planes.size(); ++i) {
          const auto sign = face.sign(i);
          if (sign) {
            EXPECT_EQ(sign_of(dot(planes[i].row, motion)), *sign) << found.back();
          }
          EXPECT_TRUE(is_asked(planes[i].side, sign ? to_int(*sign) : 0)) << found.back();
        }
        std::vector<LongWord> words(coordinates);
        if (face.motion_in_words(words.data())) {
          for (std::size_t j = 0; j < coordinates; ++j) {
            EXPECT_EQ(motion[j].str(), digits_of(words[j]));
          }
        }
        return true;
      },
      options);
  EXPECT_EQ(counts.by_dimension, by_dimension);
  EXPECT_TRUE(counts.complete);
  EXPECT_EQ(count_faces(coordinates, planes, options).by_dimension, by_dimension);
  std::sort(found.begin(), found.end());
  EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end()) << "a face came twice";
  return found;
}

}  // namespace stickslip::test
