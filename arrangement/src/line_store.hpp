// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The lines of an arrangement, each with its signs on all planes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "distinct_planes.hpp"
#include "long_word.hpp"
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
    place_.clear();
    short_.clear();
    double_.clear();
    long_.clear();
    known_.assign(kFirstSize, Known{});
    entries_ = 0;
  }

  const Set& positive(Ray ray) const { return signs_[ray].positive; }
  const Set& negative(Ray ray) const { return signs_[ray ^ 1].positive; }
  const Set& zero(Ray ray) const { return zeros_[ray >> 1]; }

  /// Returns the ray of a primitive vector, which is not 0, given planes that contain it.
  Ray add(const Row& vector, const Set& through = {}) {
    const Signs signs = signs_of(vector, through);
    const Set zero = all_ - (signs.positive | signs.negative);
    std::uint32_t line = known_[find(zero)].line;
    if (line == kNoLine) line = insert(vector, signs, zero);
    return oriented(line, signs.positive, signs.negative);
  }

  /// Returns the ray between p and q, adjacent rays of a cone, on a plane that has them on
  /// opposite sides.
  Ray between(Ray p, Ray q, std::size_t plane) {
    // These planes determine the line, though others may contain it as well.
    Set through = zero(p) & zero(q);
    through.set(plane);
    std::uint32_t line = known_[find(through)].line;
    if (line == kNoLine) {
      line = add(intersection(p, q, plane), through) >> 1;
      if (!(zeros_[line] == through)) remember(through, line);
    }
    return oriented(line, (positive(p) | positive(q)) - (negative(p) | negative(q)),
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
    const Place place = place_[ray >> 1];
    for (std::size_t j = 0; j < dimension_; ++j) {
      const Integer entry = place.length == Length::kShort ? Integer(at(short_, place)[j])
                            : place.length == Length::kDouble
                                ? integer_of(at(double_, place)[j])
                                : at(long_, place)[j];
      if ((ray & 1) != 0) {
        sum[j] -= entry;
      } else {
        sum[j] += entry;
      }
    }
  }
  /// Adds the direction of a ray, a thousand times at most. Returns whether it is short enough.
  bool add_to(LongWord* sum, Ray ray) const {
    const Place place = place_[ray >> 1];
    if (place.length == Length::kShort) {
      add(at(short_, place), ray, sum);
    } else if (place.length == Length::kDouble) {
      add(at(double_, place), ray, sum);
    }
    return place.length != Length::kLong;
  }
  /// Returns the coordinates of a ray's line, modulo the prime.
  ReducedRow reduced(Ray ray) const {
    const Place place = place_[ray >> 1];
    ReducedRow result{};
    for (std::size_t j = 0; j < dimension_; ++j) {
      result[j] = static_cast<std::int64_t>(
          place.length == Length::kShort ? at(short_, place)[j] % kRankPrime
          : place.length == Length::kDouble
              ? at(double_, place)[j] % kRankPrime
              : mpz_fdiv_ui(at(long_, place)[j].gmp(), kRankPrime));
    }
    return result;
  }

 private:
  /// The length of coordinates: words below 2^52, two words below 2^116, or longer.
  enum class Length : std::uint8_t { kShort, kDouble, kLong };
  /// The place of the D coordinates of a line.
  struct Place {
    std::uint32_t number;  ///< among the lines of this length
    Length length;
  };
  struct Signs {
    Set positive;
    Set negative;
  };
  struct OneSide {
    Set positive;
  };
  /// Planes that only one line is on.
  struct Known {
    Set planes{};
    std::uint32_t line = kNoLine;
  };
  static constexpr std::uint32_t kNoLine = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::size_t kFirstSize = 64;
  static constexpr std::size_t kShortBits = 52;
  static constexpr std::size_t kDoubleBits = 116;

  /// Returns the place in the table of these planes, or where they would be.
  std::size_t find(const Set& planes) const {
    std::uint64_t h = 0x9E3779B97F4A7C15U;
    for (const std::uint64_t w : planes.word) {
      h = (h ^ w) * 0xFF51AFD7ED558CCDU;
      h ^= h >> 32;
    }
    std::size_t i = static_cast<std::size_t>(h ^ h >> 29) & (known_.size() - 1);
    while (known_[i].line != kNoLine && !(known_[i].planes == planes)) {
      i = (i + 1) & (known_.size() - 1);
    }
    return i;
  }

  /// Remembers planes that were not known to determine a line.
  void remember(const Set& planes, std::uint32_t line) {
    if (3 * ++entries_ > 2 * known_.size()) {
      std::vector<Known> old(2 * known_.size());
      old.swap(known_);
      for (const Known& each : old) {
        if (each.line != kNoLine) known_[find(each.planes)] = each;
      }
    }
    known_[find(planes)] = {planes, line};
  }

  /// Stores a line that is not there, and returns its number.
  std::uint32_t insert(const Row& vector, const Signs& signs, const Set& zero) {
    require(zeros_.size() < kNoLine / 2, "faces: too many lines");
    const auto line = static_cast<std::uint32_t>(zeros_.size());
    ++work_.lines;
    signs_.push_back({signs.positive});
    signs_.push_back({signs.negative});
    zeros_.push_back(zero);
    std::size_t bits = 0;
    for (const Integer& entry : vector) {
      bits = std::max(bits, mpz_sizeinbase(entry.gmp(), 2));
    }
    if (bits <= kShortBits) {
      place_.push_back(next_place(short_, Length::kShort));
      for (const Integer& entry : vector) short_.push_back(entry.convert_to<std::int64_t>());
    } else if (bits <= kDoubleBits) {
      place_.push_back(next_place(double_, Length::kDouble));
      for (const Integer& entry : vector) double_.push_back(long_word_of(entry));
    } else {
      place_.push_back(next_place(long_, Length::kLong));
      long_.insert(long_.end(), vector.begin(), vector.end());
    }
    remember(zero, line);
    return line;
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

  /// Returns the signs of a vector, given planes that contain it.
  Signs signs_of(const Row& vector, const Set& through) {
    std::array<double, kMostFaceCoordinates> rounded{};
    core_detail::round_to_one(vector.data(), rounded.data(), dimension_);
    // Entries are at most 1 and off by at most two roundoffs, so that each product is off by
    // less than five, and the sum by D more of D. One more is for products of roundoffs and for
    // what underflows.
    const double bound = static_cast<double>(dimension_ * (dimension_ + 6)) *
                         (std::numeric_limits<double>::epsilon() / 2);
    Signs result;
    for_each_bit(all_ - through, [&](std::size_t g) {
      const double* plane = &planes_.rounded[g * dimension_];
      double sum = 0;
      for (std::size_t j = 0; j < dimension_; ++j) sum += plane[j] * rounded[j];
      int sign = sum > bound ? 1 : sum < -bound ? -1 : 0;
      ++work_.signs;
      if (sign == 0) {
        ++work_.exact_signs;
        sign = dot(planes_.rows[g], vector).sign();
      }
      if (sign == 0) return;
      (sign > 0 ? result.positive : result.negative).set(g);
      const double distance = std::fabs(sum);
      if (distance < work_.near || (distance == work_.near && g < work_.near_plane)) {
        work_.near = distance;
        work_.near_plane = g;
      }
    });
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

  /// Returns the coordinates of a ray's line where they are in words below 2^52, else null.
  const std::int64_t* in_words(Ray ray) const {
    const Place place = place_[ray >> 1];
    return place.length == Length::kShort ? at(short_, place) : nullptr;
  }

  template <class Entry>
  Place next_place(const std::vector<Entry>& lines, Length length) const {
    return {static_cast<std::uint32_t>(lines.size() / dimension_), length};
  }
  /// Returns the coordinates of a line, among those of its length.
  template <class Entry>
  const Entry* at(const std::vector<Entry>& lines, Place place) const {
    return &lines[place.number * dimension_];
  }

  /// Adds the direction of a ray, given its line's.
  template <class Entry>
  void add(const Entry* line, Ray ray, LongWord* sum) const {
    if ((ray & 1) != 0) {
      for (std::size_t j = 0; j < dimension_; ++j) sum[j] -= line[j];
    } else {
      for (std::size_t j = 0; j < dimension_; ++j) sum[j] += line[j];
    }
  }

  /// Does the same in words, if the numbers are short enough.
  bool short_intersection(Ray p, Ray q, std::size_t plane, Row& result) const {
    const std::int64_t* a = in_words(p);
    const std::int64_t* b = in_words(q);
    if (a == nullptr || b == nullptr || planes_.fits[plane] == 0) return false;
    const std::int64_t* row = &planes_.words[plane * dimension_];
    // At most 12 products below 2^112 are added.
    LongWord x = 0;
    LongWord y = 0;
    for (std::size_t j = 0; j < dimension_; ++j) {
      x += static_cast<LongWord>(row[j]) * a[j];
      y += static_cast<LongWord>(row[j]) * b[j];
    }
    if ((p & 1) != 0) x = -x;
    if ((q & 1) != 0) y = -y;
    const LongWord divisor = common_divisor(x, y);
    // The factor of b is positive, and that of a as well.
    const LongWord of_b = size_of(x) / divisor * ((q & 1) != 0 ? -1 : 1);
    const LongWord of_a = size_of(y) / divisor * ((p & 1) != 0 ? -1 : 1);
    constexpr LongWord kLargestFactor = static_cast<LongWord>(1) << 67;
    if (size_of(of_a) >= kLargestFactor || size_of(of_b) >= kLargestFactor) return false;
    std::array<LongWord, kMostFaceCoordinates> sum;
    LongWord content = 0;
    for (std::size_t j = 0; j < dimension_; ++j) {
      sum[j] = of_a * a[j] + of_b * b[j];
      content = common_divisor(sum[j], content);
    }
    for (std::size_t j = 0; j < dimension_; ++j) {
      const LongWord entry = sum[j] / content;
      if (size_of(entry) > std::numeric_limits<std::int64_t>::max()) return false;
      result[j] = static_cast<std::int64_t>(entry);
    }
    return true;
  }

  const DistinctPlanes& planes_;
  LineWork& work_;
  std::size_t dimension_;
  Set all_;
  std::vector<OneSide> signs_;  ///< the positive planes of each ray
  std::vector<Set> zeros_;      ///< the planes through each line
  std::vector<Place> place_;    ///< of the coordinates of each line
  std::vector<std::int64_t> short_;
  std::vector<LongWord> double_;
  std::vector<Integer> long_;
  /// A hash table of lines by all planes that contain them, and by some that determine them.
  std::vector<Known> known_;
  std::size_t entries_ = 0;  ///< of that table
};

}  // namespace stickslip::arrangement_detail
