// SPDX-License-Identifier: MIT
/// \file
/// Margin certificates (FORMAT.md §10): the claimed intervals, the segments that prove them
/// resisted, and the gaps that they leave, which trees prove not to be (tree.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tree.hpp"
#include "witness.hpp"

namespace stickslip_check {

/// Multiples of the direction: [low, high], or [low, oo).
struct Interval {
  Rational low;
  std::optional<Rational> high;
};

/// Throws Rejected (`resisted-order`).
void check_order(const std::vector<Interval>& resisted);

/// The parts of [0, oo) that intervals in order leave, in increasing order.
std::vector<LoadRange> gaps(const std::vector<Interval>& resisted);

/// A POINT: an equilibrium under w + lambda u; or, without lambda, a ray.
struct MarginPoint {
  std::optional<Rational> lambda;
  Witness witness;  ///< h = 0 for a ray
};

/// The segments, checked as they come. `rows`, `question` and `resisted` must outlive this.
class Segments {
 public:
  Segments(const std::vector<Row>& rows, const Question& question,
           const std::vector<Interval>& resisted)
      : rows_(rows), question_(question), resisted_(resisted) {}

  /// Throws Rejected.
  void visit(const MarginPoint& first, const MarginPoint& second);
  /// The list has ended. Throws Rejected (`segment-chain`).
  void finish() const;

 private:
  void check_chain(const MarginPoint& first, const MarginPoint& second) const;
  void check_point(const MarginPoint& point, const char* which) const;
  Rejected rejection(const char* rule, std::string found) const;

  const std::vector<Row>& rows_;
  const Question& question_;
  const std::vector<Interval>& resisted_;
  std::size_t interval_ = 0;     ///< not yet covered
  std::optional<Rational> end_;  ///< of the last segment, if inside that interval
  std::uint64_t visited_ = 0;
};

}  // namespace stickslip_check
