// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/arrangement/faces.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <numeric>
#include <optional>
#include <thread>
#include <tuple>
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

}  // namespace arrangement_detail

namespace {

using arrangement_detail::DistinctPlanes;
using arrangement_detail::FaceWalk;
using arrangement_detail::SharedWalk;
using arrangement_detail::WalkEvents;

FaceCounts walk(const DistinctPlanes& planes, const FaceOptions& options, SharedWalk& shared,
                const WalkEvents& events) {
  const auto run = [&](auto words) {
    return FaceWalk<words>(planes, options, shared, events).run();
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
  if (std::tie(part.near.distance, part.near.plane) <
      std::tie(sum.near.distance, sum.near.plane)) {
    sum.near = part.near;
  }
}

/// Walks by several threads at the same time, 0 being one a core; `part` walks one part.
FaceCounts walk_by_threads(unsigned threads, const std::function<FaceCounts()>& part) {
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  if (threads == 0) threads = cores;
  if (threads == 1) return part();
  // There may be more threads than cores, without a warning of TBB.
  std::optional<tbb::global_control> allowed;
  if (threads > cores) {
    allowed.emplace(tbb::global_control::max_allowed_parallelism, threads);
  }
  std::vector<FaceCounts> parts(threads);
  Cancellation* const cancellation = Cancellation::current();
  tbb::task_arena arena(static_cast<int>(threads));
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
      const SharedCancellation shared(cancellation);
      parts[i] = part();
    });
  });
  FaceCounts sum = std::move(parts.front());
  for (std::size_t i = 1; i < parts.size(); ++i) add(sum, parts[i]);
  return sum;
}

/// A batch with the numbers of its faces by dimension.
struct CountedBatch {
  std::unique_ptr<FaceBatch> batch;
  std::vector<std::uint64_t> by_dimension;
};

/// Batches of lists, handed over in the order of the lists. The part whose list has its turn
/// hands over what it has; others keep theirs until then, as long as that is not too much.
class OrderedBatches {
 public:
  OrderedBatches(std::size_t coordinates, const MakeFaceBatch& make, const TakeFaceBatch& take,
                 SharedWalk& shared)
      : make_(make), take_(take), shared_(shared), taken_(coordinates + 1) {}

  CountedBatch fresh() const { return {make_(), std::vector<std::uint64_t>(taken_.size())}; }

  /// Hands over what a list has so far if it is long, and if it is too long waits for the turn
  /// of the list. Returns whether to go on.
  bool offer(std::size_t list, CountedBatch& batch) {
    constexpr std::size_t kLong = std::size_t{1} << 16;
    constexpr std::size_t kTooLong = std::size_t{1} << 25;
    const std::size_t bytes = batch.batch->bytes();
    if (bytes < kLong) return !shared_.stopped;
    if (turn_ != list) {
      if (bytes < kTooLong) return !shared_.stopped;
      std::unique_lock<std::mutex> lock(mutex_);
      wait(lock, [&] { return turn_ == list; });
      if (turn_ != list) return false;
    }
    take(batch);
    batch = fresh();
    return !shared_.stopped;
  }

  /// Hands over what is left of a list, or keeps it for whoever has the turn before.
  void end(std::size_t list, CountedBatch batch) {
    constexpr std::size_t kMostKept = std::size_t{1} << 26;
    std::unique_lock<std::mutex> lock(mutex_);
    kept_bytes_ += batch.batch->bytes();
    kept_.emplace(list, std::move(batch));
    if (turn_ != list) {
      wait(lock, [&] { return kept_bytes_ < kMostKept; });
      return;
    }
    for (auto next = kept_.begin(); next != kept_.end() && next->first == turn_;
         next = kept_.begin()) {
      CountedBatch each = std::move(next->second);
      kept_.erase(next);
      kept_bytes_ -= each.batch->bytes();
      lock.unlock();
      take(each);
      lock.lock();
      ++turn_;
      changed_.notify_all();
    }
  }

  /// Ends the walk of all parts, as one of them failed.
  void fail() {
    failed_ = true;
    stop();
  }

  /// Returns the numbers of faces in batches that were handed over.
  std::vector<std::uint64_t> taken() && { return std::move(taken_); }

 private:
  template <class Condition>
  void wait(std::unique_lock<std::mutex>& lock, const Condition& condition) {
    // Nobody tells when the question whether to go on was answered with no.
    while (!shared_.stopped && !condition()) {
      changed_.wait_for(lock, std::chrono::milliseconds(50));
    }
  }

  void stop() {
    shared_.stopped = true;
    changed_.notify_all();
  }

  /// Hands a batch over; only the part whose list has the turn does.
  void take(CountedBatch& batch) {
    if (failed_ || refused_) return;
    for (std::size_t j = 0; j < taken_.size(); ++j) taken_[j] += batch.by_dimension[j];
    if (take_(*batch.batch)) return;
    refused_ = true;
    stop();
  }

  const MakeFaceBatch& make_;
  const TakeFaceBatch& take_;
  SharedWalk& shared_;
  std::vector<std::uint64_t> taken_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<std::size_t> turn_{0};          ///< the list whose turn it is
  std::map<std::size_t, CountedBatch> kept_;  ///< of lists that ended before their turn
  std::size_t kept_bytes_ = 0;
  std::atomic<bool> failed_{false};
  std::atomic<bool> refused_{false};
};

}  // namespace

Row Face::motion() const {
  Row motion = reader_->motion();
  return negated_ ? negated(std::move(motion)) : motion;
}

bool Face::motion_in_words(LongWord* to) const {
  const LongWord* motion = reader_->motion_in_words();
  if (motion == nullptr) return false;
  for (std::size_t j = 0; j < reader_->coordinates(); ++j) {
    to[j] = negated_ ? -motion[j] : motion[j];
  }
  return true;
}

std::uint64_t FaceCounts::total() const {
  return std::accumulate(by_dimension.begin(), by_dimension.end(), std::uint64_t{0});
}

FaceCounts visit_faces(std::size_t coordinates, const std::vector<FacePlane>& planes,
                       const FaceVisitor& visitor, const FaceOptions& options) {
  SharedWalk shared(options);
  return walk(DistinctPlanes(coordinates, planes), options, shared, {&visitor});
}

FaceCounts visit_faces_in_batches(std::size_t coordinates, const std::vector<FacePlane>& planes,
                                  const MakeFaceBatch& make, const TakeFaceBatch& take,
                                  const FaceOptions& options, unsigned threads) {
  const DistinctPlanes distinct(coordinates, planes);
  SharedWalk shared(options);
  OrderedBatches batches(coordinates, make, take, shared);
  FaceCounts counts = walk_by_threads(threads, [&] {
    try {
      std::size_t list = 0;
      CountedBatch batch;
      const FaceVisitor visitor = [&](const Face& face) {
        batch.batch->add(face);
        ++batch.by_dimension[static_cast<std::size_t>(face.dimension())];
        return batches.offer(list, batch);
      };
      return walk(distinct, options, shared,
                  {&visitor,
                   [&](std::size_t number) {
                     list = number;
                     batch = batches.fresh();
                   },
                   [&] { batches.end(list, std::move(batch)); }});
    } catch (...) {
      batches.fail();
      throw;
    }
  });
  counts.by_dimension = std::move(batches).taken();
  counts.complete = counts.complete && !shared.stopped;
  return counts;
}

FaceCounts count_faces(std::size_t coordinates, const std::vector<FacePlane>& planes,
                       const FaceOptions& options, unsigned threads) {
  const DistinctPlanes distinct(coordinates, planes);
  SharedWalk shared(options);
  return walk_by_threads(threads, [&] { return walk(distinct, options, shared, {}); });
}

}  // namespace stickslip
