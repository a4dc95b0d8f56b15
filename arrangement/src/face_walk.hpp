// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The walk over the faces of an arrangement, for sets of planes of a fixed number of words.
///
/// 1. *The closed cone*: planes of which a sign is asked cut the space down to a cone, which is
///    held by its rays and, where it has any, by its lines.
/// 2. *Its faces*: each is the rays on some of those planes. The walk goes down from the cone
///    and marks planes that have to stay positive, so that it meets each face once.
/// 3. *Inside of a face* other planes count. They turn its lines into rays (each into both
///    directions or into none), and then split the pointed cones that result.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "distinct_planes.hpp"
#include "line_store.hpp"
#include "stickslip/core/cancellation.hpp"

namespace stickslip::arrangement_detail {

/// Vectors that span a cone: its lines in both directions, its rays in one.
struct Generators {
  std::vector<Row> lines;
  std::vector<Row> rays;
};

/// Removes from the lines all on which the plane is not 0 but one, which is returned on its
/// positive side, and moves rays along it into the plane. Returns nothing if the plane contains
/// all lines.
std::optional<Row> take_line(Generators& of, const Row& plane);

/// Moves vectors along a line, on which the plane is positive, into the plane.
void move_into_plane(std::vector<Row>& vectors, const Row& plane, const Row& line);

/// The state that parts of a walk share, which are walked over at the same time. Each part meets
/// all *lists*, cones that are split, in the same order, and splits those that it is the first
/// to claim.
struct SharedWalk {
  explicit SharedWalk(const FaceOptions& options) : go_on(options.go_on) {}

  /// Adds newly found faces, and asks whether to go on unless another part is just asking.
  bool ask(std::uint64_t newly_found) {
    const std::uint64_t all = found += newly_found;
    const std::unique_lock<std::mutex> lock(asking, std::try_to_lock);
    if (lock && go_on && !stopped && !go_on(all)) stopped = true;
    return !stopped;
  }

  /// Returns whether a part may split a list, given its number.
  bool claim(std::size_t list) { return claimed.compare_exchange_strong(list, list + 1); }

  const std::function<bool(std::uint64_t)>& go_on;
  std::mutex asking;
  std::atomic<std::uint64_t> found{0};
  std::atomic<bool> stopped{false};
  std::atomic<std::size_t> claimed{0};  ///< the number of lists that are claimed
};

/// The events of a part of a walk, which somebody may listen to.
struct WalkEvents {
  const FaceVisitor* visitor = nullptr;  ///< of each face; without one they are counted
  std::function<void(std::size_t)> list_begins{};  ///< given the number of the list
  std::function<void()> list_ends{};
};

template <std::size_t words>
class FaceWalk : public FaceReader {
 public:
  using Set = PlaneSet<words>;

  FaceWalk(const DistinctPlanes& planes, const FaceOptions& options, SharedWalk& shared,
           WalkEvents events)
      : planes_(planes),
        options_(options),
        shared_(shared),
        events_(std::move(events)),
        outer_(planes, work_),
        inner_(planes, work_) {
    counts_.distinct_planes = planes.size();
    counts_.rank = planes.rank;
    counts_.by_dimension.resize(planes.coordinates + 1);
    for (std::size_t g = 0; g < planes.size(); ++g) {
      if (planes.sides[g] != AllowedSigns::kAny) asked_.set(g);
      if (planes.sides[g] == AllowedSigns::kPositive) strict_.set(g);
      if (planes.always_counts[g] != 0) always_.set(g);
    }
  }

  FaceCounts run() {
    if (planes_.possible) {
      const std::vector<Ray> cone = closed_cone();
      walk_faces(cone, strict_);
    }
    counts_.complete = !stopped_;
    counts_.lines = work_.lines;
    counts_.signs = work_.signs;
    counts_.exact_signs = work_.exact_signs;
    if (work_.near < 1) {
      const auto plane =
          std::find(planes_.group.begin(), planes_.group.end(), work_.near_plane);
      counts_.near = {static_cast<std::size_t>(plane - planes_.group.begin()), work_.near};
    }
    return std::move(counts_);
  }

  std::optional<Sign> sign(std::size_t plane) const override {
    const auto& owner = planes_.owner[plane];
    if (owner && sign_of_distinct(*owner) != 0) return std::nullopt;
    const auto& group = planes_.group[plane];
    if (!group) return Sign::kZero;
    return sign_of_int(sign_of_distinct(*group)) * planes_.orientation[plane];
  }

  std::size_t coordinates() const override { return planes_.coordinates; }

  Row motion() const override {
    Row sum(planes_.coordinates);
    for (std::size_t i = 0; i < face_.rays; ++i) {
      store_->add_to(sum, stack_[face_.begin + i]);
    }
    return primitive(std::move(sum));
  }

  const LongWord* motion_in_words() const override {
    if (!face_.motion_known) {
      face_.motion_known = true;
      face_.motion_fits = sum_of_rays();
    }
    return face_.motion_fits ? motion_.data() : nullptr;
  }

 private:
  /// The rays of the face that is visited, and its signs.
  struct Visited {
    std::size_t begin = 0;
    std::size_t rays = 0;
    Set positive;
    Set negative;
    bool motion_known = false;  ///< whether it was asked for
    bool motion_fits = false;   ///< whether it is in words
  };

  /// Computes the motion in words. Returns false if it is too long.
  bool sum_of_rays() const {
    constexpr std::size_t kMostRays = 1000;
    if (face_.rays > kMostRays) return false;
    motion_.fill(0);
    for (std::size_t i = 0; i < face_.rays; ++i) {
      if (!store_->add_to(motion_.data(), stack_[face_.begin + i])) return false;
    }
    LongWord divisor = 0;
    for (std::size_t j = 0; j < planes_.coordinates && divisor != 1; ++j) {
      divisor = common_divisor(motion_[j], divisor);
    }
    if (divisor > 1) {
      for (std::size_t j = 0; j < planes_.coordinates; ++j) motion_[j] /= divisor;
    }
    return true;
  }

  int sign_of_distinct(std::size_t g) const {
    return face_.positive.get(g) ? 1 : face_.negative.get(g) ? -1 : 0;
  }

  // The closed cone.

  std::vector<Ray> closed_cone() {
    Generators cone;
    for (std::size_t j = 0; j < planes_.coordinates; ++j) {
      cone.lines.emplace_back(planes_.coordinates);
      cone.lines.back()[j] = 1;
    }
    for_each_bit(asked_, [&](std::size_t g) {
      std::optional<Row> ray = take_line(cone, planes_.rows[g]);
      if (ray && planes_.sides[g] != AllowedSigns::kZero) cone.rays.push_back(std::move(*ray));
    });
    lines_ = std::move(cone.lines);
    std::vector<Ray> rays;
    for (const Row& ray : cone.rays) rays.push_back(outer_.add(ray));
    store_ = &outer_;
    int dimension = static_cast<int>(rays.size());
    for_each_bit(asked_, [&](std::size_t g) { clip(rays, dimension, g); });
    return rays;
  }

  /// Replaces a cone by its part that has the sign that is asked of a plane.
  void clip(std::vector<Ray>& rays, int& dimension, std::size_t plane) {
    throw_if_cancelled();
    const bool zero_only = planes_.sides[plane] == AllowedSigns::kZero;
    stack_ = rays;
    const Cut cut = cut_at(0, rays.size(), dimension, plane);
    if (cut.minus == 0 && (!zero_only || cut.plus == 0)) return;
    const auto begin = stack_.begin() + static_cast<std::ptrdiff_t>(cut.begin);
    const auto zero = begin + static_cast<std::ptrdiff_t>(cut.plus);
    rays.assign(zero_only ? zero : begin,
                zero + static_cast<std::ptrdiff_t>(cut.zero + cut.fresh));
    if (zero_only || cut.plus == 0) dimension = dimension_of(rays);
  }

  // The faces of the closed cone.

  std::size_t number_asked(const Set& positive) const {
    std::size_t result = 0;
    for_each_bit(positive & asked_, [&](std::size_t g) { result += planes_.asked[g]; });
    return result;
  }

  /// Walks over the face that these rays span and all faces on it where `forced` is positive.
  void walk_faces(const std::vector<Ray>& rays, Set forced) {
    Set positive;
    for (const Ray ray : rays) positive |= outer_.positive(ray);
    if (stopped_ || !positive.contains(forced)) return;
    if (number_asked(forced) > options_.most_positive) return;
    check();
    const int dimension = dimension_of(rays);
    if (dimension + static_cast<int>(lines_.size()) < options_.least_dimension) return;
    const Set open = positive & asked_;
    if (number_asked(open) <= options_.most_positive) walk_inside(rays, dimension, open);
    std::vector<Ray> on_plane;
    for_each_bit(open - forced, [&](std::size_t g) {
      if (stopped_ || number_asked(forced) > options_.most_positive) return;
      on_plane.clear();
      for (const Ray ray : rays) {
        if (outer_.zero(ray).get(g)) on_plane.push_back(ray);
      }
      walk_faces(on_plane, forced);
      forced.set(g);
    });
  }

  /// Returns the rank of rays of the outer store.
  int dimension_of(const std::vector<Ray>& rays) const {
    if (rays.size() <= 3)
      return static_cast<int>(rays.size());  // No two, or three, are dependent.
    std::vector<ReducedRow> vectors;
    std::vector<ReducedRow> normals;
    Set zero = outer_.zero(rays.front());
    for (const Ray ray : rays) {
      vectors.push_back(outer_.reduced(ray));
      zero = zero & outer_.zero(ray);
    }
    for_each_bit(zero & asked_, [&](std::size_t g) { normals.push_back(planes_.reduced[g]); });
    // A rank modulo a prime is a lower bound of each rank; together they have to be right.
    const int rank = reduced_rank_of(vectors, planes_.coordinates);
    const int others = reduced_rank_of(normals, planes_.coordinates);
    if (rank + others + static_cast<int>(lines_.size()) ==
        static_cast<int>(planes_.coordinates)) {
      return rank;
    }
    std::vector<Row> rows;
    for (const Ray ray : rays) rows.push_back(outer_.vector(ray));
    return rank_of(rows);
  }

  // The inside of a face.

  void walk_inside(const std::vector<Ray>& rays, int dimension, const Set& open) {
    active_ = always_;
    for_each_bit(asked_ - open, [&](std::size_t g) {
      for (const std::size_t each : planes_.owned[g]) active_.set(each);
    });
    mirrored_ = false;
    Generators cone{lines_, {}};
    if (!lines_.empty()) {  // else nothing moves them
      for (const Ray ray : rays) cone.rays.push_back(outer_.vector(ray));
    }
    std::vector<Row> taken;
    Set at;
    for_each_bit(active_, [&](std::size_t g) {
      std::optional<Row> line = take_line(cone, planes_.rows[g]);
      if (!line) return;
      // Lines that were taken before are moved into the plane as rays are.
      move_into_plane(taken, planes_.rows[g], *line);
      taken.push_back(std::move(*line));
      at.set(g);
    });
    lines_left_ = static_cast<int>(cone.lines.size());
    if (taken.empty()) {
      split_list(rays, dimension);
      return;
    }
    store_ = &inner_;
    std::vector<Ray> list;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      list.push_back(inner_.add(cone.rays[i], (outer_.zero(rays[i]) & asked_) | at));
    }
    std::vector<Ray> directions;
    for (const Row& line : taken) directions.push_back(inner_.add(line, asked_));
    walk_directions(list, directions, 0, dimension, rays.empty());
    store_ = &outer_;
    // Planes determine each ray where no line is left, so that it serves in other faces too.
    if (lines_left_ > 0) inner_.clear();
  }

  /// Walks over the cones of the list and, of each direction from number `next`, it, its
  /// opposite or neither. If `symmetric`, the first that is not neither is as given: its
  /// opposite is left to the mirror.
  void walk_directions(std::vector<Ray>& list, const std::vector<Ray>& directions,
                       std::size_t next, int dimension, bool symmetric) {
    if (stopped_) return;
    if (next == directions.size()) {
      split_list(list, dimension);
      return;
    }
    list.push_back(directions[next]);
    if (symmetric) mirrored_ = true;
    walk_directions(list, directions, next + 1, dimension + 1, false);
    if (symmetric) mirrored_ = false;
    if (!symmetric) {
      list.back() = opposite(directions[next]);
      walk_directions(list, directions, next + 1, dimension + 1, false);
    }
    list.pop_back();
    walk_directions(list, directions, next + 1, dimension, symmetric);
  }

  void split_list(const std::vector<Ray>& list, int dimension) {
    if (!shared_.claim(lists_++)) return;
    if (events_.list_begins) events_.list_begins(lists_ - 1);
    stack_.assign(list.begin(), list.end());
    split(0, list.size(), dimension);
    if (events_.list_ends) events_.list_ends();
  }

  /// Gives the faces inside of the cone of the rays at `begin` of the stack.
  void split(std::size_t begin, std::size_t rays, int dimension) {
    if (stopped_ || dimension + lines_left_ < options_.least_dimension) return;
    Set positive;
    Set negative;
    for (std::size_t i = 0; i < rays; ++i) {
      positive |= store_->positive(stack_[begin + i]);
      negative |= store_->negative(stack_[begin + i]);
    }
    const Set cuts = positive & negative & active_;
    if (!cuts.any()) {
      give(dimension + lines_left_, {begin, rays, positive, negative});
      return;
    }
    constexpr std::uint64_t kSplitsBetweenChecks = 256;
    if (++counts_.splits % kSplitsBetweenChecks == 0) check();
    const Cut cut = cut_at(begin, rays, dimension, cuts.first());
    split(cut.begin, cut.plus + cut.zero + cut.fresh, dimension);
    split(cut.begin + cut.plus, cut.zero + cut.fresh, dimension - 1);
    split(cut.begin + cut.plus, cut.zero + cut.fresh + cut.minus, dimension);
    stack_.resize(cut.begin);
  }

  /// A cone that a plane cuts, at the end of the stack: rays on the positive side, rays in the
  /// plane, new rays in the plane, and rays on the negative side. So each of the three parts is
  /// one piece of the stack.
  struct Cut {
    std::size_t begin = 0;
    std::size_t plus = 0;
    std::size_t zero = 0;
    std::size_t fresh = 0;
    std::size_t minus = 0;
  };

  /// Cuts a cone of the dimension whose rays are in the stack at `begin`.
  Cut cut_at(std::size_t begin, std::size_t rays, int dimension, std::size_t plane) {
    Cut cut;
    cut.begin = stack_.size();
    minus_.clear();
    Set positive;
    Set negative;
    for (std::size_t i = 0; i < rays; ++i) {
      const Ray each = stack_[begin + i];
      positive |= store_->positive(each);
      negative |= store_->negative(each);
      if (store_->positive(each).get(plane)) {
        stack_.push_back(each);
      } else if (store_->negative(each).get(plane)) {
        minus_.push_back(each);
      }
    }
    cut.plus = stack_.size() - cut.begin;
    cut.minus = minus_.size();
    for (std::size_t i = 0; i < rays; ++i) {
      const Ray each = stack_[begin + i];
      if (store_->zero(each).get(plane)) stack_.push_back(each);
    }
    cut.zero = rays - cut.plus - cut.minus;
    // Facets are on planes that do not cut; planes that contain the whole cone say nothing.
    const Set facets = (positive | negative) - (positive & negative);
    const bool all_adjacent = rays == static_cast<std::size_t>(dimension) || dimension <= 2;
    for (std::size_t x = 0; x < cut.plus; ++x) {
      const Ray p = stack_[cut.begin + x];
      const Set of_p = store_->zero(p) & facets;
      for (const Ray q : minus_) {
        if (!all_adjacent && !adjacent(of_p & store_->zero(q), p, q, begin, rays, dimension)) {
          continue;
        }
        stack_.push_back(store_->between(p, q, plane));
      }
    }
    cut.fresh = stack_.size() - cut.begin - cut.plus - cut.zero;
    stack_.insert(stack_.end(), minus_.begin(), minus_.end());
    return cut;
  }

  /// Returns whether two rays are adjacent, given the facets of the cone that contain both:
  /// then no other ray is on all of those.
  bool adjacent(const Set& common, Ray p, Ray q, std::size_t begin, std::size_t rays,
                int dimension) const {
    if (common.count() < dimension - 2) return false;
    for (std::size_t i = 0; i < rays; ++i) {
      const Ray each = stack_[begin + i];
      if (each != p && each != q && store_->zero(each).contains(common)) return false;
    }
    return true;
  }

  /// Ends the walk if that is wanted.
  void check() {
    throw_if_cancelled();
    stopped_ = !shared_.ask(std::exchange(found_, 0)) || stopped_;
  }

  void give(int dimension, const Visited& face) {
    if (dimension < options_.least_dimension || dimension > options_.most_dimension) return;
    const std::size_t i = static_cast<std::size_t>(dimension);
    if (events_.visitor == nullptr) {
      counts_.by_dimension[i] += mirrored_ ? 2 : 1;
      found_ += mirrored_ ? 2 : 1;
      return;
    }
    face_ = face;
    for (const bool negated : {false, true}) {
      if (stopped_ || (negated && !mirrored_)) return;
      stopped_ = !(*events_.visitor)(Face(*this, dimension, negated));
      if (stopped_) return;
      ++counts_.by_dimension[i];
      ++found_;
    }
  }

  const DistinctPlanes& planes_;
  FaceOptions options_;
  SharedWalk& shared_;
  WalkEvents events_;
  std::size_t lists_ = 0;  ///< the cones that were given to be split, in all parts
  FaceCounts counts_;
  LineWork work_;
  Set asked_;   ///< the planes of which a sign is asked
  Set strict_;  ///< those that have to be positive
  Set always_;  ///< the planes that count everywhere

  LineStore<words>
      outer_;  ///< the rays of the closed cone; those of all faces if it is pointed
  LineStore<words> inner_;     ///< the rays inside of faces, if it is not
  LineStore<words>* store_{};  ///< the one that the stack refers to
  std::vector<Row> lines_;     ///< the lines of the closed cone
  Set active_;                 ///< the planes that count inside of the face
  int lines_left_ = 0;         ///< the lines that these planes contain
  bool mirrored_ = false;  ///< whether antipodes of faces are faces that are not walked over
  std::vector<Ray> stack_;
  std::vector<Ray> minus_;  ///< used in cut_at() alone
  /// \{ The face, and its motion, which is computed when it is asked for, once for its opposite
  /// as well.
  mutable Visited face_;
  mutable std::array<LongWord, kMostFaceCoordinates> motion_{};
  /// \}
  std::uint64_t found_ = 0;  ///< the number of faces since go_on_ was asked
  bool stopped_ = false;
};

}  // namespace stickslip::arrangement_detail
