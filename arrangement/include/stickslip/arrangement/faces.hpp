// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The faces of a central arrangement of planes in Q^D, in exact arithmetic.
///
/// Planes a_i.d = 0 divide Q^D into *faces*: the sets of all d with the same signs of all
/// a_i.d. Here faces are of every dimension, from d = 0 (or the space that all planes share) to
/// the open cones between planes. (In sweep.hpp a face is of dimension 2 on the sphere, 3
/// here.) A plane may be required to be 0, not negative or positive; then only the faces of
/// that cone are found. A plane may also *count* only where another one is 0: friction knows a
/// direction of slip only while its contact is closed.
///
/// A face is held as a cone by its rays, and each ray keeps its signs on all planes as bits.
/// The bits of all rays of a cone say which planes cut it, so that no linear program is solved:
/// a cone is split by one of those planes into three, until no plane cuts. Every split gives
/// real faces only, of which there are no more than results; work and memory follow the
/// results. New rays are intersections of the plane with spans of two adjacent rays (double
/// description). In general position a face needs O(D) rays; a line of the arrangement is
/// computed once. Signs are those of dot products in double precision where their error bound
/// decides, else of integers of any length. Degenerate arrangements need nothing special: equal
/// and opposite planes are merged, and rays know all planes that they lie on.
///
/// Everything is deterministic, but for the work of several threads. Work that is broken off
/// throws Cancelled (core/cancellation.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "stickslip/core/row.hpp"
#include "stickslip/core/sign.hpp"

namespace stickslip {

/// The largest number of coordinates, D.
inline constexpr std::size_t kMostFaceCoordinates = 12;
/// The largest number of distinct planes.
inline constexpr std::size_t kMostFacePlanes = 1024;

/// The signs that a face may have on a plane.
enum class AllowedSigns : std::uint8_t { kAny, kZero, kNotNegative, kPositive };

/// A plane a.d = 0 of an arrangement.
struct FacePlane {
  Row row;  ///< a, with D entries; may be 0, and then every sign is 0
  AllowedSigns side = AllowedSigns::kAny;  ///< the signs that are asked for
  /// The index of a plane: this one counts only on faces where that one is 0. Requires
  /// AllowedSigns::kAny here, and a side other than kAny there. Without a value it always
  /// counts.
  std::optional<std::size_t> where_zero{};
};

/// A choice among the faces.
struct FaceOptions {
  /// \{ The dimensions of the faces that are wanted.
  int least_dimension = 0;
  int most_dimension = static_cast<int>(kMostFaceCoordinates);
  /// \}
  /// The largest number of planes of side kNotNegative or kPositive that may be positive.
  std::size_t most_positive = std::numeric_limits<std::size_t>::max();
  /// Called now and then with the number of faces so far; returns whether to go on.
  std::function<bool(std::uint64_t)> go_on{};
};

/// An integer of two words.
__extension__ using LongWord = __int128;

class FaceReader;

/// A face, valid during the call that it is given to.
class Face {
 public:
  /// Makes a view; only the enumerator does.
  Face(const FaceReader& reader, int dimension, bool negated)
      : reader_(&reader), dimension_(dimension), negated_(negated) {}

  int dimension() const { return dimension_; }  ///< the dimension of the set of its points
  /// Returns the sign of a plane, by its index; nothing where the plane does not count.
  std::optional<Sign> sign(std::size_t plane) const;
  /// Returns an integer point of the face, without a common divisor: 0 for d = 0.
  Row motion() const;
  /// Writes the same point in words of two, D of them. Returns false if it is too long for
  /// that.
  bool motion_in_words(LongWord* to) const;

 private:
  const FaceReader* reader_;
  int dimension_;
  bool negated_;
};

/// The reader behind a Face; the enumerator has one for each number of words of bits.
class FaceReader {
 public:
  virtual ~FaceReader() = default;
  /// Returns the sign of a plane before the face is negated.
  virtual std::optional<Sign> sign(std::size_t plane) const = 0;
  /// Returns the motion before the face is negated.
  virtual Row motion() const = 0;
  /// Returns the motion in words of two; null if it is too long for that.
  virtual const LongWord* motion_in_words() const = 0;
  /// Returns D.
  virtual std::size_t coordinates() const = 0;
};

inline std::optional<Sign> Face::sign(std::size_t plane) const {
  const std::optional<Sign> sign = reader_->sign(plane);
  return negated_ && sign ? std::optional<Sign>(-*sign) : sign;
}

/// A plane that nearly contains a line of the arrangement, in double precision.
struct NearMiss {
  std::size_t plane = 0;  ///< the index of the plane
  /// |a.r| / (|a| |r|) for the line's direction r, above 0; norms are largest entries.
  double distance = std::numeric_limits<double>::infinity();
};

/// The counts of an enumeration, and its work, which is reproducible.
struct FaceCounts {
  std::size_t distinct_planes = 0;  ///< planes that are not 0, equal and opposite ones once
  int rank = 0;                     ///< the rank of all rows
  /// The number of faces of each dimension, from 0 to D.
  std::vector<std::uint64_t> by_dimension;
  bool complete = true;  ///< whether nobody ended the walk

  std::uint64_t lines = 0;        ///< lines whose coordinates were computed
  std::uint64_t splits = 0;       ///< cones that were split
  std::uint64_t signs = 0;        ///< signs of dot products
  std::uint64_t exact_signs = 0;  ///< those of them that integers had to decide
  NearMiss near;                  ///< the nearest of all misses

  /// Returns the number of faces.
  std::uint64_t total() const;
};

/// A function that is given a face, and returns whether it takes it. The first face that is not
/// taken ends the walk, and is not counted.
using FaceVisitor = std::function<bool(const Face&)>;

/// Calls `visitor` for each face once, in a fixed order. Throws ContractError if a row has not
/// `coordinates` entries, if there are more than kMostFaceCoordinates or kMostFacePlanes, or if
/// `where_zero` is not as FacePlane says.
FaceCounts visit_faces(std::size_t coordinates, const std::vector<FacePlane>& planes,
                       const FaceVisitor& visitor, const FaceOptions& options = {});

/// A product of some faces that follow each other in the order of visit_faces(), such as their
/// text.
class FaceBatch {
 public:
  virtual ~FaceBatch() = default;
  /// Takes a face in.
  virtual void add(const Face& face) = 0;
  /// Returns about how many bytes it takes.
  virtual std::size_t bytes() const = 0;
};

/// Makes a batch without faces.
using MakeFaceBatch = std::function<std::unique_ptr<FaceBatch>()>;
/// Takes a batch, and returns whether to go on.
using TakeFaceBatch = std::function<bool(FaceBatch&)>;

/// Visits the faces by several threads: each makes batches, and those of all are handed to
/// `take` in the order of visit_faces(), by one thread at a time. `make` and FaceBatch::add are
/// called by several at a time, but each batch by one. Which faces share a batch is not fixed.
/// `threads` and counts are as in count_faces(). Faces of batches that are not handed over, as
/// somebody ended the walk, may be counted.
FaceCounts visit_faces_in_batches(std::size_t coordinates, const std::vector<FacePlane>& planes,
                                  const MakeFaceBatch& make, const TakeFaceBatch& take,
                                  const FaceOptions& options = {}, unsigned threads = 1);

/// Counts the faces without visiting them: antipodal faces are counted together. `threads`
/// share the work; 0 is one a core. Each of several computes the lines that it meets, so that
/// `lines` and `signs` grow with their number; `go_on` is called by one of them at a time.
FaceCounts count_faces(std::size_t coordinates, const std::vector<FacePlane>& planes,
                       const FaceOptions& options = {}, unsigned threads = 1);

}  // namespace stickslip
