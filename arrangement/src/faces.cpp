// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/arrangement/faces.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <numeric>
#include <thread>
#include <type_traits>
#include <utility>

#include "face_walk.hpp"
#include "stickslip/core/cancellation.hpp"

namespace stickslip {
namespace arrangement_detail {

void move_into_plane(std::vector<Row>& vectors, const Row& plane, const Row& line) {
  const Integer scale = dot(plane, line);
  for (Row& vector : vectors) {
    const Integer height = dot(plane, vector);
    if (height.is_zero()) continue;
    for (std::size_t j = 0; j < vector.size(); ++j) {
      vector[j] = scale * vector[j] - height * line[j];
    }
    vector = primitive(std::move(vector));
  }
}

std::optional<Row> take_line(Generators& of, const Row& plane) {
  for (std::size_t i = 0; i < of.lines.size(); ++i) {
    const int side = dot(plane, of.lines[i]).sign();
    if (side == 0) continue;
    Row line = std::move(of.lines[i]);
    of.lines.erase(of.lines.begin() + static_cast<std::ptrdiff_t>(i));
    if (side < 0) line = negated(std::move(line));
    move_into_plane(of.lines, plane, line);
    move_into_plane(of.rays, plane, line);
    return line;
  }
  return std::nullopt;
}

int rank_modulo_prime(const std::vector<const std::int64_t*>& rows, std::size_t n) {
  constexpr std::int64_t kPrime = 2147483647;
  using Reduced = std::array<std::int64_t, kMostFaceCoordinates>;
  std::array<Reduced, kMostFaceCoordinates> pivots;
  std::array<std::size_t, kMostFaceCoordinates> columns;
  std::size_t rank = 0;
  for (const std::int64_t* row : rows) {
    Reduced reduced;
    for (std::size_t j = 0; j < n; ++j) reduced[j] = row[j] % kPrime;
    for (std::size_t i = 0; i < rank; ++i) {
      const std::int64_t factor = reduced[columns[i]];
      if (factor == 0) continue;
      const std::int64_t scale = pivots[i][columns[i]];
      for (std::size_t j = 0; j < n; ++j) {
        reduced[j] = (reduced[j] * scale % kPrime - factor * pivots[i][j] % kPrime) % kPrime;
      }
    }
    std::size_t column = 0;
    while (column < n && reduced[column] == 0) ++column;
    if (column == n) continue;
    pivots[rank] = reduced;
    columns[rank] = column;
    if (++rank == n) break;
  }
  return static_cast<int>(rank);
}

}  // namespace arrangement_detail

namespace {

using arrangement_detail::DistinctPlanes;
using arrangement_detail::FaceWalk;
using arrangement_detail::GoOn;
using arrangement_detail::WalkPart;

FaceCounts walk(const DistinctPlanes& planes, const FaceVisitor* visitor,
                const FaceOptions& options, GoOn& go_on, WalkPart part = {}) {
  const auto run = [&](auto words) {
    return FaceWalk<words>(planes, options, visitor, go_on, part).run();
  };
  const std::size_t n = planes.size();
  return n <= 64    ? run(std::integral_constant<std::size_t, 1>{})
         : n <= 128 ? run(std::integral_constant<std::size_t, 2>{})
                    : run(std::integral_constant<std::size_t, kMostFacePlanes / 64>{});
}

/// Adds the counts of another part of a walk.
void add(FaceCounts& sum, const FaceCounts& part) {
  for (std::size_t j = 0; j < sum.by_dimension.size(); ++j) {
    sum.by_dimension[j] += part.by_dimension[j];
  }
  sum.complete = sum.complete && part.complete;
  sum.lines += part.lines;
  sum.splits += part.splits;
  sum.signs += part.signs;
  sum.exact_signs += part.exact_signs;
  if (part.near.distance < sum.near.distance) sum.near = part.near;
}

}  // namespace

Row Face::motion() const {
  Row motion = reader_->motion();
  return negated_ ? negated(std::move(motion)) : motion;
}

bool Face::motion_in_words(std::int64_t* to) const {
  if (!reader_->motion_in_words(to)) return false;
  if (negated_) {
    for (std::size_t j = 0; j < reader_->coordinates(); ++j) to[j] = -to[j];
  }
  return true;
}

std::uint64_t FaceCounts::total() const {
  return std::accumulate(by_dimension.begin(), by_dimension.end(), std::uint64_t{0});
}

FaceCounts visit_faces(std::size_t coordinates, const std::vector<FacePlane>& planes,
                       const FaceVisitor& visitor, const FaceOptions& options) {
  GoOn go_on(options);
  return walk(DistinctPlanes(coordinates, planes), &visitor, options, go_on);
}

FaceCounts count_faces(std::size_t coordinates, const std::vector<FacePlane>& planes,
                       const FaceOptions& options, unsigned threads) {
  const DistinctPlanes distinct(coordinates, planes);
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  GoOn go_on(options);
  if (threads == 1) return walk(distinct, nullptr, options, go_on);
  std::vector<FaceCounts> parts(threads);
  Cancellation* const cancellation = Cancellation::current();
  tbb::task_arena arena(static_cast<int>(threads));
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
      const SharedCancellation shared(cancellation);
      parts[i] = walk(distinct, nullptr, options, go_on, {i, parts.size()});
    });
  });
  FaceCounts sum = std::move(parts.front());
  for (std::size_t i = 1; i < parts.size(); ++i) add(sum, parts[i]);
  return sum;
}

}  // namespace stickslip
