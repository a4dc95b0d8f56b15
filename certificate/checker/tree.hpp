// SPDX-License-Identifier: MIT
/// \file
/// The walk over the nodes of trees (FORMAT.md §4), in their order. Memory grows with the
/// depth, not with the trees.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "answer.hpp"
#include "cone.hpp"

namespace stickslip_check {

/// The values of lambda that a tree is about: from low to high, or from low on.
struct Range {
  Rational low;
  std::optional<Rational> high;
  bool open_low = false;   ///< low itself is not among them
  bool open_high = false;  ///< nor is high
};

enum class NodeKind : std::int8_t { kSlip, kSeparation, kPlane, kLeaf };

/// A node as the certificate states it; only its shape has been checked.
struct Node {
  NodeKind kind = NodeKind::kLeaf;
  Integer contact;  ///< of slip and separation
  Vector numbers;   ///< a of a plane, one for each coordinate of a point; y of a leaf
};

class TreeWalk {
 public:
  /// One tree for each range. `question` must outlive this.
  TreeWalk(const Question& question, std::vector<Range> ranges);

  /// The next node of the list. Throws Rejected; after `leaf-bound` the walk may go on, as if
  /// the leaf were right.
  void visit(const Node& node);
  /// The list has ended. Throws Rejected (`tree-short`).
  void finish() const;

  std::uint64_t nodes() const { return nodes_; }
  std::uint64_t leaves() const { return leaves_; }

 private:
  struct Region {
    Cone cone;
    Set strict;  ///< the conditions of the cone that are strict functions
  };
  /// An inner node whose children are not all done.
  struct Frame {
    NodeKind kind;
    std::size_t contact;
    Form cut;  ///< tau_i, v_i or a
    Region region;
    unsigned children;
    unsigned next;  ///< child to come
  };

  Region root(const Range& range) const;
  Region child();
  std::optional<std::string> refusal(const Region& region, const Vector& y, bool rounded) const;
  void push(const Node& node, Region region);
  std::string path(unsigned ahead) const;
  Rejected rejection(const char* rule, std::string found) const;

  const Question& question_;
  std::vector<Range> ranges_;
  std::vector<Frame> stack_;
  std::size_t trees_ = 0;  ///< begun
  std::uint64_t nodes_ = 0;
  std::uint64_t leaves_ = 0;
};

}  // namespace stickslip_check
