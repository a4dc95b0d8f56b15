// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The lines of an arrangement, each with its signs on all planes.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "distinct_planes.hpp"
#include "plane_set.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip::arrangement_detail {

/// A direction of a line: 2 * its index, + 1 if it is the opposite of the direction stored.
using Ray = std::uint32_t;

/// Returns the opposite direction.
inline Ray opposite(Ray ray) {
  return ray ^ 1;
}

/// The counters of FaceCounts that lines have.
struct LineWork {
  std::uint64_t lines = 0;
  std::uint64_t signs = 0;
  std::uint64_t exact_signs = 0;
  std::size_t near_plane = 0;  ///< the distinct plane of the nearest miss
  double near = std::numeric_limits<double>::infinity();
};

/// Lines, given by primitive integer directions. A line is known by the planes that contain it:
/// all lines must be in one subspace in which these determine it.
template <std::size_t words>
class LineStore {
 public:
  using Set = PlaneSet<words>;

  LineStore(const DistinctPlanes& planes, LineWork& work)
      : planes_(planes), work_(work), dimension_(planes.coordinates) {
    for (std::size_t g = 0; g < planes.size(); ++g) all_.set(g);
    clear();
  }

  /// Forgets all lines.
  void clear() {
    signs_.clear();
    zeros_.clear();
    coordinates_.clear();
    long_index_.clear();
    long_.clear();
    by_zeros_.assign(kFirstSize, kNoLine);
    between_.assign(kFirstSize, Meeting{});
    meetings_ = 0;
  }

  const Set& positive(Ray ray) const { return signs_[ray].positive; }
  const Set& negative(Ray ray) const { return signs_[ray ^ 1].positive; }
  const Set& zero(Ray ray) const { return zeros_[ray >> 1]; }

  /// Returns the ray of a primitive vector, which is not 0.
  Ray add(const Row& vector) {
    const Signs signs = signs_of(vector);
    const Set zero = all_ - (signs.positive | signs.negative);
    std::size_t place = find(zero);
    if (by_zeros_[place] == kNoLine) place = insert(vector, signs, zero);
    return oriented(by_zeros_[place], signs.positive, signs.negative);
  }

  /// Returns the ray between p and q, adjacent rays of a cone, on a plane that has them on
  /// opposite sides.
  Ray between(Ray p, Ray q, std::size_t plane) {
    const Set flat = zero(p) & zero(q);
    std::size_t place = find(flat, plane);
    if (between_[place].line == kNoLine) {
      const Row vector = intersection(p, q, plane);
      const Ray ray = add(vector);
      if (3 * (meetings_ + 1) > 2 * between_.size()) {
        grow_meetings();
        place = find(flat, plane);
      }
      between_[place] = {flat, static_cast<std::uint32_t>(plane), ray >> 1};
      ++meetings_;
    }
    return oriented(between_[place].line,
                    (positive(p) | positive(q)) - (negative(p) | negative(q)),
                    (negative(p) | negative(q)) - (positive(p) | positive(q)));
  }

  /// Returns the direction of a ray.
  Row vector(Ray ray) const {
    Row result(dimension_);
    add_to(result, ray);
    return result;
  }
  /// Adds the direction of a ray.
  void add_to(Row& sum, Ray ray) const {
    const std::size_t line = ray >> 1;
    if (long_index_[line] != kNoLine) {
      const Row& vector = long_[long_index_[line]];
      for (std::size_t j = 0; j < dimension_; ++j) {
        if ((ray & 1) != 0) {
          sum[j] -= vector[j];
        } else {
          sum[j] += vector[j];
        }
      }
      return;
    }
    for (std::size_t j = 0; j < dimension_; ++j) {
      const std::int64_t entry = coordinates_[line * dimension_ + j];
      sum[j] += (ray & 1) != 0 ? -entry : entry;
    }
  }
  /// Returns the coordinates of a ray's line where they are in words below 2^52, else null. A
  /// sum of a thousand such words is one as well.
  const std::int64_t* in_words(Ray ray) const {
    const std::size_t line = ray >> 1;
    return long_index_[line] == kNoLine ? &coordinates_[line * dimension_] : nullptr;
  }

 private:
  __extension__ using Int128 = __int128;
  struct Signs {
    Set positive;
    Set negative;
  };
  struct OneSide {
    Set positive;
  };
  struct Meeting {
    Set flat{};
    std::uint32_t plane = 0;
    std::uint32_t line = kNoLine;
  };
  static constexpr std::uint32_t kNoLine = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::size_t kFirstSize = 64;
  static constexpr std::int64_t kLargestWord = std::int64_t{1} << 52;

  static std::size_t hash(const Set& set, std::size_t plane) {
    std::uint64_t h = 0x9E3779B97F4A7C15U * (plane + 1);
    for (const std::uint64_t w : set.word) {
      h = (h ^ w) * 0xFF51AFD7ED558CCDU;
      h ^= h >> 32;
    }
    return static_cast<std::size_t>(h ^ h >> 29);
  }

  std::size_t find(const Set& zero) const {
    std::size_t i = hash(zero, 0) & (by_zeros_.size() - 1);
    while (by_zeros_[i] != kNoLine && !(zeros_[by_zeros_[i]] == zero)) {
      i = (i + 1) & (by_zeros_.size() - 1);
    }
    return i;
  }
  std::size_t find(const Set& flat, std::size_t plane) const {
    std::size_t i = hash(flat, plane) & (between_.size() - 1);
    while (between_[i].line != kNoLine &&
           !(between_[i].plane == plane && between_[i].flat == flat)) {
      i = (i + 1) & (between_.size() - 1);
    }
    return i;
  }

  /// Stores a line that is not there, and returns its place in the table.
  std::size_t insert(const Row& vector, const Signs& signs, const Set& zero) {
    const std::size_t line = zeros_.size();
    require(line < kNoLine / 2, "faces: too many lines");
    ++work_.lines;
    signs_.push_back({signs.positive});
    signs_.push_back({signs.negative});
    zeros_.push_back(zero);
    bool fits = true;
    for (const Integer& entry : vector) {
      fits = fits && entry < kLargestWord && entry > -kLargestWord;
    }
    long_index_.push_back(fits ? kNoLine : static_cast<std::uint32_t>(long_.size()));
    if (!fits) long_.push_back(vector);
    for (const Integer& entry : vector) {
      coordinates_.push_back(fits ? entry.convert_to<std::int64_t>() : 0);
    }
    if (3 * zeros_.size() > 2 * by_zeros_.size()) {
      by_zeros_.assign(2 * by_zeros_.size(), kNoLine);
      for (std::size_t each = 0; each < zeros_.size(); ++each) {
        by_zeros_[find(zeros_[each])] = static_cast<std::uint32_t>(each);
      }
    }
    const std::size_t place = find(zero);
    by_zeros_[place] = static_cast<std::uint32_t>(line);
    return place;
  }

  void grow_meetings() {
    std::vector<Meeting> old(2 * between_.size());
    old.swap(between_);
    for (const Meeting& each : old) {
      if (each.line != kNoLine) between_[find(each.flat, each.plane)] = each;
    }
  }

  /// Returns the direction of a line that is positive on `positive` and negative on `negative`.
  Ray oriented(std::uint32_t line, const Set& positive_there, const Set& negative_there) const {
    const Ray ray = 2 * line;
    if (positive_there.any()) {
      return positive(ray).get(positive_there.first()) ? ray : opposite(ray);
    }
    require(negative_there.any(), "faces: a cone has a line");
    return negative(ray).get(negative_there.first()) ? ray : opposite(ray);
  }

  Signs signs_of(const Row& vector) {
    std::array<double, kMostFaceCoordinates> rounded{};
    core_detail::round_to_one(vector.data(), rounded.data(), dimension_);
    // Entries are at most 1 and off by at most two roundoffs, so that each product is off by
    // less than five, and the sum by D more of D. One more is for products of roundoffs and for
    // what underflows.
    const double bound = static_cast<double>(dimension_ * (dimension_ + 6)) *
                         (std::numeric_limits<double>::epsilon() / 2);
    Signs result;
    for (std::size_t g = 0; g < planes_.size(); ++g) {
      const double* plane = &planes_.rounded[g * dimension_];
      double sum = 0;
      for (std::size_t j = 0; j < dimension_; ++j) sum += plane[j] * rounded[j];
      int sign = sum > bound ? 1 : sum < -bound ? -1 : 0;
      ++work_.signs;
      if (sign == 0) {
        ++work_.exact_signs;
        sign = dot(planes_.rows[g], vector).sign();
      }
      if (sign == 0) continue;
      (sign > 0 ? result.positive : result.negative).set(g);
      const double distance = std::fabs(sum);
      if (distance < work_.near) {
        work_.near = distance;
        work_.near_plane = g;
      }
    }
    return result;
  }

  /// Returns the point of a plane on the way from p to q, primitive.
  Row intersection(Ray p, Ray q, std::size_t plane) const {
    Row result(dimension_);
    if (short_intersection(p, q, plane, result)) return result;
    const Row a = vector(p);
    const Row b = vector(q);
    const Integer x = dot(planes_.rows[plane], a);
    const Integer y = dot(planes_.rows[plane], b);
    for (std::size_t j = 0; j < dimension_; ++j) {
      result[j] = x.sign() > 0 ? x * b[j] - y * a[j] : y * a[j] - x * b[j];
    }
    return primitive(std::move(result));
  }

  static Int128 size_of(Int128 value) { return value < 0 ? -value : value; }
  static Int128 common_divisor(Int128 a, Int128 b) {
    while (b != 0) {
      if (a <= std::numeric_limits<std::int64_t>::max() &&
          b <= std::numeric_limits<std::int64_t>::max()) {
        auto s = static_cast<std::uint64_t>(a);
        auto t = static_cast<std::uint64_t>(b);
        while (t != 0) s = std::exchange(t, s % t);
        return static_cast<Int128>(s);
      }
      a = std::exchange(b, a % b);
    }
    return a;
  }

  /// Does the same in words, if the numbers are short enough.
  bool short_intersection(Ray p, Ray q, std::size_t plane, Row& result) const {
    const std::int64_t* a = in_words(p);
    const std::int64_t* b = in_words(q);
    if (a == nullptr || b == nullptr || planes_.fits[plane] == 0) return false;
    const std::int64_t* row = &planes_.words[plane * dimension_];
    // At most 12 products below 2^112 are added.
    Int128 x = 0;
    Int128 y = 0;
    for (std::size_t j = 0; j < dimension_; ++j) {
      x += static_cast<Int128>(row[j]) * a[j];
      y += static_cast<Int128>(row[j]) * b[j];
    }
    if ((p & 1) != 0) x = -x;
    if ((q & 1) != 0) y = -y;
    const Int128 divisor = common_divisor(size_of(x), size_of(y));
    // The factor of b is positive, and that of a as well.
    const Int128 of_b = size_of(x) / divisor * ((q & 1) != 0 ? -1 : 1);
    const Int128 of_a = size_of(y) / divisor * ((p & 1) != 0 ? -1 : 1);
    constexpr Int128 kLargestFactor = static_cast<Int128>(1) << 67;
    if (size_of(of_a) >= kLargestFactor || size_of(of_b) >= kLargestFactor) return false;
    std::array<Int128, kMostFaceCoordinates> sum;
    Int128 content = 0;
    for (std::size_t j = 0; j < dimension_; ++j) {
      sum[j] = of_a * a[j] + of_b * b[j];
      content = common_divisor(size_of(sum[j]), content);
    }
    for (std::size_t j = 0; j < dimension_; ++j) {
      const Int128 entry = sum[j] / content;
      if (size_of(entry) > std::numeric_limits<std::int64_t>::max()) return false;
      result[j] = static_cast<std::int64_t>(entry);
    }
    return true;
  }

  const DistinctPlanes& planes_;
  LineWork& work_;
  std::size_t dimension_;
  Set all_;
  std::vector<OneSide> signs_;             ///< the positive planes of each ray
  std::vector<Set> zeros_;                 ///< the planes through each line
  std::vector<std::int64_t> coordinates_;  ///< D numbers a line; 0 for long ones
  std::vector<std::uint32_t> long_index_;  ///< the place in long_; kNoLine for short ones
  std::vector<Row> long_;
  std::vector<std::uint32_t> by_zeros_;  ///< a hash table of lines by their zeros
  std::vector<Meeting> between_;         ///< a hash table of lines by flat and plane
  std::size_t meetings_ = 0;
};

}  // namespace stickslip::arrangement_detail
