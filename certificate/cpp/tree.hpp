// SPDX-License-Identifier: MIT
/// \file
/// The walk over the nodes of trees (FORMAT.md §4 and §6), in their order. Memory grows with
/// the depth, not with the trees.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "answer.hpp"
#include "moving.hpp"
#include "plane.hpp"
#include "region.hpp"
#include "settled.hpp"

namespace stickslip_check {

enum class NodeKind : std::int8_t {
  kSlip,
  kSeparation,
  kPlane,
  kLeaf,
  kMoving,
  kPart,
  kHeld
};

/// A node as the certificate states it; only its shape has been checked.
struct Node {
  NodeKind kind = NodeKind::kLeaf;
  /// Of slip and separation; of a part, or the component of the wrench; the piece of a held
  /// one.
  Integer contact;
  Vector
      numbers;  ///< a of a plane, one for each coordinate of a point; y of a leaf; c of a part
  Parameter parameter = Parameter::kWrench;         ///< of a part
  std::shared_ptr<const MovingTwist> moving = {};  ///< of a leaf whose twist moves
};

/// The two halves of a box.
struct Halves {
  std::shared_ptr<const Box> low;
  std::shared_ptr<const Box> high;
};
/// Cut by a part. Throws Rejected (`part-contact`, `part-inside`), without a place.
Halves cut_in_two(const Box& box, const Node& part);
/// Such as "friction 2 low".
std::string half_name(const Node& part, bool high);

/// a.x >= 0, or = 0, where the points of a tree begin.
struct Condition {
  Vector a;
  bool equality = false;
  bool strict = false;  ///< a.x is a strict function
};

/// Where a tree begins.
struct Root {
  std::shared_ptr<const Box> box;
  std::vector<Condition> conditions;
  bool bilateral = false;  ///< cut also by the v_i >= 0 that are certain
  std::string path = {};   ///< that leads here
  /// Of list 2, A (d - h d0) as rows of functions of points: `leaf-direction` is asked for.
  std::vector<Vector> direction = {};
  /// Of a region: the pieces, which `held` leaves name.
  std::shared_ptr<const std::vector<Piece>> pieces = {};
  /// If motions are bounded, and it is no wall: functions that are above 0 at no solution.
  std::vector<Form> beyond = {};
};
/// The most nodes above one: `node-depth`.
std::size_t most_depth(const Box& box);
/// h > 0, and lambda in the range.
std::vector<Condition> conditions_of(const Range& range, std::size_t dimension);
/// One for each range.
std::vector<Root> roots_of(const Question& question, const std::vector<Range>& ranges);
/// The one of a region.
Root root_of(const Question& question, std::vector<Piece> pieces);

class TreeWalk {
 public:
  /// One tree for each root. `place` is where the list is, if that has a name.
  explicit TreeWalk(std::vector<Root> roots, std::string place = "");

  /// The next node of the list. Throws Rejected; after a rule about a leaf the walk may go on,
  /// as if the leaf were right.
  void visit(const Node& node);
  /// The list has ended. Throws Rejected (`tree-short`).
  void finish() const;

  std::uint64_t nodes() const { return nodes_; }
  std::uint64_t leaves() const { return leaves_; }
  /// Sum over the leaves, and the nodes that look for what is settled, of the contacts that
  /// were not settled above them.
  std::uint64_t contacts_visited() const { return contacts_visited_; }
  /// Leaves that doubles with error bounds did not prove.
  std::uint64_t exact_leaves() const { return exact_leaves_; }

 private:
  struct Region {
    Cone cone;
    Strict strict;
    std::shared_ptr<const Box> box;
    std::shared_ptr<const Settled> settled;  ///< above it; none unless the box is one point
  };
  /// An inner node whose children are not all done.
  struct Frame {
    Node node;
    Form cut;                ///< tau_i, v_i or a
    std::vector<Form> slip;  ///< in space: the components of s_i, but the one that follows
    Halves halves;           ///< of a part
    Region region;
    unsigned children;
    unsigned next;  ///< child to come
  };

  Region begin(const Root& root);
  Region child();
  void settle(Region& region, const Generators& generators);
  void check_leaf(Region region, const Vector& y);
  void check_moving(const Region& region, const MovingTwist& twist);
  bool stands_for_nothing(const Generators& generators) const;
  void check_held(const Region& region, const Integer& piece) const;
  void push(const Node& node, Region region);
  std::string path(unsigned ahead) const;
  Rejected rejection(const char* rule, std::string found) const;

  std::vector<Root> roots_;
  std::string place_;
  // Of the box of the last root:
  std::shared_ptr<const BoxDoubles> doubles_;
  std::shared_ptr<const Settled> nothing_settled_;
  std::vector<Frame> stack_;
  std::size_t trees_ = 0;  ///< begun
  std::uint64_t nodes_ = 0;
  std::uint64_t leaves_ = 0;
  std::uint64_t contacts_visited_ = 0;
  std::uint64_t exact_leaves_ = 0;
};

}  // namespace stickslip_check
