// SPDX-License-Identifier: MIT
/// \file
/// Margins (FORMAT.md §5): the claimed intervals, the segments that prove them resisted, and
/// the gaps that they leave, which trees prove not to be. And claims, each with its proof.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "answer.hpp"
#include "degree.hpp"
#include "tree.hpp"
#include "witness.hpp"

namespace stickslip_check {

/// Whether w and all P are 0.
bool at_rest(const Question& question);

/// Throws Rejected (`resisted-order`).
void check_order(const std::vector<Interval>& resisted);

/// The parts of [0, oo) that intervals in order leave, in increasing order.
std::vector<Range> gaps(const std::vector<Interval>& resisted);

/// A segment as the certificate states it; only its shape has been checked.
struct Segment {
  std::vector<Witness> points;  ///< two; or none, and then it is by degree
  Part part;                    ///< not cut
  std::optional<Rational> to;   ///< its high end; none for all from its low end on
};

/// The segments, checked as they come; what was done is counted in `accepted`, whose `resisted`
/// they prove. Both arguments must outlive this.
class Segments {
 public:
  Segments(const Question& question, Accepted& accepted)
      : question_(question), accepted_(accepted), resisted_(accepted.resisted) {}

  /// Throws Rejected.
  void visit(const Segment& segment);
  /// The list has ended. Throws Rejected (`segment-chain`).
  void finish() const;

 private:
  void check_points(const Witness& first, const Witness& second);
  void check_by_degree(const Part& part, const Range& range);
  std::string place() const;
  Rejected out_of_chain(const std::string& found) const;

  const Question& question_;
  Accepted& accepted_;
  const std::vector<Interval>& resisted_;
  std::size_t interval_ = 0;     ///< not yet covered
  std::optional<Rational> end_;  ///< of the last segment, if inside that interval
  std::uint64_t visited_ = 0;
  Witness last_;                           ///< the last point, where a segment often begins,
  std::vector<ContactForce> last_forces_;  ///< and its forces
  ForceSum sum_;
};

/// A claim as the certificate states it; only its shape has been checked.
struct RangeProof {
  bool stable = false;
  Interval range;
  std::vector<Witness> points;  ///< if stable, at the ends: two, or one, or none and then
  Part part;                    ///< not cut
  std::vector<Node> tree;       ///< if not stable
};

/// The claims, checked as they come; what they prove is added to `accepted`. Both arguments
/// must outlive this.
class RangeProofs {
 public:
  RangeProofs(const Question& question, Accepted& accepted)
      : question_(question), accepted_(accepted), rests_(at_rest(question)) {}

  /// Throws Rejected.
  void visit(const RangeProof& claim);

 private:
  void check_order(const RangeProof& claim, const std::string& place) const;
  void check_resisted(const RangeProof& claim, const std::string& place);
  void check_refuted(const RangeProof& claim, const std::string& place);

  const Question& question_;
  Accepted& accepted_;
  bool rests_;
  std::uint64_t visited_ = 0;
  std::optional<Rational> end_;  ///< of the last claim, if it has one
};

}  // namespace stickslip_check
